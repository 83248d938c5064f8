"""Figures 5, 8 and 11 of the paper and a map of temperatures: deformed shapes."""

from dataclasses import dataclass

from thelma import bending_exact
import numpy as np
from thelma import plotting
from thelma import study
from figures import bodies, render
from thelma.plotting import matplotlib, plt

WIDTH, LENGTH, LAYER, PUMP = 4.0, 20.0, 0.5, 1.0  # mm, of the scenes
DEFLECTION = matplotlib.colormaps["viridis"]
BOTH_WAYS = matplotlib.colormaps["PuOr_r"]
POTENTIAL = matplotlib.colormaps["cividis"]
FROM_THE_SIDE = (0.35, 1.0, 0.32), (1, 0, 0)  # x3 to the right, x1 upwards


@dataclass
class State:
    """The last state of a case."""

    case: study.Case
    row: dict  # last row of curve.csv
    body: bodies.Body


def load_states(folder, width=None):
    """The states of a study by the swept load."""
    states = []
    for case in study.read_study(folder):
        table = case.curve("e", "voltage_kV")
        row = {name: values[-1] for name, values in table.items()}
        states.append(State(case, row, bodies.load(case.directory, width)))
    if not states:
        raise study.StudyError(f"{folder}/study.csv has no case.")
    return states


def limits(states, name, symmetric=False):
    """Range of a field over several states."""
    low, high = bodies.Body.span([state.body for state in states], name)
    return (-max(-low, high), max(-low, high)) if symmetric else (low, high)


def sheet(rows, titles, row_titles=None, pixels_per_inch=160):
    """Pictures on a common scale in rows and columns, with room for a colour bar on the right."""
    widths = [max(row[i].shape[1] for row in rows) for i in range(len(rows[0]))]
    heights = [max(picture.shape[0] for picture in row) for row in rows]
    size = ((sum(widths) + 150) / pixels_per_inch, sum(heights) / pixels_per_inch
            + 0.35 * len(rows))
    figure = plt.figure(figsize=size, constrained_layout=True)
    axes = figure.subplots(len(rows), len(widths), squeeze=False, gridspec_kw={
        "width_ratios": widths, "height_ratios": heights})
    for line, pictures, names in zip(axes, rows, titles):
        for panel, picture, name in zip(line, pictures, names):
            height, width = picture.shape[:2]
            panel.imshow(picture, interpolation="lanczos")
            column, row = widths[list(line).index(panel)], max(p.shape[0] for p in pictures)
            panel.set_xlim((width - column) / 2, (width + column) / 2)
            panel.set_ylim(height, height - row)
            panel.axis("off")
            panel.set_title(name, fontsize=10)
    for line, name in zip(axes, row_titles or []):
        line[0].text(-0.02, 0.5, name, transform=line[0].transAxes, rotation=90, ha="right",
                     va="center", fontsize=10)
    return figure, axes


def bar(figure, axes, colormap, scale, label, **options):
    """The scalar bar of some panels."""
    values = matplotlib.cm.ScalarMappable(matplotlib.colors.Normalize(*scale), colormap)
    shown = figure.colorbar(values, ax=axes, label=label, aspect=25, pad=0.02,
                            **{"shrink": 0.8, **options})
    shown.ax.minorticks_off()
    return shown


def planar(folder, path):
    """Figure 5: the film before pull-in, with its outline before."""
    state = load_states(folder / "figures/planar_actuator")[0]
    pictures, scales = [], []
    with render.display():
        for name, colormap, direction in (("u3", DEFLECTION, (1.0, -1.2, 0.75)),
                                          ("phi", POTENTIAL, (1, 0, 0))):
            scene = render.Scene(np.array(direction) / np.linalg.norm(direction), (0, 0, 1))
            scales.append(limits([state], name))
            scene.add_body(state.body, name, colormap, scales[-1])
            scene.add_edges(state.body.grid(deformed=False), 1.0, 1.6, 30, color=(0.6, 0.6, 0.6))
            pictures.append(scene.picture(85))
    figure, axes = sheet([pictures], [["(a)", r"(b)  in the $x_2$-$x_3$ plane"]])
    bar(figure, axes[0, 0], DEFLECTION, scales[0], r"$u_3$  (mm)", location="bottom")
    bar(figure, axes[0, 1], POTENTIAL, scales[1], r"$\phi$  (kV)", location="bottom")
    plotting.save(figure, path)


def circle_line(state, length=LENGTH):
    """The exact interface on the near side of the bending actuator."""
    material, theta = state.case.material(), state.row["theta_K"]
    e = bending_exact.circles(material, theta, [state.row["e"]])[0]
    s = np.linspace(0, length / LAYER, 200)
    radius = e.stretch / e.curvature
    x1 = LAYER * (1 + radius * (1 - np.cos(e.curvature * s)))
    x3 = LAYER * radius * np.sin(e.curvature * s)
    return np.column_stack([x1, np.full_like(s, WIDTH + 0.02), x3])


def bending(folder, path):
    """Figure 8: the bending actuator, with the exact circle."""
    rows = [load_states(folder / f"figures/{name}", WIDTH)
            for name in ("bending_actuator", "bending_actuator_plane")]
    scale = limits(rows[0] + rows[1], "u1")
    pictures = []
    with render.display():
        for states, edges in zip(rows, (render.EDGES, render.NO_EDGES)):
            pictures.append([])
            for state in states:
                scene = render.Scene(*FROM_THE_SIDE)
                scene.add_body(state.body, "u1", DEFLECTION, scale, edges)
                if not edges:
                    scene.add_edges(state.body.grid(), 0.6, feature_angle=50)
                scene.add_polyline(circle_line(state), (0.85, 0.1, 0.1))
                pictures[-1].append(scene.picture(22))
    titles = [[f"$e = {state.row['e']:g}$,  {state.row['end_rotation_deg']:.0f}°"
               for state in states] for states in rows]
    figure, axes = sheet(pictures, titles, ["paper's mesh and element", "converged"])
    bar(figure, axes, DEFLECTION, scale, r"$u_1$  (mm)")
    plotting.save(figure, path)


def whole(quarter):
    """The layer of which a quarter was computed; its symmetry planes are its far ends."""
    half = bodies.together(quarter, quarter.mirrored(1, quarter.points[:, 1].max()))
    return bodies.together(half, half.mirrored(2, half.points[:, 2].max()))


def two_layers(state):
    """Both layers of the pump. One that buckled inwards stands for its mirror image."""
    body = state.body
    if state.row["centre_u1_mm"] < 0:
        body = body.mirrored(0, PUMP / 2)
    return [body, body.mirrored(0)]


def pump_rows(folder):
    """Title -> states: the paper's element, then the converged one for every expansion."""
    rows = {r"paper's element, $\alpha = 0$": load_states(folder / "figures/buckling_pump")}
    for state in load_states(folder / "figures/buckling_pump_quarter"):
        state.body = whole(state.body)
        alpha = plotting.expansion_title(state.case.material().alpha).split(", ")[-1]
        rows.setdefault(f"converged, {alpha}", []).append(state)
    return rows


def pump(folder, path):
    """Figure 11: the buckling pump, in the paper's element and converged."""
    rows = pump_rows(folder)
    scale = limits(sum(rows.values(), []), "u1", symmetric=True)
    pictures, titles = [], []
    with render.display():
        for name, row in rows.items():
            pictures.append([])
            for state in row:
                scene = render.Scene(*FROM_THE_SIDE)
                for body in two_layers(state):
                    edges = render.NO_EDGES if "converged" in name else render.EDGES
                    scene.add_body(body, "u1", BOTH_WAYS, scale, edges)
                    if not edges:
                        scene.add_edges(body.grid(), 0.6, feature_angle=50)
                pictures[-1].append(scene.picture(14))
            titles.append([f"$e = {state.row['e']:.3g}$"
                           + (", last state" if state.case.exit_code else "") for state in row])
    figure, axes = sheet(pictures, titles, list(rows))
    bar(figure, axes, BOTH_WAYS, scale, r"$u_1$  (mm)")
    plotting.save(figure, path)


def heat(folder, path):
    """A temperature field across and along the bending actuator."""
    states = [load_states(folder / f"figures/{name}", WIDTH)[0]
              for name in ("bending_hot_face", "bending_hot_end")]
    scale = limits(states, "theta")
    pictures = []
    with render.display():
        for state in states:
            scene = render.Scene(*FROM_THE_SIDE)
            scene.add_body(state.body, "theta", plotting.COLD_TO_HOT, scale, render.NO_EDGES)
            scene.add_edges(state.body.grid(), 0.6, feature_angle=50)
            pictures.append(scene.picture(28))
    titles = [f"({name})  {text},  {state.row['voltage_kV']:.2f} kV" for name, text, state in
              zip("ab", ("heated across", "heated along"), states)]
    figure, axes = sheet([pictures], [titles])
    bar(figure, axes, plotting.COLD_TO_HOT, scale, r"$\theta$  (K)")
    plotting.save(figure, path)
