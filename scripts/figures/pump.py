"""Figure 10 of the paper: centre of the buckling pump."""

import numpy as np
from thelma import plotting
from figures import curves
from thelma.plotting import DASHED, LAST

LENGTH, THICKNESS = 20.0, 1.0  # mm, of prm/buckling_pump.prm
MEANING = [plotting.line("converged: Q2/P1, a quarter", marker="o", markersize=2.6),
           plotting.line("paper's mesh and element", linewidth=0.8),
           plotting.line("unstable", linestyle=DASHED),
           plotting.mark("last state before pull-in", **LAST),
           plotting.mark("buckling of a thin strip", marker="|", markersize=9)]


def thin_strip(material, theta):
    """Buckling field of a clamped strip with free width, doc/theory.md; None if heat alone does."""
    square = 2 * (np.pi * THICKNESS / LENGTH) ** 2
    square -= 6 * material.alpha * (theta - material.theta_0)
    return np.sqrt(material.factor(theta) * square) if square > 0 else None


def draw_curve(axes, curve, color, converged):
    """A computed curve in both panels of a column. A layer may buckle to either side."""
    deflection = np.abs(curve.value) / LENGTH
    style = {"marker": "o", "markersize": 2.6} if converged else {"linewidth": 0.8}
    for panel, (x, factor) in zip(axes, curve.abscissas()):
        plotting.by_stability(panel, x, deflection, curve.unstable, color=color,
                              zorder=3 if converged else 2, **style)
        if curve.stopped:
            panel.plot(x[-1], deflection[-1], color=color, zorder=5, **LAST)
        onset = thin_strip(curve.material, curve.theta)
        if converged and onset is not None:
            panel.plot(factor * onset, 0, "|", color=color, markersize=11, markeredgewidth=1.6,
                       clip_on=False, zorder=6)


def deflection(folder, path):
    """Figure 10."""
    studies = [curves.load_study(folder / f"studies/{name}", "centre_u1_mm")[0]
               for name in ("buckling_pump_quarter", "buckling_pump")]
    colors = plotting.temperature_colors([curve.theta for curve in studies[0] + studies[1]])
    groups = [curves.by_expansion(study) for study in studies]
    titles = [plotting.expansion_title(alpha) for alpha in groups[0]]
    figure, axes, strip = plotting.panels(titles, r"deflection of the centre  $|u_1|/L$")
    for column, alpha in enumerate(groups[0]):
        for group, converged in zip(groups, (True, False)):
            for curve in group.get(alpha, []):
                draw_curve(axes[:, column], curve, colors[curve.theta], converged)
    plotting.from_zero(axes)
    axes[0, 0].set_ylim(bottom=0)
    plotting.legends(strip, colors, MEANING)
    plotting.save(figure, path)
