"""Bodies of revolution against their boundary value problems, and against the same bodies in space.

    axisymmetry.py THELMA_BINARY MPIEXEC SOURCE_DIR RANKS...
"""

import csv
import itertools
import math
import subprocess

import numpy as np
from scipy.optimize import brentq, fsolve
from scipy.special import j1, jn_zeros

from diaphragm_reference import Diaphragm
from membrane_reference import Membrane
from scene import program_and_ranks, require, sentences, settings, side_by_side, validated
from thelma import balloon_exact
from thelma import planar_exact
import slab_exact

THETA = 293.0
QUIET = {"Output/Fields": "none", "Expectations/Final values": ""}
# With the order of convergence on curved cells (doc/theory.md, "Axisymmetry").
ELEMENTS = (("standard", 2, 4), ("selective reduced", 1, 2), ("selective reduced", 2, 3),
            ("mean dilatation", 1, 2), ("mean dilatation", 2, 4), ("enhanced strain", 1, 2))
# The cylinder without its weight, and of the material of relaxation.prm.
LIGHT = {**QUIET, "Loads/Force": "", "Loading/Stages": ""}
VHB = {"Elastic law": "Arruda-Boyce", "Shear modulus": "15.36 kPa", "Locking stretch": "5.85",
       "Bulk modulus": "15.36 MPa", "Permittivity": "4.25e-5", "Branches": "Maxwell, Maxwell, Maxwell",
       "Branch 1/Modulus": "26.06 kPa", "Branch 1/Relaxation time": "0.6074",
       "Branch 2/Modulus": "26.53 kPa", "Branch 2/Relaxation time": "6.56",
       "Branch 3/Modulus": "10.83 kPa", "Branch 3/Relaxation time": "61.25"}


def element(formulation, degree):
    """The entries that choose it."""
    return {"Discretisation/Formulation": formulation, "Discretisation/Degree": str(degree)}


def balloon_errors(program, folder, entries, ranks=1):
    """Largest relative errors of radii and volume at 4 kPa, and there with 15 kV."""
    curve = program.run("balloon_axisymmetric", folder, *settings({**QUIET, **entries}),
                        ranks=ranks).curve("load", "voltage_kV", "tip_u1_mm", "centre_u1_mm",
                                           "enclosed_volume_mm3", "unstable_directions")
    require(not any(curve["unstable_directions"]), "a stable balloon is called unstable")
    found = []
    for row in (list(curve["load"]).index(1), -1):
        exact = balloon_exact.Balloon().at_pressure(0.004, curve["voltage_kV"][row], 9.99, 13.3)
        found.append(max(abs((10 + curve["tip_u1_mm"][row]) / exact.inner - 1),
                         abs((11 + curve["centre_u1_mm"][row]) / exact.outer - 1),
                         abs(curve["enclosed_volume_mm3"][row] / (exact.volume / 2) - 1)))
    return found


def check_balloon(program, folder, ranks):
    """As it is written."""
    inflated, driven = balloon_errors(program, folder, {}, ranks)
    print(f"{ranks} rank(s), balloon: radii and volume are {inflated:.1e} off at 4 kPa, {driven:.1e} "
          "with 15 kV")
    validated("balloon_axisymmetric", "radii and enclosed volume at 4 kPa and 15 kV",
              "radial boundary value problem", driven)
    require(max(inflated, driven) < 1e-5, "not the exact balloon")


def check_elements(program, folder):
    """Every element tends to it with its order."""
    for formulation, degree, expected in ELEMENTS:
        cells = (8, 16) if expected == 4 else (16, 32)
        errors = [balloon_errors(program, folder, {
            "Mesh/Parameters": f"Ri: 10, Ro: 11, n1: {n // 8 * 2}, n3: {n}",
            **element(formulation, degree)})[1] for n in cells]
        order = math.log2(errors[0] / errors[1])
        print(f"balloon, {formulation}, degree {degree}: errors {errors[0]:.1e}, {errors[1]:.1e}, "
              f"order {order:.2f}")
        require(order > expected - 0.2, f"{formulation}, degree {degree}: order {order:.2f}")


def check_limits(program, folder):
    """Pull-in at 4 kPa, and the largest pressure without voltage."""
    balloon = balloon_exact.Balloon()
    exact = brentq(lambda V: balloon.limit_point(V, 10.5, 18).pressure - 0.004, 16, 16.3, xtol=1e-6)
    case = program.run("balloon_axisymmetric", folder / "voltage", *settings(
        {**QUIET, "Loading/Target": "17 kV", "Loading/Expected end": "pull-in"}))
    last = case.curve("voltage_kV", "e")
    below, above = (e * last["voltage_kV"][-1] / last["e"][-1] for e in case.pull_in())
    print(f"pull-in at 4 kPa between {below:.4f} and {above:.4f} kV, exactly {exact:.4f}")
    validated("balloon_axisymmetric", "pull-in voltage at 4 kPa, middle of the bracket",
              "radial boundary value problem", (below + above) / 2 / exact - 1)
    require(below < exact < above, "the pull-in is not in its bracket")

    curve = program.run("balloon_axisymmetric", folder / "pressure", *settings({
        **QUIET, "Loads/Pressure": "inner: 10 kPa", "Loading/Stages": "pressure 1",
        "Loading/Until": "enclosed_volume_mm3: 8000", "Stepping/Continuation": "automatic",
        "Regions/Passive": "wall", "Electrodes/Potential": "",
        "Output/Observables": "tip, centre, enclosed_volume"})).curve("load", "event")
    largest = 0.01 * curve["load"][list(curve["event"]).index("limit point")]
    off = largest / balloon.limit_point(0, 12, 17).pressure - 1
    print(f"largest pressure {1e3 * largest:.5f} kPa, {off:.1e} off")
    validated("balloon_axisymmetric", "largest pressure", "radial boundary value problem", off)
    require(abs(off) < 1e-5, "not the largest pressure")


def check_tube(program, folder, ranks):
    """Radii, potential and temperature of all cases; the charge is that of the whole ring."""
    scene = "verification/thermo_electric_tube"
    names = ("tip_u1_mm", "centre_u1_mm", "probe_phi_kV", "probe_theta_K")
    with open(program.source / "tests/reference/tube.csv", newline="", encoding="utf8") as file:
        rows = list(csv.DictReader(file))
    worst = [0.0, 0.0]
    for row in rows:
        curve = program.run(f"{scene}_axisymmetric", folder / "ring", *settings({
            **QUIET, "Loading/Target": str(max(float(row["V_kV"]), 1e-9)),
            "Temperature/Fixed": f"inner: {row['theta_inner_K']}, outer: {row['theta_outer_K']}"}),
            ranks=ranks).curve(*names)
        found = [curve[name][-1] + shift for name, shift in zip(names, (1, 2, 0, 0))]
        exact = [float(row[name]) for name in
                 ("r_inner_mm", "r_outer_mm", "phi_at_R_1.5_kV", "theta_at_R_1.5_K")]
        off = [abs(f - e) / max(abs(e), 1) for f, e in zip(found, exact)]
        worst = [max(worst[0], *off[:2]), max(worst[1], *off[2:])]
    print(f"{ranks} rank(s), tube: radii are {worst[0]:.1e} off, potential and temperature "
          f"{worst[1]:.1e}, in {len(rows)} cases")
    validated("thermo_electric_tube_axisymmetric", "radii, potential and temperature, all cases",
              "boundary value problem, two codes", max(worst))
    require(max(worst) < 1e-6, "not the exact tube")

    charges = [program.run(scene + name, folder / "charge", *settings({
        **QUIET, "Output/Observables": "tip, centre, probe, charge"}), ranks=ranks).curve(
            "charge_uC")["charge_uC"][-1] for name in ("", "_axisymmetric")]
    off = charges[1] / (0.125 * 4 * charges[0]) - 1  # of a quarter and 1 mm, and of 0.125 mm of all
    print(f"{ranks} rank(s): its charge is {off:.1e} off that of the quarter in plane strain")
    require(abs(off) < 1e-6, "not the charge of the whole ring")


def check_membrane(program, folder, ranks):
    """The thinner, the nearer to a membrane in plane stress: the cells are fine at the edges only."""
    material = planar_exact.Material(alpha=0.182321556793955, theta_0=294)
    thin, errors = Membrane(material, THETA, 5, 15), []
    exact = 5 * (thin.state(material.field(0.5, THETA))[0] - 1)
    for h in (1e-2, 1e-3, 1e-4):
        n = round(math.log(5 / h) / math.log(1.15)) + 6
        curve = program.run("membrane_axisymmetric", folder, *settings({
            **QUIET, "Loading/Film thickness": str(h), "Mesh/Parameters":
            f"R: 15, Re: 5, h: {h}, n1: {n}, n2: {n + 4}, n3: 2, coarser: 1.15"}),
            ranks=ranks).curve("tip_u1_mm", "lambda_3")
        errors.append(curve["tip_u1_mm"][-1] / exact - 1)
    at_rest = abs(curve["lambda_3"][0] - thin.thinned(1.0))
    print(f"{ranks} rank(s): the electrode grows by {exact:.6f} mm; errors of films of 0.01, 0.001, "
          f"0.0001 mm {' '.join(f'{error:.2e}' for error in errors)}; at rest lambda_3 is {at_rest:.1e} off")
    validated("membrane_axisymmetric", "lambda_3 at rest", "exact, homogeneous", at_rest)
    validated("membrane_axisymmetric", "growth of the electrode at e = 0.5, h = 0.0001 mm",
              "thin membrane in plane stress", errors[-1])
    require(at_rest < 1e-9 and abs(errors[-1]) < 1e-5, "not the thin membrane")
    require(all(9 < thick / thinner < 11 for thick, thinner in zip(errors, errors[1:])),
            "the error is not proportional to the thickness")


def check_diaphragm(program, folder, ranks):
    """The thinner, the nearer to a membrane: it bends at its rim, in a length like its thickness."""
    errors = []
    for h, n in ((0.1, 32), (0.05, 40), (0.025, 48)):
        height = Diaphragm(planar_exact.Material(), THETA, 10, h).height(3e-3 * h, 15 * h)
        tip = program.run("diaphragm", folder, *settings({
            **QUIET, "Loading/Film thickness": str(h), "Loading/Target": str(15 * h),
            "Loads/Pressure": f"bottom: {3e-3 * h}",
            "Mesh/Parameters": f"Ri: 0, Ro: 10, H: {h}, n1: {n}, n3: 1, finer: 0.8"}),
            ranks=ranks).curve("tip_u3_mm")["tip_u3_mm"][-1]
        errors.append(tip / height - 1)
    limit = 2 * errors[2] - errors[1]
    print(f"{ranks} rank(s), diaphragm: height {height:.5f} mm, errors of films of 0.1, 0.05, 0.025 mm "
          f"{' '.join(f'{error:.2e}' for error in errors)}, extrapolated {limit:.1e}")
    validated("diaphragm", "height at 0.3 kPa and 1.5 kV, extrapolated to a thin film",
              "boundary value problem of a membrane", limit)
    require(errors[0] > errors[1] > errors[2] > 0 and abs(limit) < 3e-5, "not the thin diaphragm")


def check_weight(program, folder, ranks):
    """A cylinder under a force on its top: its stress is the force over the circle."""
    force = 0.1 * math.pi
    curve = program.run("verification/cylinder", folder, *settings(QUIET), ranks=ranks).curve(
        "lambda_3", "displacement_u1_mm", "reaction_f3_N")
    mu, K = planar_exact.Material().mu(THETA), planar_exact.Material().K

    def unbalanced(stretch):
        pressure = K * math.log(stretch[0] ** 2 * stretch[1]) - mu
        return (mu * stretch[0] ** 2 + pressure,
                mu * stretch[1] ** 2 + pressure - 0.1 * stretch[1])

    exact = fsolve(unbalanced, (0.8, 1.6), xtol=1e-12)
    off = max(abs(curve["displacement_u1_mm"][-1] + 1 - exact[0]), abs(curve["lambda_3"][-1] - exact[1]))
    print(f"{ranks} rank(s), cylinder under a weight: stretches {exact[0]:.5f}, {exact[1]:.5f}, "
          f"{off:.1e} off; the force on its base is {curve['reaction_f3_N'][-1] / -force - 1:.1e} off")
    validated("cylinder", "stretches under a weight", "exact, homogeneous", off)
    require(off < 1e-9 and abs(curve["reaction_f3_N"][-1] / force + 1) < 1e-8, "not the exact cylinder")


def check_relaxation(program, folder, ranks):
    """A viscoelastic cylinder, stretched and held, has the stress of the strip in space."""
    time = {"Time/Analysis": "transient", "Time/End": "100", "Time/Initial step": "0.5",
            "Time/Strain tolerance": "0.1", "Time/Motion amplitude": "0: 0, 50: 1"}
    cylinder = {**LIGHT, "Loading/Stages": "move 1", "Supports/Moved": "top: u3 1.5",
                "Observables/reaction/At": "top", "Discretisation/Degree": "1",
                **{f"Materials/elastomer/{name}": value for name, value in VHB.items()}}
    stresses = [program.run(scene, folder / force, *settings({**QUIET, **time, **entries}),
                            ranks=ranks).curve(force)[force]
                for scene, entries, force in (("relaxation", {}, "reaction_f1_N"),
                                              ("verification/cylinder", cylinder, "reaction_f3_N"))]
    off = max(abs(stresses[1] / math.pi - stresses[0])) / max(stresses[0])
    print(f"{ranks} rank(s): {len(stresses[0])} states of a stretched viscoelastic cylinder are "
          f"{off:.1e} off those of a strip")
    require(off < 1e-8, "not the stress of the strip")


def check_heat(program, folder, ranks):
    """A long cylinder whose surface is suddenly hot: its axis against the series of Bessel functions."""
    errors = []
    for steps in (20, 40):
        curve = program.run("verification/cylinder", folder, *settings({
            **LIGHT, "Mesh/Parameters": "Ri: 0, Ro: 0.5, H: 0.1, n1: 20, n3: 1",
            "Output/Observables": "displacement, lambda_3, reaction, probe",
            "Observables/probe/At": "inner_end", "Temperature/Model": "transient",
            "Temperature/Value": "293", "Temperature/Fixed": "outer: 353", "Time/End": "0.6",
            "Time/Tolerance": "0", "Time/Initial step": repr(0.6 / steps)}),
            ranks=ranks).curve("probe_theta_K")
        zeros = jn_zeros(0, 50)
        rate = slab_exact.CONDUCTIVITY / slab_exact.CAPACITY / 0.25
        series = sum(2 / (zeros * j1(zeros)) * np.exp(-zeros**2 * rate * 0.6))
        exact = slab_exact.WALL - (slab_exact.WALL - slab_exact.START) * series
        errors.append(abs(curve["probe_theta_K"][-1] - exact))
    order = math.log2(errors[0] / errors[1])
    print(f"{ranks} rank(s), heated cylinder: the axis at {exact:.4f} K is {errors[0]:.1e}, "
          f"{errors[1]:.1e} K off, order {order:.2f}")
    validated("cylinder", "temperature of the axis in K after 0.6 s, heated from outside, 40 steps",
              "series of Bessel functions", errors[1])
    require(order > 1.8 and errors[1] < 0.02, "not the temperature of the cylinder")


def check_convection(program, folder, ranks):
    """A ring that is hot inside and cooled by the air around it, and a disc that is cooled from above."""
    k, h, inside, air = slab_exact.CONDUCTIVITY, 0.1, 353.0, 293.0
    resistances = math.log(2) / k, 1 / (2 * h)  # of a ring from 1 to 2 mm and of its surface, times 2 pi
    exact = (inside - (inside - air) * resistances[0] / sum(resistances),
             inside - (inside - air) * (1 / k) / (1 / k + 1 / h))
    off = []
    for walls, surface, mesh, theta in (("inner: 353", "outer", "Ri: 1, Ro: 2, H: 0.1, n1: 32", exact[0]),
                                        ("bottom: 353", "top", "Ri: 0, Ro: 2, H: 1, n1: 4", exact[1])):
        curve = program.run("verification/cylinder", folder / surface, *settings({
            **LIGHT, "Mesh/Parameters": f"{mesh}, n3: 1", "Temperature/Model": "steady",
            "Output/Observables": "displacement, lambda_3, reaction, probe",
            "Observables/probe/At": surface, "Temperature/Fixed": walls,
            "Heat/Convection": f"{surface}: {h}", "Heat/Surroundings": f"{surface}: {air}"}),
            ranks=ranks).curve("probe_theta_K")
        off.append(abs(curve["probe_theta_K"][-1] - theta))
    print(f"{ranks} rank(s), convection: ring at {exact[0]:.4f} K, {off[0]:.1e} K off; disc at "
          f"{exact[1]:.4f} K, {off[1]:.1e} K off")
    validated("cylinder", "temperature in K of a ring and of a disc cooled by air", "exact", max(off))
    require(off[0] < 1e-5 and off[1] < 1e-8, "not the temperature of the surface")


def check_charge(program, folder, ranks):
    """A disc between plates has Q = eps V pi R^2/h, a ring Q = 2 pi eps H V/ln(Ro/Ri), both at rest."""
    eps = planar_exact.Material().eps(THETA)
    off = []
    for electrodes, mesh, exact in (
            ("bottom: 0, top: 1", "Ri: 0, Ro: 3, H: 0.5", eps * math.pi * 9 / 0.5),
            ("inner: 0, outer: 1", "Ri: 1, Ro: 2, H: 0.5", eps * math.pi / math.log(2))):
        curve = program.run("verification/cylinder", folder / mesh[:5], *settings({
            **LIGHT, "Regions/Passive": "", "Electrodes/Potential": electrodes,
            "Mesh/Parameters": f"{mesh}, n1: 32, n3: 1", "Loading/Stages": "voltage 1",
            "Loading/Control": "voltage", "Loading/Target": "1e-3", "Loading/Film thickness": "1",
            "Output/Observables": "displacement, lambda_3, reaction, charge"}),
            ranks=ranks).curve("charge_uC", "voltage_kV")
        off.append(abs(curve["charge_uC"][-1] / curve["voltage_kV"][-1] / exact - 1))
    print(f"{ranks} rank(s): capacitances of disc and ring are {off[0]:.1e}, {off[1]:.1e} off")
    validated("cylinder", "capacitance of a disc and of a ring", "exact", max(off))
    require(max(off) < 1e-6, "not the capacitance")


def check_solvers(program, folder, ranks):
    """The block solver finds what the direct one does."""
    tips = [program.run("balloon_axisymmetric", folder / solver, *settings(
        {**QUIET, "Linear solver/Solver": solver}), ranks=ranks).curve("tip_u1_mm")["tip_u1_mm"][-1]
        for solver in ("direct", "block")]
    print(f"{ranks} rank(s): with the block solver the inner radius differs by {tips[1] - tips[0]:.1e} mm")
    require(abs(tips[1] - tips[0]) < 1e-7, "the block solver finds another balloon")


WRONG = (("in space", {"Dimension": "3", "Mesh/File": "meshes/box.geo", "Mesh/Parameters": "",
                       "Loads/Force": "top: 0 0 1"},
          "entry 'Geometry': a scene in space"),
         ("beyond the axis", {"Mesh/Parameters": "Ri: -1, Ro: 1"},
          "section Mesh, entry 'File': the mesh has a vertex at x1 = -1 mm"),
         ("axis moved", {"Supports/Moved": "inner: u1 0.1"}, "u1 of a point on the axis"),
         ("floats", {"Supports/Fixed": "outer: u1"}, "it can move along x3"),
         ("force on the axis", {"Loads/Force": "inner: 0 1"}, "'inner' is no outer surface"),
         ("electrode on the axis", {"Regions/Passive": "", "Electrodes/Potential": "inner: 0, outer: 1"},
          "'inner' lies on the axis"),
         ("wall on the axis", {"Temperature/Model": "steady", "Temperature/Fixed": "inner: 293"},
          "'inner' lies on the axis"),
         ("pressure on the axis", {"Loads/Pressure": "inner: 1 kPa", "Loading/Stages": "pressure 1"},
          "'inner' is no outer surface"),
         ("air on the axis", {"Temperature/Model": "steady", "Heat/Convection": "inner: 1",
                              "Heat/Surroundings": "inner: 293"}, "'inner' is no outer surface"),
         ("force per depth", {"Loads/Force": "top: 0 1 N/mm"}, "in N with"),
         ("mean over the axis", {"Observables/lambda_3/From": "inner"}, "has no area"),
         ("rotation", {"Output/Observables": "displacement, lambda_3, reaction, mid_rotation",
                       "Observables/mid_rotation/Section": "0"},
          "have no rotation"))


def check_sentences(program, folder, all_ranks):
    """What makes no sense is answered."""
    for (name, entries, words), ranks in itertools.product(WRONG, all_ranks):
        command = program.command(["prm/verification/cylinder.prm", "--output", str(folder),
                                   *settings(entries)], ranks)
        done = subprocess.run(command, cwd=program.source, capture_output=True, text=True, check=False)
        print(f"{name} ({ranks}): {done.stderr.strip()}")
        require(done.returncode == 1 and any(words in line for line in sentences(done.stderr)),
                f"{name}: no sentence with {words}")


def main():
    program, all_ranks = program_and_ranks(__doc__)
    checks = (check_balloon, check_tube, check_membrane, check_diaphragm, check_weight,
              check_relaxation, check_heat, check_convection, check_charge, check_solvers)
    side_by_side(program, *itertools.product(checks, all_ranks), (check_elements,), (check_limits,),
                 (check_sentences, all_ranks))


main()
