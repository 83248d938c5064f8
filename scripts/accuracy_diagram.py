"""Draws error against seconds: a panel per goal, a line per element and model, a mark per mesh."""

import matplotlib

from accuracy_cases import PEER_PROGRAMS, PEER_TO, PEERS
from accuracy_report import TIME_BARS, solved
from accuracy_table import families, select

matplotlib.use("Agg")
import matplotlib.pyplot as plt  # noqa: E402
from matplotlib.lines import Line2D  # noqa: E402

STYLE = {
    "font.family": "serif", "font.serif": ["STIXGeneral", "DejaVu Serif"],
    "mathtext.fontset": "stix", "font.size": 10, "axes.labelsize": 12, "legend.fontsize": 9,
    "axes.linewidth": 0.8, "xtick.direction": "in", "ytick.direction": "in",
    "xtick.top": True, "ytick.right": True, "lines.linewidth": 1.2,
}
PANELS = ((r"bending: tip, $e = 0.475$", "bending", 0.475),
          (r"bending: rotation, $e = 0.87$", "bending", 0.87),
          (r"pump: deflection, $e = 0.5$", "pump", 0.5))
COLORS = ("#b3202c", "#1f4e9c", "#5a9a5f", "#dd9025", "#7a4ea0", "#3f93bd")
MARKS = "osD^vP"
DASHED = (0, (3.5, 2))


def styles(rows):
    """Colour and mark by formulation, in the order of the rows."""
    names = list(dict.fromkeys(row.formulation for row in rows))
    return {name: (COLORS[i % len(COLORS)], MARKS[i % len(MARKS)])
            for i, name in enumerate(sorted(names))}


def draw_panel(axes, rows, style):
    """Families: full marks are quadratic, empty ones linear; broken lines the whole body."""
    for (_, model, formulation, degree, _), family in families(rows).items():
        reached = [row for row in family if row.relative_error]
        color, mark = style[formulation]
        axes.plot([row.solve_seconds for row in reached], [row.error for row in reached],
                  color=color, linestyle=DASHED if model == "3-D" else "-", marker=mark,
                  markersize=5, markeredgewidth=1, markeredgecolor=color,
                  markerfacecolor=color if degree == 2 else "white", zorder=3)
    axes.set_xscale("log")
    axes.set_yscale("log")
    axes.grid(True, which="major", color="0.92", linewidth=0.6, zorder=0)


def draw_bars(axes, e):
    """Corners that the requirements leave: below an error within so many seconds."""
    for field, error, seconds in TIME_BARS:
        if field == e:
            low, left = axes.get_ylim()[0], axes.get_xlim()[0]
            axes.plot([left, seconds, seconds], [error, error, low], color="0.6", linewidth=0.9,
                      linestyle=":", zorder=1, scalex=False, scaley=False)


def draw_peers(axes, rows):
    """The peer's runs here, or what it published."""
    measured = select(rows, program=PEER_PROGRAMS[0])
    points = ([(row.solve_seconds, row.error) for row in measured] or
              [(min(peer.seconds), peer.error) for peer in PEERS.values()])
    axes.plot(*zip(*points), "*", color="0.35", markersize=9, markeredgewidth=0, zorder=2)


def legend(figure, style):
    """What colours, marks and lines mean, below the panels."""
    grey = "0.25"
    handles = [Line2D([], [], color=color, marker=mark, markersize=5, label=name)
               for name, (color, mark) in style.items()]
    handles += [
        Line2D([], [], color=grey, marker="o", linestyle="", markersize=5, label="degree 2"),
        Line2D([], [], color=grey, marker="o", linestyle="", markersize=5,
               markerfacecolor="white", label="degree 1"),
        Line2D([], [], color=grey, label="plane, quarter"),
        Line2D([], [], color=grey, linestyle=DASHED, label="3-D"),
        Line2D([], [], color="0.35", marker="*", linestyle="", markersize=9,
               markeredgewidth=0, label="peer, 3-D"),
        Line2D([], [], color="0.6", linestyle=":", label="required"),
    ]
    figure.legend(handles=handles, loc="lower center", ncol=5, frameon=False)


def draw(rows, path):
    """One rank; the seconds of the whole load path."""
    plt.rcParams.update(STYLE)
    panels = [panel for panel in PANELS if solved(rows, *panel[1:])]
    figure, axes = plt.subplots(1, len(panels), figsize=(max(3.5 * len(panels), 8.5), 4.5),
                                squeeze=False)
    axes = axes[0]
    figure.subplots_adjust(left=0.07, right=0.985, top=0.93, bottom=0.29, wspace=0.22)
    style = styles(rows)
    for panel, (title, scene, e) in zip(axes, panels):
        draw_panel(panel, solved(rows, scene, e), style)
        if e == PEER_TO:
            draw_peers(panel, rows)
        draw_bars(panel, e)
        panel.set_title(title, fontsize=11)
        panel.set_xlabel("seconds")
    axes[0].set_ylabel("relative error")
    legend(figure, style)
    figure.savefig(path, dpi=200)
    plt.close(figure)
