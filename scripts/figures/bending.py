"""Figure 7 of the paper: tip of the bending actuator against the exact circle."""

from thelma import bending_exact
import numpy as np
from thelma import plotting
from figures import curves
from thelma.plotting import COMPUTED, DASHED

LENGTH, LAYER = 20.0, 0.5  # mm, of prm/bending_actuator.prm
MEANING = [plotting.line("exact circle"),
           plotting.mark("converged: Q2/P1, plane strain", **COMPUTED),
           plotting.line("paper's mesh and element", linewidth=0.8),
           plotting.mark("(against e: coldest and hottest)"),
           plotting.line("the same, unstable", linestyle=DASHED, linewidth=0.8)]


def draw_exact(axes, curve, color):
    """The exact tip in both panels of a column."""
    e = np.linspace(0, curve.e[-1], 240)
    states = bending_exact.circles(curve.material, curve.theta, e)
    tip = [LAYER * state.tip(LENGTH / LAYER) / LENGTH for state in states]
    for panel, (_, factor) in zip(axes, curve.abscissas()):
        panel.plot(factor * e, tip, color=color, alpha=0.75, linewidth=1.6, zorder=2)


def draw_converged(axes, curve, color):
    """Q2/P1 in both panels of a column."""
    tip = curve.value / LENGTH
    for panel, (x, _) in zip(axes, curve.abscissas()):
        shown = plotting.spaced(x, tip, 0.07)
        panel.plot(x[shown], tip[shown], linestyle="", color=color, zorder=4, **COMPUTED)
        plotting.by_stability(panel, x, tip, curve.unstable, linestyle="", color=color, linewidth=0.8)


def draw_paper(axes, group, colors):
    """The paper's element in both panels; against e all five would hide the others."""
    for curve in group:
        for panel, (x, _) in zip(axes, curve.abscissas()):
            if panel is axes[1] or curve in (group[0], group[-1]):
                plotting.by_stability(panel, x, curve.value / LENGTH, curve.unstable,
                                      linewidth=0.8, color=colors[curve.theta], zorder=3)


def deflection(folder, path):
    """Figure 7."""
    studies = [curves.load_study(folder / f"studies/{name}", "tip_u1_mm")[0]
               for name in ("bending_actuator_plane", "bending_actuator")]
    colors = plotting.temperature_colors([curve.theta for curve in studies[0] + studies[1]])
    groups = [curves.by_expansion(study) for study in studies]
    titles = [plotting.expansion_title(alpha) for alpha in groups[0]]
    figure, axes, strip = plotting.panels(titles, r"deflection of the tip  $u_1/L$")
    for column, alpha in enumerate(groups[0]):
        for curve in groups[0][alpha]:
            draw_exact(axes[:, column], curve, colors[curve.theta])
            draw_converged(axes[:, column], curve, colors[curve.theta])
        draw_paper(axes[:, column], groups[1].get(alpha, []), colors)
    plotting.from_zero(axes)
    plotting.legends(strip, colors, MEANING)
    plotting.save(figure, path)
