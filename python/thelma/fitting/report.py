"""What a fit leaves: parameters.csv, stresses.csv, the fitted scene, the material's section and a figure."""

import csv

import numpy as np

from thelma.fitting.fit import CONFIDENCE, residuals


def number(value):
    """Six digits."""
    return f"{value:.6g}"


def table(fit):
    """The parameters and how well the tests agree, as text."""
    rows = [("parameter", "value", f"{100 * CONFIDENCE:g} % from", "to", "unit")]
    rows += [(one.name, number(value), number(low), number(high), one.unit)
             for one, value, low, high in zip(fit.parameters, fit.values, fit.low, fit.high)]
    widths = [max(len(row[i]) for row in rows) for i in range(len(rows[0]))]
    lines = ["  ".join(cell.ljust(width) for cell, width in zip(row, widths)).rstrip() for row in rows]
    lines += ["", f"root mean square of the residuals, of the largest stress of each test: {100 * fit.rms:.3g} %"]
    if len(fit.tests) > 1:
        lines += [f"  {test.label}: {100 * fit.rms_of(i):.3g} %" for i, test in enumerate(fit.tests)]
    if fit.undetermined:
        lines.append(f"warning: the tests do not determine {', '.join(fit.undetermined)}; free fewer parameters, or "
                     "add tests that tell them apart")
    return "\n".join(lines) + "\n"


def write(fit, folder):
    """All files."""
    folder.mkdir(parents=True, exist_ok=True)
    with open(folder / "parameters.csv", "w", newline="", encoding="utf8") as file:
        writer = csv.writer(file)
        writer.writerow(("parameter", "value", "low", "high", "unit"))
        writer.writerows((one.name, repr(float(value)), repr(float(low)), repr(float(high)), one.unit)
                         for one, value, low, high in zip(fit.parameters, fit.values, fit.low, fit.high))
    with open(folder / "stresses.csv", "w", newline="", encoding="utf8") as file:
        writer = csv.writer(file)
        writer.writerow(("test", "mode", "stretch", "measured", "fitted", "unit"))
        for test, stresses in zip(fit.tests, fit.stresses):
            for stretch, measured, value in zip(test.columns["stretch"], test.stress, stresses):
                writer.writerow((test.name, test.mode, stretch, measured if np.isfinite(measured) else "",
                                 repr(value), test.units["stress"]))
    (folder / "scene.prm").write_text(str(fit.fitted_scene()), encoding="utf8")
    (folder / "material.prm").write_text(fit.section(), encoding="utf8")
    (folder / "parameters.txt").write_text(table(fit), encoding="utf8")
    draw(fit, folder / "fit.png")


def rests(test):
    """Whether most stresses were measured at a stretch that was held."""
    stretch = test.columns["stretch"][test.measured]
    return "time" in test.columns and len(set(stretch)) <= len(stretch) / 2


def draw(fit, path):
    """Stresses above and residuals below, against the stretch and, of tests at rest, against time."""
    from thelma import plotting  # pylint: disable=import-outside-toplevel  # slow
    plt = plotting.plt
    kinds = [kind for kind in (False, True) if any(rests(test) == kind for test in fit.tests)]
    figure, axes = plt.subplots(2, len(kinds), figsize=(1 + 5.4 * len(kinds), 6.4), sharex="col", squeeze=False,
                                constrained_layout=True, gridspec_kw={"height_ratios": (2.2, 1)})
    errors = residuals(fit.tests, fit.stresses)
    for i, (test, stresses) in enumerate(zip(fit.tests, fit.stresses)):
        above, below = axes[:, kinds.index(rests(test))]
        color = plt.get_cmap("viridis")(i / max(1, len(fit.tests) - 1) * 0.9)
        x, measured = test.columns["time" if rests(test) else "stretch"], test.measured
        above.plot(x[measured], test.stress[measured], linestyle="", color=color, label=test.label,
                   **plotting.COMPUTED)
        above.plot(x, stresses, color=color)
        below.plot(x[measured], 100 * errors[i], color=color, linewidth=0.8, marker="o", markersize=2.5)
    for (above, below), kind in zip(axes.T, kinds):
        above.legend(frameon=False, title="points: measured, lines: fitted")
        below.axhline(0, color=plotting.GREY, linewidth=0.6)
        below.set_xlabel(f"time ({units(fit, 'time')})" if kind else r"stretch $\lambda$")
    axes[0, 0].set_ylabel(f"nominal stress ({units(fit, 'stress')})")
    axes[1, 0].set_ylabel("residual (% of largest stress)")
    plotting.save(figure, path)


def units(fit, column):
    """Of a column in the tests that have it."""
    return ", ".join(sorted({test.units[column] for test in fit.tests if column in test.units}))
