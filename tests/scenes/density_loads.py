"""Loads per volume and per area, constant and as expressions of x1, x2, x3 and t.

    density_loads.py THELMA_BINARY MPIEXEC SOURCE_DIR RANKS...

Every state is exact: homogeneous, of one coordinate along a block whose sides are held, or
manufactured, with the loads that hold it. Elements that contain the state must find it; the others
converge to it with their order.
"""

import math
import subprocess

import numpy as np
from scipy.integrate import quad
from scipy.optimize import brentq

from scene import program_and_ranks, require, settings, side_by_side, validated
from thelma import planar_exact

MATERIAL = planar_exact.Material(K=0.6)
MU, EPS = MATERIAL.mu(293), MATERIAL.eps(293)
LENGTH, G = 4.0, 9.80665e-9  # mm, N/mm^3 for 1 kg/m^3
FORMULATIONS = (("selective reduced", 1), ("mean dilatation", 1), ("enhanced strain", 1),
                ("mean dilatation", 2))
CLAMPED = {"Loads/Gravity": "", "Supports/Fixed": "bottom: u1 u2 u3"}
CHARGED = {"Loads/Gravity": "", "Regions/Passive": "", "Electrodes/Potential": "bottom: 0",
           "Output/Observables": "displacement, probe, ledger", "Observables/probe/At": "top"}


def run(program, folder, ranks, formulation, entries, n=8, across=1):
    """The curve of the block under other loads, with n cells along it."""
    law, degree = formulation
    return program.run("verification/loaded_block", folder, *settings(
        {"Discretisation/Formulation": law, "Discretisation/Degree": str(degree),
         "Mesh/Parameters": f"L1: 1, L2: 1, L3: {LENGTH}, n1: {across}, n2: {across}, n3: {n}",
         "Output/Fields": "none", **entries}), ranks=ranks).curve()


def require_convergence(program, folder, ranks, what, entries, exact):
    """Last values of columns to the order of each formulation: h^2 of Q1, at least h^3 of Q2."""
    for formulation in FORMULATIONS:
        errors = []
        for n in (8, 16):
            curve = run(program, folder, ranks, formulation, entries, n)
            errors.append(max(abs(curve[name][-1] / value - 1) for name, value in exact.items()))
        order = math.log2(errors[0] / errors[1]) if errors[1] > 1e-10 else math.inf
        print(f"{ranks} rank(s), {what}, {formulation[0]}, degree {formulation[1]}: errors "
              f"{errors[0]:.1e}, {errors[1]:.1e} with 8 and 16 cells, order {order:.2f}")
        require(order > (1.9, 2.9)[formulation[1] - 1], f"{what} does not converge")
        require(errors[1] < (2e-3, 1e-6)[formulation[1] - 1], f"{what} is not exact")
    validated("loaded_block", f"{', '.join(exact)}, {what}", "exact, along one axis", errors[1])


def hanging(density):
    """Displacement of the end under a body force density(x3) (N/mm^3): the stress of every cross
    section bears what hangs below it."""
    def stretch(X):
        stress = quad(density, X, LENGTH, epsabs=1e-14)[0]
        return brentq(lambda s: MU * (s - 1 / s) + MATERIAL.K * math.log(s) / s - stress, 0.3, 2.5,
                      xtol=1e-15)

    return quad(lambda X: stretch(X) - 1, 0, LENGTH, epsabs=1e-13)[0]


def check_gravity(program, folder, ranks):
    """The block hangs by its own weight, constant or as in a centrifuge."""
    for what, entry, multiple in (
            ("gravity", "0 0 2000", lambda X: 2000),
            ("gravity of x3", "0 0 300*x3+500", lambda X: 300 * X + 500)):
        exact = hanging(lambda X, multiple=multiple: 1000 * G * multiple(X))
        require_convergence(program, folder, ranks, what, {"Loads/Gravity": entry},
                            {"displacement_u3_mm": exact})


def check_body_force(program, folder, ranks):
    """The same by a body force of the place; in plane strain and in a body of revolution, by two regions."""
    exact = {"displacement_u3_mm": hanging(lambda X: 0.01 * math.sin(X))}
    entries = {"Loads/Gravity": "", "Loads/Body force": "film: 0 0 0.01*sin(x3)",
               "Loading/Stages": "body force 1"}
    require_convergence(program, folder, ranks, "body force of x3", entries, exact)
    for geometry, sides in (("plane strain", "outer: u1, back: u1"), ("axisymmetric", "back: u1")):
        flat = program.run("verification/column", folder / geometry, *settings({
            "Geometry": geometry, "Mesh/Parameters": "L: 4, H: 1, n1: 2, n3: 16",
            "Materials/elastomer/Bulk modulus": "0.6", "Supports/Fixed": f"{sides}, x3_min: u3",
            "Loads/Force": "", "Loads/Body force": "active: 0 0.01*sin(x3), passive: 0 0.01*sin(x3)",
            "Loading/Stages": "body force 1", "Output/Fields": "none",
            "Output/Observables": "tip, reaction", "Observables/reaction/At": "x3_min"}), ranks=ranks).curve()
        depth = math.pi if geometry == "axisymmetric" else 1  # times H = 1 mm: the cross section
        errors = [flat["tip_u3_mm"][-1] / exact["displacement_u3_mm"] - 1,
                  flat["reaction_f3_N"][-1] / (-depth * 0.01 * (1 - math.cos(LENGTH))) - 1]
        print(f"{ranks} rank(s), body force, {geometry}: errors of the end {errors[0]:.1e}, of the reaction "
              f"{errors[1]:.1e}")
        require(max(map(abs, errors)) < 1e-6, f"not exact with {geometry}")
    require(refused(program, folder / "radial"), "gravity that is not along the axis")


def refused(program, folder):
    """Whether a body of revolution under gravity across its axis is."""
    command = program.command(["prm/verification/column.prm", *settings({
        "Geometry": "axisymmetric", "Supports/Fixed": "x3_min: u3", "Loads/Force": "", "Loads/Gravity": "1 0",
        "Loading/Stages": "gravity 1"}), "--output", str(folder)], 1)
    done = subprocess.run(command, cwd=program.source, capture_output=True, text=True, check=False)
    return done.returncode == 1 and "entry 'Gravity'" in done.stderr + done.stdout


def check_traction(program, folder, ranks):
    """Stretched and sheared evenly by tractions P N all around, in every element; their energy is
    minus their work."""
    F = np.array([[1, 0, 0.2], [0, 1, 0], [0, 0, 1.1]])
    inverse = np.linalg.inv(F).T
    P = MU * (F - inverse) + MATERIAL.K * math.log(np.linalg.det(F)) * inverse
    sides = {"x1_min": -P[:, 0], "x1_max": P[:, 0], "x2_min": -P[:, 1], "x2_max": P[:, 1],
             "top": P[:, 2]}
    text = ", ".join(f"{name}: " + " ".join(f"{t:.15g}" for t in traction)
                     for name, traction in sides.items())
    worst = 0.0
    for formulation in FORMULATIONS:
        curve = run(program, folder, ranks, formulation, {
            **CLAMPED, "Loads/Traction": text + " MPa", "Loading/Stages": "traction 1"}, 2, 2)
        worst = max(worst, abs(curve["displacement_u1_mm"][-1] - 0.2 * LENGTH),
                    abs(curve["displacement_u3_mm"][-1] - 0.1 * LENGTH),
                    abs(curve["energy_loads_mJ"][-1] / (-LENGTH * np.sum(P * (F - np.eye(3)))) - 1))
    print(f"{ranks} rank(s), traction: largest error of four elements {worst:.1e}")
    validated("loaded_block", "displacements and energy, traction", "exact, homogeneous", worst)
    require(worst < 1e-8, "not the homogeneous state")


def check_shear(program, folder, ranks):
    """Manufactured: u1 = a x3^2/2 with P31 = P13 = mu a x3, held by tractions of the place and a
    body force. Q2 contains it; the stress is linear in the slope, so Q1 has it at the nodes."""
    a = 0.02
    slope = f"{MU * a:.15g}*x3"
    entries = {"Loads/Gravity": "", "Loading/Stages": "body force 1, traction 1",
               "Supports/Fixed": "bottom: u1 u2 u3, x2_min: u2, x2_max: u2, top: u3",
               "Loads/Traction": f"x1_min: 0 0 -{slope}, x1_max: 0 0 {slope}, top: {slope} 0 0",
               "Loads/Body force": f"film: -{MU * a:.15g} 0 0"}
    exact = a * LENGTH**2 / 2
    worst = max(abs(run(program, folder, ranks, formulation, entries, 4)["displacement_u1_mm"][-1]
                    / exact - 1) for formulation in FORMULATIONS)
    print(f"{ranks} rank(s), manufactured shear: largest error of four elements {worst:.1e}")
    validated("loaded_block", "displacement_u1_mm, traction and body force",
              "manufactured, exact at nodes", worst)
    require(worst < 1e-8, "not the manufactured state")


def thinned(D):
    """The stretch along a given D (uC/mm^2) between held sides, without stress along it."""
    return brentq(lambda s: MU * (s - 1 / s) + MATERIAL.K * math.log(s) / s + D**2 / (2 * EPS), 0.3,
                  1.5, xtol=1e-15)


def check_free_charge(program, folder, ranks):
    """Over a ground electrode, Div D = q with D = 0 at the free end."""
    for what, text, charge in (("free charge", "7e-4", lambda X: 7e-4 * (LENGTH - X)),
                               ("free charge of x3", "2e-4*x3",
                                lambda X: 1e-4 * (LENGTH**2 - X**2))):
        def potential(X, charge=charge):
            return charge(X) * thinned(charge(X)) / EPS

        exact = {"probe_phi_kV": quad(potential, 0, LENGTH, epsabs=1e-10)[0],
                 "displacement_u3_mm": quad(lambda X, charge=charge: thinned(charge(X)) - 1, 0,
                                            LENGTH, epsabs=1e-13)[0]}
        require_convergence(program, folder, ranks, what, {
            **CHARGED, "Loads/Free charge": f"film: {text}", "Loading/Stages": "free charge 1"},
            exact)


def check_surface_charge(program, folder, ranks):
    """A charge on the free end makes an even field, in every element; it may come and go in time.
    On a floating electrode it is what the electrode has."""
    worst = 0.0
    for formulation in FORMULATIONS:
        curve = run(program, folder, ranks, formulation, {
            **CHARGED, "Loads/Surface charge": "top: 1e-3*cos(3*t)",
            "Loading/Stages": "surface charge 1", "Time/Analysis": "transient", "Time/End": "2",
            "Time/Initial step": "0.2", "Time/Largest step": "0.2"}, 2, 2)
        rows = zip(curve["load"], curve["time_s"], curve["probe_phi_kV"],
                   curve["displacement_u3_mm"])
        for level, t, phi, u in rows:
            D = 1e-3 * (math.cos(3 * t) if t > 0 else min(level, 1))
            worst = max(worst, abs(u - LENGTH * (thinned(D) - 1)),
                        abs(phi / (LENGTH * 1e-3 / EPS) - D * thinned(D) / 1e-3))
    print(f"{ranks} rank(s), surface charge in time, {len(curve['load'])} states: largest error of "
          f"four elements {worst:.1e}")
    validated("loaded_block", "phi and u3 of every state, surface charge in time",
              "exact, homogeneous", worst)
    require(worst < 1e-8, "not the homogeneous state")
    floating = run(program, folder, ranks, FORMULATIONS[3], {
        **CHARGED, "Electrodes/Floating": "top: 0", "Loads/Surface charge": "top: 1e-3",
        "Loading/Stages": "surface charge 1"}, 2)
    require(abs(floating["displacement_u3_mm"][-1] / LENGTH + 1 - thinned(1e-3)) < 1e-8,
            "on a floating electrode it is another charge")


def check_ledger(program, folder):
    """What forces and charges do is what the body has stored, to the second order of the steps."""
    loads = {"Loads/Free charge": "film: 2e-4*x3", "Loads/Surface charge": "top: 1e-3",
             "Loads/Traction": "top: 0 0 0.02*x1", "Loads/Body force": "film: 0 0 0.01*sin(x3)",
             "Loads/Gravity": "0 0 500",
             "Loading/Stages": "gravity 1, surface charge 1, free charge 1, traction 1, body force 1"}
    in_time = {"Loads/Body force": "film: 0 0 0.02*sin(x3)*sin(t)",
               "Loads/Free charge": "film: 2e-4*x3*sin(t)", "Time/Analysis": "transient",
               "Loading/Stages": "body force 1, free charge 1", "Time/End": "2"}
    for what, entries in (("in steps of load", loads), ("in time", in_time)):
        missing = []
        for step in (0.1, 0.05, 0.025):
            section = "Time" if what == "in time" else "Stepping"
            curve = run(program, folder, 1, FORMULATIONS[3], {
                **CHARGED, **entries, f"{section}/Initial step": str(step),
                f"{section}/Largest step": str(step)}, 4)
            missing.append(abs(curve["ledger_energy_missing_mJ"][-1]))
        done = curve["ledger_load_work_mJ"][-1]
        orders = [math.log2(a / b) for a, b in zip(missing, missing[1:])]
        print(f"{what}, loads do {done:.6f} mJ; missing {' '.join(f'{m:.1e}' for m in missing)} mJ, "
              f"orders {' '.join(f'{order:.2f}' for order in orders)}")
        require(min(orders) > 1.8 and missing[-1] < 1e-2 * abs(done), "energy is missing")


def main():
    """Every check on every number of ranks."""
    program, all_ranks = program_and_ranks(__doc__)
    side_by_side(program, *((check, ranks) for ranks in all_ranks for check in (
        check_gravity, check_body_force, check_traction, check_shear, check_free_charge,
        check_surface_charge)), (check_ledger,))


main()
