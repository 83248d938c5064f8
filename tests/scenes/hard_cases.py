"""The hard cases of prm/hard (doc/hard_cases.md) in their small size, each against what is known.

    hard_cases.py THELMA_BINARY MPIEXEC SOURCE_DIR RANKS...
"""

import inspect
import math
import time

from scene import program_and_ranks, require, side_by_side, validated
from thelma import bending_exact
import constant_charge
import gent_exact
import heated_strip
from thelma import planar_exact

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


def exact_rotation(e, length):
    """Degrees that sections of the bending actuator a length (mm) apart turn against each other."""
    fields = [e * part / 20 for part in range(21)]
    circle = list(bending_exact.circles(planar_exact.Material(), 293, fields))[-1]
    return circle.rotation(length / 0.5)


def require_within(what, value, reference, tolerance):
    """Within the relative tolerance."""
    print(f"  {what}: {value:.6g}, reference {reference:.6g}")
    case = inspect.stack()[1].function
    validated(f"hard/{case}", what, "doc/hard_cases.md", value / reference - 1)
    require(abs(value / reference - 1) <= tolerance, f"{what}: {value}, not {reference}")


def pull_in_loop(program, folder, ranks):
    """(a) Both branches and the limit point of the planar actuator."""
    for formulation, controlled in (("selective reduced", ""), ("mean dilatation", ""),
                                    ("mean dilatation", "top: u3")):
        case = program.run("hard/pull_in_loop", folder, ranks=ranks, *options(
            Discretisation__Formulation=formulation, Stepping__Controlled_displacement=controlled))
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
        print(f"  {formulation}{', control by ' * bool(controlled)}{controlled}: limit point e - exact {e - limit.e:.1e}, largest error of a state "
              f"{error:.1e} in e, {len(curve['e'])} rows")
        validated("hard/pull_in_loop", f"e of every state of both branches, {formulation}"
                  f"{', control by ' * bool(controlled)}{controlled}", "exact, homogeneous", error)


def snap_through(program, folder, ranks):
    """(b) Both limit points of a Gent film, as compressible as it is and nearly incompressible: a
    residual falls no further than the round-off of the pressure, up to 1e-16 K/mu / lambda_3."""
    for bulk in (50, 50000):
        ratio = bulk / 0.05
        case = program.run("hard/snap_through", folder, ranks=ranks,
                           *options(Materials__elastomer__Bulk_modulus=bulk))
        curve = case.curve("e", "lambda_3", "event")
        rows = events(curve, "limit point")
        require(len(rows) == 2, f"{len(rows)} limit points")
        require(len(curve["e"]) < 120, f"{len(curve['e'])} steps")
        found = curve["e"][rows]
        exact = [e for e, _ in gent_exact.limit_points(100, ratio)]
        error = max(abs(found - exact))
        require(error < LIMIT_TOLERANCE, f"limit points at {found}, exact {exact}")
        validated("hard/snap_through", f"e of both limit points, K/mu = {ratio:g}",
                  "exact, homogeneous", error)
        print(f"  K/mu = {ratio:g}: limit points {found[0]:.8f}, {found[1]:.8f}, "
              f"exact {exact[0]:.8f}, {exact[1]:.8f}, {len(curve['e'])} rows")


QUARTER_Q2 = {"Discretisation__Degree": 2, "Discretisation__Formulation": "mean dilatation",
              "Loading__Until": ""}
DEFLECTION = {0.25: 0.620, 0.40: 1.925, 0.60: 3.842}  # mm by e, independent code, 2 x 2 x 5


def gent_stability(program, folder, ranks):
    """(b) Its film is stable again behind the second limit point; the paper's element keeps three modes of a cell."""
    for formulation, modes in (("standard", 0), ("mean dilatation", 0), ("selective reduced", 3)):
        case = program.run("hard/snap_through", folder, ranks=ranks,
                           *options(Discretisation__Formulation=formulation))
        curve = case.curve("unstable_directions", "event")
        first, second = events(curve, "limit point")
        between, beyond = curve["unstable_directions"][[second - 1, -1]]
        print(f"  {formulation}: {between:g} unstable directions between the limit points, "
              f"{beyond:g} beyond")
        require((between, beyond) == (modes + 1, modes), "not the homogeneous one and the cell's")


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


def charge_control(program, folder, ranks):
    """(a) The planar actuator under given charge: no limit point, the same states."""
    case = program.run("hard/charge_control", folder, ranks=ranks)
    curve = case.curve("e", "lambda_3", "top_charge_uC", "charge_uC", "event")
    material = planar_exact.Material()
    lambda_1, field = planar_exact.curve(material, 293, curve["lambda_3"])
    charge = 25 * planar_exact.charge_per_area(material, 293, lambda_1, curve["lambda_3"], field)
    error = max(abs(curve["e"] - material.e(field, 293)))
    require(error < STATE_TOLERANCE, f"a state is off by {error} in e")
    for column in ("top_charge_uC", "charge_uC"):
        require(max(abs(charge - curve[column])) < 1e-9, f"{column} is off")
    require(not events(curve, "limit point") + events(curve, "pull-in"), "there is a limit point")
    require(min(curve["lambda_3"]) < 0.301, f"ends at lambda_3 = {min(curve['lambda_3'])}")
    beyond = curve["lambda_3"] < planar_exact.limit_point(material, 293).lambda_3
    print(f"  {len(beyond)} rows, {sum(beyond)} beyond the pull-in, largest error {error:.1e} in e")


def generator(program, folder, ranks):
    """A generator's cycle: the voltage after relaxing at constant charge, and the energy."""
    case = program.run("hard/generator", folder, ranks=ranks)
    curve = case.curve("load", "top_charge_uC", "top_voltage_kV", "lambda_1", "lambda_3",
                       "reaction_f1_N")
    V, Q, load = curve["top_voltage_kV"], curve["top_charge_uC"], curve["load"]
    charged, relaxed = (max(row for row, value in enumerate(load) if value <= end)
                        for end in (2, 3))
    _, lambda_3, exact = constant_charge.state(planar_exact.Material(), 293,
                                               curve["lambda_1"][relaxed], Q[relaxed] / 25)
    require(abs(Q[relaxed] / Q[charged] - 1) < 1e-9, "the floating electrode has lost charge")
    require_within("voltage at constant charge, relaxed, in kV", V[relaxed], exact, 1e-8)
    require_within("lambda_3 there", curve["lambda_3"][relaxed], lambda_3, 1e-8)
    require(abs(Q[-1]) < 1e-12, f"charge {Q[-1]} uC is left")
    electric = sum((V[1:] + V[:-1]) / 2 * (Q[1:] - Q[:-1]))
    way, force = 5 * (curve["lambda_1"] - 1), curve["reaction_f1_N"]
    mechanical = sum((force[1:] + force[:-1]) / 2 * (way[1:] - way[:-1]))
    print(f"  {V[charged]:.4f} kV charged, {V[relaxed]:.4f} kV relaxed; a cycle takes "
          f"{mechanical:.6f} mJ from the grips and gives {-electric:.6f} mJ to the source")
    # The trapezoidal sums are off by the square of the steps.
    require(mechanical > 0 and abs(mechanical + electric) < 2e-4 * mechanical, "energy is lost")


def bulk_modulus(program, folder, ranks):
    """(d) K/mu from 1e3 to 1e6: iterations per step, and convergence to incompressible."""
    iterations, rotation = [], []
    for bulk in (50, 500, 5000, 50000):
        case = program.run("hard/bulk_modulus", folder, ranks=ranks, *options(
            Materials__elastomer__Shear_modulus=0.05, Materials__elastomer__Bulk_modulus=bulk,
            Newton__Reuse_tangent="false", Stepping__Initial_step=0.1,
            Stepping__Largest_step=0.1))
        curve = case.curve("newton_iterations", "mid_rotation_deg")
        iterations.append(curve["newton_iterations"])
        rotation.append(curve["mid_rotation_deg"][-1])
        print(f"  K/mu = {bulk / 0.05:g}: {max(iterations[-1]):g} iterations a step at most, "
              f"rotation {rotation[-1]:.8f} degrees")
    for other in iterations[1:]:
        require(len(other) == len(iterations[0]), "other steps")
        require(max(abs(other - iterations[0])) <= 2, f"iterations {other}, not {iterations[0]}")
    changes = [abs(b - a) for a, b in zip(rotation, rotation[1:])]
    require(all(8 < a / b < 12 for a, b in zip(changes, changes[1:])),
            f"the changes {changes} do not fall with 1/K")


def slender(program, folder, ranks):
    """(e) Aspect ratios of 1:100 and 1:1000, two Q2/P1 cells through the thickness."""
    for length, cells in ((100, 20), (1000, 80)):
        case = program.run(
            "hard/slender", folder, "--set", f"Observables/mid_rotation/Section={length / 2}",
            *options(Mesh__Parameters=f"L: {length}, H: 1, n1: 2, n3: {cells}"), ranks=ranks)
        rotation = case.curve("mid_rotation_deg")["mid_rotation_deg"][-1]
        require_within(f"1:{length}, rotation in degrees", rotation,
                       exact_rotation(0.1, length / 2), 1e-2)


def distorted(program, folder, ranks):
    """(f) Distorted cells find the homogeneous states exactly, but for selective reduction."""
    material = planar_exact.Material()
    for degree, formulation, tolerance in (
            (1, "mean dilatation", 1e-9), (1, "standard", 1e-9), (1, "enhanced strain", 1e-9),
            (2, "mean dilatation", 1e-9), (1, "selective reduced", 1e-4)):
        case = program.run("hard/distorted", folder, ranks=ranks, *options(
            Discretisation__Degree=degree, Discretisation__Formulation=formulation))
        curve = case.curve("e", "lambda_3")
        exact = planar_exact.stable_state(material, 293, material.field(curve["e"][-1], 293))[1]
        error = abs(curve["lambda_3"][-1] - exact)
        print(f"  {formulation}, degree {degree}: error of lambda_3 {error:.1e}")
        require(error < tolerance, f"lambda_3 is off by {error}")


def rolling(program, folder, ranks):
    """(g) Rolling up by two turns."""
    case = program.run("hard/rolling", folder, ranks=ranks)
    curve = case.curve("mid_rotation_deg", "end_rotation_deg")
    require(curve["end_rotation_deg"][-1] > 720, "less than two turns")
    require_within("rotation of the middle in degrees", curve["mid_rotation_deg"][-1],
                   exact_rotation(0.87, 12), 1e-2)
    print(f"  end face {curve['end_rotation_deg'][-1]:.1f} degrees in "
          f"{len(curve['end_rotation_deg'])} steps")


def stiff_layer(program, folder, ranks):
    """(h) A passive layer 1000 times as stiff, against Timoshenko's bimorph."""
    case = program.run("hard/stiff_layer", folder, ranks=ranks)
    curve = case.curve("e", "mid_rotation_deg", "newton_iterations")
    n, strain = 1000, curve["e"][-1] ** 2 / 4
    curvature = 24 * strain / (12 + (1 + n) * (1 + 1 / n))  # total thickness 1 mm
    require_within("rotation in degrees", curve["mid_rotation_deg"][-1],
                   math.degrees(10 * curvature), 1e-2)
    print(f"  {max(curve['newton_iterations']):g} iterations a step at most")


def heat_step(program, folder, ranks):
    """(i) 60 K in one time step of 1e-6 to 1e3 diffusion times."""
    for exponent in (-6, -3, 0, 3):
        step = 1.2 * 10.0**exponent
        case = program.run("hard/heat_step", folder, ranks=ranks,
                           *options(Time__End=step, Time__Initial_step=step))
        curve = case.curve("theta_min_K", "theta_max_K", "lambda_3")
        low, high = min(curve["theta_min_K"]), max(curve["theta_max_K"])
        print(f"  {step:g} s: {low:.6f} to {high:.6f} K, {len(curve['lambda_3'])} rows")
        require(low > 293 - 1e-6 and high < 353 + 1e-6, "a temperature is out of range")


def too_large_step(program, folder, ranks):
    """(j) The whole load at once, beyond the pull-in, is cut and ends rightly."""
    material = planar_exact.Material()
    limit = planar_exact.limit_point(material, 293)
    case = program.run("hard/too_large_step", folder, ranks=ranks)
    below, above = case.pull_in()
    curve = case.curve("e", "lambda_3")
    exact = [planar_exact.stable_state(material, 293, min(material.field(e, 293), limit.field))[1]
             for e in curve["e"]]
    error = max(abs(curve["lambda_3"] - exact))
    print(f"  pull-in between {below:.6f} and {above:.6f}, largest error of lambda_3 {error:.1e}")
    require(below - 1e-8 <= limit.e <= above + 1e-8, f"exact pull-in {limit.e}")
    require(error < 1e-6, f"lambda_3 is off by {error}")


def hourglass(program, folder, ranks):
    """(k) Hourglassing of enhanced strain is counted and refused."""
    case = program.run("hard/hourglass", folder, ranks=ranks, exit_code=3)
    curve = case.curve("e", "event", "unstable_directions")
    print(f"  stable up to e = {curve['e'][-1]:.4f}")
    require(curve["event"][-1] == "bifurcation", f"the last event is '{curve['event'][-1]}'")
    require(not any(curve["unstable_directions"]), "an unstable state was accepted")
    require(0.33 < curve["e"][-1] < 0.37, f"unstable from e = {curve['e'][-1]} on")


def creasing(program, folder, ranks):
    """(l) A bonded film's surface: the run ends where wrinkles as short as the cells appear."""
    fields = {}
    for formulation in ("standard", "mean dilatation"):
        for cells in ("n1: 4, n3: 16", "n1: 8, n3: 32"):
            case = program.run("hard/creasing", folder, ranks=ranks, exit_code=3, *options(
                Mesh__Parameters=f"L: 4, H: 1, {cells}", Discretisation__Formulation=formulation))
            curve = case.curve("e", "event", "unstable_directions")
            fields.setdefault(formulation, []).append(curve["e"][-1])
            print(f"  {formulation}, {cells}: stable up to e = {curve['e'][-1]:.4f}")
            require(curve["event"][-1] == "bifurcation", f"last event '{curve['event'][-1]}'")
            require(not any(curve["unstable_directions"]), "an unstable state was accepted")
    # Short waves on an ideal dielectric half-space: e = sqrt(2).
    coarse, fine = fields["standard"]
    require(coarse > fine > math.sqrt(2) and fine - math.sqrt(2) < 0.5 * (coarse - math.sqrt(2)),
            f"{coarse}, {fine} do not approach sqrt(2)")
    # Q2/P1 has no modes of its own cells.
    for ours, full in zip(fields["mean dilatation"], fields["standard"]):
        require(abs(ours / full - 1) < 1e-3, f"{ours}, with full integration {full}")


CASES = [pull_in_loop, charge_control, generator, snap_through, gent_stability, buckling_branches, thermal_buckling,
         bulk_modulus, slender, distorted, rolling, stiff_layer, heat_step, too_large_step,
         hourglass, creasing]

# Hard for the laws and elements, which know nothing of ranks, and several runs each: on one.
ALONE = [snap_through, gent_stability, bulk_modulus, distorted, creasing]


def ranks_of(case, all_ranks):
    """The branches take long: only on the most."""
    if case is buckling_branches:
        return all_ranks[-1:]
    return all_ranks[:1] if case in ALONE else all_ranks


def timed(program, folder, case, ranks):
    """A case, with its name and how long it took."""
    start = time.time()
    print(f"{case.__doc__} ({ranks} rank(s))")
    case(program, folder, ranks)
    print(f"  {time.time() - start:.1f} s")


def main():
    program, all_ranks = program_and_ranks(__doc__)
    side_by_side(program, *((timed, case, ranks) for case in CASES
                            for ranks in ranks_of(case, all_ranks)))


main()
