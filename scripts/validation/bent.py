"""Bilayers that bend into a circle, and columns: strips that buckle between smooth walls.

Tolerances, with a the length of a cell, H the thickness (of the thinner layer, the softest in bending), n cells
through it, k the curvature (of the circle, or of the buckling mode, pi/L). A quadratic element leaves out the
cubic part of the circle, k^2 s^3/6: a strain of 0.0373 (k a)^2, root mean square, whose energy is
(k a)^2 (a/H)^2/60 of that of bending:

    degree 2:         (k a)^2 (a/H)^2/60 + (k a)^4/180 + 9 (k h)^2/(60 n^2)
    enhanced strain:  (k a)^2/6 + (k a)^4, and 1/n^4 of linear strains through the thickness
    mean dilatation of degree 1:  2 [(a/H)^2/4 + 1/(2 n^2)] (doc/theory.md: its bending stiffness)

times the sensitivity d ln(result)/d ln(stiffness) of the state. The last term of degree 2 is what its n cells of
1/n mm leave out across 1 mm: there lambda_1 = 1/lambda_t = 1 - k s + 3/2 (k s)^2, of which the cubic part of x_1 is
three times that of the circle. The free end disturbs the circle by exp(-g x/H), g = 2 (soft layers on stiff ones), 4.2
and 7.5 (the first two of one material), of which quadratic cells have the rational approximation
(1 - z/2 + z^2/12)/(1 + z/2 + z^2/12), z = g a/H, each: long cells let the second through, 0.28 of it for
a = 1.25 mm. Standard elements lock and are not drawn here.
"""

from dataclasses import replace

import numpy as np

from validation import draw
from validation.layered import Layered, Solver
from validation.material import newton
from validation.scene import LAYERS, Case, Verdict
from validation.strip import Strip

ELEMENTS = ("enhanced strain", "mean dilatation", "selective reduced")


def tolerance(element, curvature, cell, thickness, through):
    """Relative error of a bending stiffness, as above."""
    ka, slender = abs(curvature) * cell, cell / thickness
    if element[1] == 2:
        return ka**2 * slender**2 / 60 + ka**4 / 180 + 9 * curvature**2 / through**4 / 60
    if element[0] == "enhanced strain":
        return ka**2 / 6 + ka**4 + through**-4
    return 2 * (slender**2 / 4 + 1 / (2 * through**2))


def end_effect(cell, cells):
    """What the free end leaves of a disturbance so many cells away, for a thickness of 1 mm."""
    z = np.array([2.0, 4.2, 7.5]) * cell
    return float(np.max(np.abs((1 - z / 2 + z**2 / 12) / (1 + z / 2 + z**2 / 12)))**cells)


def bilayer(rng, element):
    """Two layers, one of them charged, mostly heated, from no voltage to a large one."""
    if element[0] not in ELEMENTS:
        element = ("mean dilatation", 2)
    hot = rng.random() < 0.75
    theta = float(round(rng.uniform(273, 353))) if hot else 293.0
    a, b = (draw.material(rng).at(theta) for _ in range(2))
    if hot and rng.random() < 0.7:  # evenly expanding: the heated state hardly bends
        strain = draw.log_uniform(rng, 1e-5, 5e-3)
        a = replace(a, alpha=float(np.clip(strain / max(abs(theta - 293), 1), 1e-6, 3e-4)))
        b = replace(b, alpha=a.alpha)
    ha = float(round(rng.uniform(0.25, 0.75), 2))
    length, n3 = float(rng.choice([10.0, 16.0])), int(rng.choice([8, 12, 16, 20]))
    n = int(rng.choice([1, 2, 2])) if element[1] == 2 else 2
    e = draw.log_uniform(rng, 1e-4, 0.6) if rng.random() < 0.4 else float(rng.uniform(0.1, 0.6))
    if element[0] == "enhanced strain":  # which hourglasses beyond (doc/elements.md)
        e /= 3
    voltage = e * draw.of_one(a) * ha
    solver = Solver(Layered("bilayer", ((ha, a, True), (1 - ha, b, False))))
    rest, y = solver.path(0.0, 1), solver.path(voltage, 2 + int(20 * e))
    more = None if y is None else newton(lambda z: solver.residual(z, 1.01 * voltage), y)
    if more is None:
        return bilayer(rng, element)
    entries = {"Dimension": 2, "Regions/Passive": "b", "Temperature/Value": theta, "Loading/Control": "voltage",
               "Loading/Target": voltage, "Loading/Film thickness": ha, "Loading/Film material": "m0",
               "Stepping/Initial step": float(rng.choice([0.02, 0.05, 0.05, 0.1])),
               "Supports/Fixed": "root: u3, pin: u1", "Electrodes/Potential": "outer: 1, interface: 0",
               "Output/Observables": "mid_rotation", "Observables/mid_rotation/Section": length / 4}
    parameters = {"L": length, "ha": ha, "hb": 1 - ha, "na": n, "nb": n, "n3": n3}
    story = (f"bilayer, e {e:.2g}, active {ha} of 1 mm: {draw.told(a)}; passive: {draw.told(b)}; "
             f"{2 * n} x {n3} cells, {length:g} mm")
    kappas = [-float(state[-1]) for state in (rest, y, more)]
    return Case("bilayer", element, LAYERS, parameters, {"a": a, "b": b}, entries, story,
                lambda run: compare_bilayer(run, element, kappas, min(ha, 1 - ha), length, n3, n))


def compare_bilayer(run, element, kappas, thinner, length, n3, n):
    """End and rotation at a quarter of the length."""
    verdict = Verdict()
    rest, kappa, more = kappas
    if not run.at_target:
        verdict.ends_wrongly(f"no instability, {np.degrees(kappa * length / 4):.6g} degrees, but {run.told()}")
        return verdict
    scale = abs(rest) + abs(kappa - rest)
    # Rotation grows with e^2 over the stiffness where nothing amplifies it.
    sensitivity = max(1.0, abs((more - kappa) / max(abs(kappa - rest), 1e-30)) / 0.02)
    allowed = sensitivity * tolerance(element, kappa, length / n3, thinner, 2 * n)
    allowed += end_effect(length / n3, 3 * n3 // 4) + 1e-7
    # Newton's tolerance, 1e-10 mu of stress, as a curvature over half the thickness.
    verdict.value("rotation", run.curve["mid_rotation_deg"][-1], np.degrees(kappa * length / 4),
                  allowed + 4e-10 / scale, np.degrees(scale * length / 4))
    if any(run.curve.get("unstable_directions", [])):
        verdict.disagreements.append("unstable directions on a stable path")
    return verdict


def column(rng, element):
    """A strip between walls, pushed or charged, below its buckling or beyond."""
    if element[0] not in ELEMENTS:
        element = ("mean dilatation", 2)
    m = draw.material(rng)
    length = float(round(rng.uniform(8, 30)))
    n3, n = int(rng.choice([10, 16, 20])), 2 if element[1] == 2 else 4
    charged = rng.random() < 0.5
    strip, one = Strip(m, length, 1.0), draw.of_one(m)
    state = (lambda V: (1.0, V)) if charged else (lambda way: (1 - way / length, 0.0))
    found = strip.first_bifurcation(state, one if charged else 0.2 * length)
    if not found or found[1] != 1 or found[0] == 0.0:  # buckled by heat alone, or never
        return column(rng, element)
    critical, past = found[0], rng.random() < 0.7
    # Heat takes a part of the compression, so that the load's is less than stiffness asks for: 1 % more of it.
    stiffer = Strip(m, length / np.sqrt(1.01), 1.0).first_bifurcation(state, one if charged else 0.2 * length)
    sensitivity = 100 * (stiffer[0] / critical - 1) if stiffer else 1.0
    allowed = max(1.0, sensitivity) * tolerance(element, np.pi / length, length / n3, 1.0, n)
    # Past what the element's own stiffness may add.
    target = critical * float((1 + allowed) * rng.uniform(1.1, 1.5) if past else rng.uniform(0.2, 0.75))
    entries = {"Dimension": 2, "Temperature/Value": m.theta, "Supports/Fixed": "root: u3, end: u3, pin: u1",
               "Stepping/Continuation": "automatic", "Loading/Control": "voltage", "Loading/Target": target,
               "Loading/Film thickness": 1, "Output/Observables": "tip", "Observables/tip/At": "tip"}
    if charged:
        entries["Electrodes/Potential"] = "outer: 0, back: 1"
    else:
        entries.update({"Regions/Passive": "a, b", "Supports/Fixed": "root: u3, pin: u1",
                        "Supports/Moved": f"end: u3 {float(-target)!r}", "Loading/Stages": "move 1"})
        del entries["Loading/Control"], entries["Loading/Target"]
    parameters = {"L": length, "ha": 0.5, "hb": 0.5, "na": n // 2, "nb": n // 2, "n3": n3}
    story = (f"column, {'charged' if charged else 'pushed'}, {length:g} mm, {draw.told(m)}, {n} x {n3} cells, to "
             f"{target / critical:.3g} of the buckling load")
    return Case("column", element, LAYERS, parameters, {"a": m, "b": m}, entries, story,
                lambda run: compare_column(run, critical / target, past, allowed))


def compare_column(run, load, past, allowed):
    """Whether it buckles, and at which part of the load."""
    verdict, events = Verdict(), run.events()
    if not past:
        if events or not run.at_target:
            verdict.ends_wrongly(f"stable, but {events} {run.told()}")
        return verdict
    if not events:
        verdict.ends_wrongly(f"no bifurcation at load {load:.6g}, but {run.told()}")
        return verdict
    event, row = events[0]
    if event != "bifurcation":
        verdict.ends_wrongly(f"{event} for a bifurcation: {run.told()}")
    elif not run.at_target:
        verdict.ends_wrongly(f"the straight path goes on to its target, but {run.told()}")
    verdict.value(f"load of the {event}", run.curve["load"][row], load, allowed + 1e-6)
    return verdict
