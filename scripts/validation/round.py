"""Tubes in plane strain with a steady temperature, and balloons: radial boundary value problems.

Tolerance: with h the largest size of a cell relative to its radius, through the wall or around it, and elements of
degree p, displacements converge like the energy, h^(2p); that is allowed, relative to the displacement.
"""

import numpy as np

from validation import draw
from validation.layered import Layered, Solver
from validation.scene import ROOT, Case, Verdict


def observables(names):
    """Entries of the points whose displacement is wanted."""
    entries = {"Output/Observables": ", ".join(names)}
    entries.update({f"Observables/{name}/At": at for name, at in names.items()})
    return entries


def tube(rng, element):
    """A quarter of a tube between end plates."""
    if element[0] == "standard":
        element = ("mean dilatation", 2)
    steady = rng.random() < 0.6
    m, outer = draw.material(rng), float(round(rng.uniform(1.3, 2.0), 2))
    walls = (draw.temperature(rng), draw.temperature(rng)) if steady else ()
    one = draw.of_one(m) * (outer - 1)
    solver = Solver(Layered("tube", ((outer - 1, m, True),), 1.0, 0.0, walls))
    voltage = one * draw.log_uniform(rng, 0.01, 0.5)
    y = solver.path(voltage, 12)
    if y is None:
        return tube(rng, element)
    n1, n3 = (4, 6) if element[1] == 2 else (6, 12)
    entries = {"Dimension": 2, "Mesh/Curved": "around x2", "Temperature/Value": m.theta,
               "Supports/Fixed": "x1_axis: u3, x3_axis: u1", "Electrodes/Potential": "outer: 0, inner: 1",
               "Loading/Control": "voltage", "Loading/Target": voltage, "Loading/Film thickness": outer - 1,
               **observables({"tip": "inner_end", "centre": "outer_end", "probe": "middle"})}
    if steady:
        entries.update({"Temperature/Model": "steady", "Temperature/Fixed": f"inner: {walls[0]}, outer: {walls[1]}"})
    story = f"tube 1 to {outer} mm, {voltage / one:.2g} of e = 1, walls {walls}, {draw.told(m)}, {n1} x {n3} cells"
    middle = (1 + outer) / 2
    exact = {"tip_u1_mm": y[0] - 1, "centre_u1_mm": y[-1] - outer, "probe_phi_kV": solver.potential(y, voltage, middle)}
    if steady:
        part = np.log(solver.at(y, middle) / y[0]) / np.log(y[-1] / y[0])
        exact["probe_theta_K"] = walls[0] + (walls[1] - walls[0]) * part
    h = max(np.log(outer) / n1, np.pi / 2 / n3)
    return Case("tube", element, ROOT / "meshes/tube_quarter_plane.geo", {"Ro": outer, "n1": n1, "n3": n3},
                {"wall": m}, entries, story,
                lambda run: compare(run, exact, h**(2 * element[1]), 1.0, voltage, walls))


def balloon(rng, element):
    """An eighth of a balloon, inflated, then charged, below its largest voltage or up to it."""
    element = ("mean dilatation", 2) if element[0] == "standard" else element
    m = draw.material(rng)
    thickness, radius = float(round(rng.uniform(0.5, 2.0), 2)), 10.0
    # The largest pressure of a thin neo-Hookean balloon is 1.24 mu H/R.
    pressure = 1.24 * float(m.mu * m.theta / m.theta_0) * thickness / radius * float(rng.uniform(0, 0.6))
    solver = Solver(Layered("balloon", ((thickness, m, True),), radius, pressure))
    one = draw.of_one(m) * thickness
    limit = solver.limit(1.5 * one)
    past = limit is not None and rng.random() < 0.3
    voltage = (limit or one) * (1.1 if past else float(rng.uniform(0.05, 0.9)))
    y = solver.path(min(voltage, 0.9 * (limit or one)), 12)
    n, nr = (2, 1) if element[1] == 2 else (3, 2)
    entries = {"Dimension": 3, "Mesh/Curved": "around the origin", "Temperature/Value": m.theta,
               "Supports/Fixed": "x1_min: u1, x2_min: u2, x3_min: u3",
               "Electrodes/Potential": "outer: 0, inner: 1", "Loads/Pressure": f"inner: {float(pressure)!r}",
               "Loading/Control": "voltage", "Loading/Target": voltage, "Loading/Film thickness": thickness,
               "Loading/Stages": "pressure 1, voltage 1", "Loading/Expected end": "pull-in" if past else "target",
               **observables({"tip": "inner_end", "centre": "outer_end"})}
    story = (f"balloon {radius:g} mm, wall {thickness} mm, {1e3 * pressure:.3g} kPa, to {voltage / one:.3g} of e = 1"
             f"{', past its largest voltage' if past else ''}, {draw.told(m)}, 3 x {n} x {n} x {nr} cells")
    h = max(np.pi / 4 / n, np.log1p(thickness / radius) / nr)
    allowed = h**(2 * element[1])
    exact = {"tip_u1_mm": y[0] - radius, "centre_u1_mm": y[-1] - radius - thickness}
    check = (lambda run: compare_limit(run, limit, draw.of_one(m) * thickness, allowed)) if past else \
        (lambda run: compare(run, exact, allowed, 1.0, voltage, ()))
    return Case("balloon", element, ROOT / "meshes/balloon.geo", {"H": thickness, "n": n, "nr": nr}, {"wall": m},
                entries, story, check)


def compare(run, exact, allowed, radius, voltage, walls):
    """End and values: displacements relative to themselves, phi to the voltage, theta to the difference."""
    verdict = Verdict()
    if not run.at_target:
        verdict.ends_wrongly(f"stable, but {run.told()}")
        return verdict
    for name, value in exact.items():
        scale = {"phi": voltage, "the": max(abs(walls[0] - walls[1]), 1.0) if walls else 1.0}.get(
            name.split("_")[1][:3], max(map(abs, (exact["tip_u1_mm"], exact["centre_u1_mm"]))))
        verdict.value(name, run.curve[name][-1], value, allowed + 1e-9 * radius / scale, scale)
    return verdict


def compare_limit(run, limit, one, allowed):
    """The largest voltage."""
    verdict = Verdict()
    if not run.bracket:
        verdict.ends_wrongly(f"a limit point at {limit:.6g} kV, but {run.told()}")
        return verdict
    verdict.value("largest voltage", sum(run.bracket) / 2 * one, limit, allowed + 1.5e-4 * one / limit)
    if verdict.disagreements or run.exit_code != 0:
        verdict.wrong_end = True
        verdict.disagreements.append(run.told())
    return verdict
