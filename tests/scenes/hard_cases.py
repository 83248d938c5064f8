"""The hard cases of prm/hard (doc/hard_cases.md) in their small size, each against what is known.

    hard_cases.py THELMA_BINARY MPIEXEC SOURCE_DIR RANKS...
"""

import tempfile
import time
from pathlib import Path

from scene import program_and_ranks, require
import gent_exact
import heated_strip
import planar_exact

LIMIT_TOLERANCE = 1e-6  # in e
STATE_TOLERANCE = 1e-6  # in e at the lambda_3 of a state


def options(**entries):
    """Command line of entries written as Section__Entry_name=value."""
    words = []
    for name, value in entries.items():
        words += ["--set", name.replace("__", "/").replace("_", " ") + f"={value}"]
    return words


def events(curve, kind):
    """Rows of the curve with that event."""
    return [row for row, event in enumerate(curve["event"]) if event == kind]


def require_within(what, value, reference, tolerance):
    """Within the relative tolerance."""
    print(f"  {what}: {value:.6g}, reference {reference:.6g}")
    require(abs(value / reference - 1) <= tolerance, f"{what}: {value}, not {reference}")


def pull_in_loop(program, folder, ranks):
    """(a) Both branches and the limit point of the planar actuator."""
    for formulation in ("selective reduced", "mean dilatation"):
        case = program.run("hard/pull_in_loop", folder, ranks=ranks,
                           *options(Discretisation__Formulation=formulation))
        curve = case.curve("e", "lambda_3", "unstable_directions", "event")
        material = planar_exact.Material()
        exact = material.e(planar_exact.curve(material, 293, curve["lambda_3"])[1], 293)
        error = max(abs(curve["e"] - exact))
        require(error < STATE_TOLERANCE, f"a state is off by {error} in e")
        limit = planar_exact.limit_point(material, 293)
        rows = events(curve, "limit point")
        require(len(rows) == 1, f"{len(rows)} limit points")
        e = curve["e"][rows[0]]
        require(abs(e - limit.e) < LIMIT_TOLERANCE, f"limit point at {e}, exact {limit.e}")
        require(abs(curve["lambda_3"][-1] - 0.3) < 1e-9, "the path did not end at lambda_3 = 0.3")
        stable = curve["lambda_3"] > limit.lambda_3 + 1e-6
        require(not any(curve["unstable_directions"][stable]), "unstable before the limit point")
        require(all(curve["unstable_directions"][rows[0] + 1:]), "stable beyond the limit point")
        print(f"  {formulation}: limit point e - exact {e - limit.e:.1e}, largest error of a state "
              f"{error:.1e} in e, {len(curve['e'])} rows")


def snap_through(program, folder, ranks):
    """(b) Both limit points of a Gent film, as compressible as it is and nearly incompressible."""
    # A residual cannot fall below the round-off of the pressure, 1e-16 K/mu.
    for bulk, ratio, reference, tolerance, residual in (
            (50, 1e3, 1e3, LIMIT_TOLERANCE, 1e-10), (50000, 1e6, None, 1e-4, 1e-9)):
        case = program.run("hard/snap_through", folder, ranks=ranks,
                           *options(Materials__elastomer__Bulk_modulus=bulk,
                                    Newton__Tolerance=residual))
        curve = case.curve("e", "lambda_3", "event")
        rows = events(curve, "limit point")
        require(len(rows) == 2, f"{len(rows)} limit points")
        require(len(curve["e"]) < 120, f"{len(curve['e'])} steps")
        found = curve["e"][rows]
        exact = [e for e, _ in gent_exact.limit_points(100, reference)]
        require(max(abs(found - exact)) < tolerance, f"limit points at {found}, exact {exact}")
        print(f"  K/mu = {ratio:g}: limit points {found[0]:.8f}, {found[1]:.8f}, "
              f"{'exact' if reference else 'closed form'} {exact[0]:.8f}, {exact[1]:.8f}, "
              f"{len(curve['e'])} rows")


QUARTER_Q2 = {"Discretisation__Degree": 2, "Discretisation__Formulation": "mean dilatation",
              "Loading__Until": ""}
DEFLECTION = {0.25: 0.620, 0.40: 1.925, 0.60: 3.842}  # mm by e, independent code, 2 x 2 x 5


def buckling_branches(program, folder, ranks):
    """(c) The perfect pump through its bifurcation, to both sides, and through its pull-in."""
    sides = []
    for branch in ("plus", "minus"):
        case = program.run("hard/buckling_branches", folder, ranks=ranks,
                           *options(Stepping__Branch=branch))
        curve = case.curve("e", "centre_u1_mm", "unstable_directions", "event")
        row = events(curve, "bifurcation")[0]
        require_within("bifurcation", curve["e"][row], 0.2536, 5e-3)
        turn = events(curve, "limit point")[0]
        require_within("pull-in", curve["e"][turn], 0.683, 5e-3)
        require(curve["unstable_directions"][turn + 1] == 1, "stable beyond pull-in")
        sides.append((curve["e"][[turn, -1]], curve["centre_u1_mm"][[turn, -1]]))
    (e, u), (other_e, other_u) = sides
    asymmetry = max(max(abs(e - other_e)), max(abs(u + other_u)))
    require(asymmetry < 1e-8, f"the branches differ by {asymmetry}")
    require(min(u) > 1, f"the branch plus goes to {u}")
    print(f"  at the limit points and ends u1 = {u}, branches differ by {asymmetry:.1e}")
    if ranks == 1:
        converged_pump(program, folder)


def converged_pump(program, folder):
    """The same with Q2/P1."""
    case = program.run("hard/buckling_branches", folder, *options(
        Mesh__Parameters="n1: 2, n2: 4, n3: 20, quarter: 1", Loading__Target=0.225, **QUARTER_Q2))
    curve = case.curve("e", "event")
    require_within("bifurcation, Q2/P1", curve["e"][events(curve, "bifurcation")[0]], 0.2204, 5e-3)
    for e, reference in DEFLECTION.items():
        case = program.run("hard/buckling_branches", folder, *options(
            Mesh__Parameters="n1: 2, n2: 4, n3: 10, quarter: 1", Loading__Target=e, **QUARTER_Q2))
        deflection = case.curve("centre_u1_mm")["centre_u1_mm"][-1]
        require_within(f"deflection in mm at e = {e}", deflection, reference, 5e-3)


def thermal_buckling(program, folder, ranks):
    """(c) A strip between walls buckles by heat alone and goes on buckled."""
    case = program.run("hard/thermal_buckling", folder, ranks=ranks)
    curve = case.curve("theta_K", "tip_u1_mm", "event", "unstable_directions")
    exact, estimate = heated_strip.buckling_temperature(1.8e-4, 10, 1)
    found = curve["theta_K"][events(curve, "bifurcation")[0]]
    print(f"  linear estimate {estimate:.3f} K")
    require_within("rise to the buckling temperature in K", found - 293, exact - 293, 1e-2)
    require(curve["tip_u1_mm"][-1] > 0.5 and not curve["unstable_directions"][-1],
            "the heated strip is not buckled")


CASES = [pull_in_loop, snap_through, buckling_branches, thermal_buckling]


def main():
    program, all_ranks = program_and_ranks(__doc__)
    for case in CASES:
        for ranks in all_ranks:
            start = time.time()
            print(f"{case.__doc__} ({ranks} rank(s))", flush=True)
            with tempfile.TemporaryDirectory() as folder:
                case(program, Path(folder), ranks)
            print(f"  {time.time() - start:.1f} s", flush=True)


main()
