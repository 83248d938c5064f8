"""Bodies that remember: relaxation, pull-in by rate and by delay, a bending actuator that creeps."""

from thelma import bending_exact
from thelma import creeping_exact
import numpy as np
from thelma import plotting
from thelma import study
from thelma import viscoelastic_exact as exact
from figures import shapes
from thelma.plotting import COMPUTED, DASHED, GREY, LAST, plt

FIELD_LABEL = r"nominal field  $E\,\sqrt{\varepsilon/G}$"
STRESS_LABEL = "nominal stress  (kPa)"
TIME_LABEL = r"time  $t$  (s)"
UNIT_VOLTAGE = np.sqrt(1e-3 * exact.G_VHB / 4.25e-5)  # kV on a millimetre of VHB 4910
SPACING = 0.05  # of marks
METHOD = "LSODA"  # of the exact histories, whose times differ by decades from their time constants


def cases(folder, name, *columns):
    """The cases of a study that left a curve, with it."""
    return [(case, case.curve("time_s", *columns)) for case in study.read_study(folder / f"figures/{name}")
            if (case.directory / "curve.csv").is_file()]


def in_time(table):
    """The rows after time 0."""
    return {name: values[table["time_s"] > 0] for name, values in table.items() if name != "event"}


def colors_of(number):
    """A colour for each of them in their order."""
    return [plotting.COLD_TO_HOT(i / max(number - 1, 1)) for i in range(number)]


def marks(axes, x, y, color, shown):
    """Computed states at these indices."""
    axes.plot(x[shown], y[shown], linestyle="", color=color, zorder=4, **COMPUTED)


def over_time(axes, time, values, color, last=None):
    """Computed states over the logarithm of time, as far apart as they can be told."""
    kept = plotting.spaced(np.log10(time / time[0]), values / np.ptp(values), SPACING)
    if last:
        kept.pop()
        axes.plot(time[-1], values[-1], color=color, zorder=5, **last)
    marks(axes, time, values, color, kept)


def lettered(axes, *labels):
    """(a), (b), ... and what is along x and y."""
    for panel, name, (x, y) in zip(axes, "abc", labels):
        panel.set_title(f"({name})", loc="left", fontsize=11)
        panel.set_xlabel(x)
        panel.set_ylabel(y)


def peak_of(table):
    """Time and stretch of the peak, and whether the strip goes back."""
    stretch = table["lambda_1"]
    high = stretch > max(stretch) - 1e-6
    return table["time_s"][high][0], max(stretch), not high[-1]


def at_rest(film, stretch):
    """Stress when all branches have relaxed."""
    return exact.replace(film, branches=()).stress(np.log(stretch), np.zeros(0))


def cycle(axes, film, table, color):
    """Stress over stretch, to the peak and back."""
    time, peak, _ = peak_of(table)
    test = exact.uniaxial(film, (peak - 1) / time, peak, METHOD)
    fine = np.linspace(0, 2 * time, 201)
    axes.plot([test.stretch(t) for t in fine], [test.stress(t) for t in fine], color=color,
              label=f"{(peak - 1) / time:.2g} /s")
    within = table["time_s"] <= 2 * time * (1 + 1e-9)
    x, y = table["lambda_1"][within], 1e3 * table["reaction_f1_N"][within]
    way = np.cumsum(np.hypot(np.diff(x, prepend=1) / (peak - 1), np.diff(y, prepend=0) / max(y)))
    marks(axes, x, y, color, plotting.spaced(way, y, SPACING))


def hold(axes, film, table):
    """Stress over time, to the peak and held there."""
    time, peak, _ = peak_of(table)
    t, stress = table["time_s"], 1e3 * table["reaction_f1_N"]
    test = exact.stretched(film, (0, time, t[-1]), (1, peak, peak), METHOD)
    fine = np.unique(np.append(np.geomspace(1, t[-1], 150), time))
    axes.plot(fine, [test.stress(one) for one in fine], color=GREY)
    over_time(axes, t[t > 1], stress[t > 1], GREY)
    axes.axhline(at_rest(film, peak), color=GREY, linestyle=DASHED, linewidth=1.0)
    axes.set_xscale("log")
    axes.set_xlim(1, t[-1])


def relaxation(folder, path):
    """Cycles of a strip, and its stress while it is held."""
    figure, axes = plt.subplots(1, 2, figsize=(8.2, 3.7), constrained_layout=True)
    film = exact.vhb(5.85, K=exact.STIFF)
    tables = [in_time(table) for _, table in cases(folder, "relaxation", "lambda_1", "reaction_f1_N")]
    cycles = [table for table in tables if peak_of(table)[2]]
    for table, color in zip(cycles, colors_of(len(cycles))[::-1]):
        cycle(axes[0], film, table, color)
    for table in tables:
        if not peak_of(table)[2]:
            hold(axes[1], film, table)
    fine = np.linspace(1, axes[0].dataLim.x1, 100)
    axes[0].plot(fine, [at_rest(film, one) for one in fine], color=GREY, linestyle=DASHED, zorder=1,
                 label="equilibrium")
    lettered(axes, (r"stretch  $\lambda_1$", STRESS_LABEL), (TIME_LABEL, STRESS_LABEL))
    axes[0].legend(frameon=False, loc="upper left")
    axes[1].legend(handles=[plotting.line("exact"), plotting.mark("computed", **COMPUTED),
                            plotting.line("equilibrium", linestyle=DASHED)], frameon=False, loc="upper right")
    plotting.save(figure, path)


def charged(history):
    """Times, nominal fields and thickness stretches along an exact history."""
    parts = np.concatenate([[0], np.geomspace(1e-7, 1e-2, 100), np.linspace(0.012, 1, 300)])
    values = history.path(parts * history.end)
    x = np.array([history.film.stretches(y)[0] for y in values[1:1 + history.film.basis.shape[1]].T])
    fields = np.array([np.sqrt(history.load(t)[0] / history.film.eps) for t in values[0]])
    return values[0], fields, np.exp(x)


def pull_in_rate(folder, path):
    """Thickness over field, and the field at pull-in over the rate."""
    figure, axes = plt.subplots(1, 2, figsize=(8.2, 3.7), constrained_layout=True)
    film, unit = exact.vhb(K=exact.STIFF), np.sqrt(exact.G_VHB)
    found = cases(folder, "pull_in_rate", "voltage_kV", "lambda_3")
    rates = []
    for (_, table), color in zip(found, colors_of(len(found))):
        later = in_time(table)
        field, thickness = later["voltage_kV"] / UNIT_VOLTAGE, later["lambda_3"]
        rates.append(field[-1] / later["time_s"][-1])
        _, fields, stretches = charged(exact.ramped(film, rates[-1] * unit, method=METHOD))
        axes[0].plot(fields / unit, stretches, color=color, label=f"{float(f'{rates[-1]:.2g}'):g} /s")
        shown = plotting.spaced(field, 2 * thickness, 0.07)
        marks(axes[0], field, thickness, color, shown[:-1])
        axes[0].plot(field[-1], thickness[-1], color=color, zorder=5, **LAST)
        axes[1].plot(rates[-1], field[-1], color=color, zorder=5, **LAST)
    along = np.geomspace(min(rates) / 30, max(rates) * 3, 36)
    axes[1].plot(along, [exact.ramped(film, rate * unit, method=METHOD).field / unit for rate in along],
                 color=GREY, zorder=2)
    for limit, name, at, align in ((exact.equilibrium_limit(film), "equilibrium", -1, "right"),
                                   (exact.instantaneous_limit(film), "instantaneous", 0, "left")):
        axes[1].axhline(limit.field / unit, color=GREY, linestyle=DASHED, linewidth=1.0)
        axes[1].annotate(f"{name}, {limit.field / unit:.4f}", (along[at], limit.field / unit),
                         (-6 if at else 6, 4), textcoords="offset points", ha=align, fontsize=9, color=GREY)
    axes[1].set_xscale("log")
    axes[1].set_xlim(along[0], along[-1])
    axes[1].set_ylim(0.6, 1.65)
    axes[0].set_xlim(left=0)
    lettered(axes, (FIELD_LABEL, r"thickness stretch  $\lambda_3$"),
             (r"rate of the field  (s$^{-1}$)", "field at pull-in"))
    axes[0].legend(frameon=False, loc="lower left", title="rate")
    axes[1].legend(handles=[plotting.line("exact"), plotting.mark("computed pull-in", **LAST)], frameon=False,
                   loc="center right")
    plotting.save(figure, path)


def delayed_pull_in(folder, path):
    """Thickness over time under fields that are held."""
    figure, axes = plt.subplots(figsize=(5.6, 3.9), constrained_layout=True)
    film = exact.unit_film(K=1e3)
    found = cases(folder, "delayed_pull_in", "e", "lambda_3")
    for (_, table), color in zip(found, colors_of(len(found))):
        later, field = in_time(table), table["e"][-1]
        history = exact.held(film, field, later["time_s"][-1] * 1.1, METHOD)
        time, _, stretches = charged(history)
        axes.plot(time[1:], stretches[1:], color=color,
                  label=f"{field / exact.UNIT_FIELD:.3g}" + ("" if history.pulled_in else ", rests"))
        late = later["time_s"] > 1e-3
        over_time(axes, later["time_s"][late], later["lambda_3"][late], color,
                  LAST if history.pulled_in else None)
    axes.set_xscale("log")
    axes.set_xlim(1e-3, 100)
    axes.set_xlabel(r"time  $t/\tau$")
    axes.set_ylabel(r"thickness stretch  $\lambda_3$")
    shown = axes.legend(frameon=False, loc="lower left", title=r"field over that of equilibrium")
    axes.add_artist(shown)
    axes.legend(handles=[plotting.line("exact"), plotting.mark("computed", **COMPUTED),
                         plotting.mark("pull-in", **LAST)], frameon=False, loc="upper right")
    plotting.save(figure, path)


def creeping(folder, path):
    """Rotation of mid-length over time, and over time by the shift, between sudden state and rest."""
    figure, axes = plt.subplots(1, 2, figsize=(8.2, 3.9), constrained_layout=True)
    found = cases(folder, "creeping_bending_actuator", "theta_K", "mid_rotation_deg", "e")
    colors = plotting.temperature_colors([float(table["theta_K"][0]) for _, table in found])
    half = shapes.LENGTH / shapes.LAYER / 2
    for case, table in found:
        theta, e, later = float(table["theta_K"][0]), table["e"][-1], in_time(table)
        material, time, turn = case.material(), later["time_s"], later["mid_rotation_deg"]
        fine = np.geomspace(time[0], time[-1], 120)
        states = creeping_exact.creep(material, theta, creeping_exact.BRANCHES, e, np.append(0, fine))
        exact_turn = np.array([state.rotation(half) for state in states])
        rest = bending_exact.circles(material, theta, [e])[0].rotation(half)
        shift = creeping_exact.BRANCHES[0].tau(theta) / creeping_exact.BRANCHES[0].tau(293.0)
        for panel, factor, start, over in ((axes[0], 1, 0, 1), (axes[1], shift, exact_turn[0], rest - exact_turn[0])):
            panel.plot(fine / factor, (exact_turn[1:] - start) / over, color=colors[theta], zorder=2)
            over_time(panel, time / factor, (turn - start) / over, colors[theta])
    lettered(axes, (TIME_LABEL, "rotation at mid-length  (°)"),
             (r"time by the shift  $t/a_T$  (s)", "creep, part of the whole"))
    for panel in axes:
        panel.set_xscale("log")
        panel.set_xlim(1e-3, 1e4)
        panel.set_ylim(bottom=0)
    axes[0].legend(handles=plotting.temperature_handles(colors), frameon=False, loc="upper left",
                   title=r"temperature $\theta$")
    axes[1].legend(handles=[plotting.line("exact circle"), plotting.mark("computed", **COMPUTED)], frameon=False,
                   loc="upper left")
    plotting.save(figure, path)
