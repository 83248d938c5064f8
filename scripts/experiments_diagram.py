"""The figures of doc/experiments.md."""

from thelma import plotting  # first: says what is missing
from thelma.plotting import DASHED, GREY, line, mark, plt

import numpy as np

import experiments_data as data
import experiments_model as model
import experiments_report as report
from thelma import viscoelastic_exact as exact

COLORS = ("#1f4e9c", "#b3202c", "#dd9025")
MEASURED = {"marker": "o", "markersize": 5.5, "linestyle": "", "zorder": 4}
PLUS = {"marker": "+", "markersize": 6, "markeredgewidth": 0.9}
OWN = {**PLUS, "linestyle": "", "zorder": 5, "markeredgecolor": "black"}
STRETCH = r"stretch  $\lambda$"
STRESS = "nominal stress (kPa)"
CELSIUS = "temperature (°C)"


def rates(found, path):
    """Triangles at three rates, measured peaks, the program's points."""
    figure, axes = plt.subplots(figsize=(6.2, 4.6), constrained_layout=True)
    for color, (rate, measured) in zip(COLORS, data.HOSSAIN_PEAKS.items()):
        for film, style in ((exact.vhb(model.LOCKING), "-"), (found.fit.material.film(report.ROOM), DASHED)):
            test = exact.uniaxial(film, rate, data.HOSSAIN_STRETCH, model.METHOD)
            times = np.linspace(0, test.times[1 if style == DASHED else 2], 161)
            axes.plot([test.stretch(t) for t in times], [test.stress(t) for t in times], color=color,
                      linestyle=style, linewidth=0.9 if style == DASHED else 1.3)
        axes.plot(data.HOSSAIN_STRETCH, measured, color=color, **MEASURED)
        for points in [found.program["rates"][f"{rate:g}"]] if found.program else []:
            kept = plotting.spaced(*np.transpose(points), 0.04)
            axes.plot(*np.transpose([points[i] for i in kept]), color=color, **OWN)
    axes.set_xlabel(STRETCH)
    axes.set_ylabel(STRESS)
    axes.set_ylim(bottom=0)
    axes.legend(handles=[line(f"{rate:g} /s", color=color) for color, rate in zip(COLORS, data.HOSSAIN_PEAKS)]
                + [line(f"parameters of {data.WANG.short}"),
                   line("predicted by the fit to other tests", linestyle=DASHED, linewidth=0.9),
                   mark(f"peak measured, {data.HOSSAIN.short}", marker="o")]
                + ([mark("Thelma", **PLUS, color="black")] if found.program else []), frameon=False)
    plotting.save(figure, path)


def curve(axes, found, tables, test, low, high, factor=1.0, **style):
    """The model against temperature."""
    celsius = np.linspace(low, high, 121)
    axes.plot(celsius, [factor * tables.stress(found.fit.material, test, one) for one in celsius], **style)


def own_points(axes, found, wanted, color):
    """The program's stresses."""
    for own, (point, _) in zip(found.program.get("points", []), found.points):
        if wanted(point):
            axes.plot(point.celsius, own, color=color, **OWN)


def log_stress(axes, ticks):
    """A logarithmic axis with plain numbers."""
    axes.set_yscale("log")
    axes.set_yticks(ticks, [f"{tick:g}" for tick in ticks])
    axes.yaxis.set_minor_formatter(plt.NullFormatter())
    axes.set_xlabel(CELSIUS)


def temperature(found, tables, path):
    """Peaks of both laboratories."""
    figure, (left, right) = plt.subplots(1, 2, figsize=(9.2, 4.4), constrained_layout=True)
    for color, rate in zip(COLORS, data.LIAO_PEAKS):
        curve(left, found, tables, model.Test(data.LIAO_STRETCH, rate), -22, 82, color=color)
        left.plot(data.LIAO_CELSIUS, data.LIAO_PEAKS[rate], color=color, **MEASURED)
        own_points(left, found, lambda point, rate=rate: point.set == model.LIAO and point.test.rate == rate, color)
    test = model.Test(data.ALKHOURY_STRETCH, data.ALKHOURY_RATE)
    curve(right, found, tables, test, -5, 65, found.fit.factor, color=COLORS[0])
    curve(right, found, tables, test, -5, 65, color=COLORS[0], linestyle=DASHED, linewidth=0.9)
    right.plot(list(data.ALKHOURY_PEAKS), list(data.ALKHOURY_PEAKS.values()), color=COLORS[0], **MEASURED)
    own_points(right, found, lambda point: point.set == model.PEAK, COLORS[0])
    log_stress(left, (50, 100, 200, 500, 1000, 2000))
    log_stress(right, (50, 100, 200, 500))
    left.set_ylabel("peak " + STRESS)
    left.set_title(rf"VHB 4905, $\lambda = 4$, {data.LIAO.short}", fontsize=11)
    right.set_title(rf"VHB 4910, $\lambda = 2$, {data.ALKHOURY.short}", fontsize=11)
    thelma = [mark("Thelma", **PLUS, color="black")] if found.program else []
    left.legend(handles=[line(f"fit, {rate:g} /s", color=color) for color, rate in zip(COLORS, data.LIAO_PEAKS)]
                + [mark("measured", marker="o"), *thelma], frameon=False)
    right.legend(handles=[line(f"fit, 0.1 /s, times {found.fit.factor:.2f}", color=COLORS[0]),
                          line("fit without this factor", color=COLORS[0], linestyle=DASHED, linewidth=0.9),
                          mark("measured", marker="o"), *thelma], frameon=False)
    plotting.save(figure, path)


def relaxation(found, tables, path):
    """Stress after an hour, and the fraction of the peak that is gone."""
    figure, (left, right) = plt.subplots(1, 2, figsize=(9.2, 4.2), constrained_layout=True)
    curve(left, found, tables, model.RELAXED_TEST, -5, 65, found.fit.factor, color=COLORS[0])
    curve(left, found, tables, model.RELAXED_TEST, -5, 65, color=COLORS[0], linestyle=DASHED, linewidth=0.9)
    left.plot(list(data.ALKHOURY_RELAXED), list(data.ALKHOURY_RELAXED.values()), color=COLORS[0], **MEASURED)
    own_points(left, found, lambda point: point.set == model.RELAXED, COLORS[0])
    left.set_ylim(0, 110)
    left.set_ylabel("nominal stress after an hour (kPa)")
    left.set_title(rf"VHB 4910, $\lambda = 3.5$, {data.ALKHOURY.short}", fontsize=11)
    thelma = [mark("Thelma", **PLUS, color="black")] if found.program else []
    left.legend(handles=[line(f"fit, times {found.fit.factor:.2f}", color=COLORS[0]),
                         line("fit without this factor", color=COLORS[0], linestyle=DASHED, linewidth=0.9),
                         mark("measured", marker="o"), *thelma], frameon=False, loc="lower left")
    celsius = np.linspace(-20, 80, 121)
    right.plot(celsius, [report.relaxed_fraction(found.fit.material, one, tables) for one in celsius],
               color=COLORS[0])
    right.set_ylim(0, 1)
    right.set_ylabel("fraction relaxed after an hour")
    right.set_title("model, after a stretch at 0.1 /s; not measured", fontsize=11)
    for axes in (left, right):
        axes.set_xlabel(CELSIUS)
    plotting.save(figure, path)


def field(found, path):
    """A panel per temperature: with and without voltage."""
    figure, panels = plt.subplots(1, 2, figsize=(9.2, 4.3), sharey=True, constrained_layout=True)
    for axes, (celsius, stresses) in zip(panels, data.MEHNERT_STRESSES.items()):
        for color, (kilovolts, measured) in zip(COLORS, stresses.items()):
            for held, style in ((False, "-"), (True, DASHED)):
                axes.plot(*model.under_voltage(found.fit.material, celsius, kilovolts, width_held=held, points=121),
                          color=color, linestyle=style, linewidth=0.9 if held else 1.3)
            axes.plot(data.MEHNERT_STRETCH, measured, color=color, **MEASURED)
            own = found.program.get("fields", {}).get(f"{celsius}", {}).get(f"{kilovolts}")
            if own:
                axes.plot(data.MEHNERT_STRETCH, own, color=color, **OWN)
        axes.axhline(0, color="0.8", linewidth=0.6, zorder=0)
        axes.set_xlabel(STRETCH)
        axes.set_title(f"{celsius} °C, 0.2 /s", fontsize=11)
    panels[0].set_ylabel(STRESS)
    thelma = [mark("Thelma, width free", **PLUS, color="black")] if found.program else []
    kinds = [line("width free, predicted", color=GREY), line("width held, predicted", linestyle=DASHED, linewidth=0.9)]
    panels[1].legend(handles=[line(f"{kV} kV over {model.THICKNESS:g} mm (assumed)" if kV else "without voltage",
                                   color=color) for color, kV in zip(COLORS, (0, 6))]
                     + [*kinds, mark(f"measured, {data.MEHNERT.short}", marker="o"), *thelma], frameon=False)
    plotting.save(figure, path)


def draw(found, tables, folder):
    """All of them; their names."""
    rates(found, folder / "experiments_rates.png")
    temperature(found, tables, folder / "experiments_temperature.png")
    relaxation(found, tables, folder / "experiments_relaxation.png")
    field(found, folder / "experiments_field.png")
