"""Deformed shapes as PNG, drawn as scripts/plot draws them."""

import base64
import io
import re

import numpy as np
from thelma import plotting
from thelma.plotting import matplotlib

LARGEST, PIXELS = 9, 700  # pictures a page, pixels of the longest side
VIEW = (0.35, 1.0, 0.32), (1, 0, 0)  # x3 to the right, x1 upwards
FLAT_VIEW = (0.65, -0.65, 0.4), (0, 0, 1)  # of bodies that are thin along x3


UNITS = {"phi": "kV", "theta": "K", "J": "", "E": "kV/mm", "D": "µC/mm²", "P": "MPa"}


def of_runs(runs, chosen, at):
    """Label -> (PNG in base64, caption) for the runs that wrote fields, at most LARGEST of them, spread
    over the study. The colours are the field that is `chosen` or the largest displacement, the state
    is the written one nearest to the load or second `at` or the last."""
    shown = [run for run in runs if has_fields(run.case.directory)]
    if len(shown) > LARGEST:
        shown = [shown[i] for i in np.linspace(0, len(shown) - 1, LARGEST).round().astype(int)]
    if not shown:
        return {}
    from figures import bodies, render  # VTK is needed from here on
    from thelma.fields import state_file
    states = {run.label: bodies.load(run.case.directory, width(run), at) for run in shown}
    name = field(states.values(), chosen)
    scale = bodies.Body.span(states.values(), name)
    result = {}
    with render.display():
        for run in shown:
            result[run.label] = (encoded(picture(states[run.label], name, scale)),
                                 caption(run, state_file(run.case.directory, at), name, scale))
    return result


def has_fields(folder):
    """Whether there is a field file."""
    path = folder / "fields.pvd"
    return path.is_file() and 'file="' in path.read_text()


def width(run):
    """Of a body drawn from a plane: a fifth of the geometry's largest length."""
    entries = dict((entry, value) for entry, value, *_ in run.changed)
    lengths = [float(x) for x in re.findall(r"\bL\d?: ([\d.]+)", entries.get("Mesh/Parameters", ""))]
    return max(lengths) / 5 if lengths else None


def field(shown, chosen):
    """The field that is chosen or else the displacement component with the largest range, by name."""
    known = {"u1", "u2", "u3"}.union(*(body.fields for body in shown)) - {"u"}
    if chosen and chosen not in known:
        raise plotting.PlotError(f"there is no field '{chosen}'; known: {', '.join(sorted(known))}.")
    if chosen:
        return chosen
    ranges = [max(np.ptp(body.values(f"u{i}")) for body in shown) for i in (1, 2, 3)]
    return f"u{int(np.argmax(ranges)) + 1}"


def picture(body, name, scale):
    """An array of RGB: the deformed body and the outline of the undeformed one."""
    from figures import render
    size = np.ptp(np.concatenate([body.points, body.points + body.u]), axis=0)
    direction, up = FLAT_VIEW if size[2] < min(size[0], size[1]) else VIEW
    scene = render.Scene(np.array(direction) / np.linalg.norm(direction), up)
    scene.add_body(body, name, matplotlib.colormaps["viridis"], scale)
    scene.add_edges(body.grid(deformed=False), 1.0, 1.2, 30, color=(0.6, 0.6, 0.6))
    return scene.picture(PIXELS / float(np.linalg.norm(size)))


def encoded(pixels):
    """PNG in base64."""
    from PIL import Image  # matplotlib brings it along
    buffer = io.BytesIO()
    Image.fromarray(pixels).quantize(128).save(buffer, "PNG", optimize=True)
    return base64.b64encode(buffer.getvalue()).decode()


def caption(run, path, name, scale):
    """What the picture of a field file shows."""
    step = float(re.search(r"_(\d+)\.", path.name)[1])
    steps = run.columns.get("step", [])
    row = steps.index(step) if step in steps else -1
    last = {column: values[row] for column, values in run.columns.items() if values}
    parts = [f"{key} = {last[column]:.4g}{unit}" for column, key, unit in
             (("time_s", "t", " s"), ("e", "e", ""), ("voltage_kV", "V", " kV"))
             if isinstance(last.get(column), float)]
    of_vector = "magnitude of " if name in ("E", "D", "P") else ""
    unit = UNITS.get(name, "mm")
    return (f"{', '.join(parts)}; colours: {of_vector}{name} from {scale[0]:.3g} (dark) to "
            f"{scale[1]:.3g} {unit}".rstrip() + " (bright); grey: undeformed")
