"""Where a path goes and ends hangs on the body alone: not on the target, the first step, rounding
at rest or a mirror image nearby. And the end is called what it is.

    paths.py THELMA_BINARY MPIEXEC SOURCE_DIR RANKS...
"""

import json
import math

from scene import program_and_ranks, require, settings, side_by_side, study, validated
from thelma import bending_exact
import film_exact
import gent_exact
from thelma import planar_exact

MATERIAL = planar_exact.Material()
RATIO = MATERIAL.K / MATERIAL.mu(293)
FILMS = {  # by dimension: scene and entries; on until both are far behind the limit point
    3: ("hard/pull_in_loop", {"Mesh/Parameters": "L1: 5, L2: 5, L3: 1, n1: 1, n2: 1, n3: 1",
                              "Loading/Until": "lambda_3: 0.35"}),
    2: ("hard/creasing", {"Mesh/Parameters": "L: 1, H: 1, n1: 2, n3: 1",
                          "Supports/Fixed": "back: u1, x3_min: u3",
                          "Discretisation/Formulation": "standard",
                          "Stepping/Continuation": "automatic",
                          "Loading/Until": "tip_u1_mm: 0.4"})}
LAWS = {film_exact.NEO_HOOKEAN: {},
        film_exact.GENT: {"Materials/elastomer/Elastic law": "Gent",
                          "Materials/elastomer/Gent limit": "30"},
        film_exact.MOONEY_RIVLIN: {"Materials/elastomer/Elastic law": "Mooney-Rivlin",
                                   "Materials/elastomer/Second share": "0.5"}}
DEFLECTION = 1.117  # of the pump in mm at e = 0.3 and 293 K: independent code (buckling_pump.py)
NO_PULL_IN = {"Loading/Expected end": "target", "Expectations/Final values": ""}


def cases(program, folder, scene, entries, *sweeps):
    """The cases of a sweep; each of the @p sweeps is `Section/Entry=v1,v2,...`."""
    words = [word for sweep in sweeps for word in ("--sweep", sweep)]
    program.run(scene, folder, *settings({**entries, "Output/Fields": "none"}), *words)
    return study.read_study(folder)


def rows_of(curve, event):
    return [row for row, other in enumerate(curve["event"]) if other == event]


def limit_points(program, folder):
    """The limit point of a film is that of its law, whatever the target and the first step."""
    for dimension, (scene, film) in FILMS.items():
        for law, entries in LAWS.items():
            if (law, dimension) == (film_exact.GENT, 2):
                continue  # it has none
            exact = film_exact.limit_point(law, dimension, RATIO)
            worst = 0.
            for case in cases(program, folder / f"{dimension}{law[0]}", scene,
                              {**film, **entries}, "Loading/Target=1.5,3,10",
                              "Stepping/Initial step=0.01,0.2"):
                curve = case.curve("e", "event")
                rows = rows_of(curve, "limit point")
                require(len(rows) == 1, f"{len(rows)} limit points")
                worst = max(worst, abs(curve["e"][rows[0]] / exact - 1))
            print(f"  {law[0]}, {dimension} dimensions: {exact:.8f}, six runs off by {worst:.1e}")
            validated("paths", f"limit point, {law[0]}, {dimension} dimensions, six targets and steps",
                      "exact, homogeneous", worst)
            require(worst < 1e-6, f"a limit point is off by {worst}")


def snap_through(program, folder):
    """Both limit points of Gent's film of hard_cases.py, however little its volume changes; a step
    across the target, too, ends at the stretch that comes first."""
    for bulk in (50, 5e3, 5e5):
        exact = [e for e, _ in gent_exact.limit_points(100, bulk / 0.05)]
        worst = 0.
        for case in cases(program, folder / f"{bulk:g}", "hard/snap_through",
                          {"Materials/elastomer/Bulk modulus": f"{bulk}"},
                          "Loading/Target=1.5,4,10", "Stepping/Initial step=0.01,0.2"):
            curve = case.curve("e", "lambda_3", "event")
            found = curve["e"][rows_of(curve, "limit point")]
            require(len(found) == 2, f"{len(found)} limit points")
            require(abs(curve["lambda_3"][-1] - 0.02) < 1e-9, f"ends at {curve['lambda_3'][-1]}")
            worst = max(worst, *abs(found / exact - 1))
        print(f"  K/mu = {bulk / 0.05:g}: {exact[0]:.8f}, {exact[1]:.8f}, six runs off by {worst:.1e}")
        validated("paths", f"both limit points, Gent, K/mu = {bulk / 0.05:g}, six targets and steps",
                  "exact, homogeneous", worst)
        require(worst < 1e-6, f"a limit point is off by {worst}")


def heated_rest(program, folder):
    """What rounding leaves at rest of a heated body is no instability."""
    fields = [0.15 * part / 10 for part in range(11)]
    for alpha in (1e-5, 1e-4):
        material = planar_exact.Material(alpha=alpha)
        temperatures = (294, 299, 305, 311, 323, 341)
        found = cases(program, folder / f"{alpha}", "bending_actuator_plane", {
            "Mesh/Parameters": "L: 20, H: 1, n1: 2, n3: 20", "Loading/Target": "0.15",
            "Materials/elastomer/Thermal expansion": f"{alpha}", **NO_PULL_IN},
                      "Temperature/Value=" + ",".join(map(str, temperatures)))
        for case, theta in zip(found, temperatures):
            curve = case.curve("e", "mid_rotation_deg")
            circle = list(bending_exact.circles(material, theta, fields))[-1]
            error = curve["mid_rotation_deg"][-1] / circle.rotation(20) - 1
            require(curve["e"][-1] > 0.15 - 1e-9 and abs(error) < 1e-2,
                    f"{theta} K ends at e = {curve['e'][-1]}, the rotation is off by {error}")
        print(f"  alpha = {alpha}: reached at {len(temperatures)} temperatures")
    for case in cases(program, folder / "pump", "buckling_pump_quarter", {
            "Materials/elastomer/Thermal expansion": "1.8e-4", "Loading/Target": "0.15",
            **NO_PULL_IN}, "Temperature/Value=303,309"):
        curve = case.curve("e", "centre_u1_mm")
        require(curve["e"][-1] > 0.15 - 1e-9 and curve["centre_u1_mm"][-1] > 0, "not reached")


def mirror_image(program, folder):
    """An imperfect pump buckles to the side of its imperfection, at any temperature. Without thermal
    expansion its stiffness grows with theta, and e with the root of it."""
    for theta in (275, 281, 299, 309, 323, 341):
        case = program.run("buckling_pump_quarter", folder, *settings({
            "Mesh/Parameters": "n1: 2, n2: 4, n3: 10, quarter: 1", **NO_PULL_IN,
            "Temperature/Value": f"{theta}", "Output/Fields": "none",
            "Loading/Target": f"{0.3 * math.sqrt(theta / 293)}"}))
        u = case.curve("centre_u1_mm")["centre_u1_mm"]
        require(all(u[1:] > u[:-1]), f"the deflection does not grow all the way: {u}")
        print(f"  {theta} K: {u[-1]:.4f} mm, {DEFLECTION} mm expected")
        require(abs(u[-1] / DEFLECTION - 1) < 1e-2, f"a deflection of {u[-1]} mm at {theta} K")


def double_bifurcation(program, folder):
    """A square column buckles in two directions under one load, Euler's, with 3 mu for its modulus."""
    case = program.run("hard/pull_in_loop", folder, *settings({
        "Mesh/Parameters": "L1: 1, L2: 1, L3: 40, n1: 1, n2: 1, n3: 20",
        "Discretisation/Degree": "2", "Discretisation/Formulation": "mean dilatation",
        "Supports/Fixed": "bottom: u1 u2 u3", "Electrodes/Potential": "", "Regions/Passive": "film",
        "Loads/Force": "top: 0 0 -5e-5", "Loading/Stages": "force 1", "Loading/Until": "",
        "Output/Observables": "lambda_3", "Output/Fields": "none"}))
    curve = case.curve("load", "unstable_directions", "event")
    found = [(row, event) for row, event in enumerate(curve["event"]) if event]
    require([event for _, event in found] == ["double bifurcation"], f"events {found}")
    force = 5e-5 * curve["load"][found[0][0]]
    euler = math.pi**2 * 3 * MATERIAL.mu(293) / 12 / (4 * 40**2)
    print(f"  {force:.5e} N, Euler's load {euler:.5e} N")
    validated("paths", "double buckling force of a square column", "Euler, slender limit",
              force / euler - 1)
    # The clamped end is stiffer by a part of the width, which falls with the length.
    require(abs(force / euler - 1) < 1e-2, "not Euler's load")
    require(curve["unstable_directions"][-1] == 2, "not two unstable directions")


def branch(program, folder):
    """The pump's bifurcation and the limit point of its branch are those of any target and step."""
    found = [[(event, case.curve("e")["e"][row])
              for row, event in enumerate(case.curve("event")["event"]) if event]
             for case in cases(program, folder, "hard/buckling_branches",
                               {"Expectations/Final values": ""}, "Loading/Target=1.5,10",
                               "Stepping/Initial step=0.05,0.2")]
    for events in found:
        print("  " + ", ".join(f"{event} at e = {e:.9f}" for event, e in events))
        require([event for event, _ in events] == ["bifurcation", "limit point"],
                f"events {events}")
        for (_, e), (name, first) in zip(events, found[0]):
            require(abs(e / first - 1) < 1e-7, f"the {name} at {e}, before at {first}")


def ends(program, folder):
    """Ends are called what they are, with what is known of them."""
    by_load = {"Stepping/Continuation": "load", "Loading/Until": "", "Output/Fields": "none"}
    for scene, entries, outcome, texts in (
            ("hard/pull_in_loop", by_load, "pull-in", ["pull-in between e = 0.687"]),
            ("hard/snap_through", by_load, "pull-in", ["pull-in between e = 0.689"]),
            ("hard/hourglass", {}, "instability",
             ["1 unstable direction", "critical mode is mostly u", "e_true", "smallest stretch"])):
        case = program.run(scene, folder / outcome / scene, *settings(entries), exit_code=3)
        report = json.loads((case.directory / "run.json").read_text())
        print(f"  {report['reason']}")
        require(report["outcome"] == outcome, f"{scene} ends as {report['outcome']}")
        for text in texts:
            require(text in report["reason"], f"{scene} does not say '{text}'")


CASES = [limit_points, snap_through, heated_rest, mirror_image, double_bifurcation, branch, ends]


def timed(program, folder, case):
    print(case.__doc__)
    case(program, folder)


def main():
    program, _ = program_and_ranks(__doc__)
    side_by_side(program, *((timed, case) for case in CASES))


main()
