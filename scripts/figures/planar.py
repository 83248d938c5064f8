"""Figures 2 and 4 of the paper: shear modulus, and thickness stretch of the planar actuator."""

import numpy as np
from thelma import planar_exact as exact
from thelma import plotting
from figures import curves
from thelma.plotting import COMPUTED, DASHED, LAST, plt

PAST_LIMIT = 0.13  # how far below the lambda_3 of the limit point the unstable branch is drawn
MEANING = [plotting.line("exact, stable"),
           plotting.line("exact, unstable", linestyle=DASHED),
           plotting.mark("computed", **COMPUTED),
           plotting.mark("computed, last before pull-in", **LAST)]


def draw_curve(axes, curve, color, x, factor):
    """Exact branches behind, computed points on top; factor maps e to the axis."""
    material, theta = curve.material, curve.theta
    limit = exact.limit_point(material, theta)
    start = float(exact.free_expansion(material, theta))
    # Equal steps in sqrt(start - lambda_3) resolve the rise from e = 0.
    stable = start - np.linspace(0, np.sqrt(start - limit.lambda_3), 300) ** 2
    unstable = np.linspace(limit.lambda_3, limit.lambda_3 - PAST_LIMIT, 100)
    for branch, style in ((stable, "-"), (unstable, DASHED)):
        field = exact.curve(material, theta, branch)[1]
        axes.plot(factor * material.e(field, theta), branch, linestyle=style, color=color,
                  zorder=2)
    shown = plotting.spaced(x, 2 * curve.value, 0.06)
    if curve.pulled_in:
        shown.pop()
        axes.plot(x[-1], curve.value[-1], color=color, zorder=5, **LAST)
    axes.plot(x[shown], curve.value[shown], linestyle="", color=color, zorder=4, **COMPUTED)
    plotting.by_stability(axes, x, curve.value, curve.unstable, linestyle="", color=color, zorder=3)


def shear_modulus(folder, path):
    """Figure 2."""
    results, _ = curves.load_study(folder / "studies/planar_actuator", "lambda_3")
    material = results[0].material
    colors = plotting.temperature_colors([curve.theta for curve in results])
    theta = np.linspace(min(colors) - 8, max(colors) + 8, 200)
    figure, axes = plt.subplots(figsize=(4.6, 3.5), constrained_layout=True)
    modulus = material.mu(theta)
    axes.plot(theta, 1e3 * modulus, color=plotting.GREY, label=r"$\mu(\theta)$")
    axes.plot(theta, 1e3 * modulus * material.factor(theta), color=plotting.GREY,
              linestyle=DASHED, label=r"$(\theta/\theta_0)\,\mu(\theta)$, stiffness of the film")
    for value, color in colors.items():
        axes.plot(value, 1e3 * material.mu(value), "o", color=color, markersize=7, zorder=3)
    axes.set_xlabel(r"temperature  $\theta$  (K)")
    axes.set_ylabel(r"shear modulus  (kPa)")
    axes.set_ylim(bottom=0)
    axes.legend(frameon=False, loc="upper right")
    plotting.save(figure, path)


def pull_in(results, path):
    """The picture of scripts/run: against e and against kV, side by side."""
    colors = plotting.temperature_colors([curve.theta for curve in results])
    figure, axes = plt.subplots(1, 2, figsize=(8.2, 3.9), sharey=True, constrained_layout=True)
    for curve in results:
        for panel, (x, factor) in zip(axes, curve.abscissas()):
            draw_curve(panel, curve, colors[curve.theta], x, factor)
    for panel, name, label in zip(axes, ("(a)", "(b)"),
                                  (plotting.FIELD_LABEL, plotting.VOLTAGE_LABEL)):
        panel.set_xlim(left=0)
        panel.set_xlabel(label)
        panel.text(0.97, 0.96, name, transform=panel.transAxes, ha="right", va="top", fontsize=11)
    axes[0].set_ylabel(r"thickness stretch  $\lambda_3$")
    axes[0].legend(handles=plotting.temperature_handles(colors), loc="lower left", frameon=False,
                   title=r"temperature $\theta$")
    axes[1].legend(handles=MEANING, loc="lower left", frameon=False)
    figure.align_xlabels(axes)
    plotting.save(figure, path)


def stretch(folder, path):
    """Figure 4."""
    draw_study(curves.load_study(folder / "studies/planar_actuator", "lambda_3")[0], path)


def draw_study(results, path):
    """A column for every thermal expansion in the study."""
    groups = curves.by_expansion(results)
    colors = plotting.temperature_colors([curve.theta for curve in results])
    titles = [plotting.expansion_title(alpha) for alpha in groups]
    figure, axes, strip = plotting.panels(titles, r"thickness stretch  $\lambda_3$")
    for column, group in enumerate(groups.values()):
        for curve in group:
            for row, (x, factor) in enumerate(curve.abscissas()):
                draw_curve(axes[row, column], curve, colors[curve.theta], x, factor)
    plotting.from_zero(axes)
    plotting.legends(strip, colors, MEANING)
    plotting.save(figure, path)
