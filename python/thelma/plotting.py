"""What all pictures share: fonts, colours, legends, files."""

import io
from pathlib import Path

from thelma import interpreter

interpreter.require("matplotlib", "numpy")

import matplotlib  # noqa: E402
import numpy as np  # noqa: E402
from thelma import stability  # noqa: E402
from thelma.errors import ThelmaError  # noqa: E402

matplotlib.use("Agg")
import matplotlib.pyplot as plt  # noqa: E402
from matplotlib.colors import LinearSegmentedColormap  # noqa: E402
from matplotlib.lines import Line2D  # noqa: E402

STYLE = {
    "font.family": "serif", "font.serif": ["STIXGeneral", "DejaVu Serif"],
    "mathtext.fontset": "stix", "font.size": 10, "axes.labelsize": 12, "legend.fontsize": 9,
    "axes.linewidth": 0.8, "xtick.direction": "in", "ytick.direction": "in",
    "xtick.top": True, "ytick.right": True, "xtick.minor.visible": True,
    "ytick.minor.visible": True, "lines.linewidth": 1.3,
}
plt.rcParams.update(STYLE)

# Dark is cold, bright is hot; readable without red and green, and on paper.
COLD_TO_HOT = LinearSegmentedColormap.from_list(
    "cold to hot", matplotlib.colormaps["plasma"](np.linspace(0.0, 0.86, 256)))
DASHED = (0, (3.5, 2))
GREY = "0.25"
FIELD_LABEL = r"nominal field  $e = E\,\sqrt{\varepsilon/\mu(\theta)}$"
VOLTAGE_LABEL = r"voltage  $V$  (kV)"
COMPUTED = {"marker": "o", "markersize": 3.8, "markerfacecolor": "white", "markeredgewidth": 0.9}
LAST = {"marker": "x", "markersize": 6, "markeredgewidth": 1.6}


class PlotError(ThelmaError):
    """One sentence for the user."""


def temperature_colors(temperatures):
    """A colour per temperature, cold to hot."""
    low, high = min(temperatures), max(temperatures)
    return {theta: COLD_TO_HOT((theta - low) / (high - low) if high > low else 0.0)
            for theta in temperatures}


def temperature_handles(colors):
    """Legend entries of the temperatures."""
    return [Line2D([], [], color=color, label=f"{theta:g} K", linewidth=2)
            for theta, color in sorted(colors.items())]


def line(label, **style):
    """A legend entry in grey: what a kind of line or mark means."""
    return Line2D([], [], **{"color": GREY, "label": label, **style})


def mark(label, **style):
    """A legend entry of a mark without a line."""
    return line(label, linestyle="", **style)


def expansion_title(alpha):
    """Heading of what was computed with a thermal expansion."""
    if alpha == 0:
        return r"without thermal expansion, $\alpha = 0$"
    digits, exponent = f"{alpha:.1e}".split("e")
    return rf"$\alpha = {digits}\times 10^{{{int(exponent)}}}\ \mathrm{{K}}^{{-1}}$"


def panels(titles, ylabel):
    """Against e above and kV below, a column per title, and an empty strip for legends below."""
    figure = plt.figure(figsize=(4.1 * len(titles), 6.9), constrained_layout=True)
    grid = figure.add_gridspec(3, len(titles), height_ratios=[1, 1, 0.2])
    first = figure.add_subplot(grid[0, 0])
    axes = np.empty((2, len(titles)), dtype=object)
    for row, column in np.ndindex(axes.shape):
        axes[row, column] = first if row == column == 0 else figure.add_subplot(
            grid[row, column], sharey=first)
        axes[row, column].set_xlabel((FIELD_LABEL, VOLTAGE_LABEL)[row])
        axes[row, column].set_ylabel(ylabel if column == 0 else "")
        axes[row, column].tick_params(labelleft=column == 0)
        name = f"({'abcdefgh'[row * len(titles) + column]})"
        axes[row, column].set_title(name, loc="left", fontsize=11)
    for panel, title in zip(axes[0], titles):
        panel.set_title(title, fontsize=11)
    strip = figure.add_subplot(grid[2, :])
    strip.axis("off")
    figure.set_constrained_layout_pads(wspace=0.03)
    return figure, axes, strip


def from_zero(axes):
    """The same horizontal axis from zero in all panels of a row."""
    for row in axes:
        right = max(panel.get_xlim()[1] for panel in row)
        for panel in row:
            panel.set_xlim(0, right)


def legends(strip, colors, meaning):
    """Temperatures on the left of the strip, the meaning of lines and marks on the right."""
    left = strip.legend(handles=temperature_handles(colors), loc="center left", frameon=False,
                        ncol=3, title=r"temperature $\theta$")
    strip.add_artist(left)
    strip.legend(handles=meaning, loc="center right", frameon=False, ncol=2)


def by_stability(axes, x, y, pieces, linestyle="-", **style):
    """A curve whose unstable pieces (stability.unstable_pieces) are dashed; `linestyle` is that of
    the stable ones. A marker stands at every point all the same."""
    marker = {name: style.pop(name) for name in list(style) if name.startswith("marker")}
    for first, last, unstable in stability.parts(pieces):
        if unstable or linestyle:
            axes.plot(x[first:last + 1], y[first:last + 1], **style,
                      linestyle=DASHED if unstable else linestyle)
    if marker:
        axes.plot(x, y, **{**style, "linestyle": "", **marker})


def spaced(x, y, distance):
    """Indices of points at least `distance` apart in the unit square; the last one always."""
    unit = np.column_stack([values / max(np.max(np.abs(values)), 1e-300) for values in (x, y)])
    kept = [len(x) - 1]
    for i in range(len(x) - 2, -1, -1):
        if np.hypot(*(unit[i] - unit[kept[-1]])) >= distance:
            kept.append(i)
    return kept[::-1]


def save(figure, path, dpi=160):
    """A PNG of 256 colours, which is a third of the size; the first pixel stays white."""
    buffer = io.BytesIO()
    figure.savefig(buffer, dpi=dpi)
    plt.close(figure)
    from PIL import Image  # matplotlib brings it along
    picture = Image.open(buffer).convert("RGB")
    few = picture.quantize(256)
    picture = picture.quantize(palette=few, dither=Image.Dither.FLOYDSTEINBERG)
    background, colors = picture.getpixel((0, 0)), picture.getpalette()
    colors[3 * background:3 * background + 3] = [255, 255, 255]
    picture.putpalette(colors)
    path.parent.mkdir(parents=True, exist_ok=True)
    picture.save(path, optimize=True)
