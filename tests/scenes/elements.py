"""Where each element formulation fails in the scenes, and the energy it reports.

Usage: elements.py THELMA_BINARY MPIEXEC SOURCE_DIR RANKS...

Truth: the exact circle (tests/reference/bilayer_bending.csv), the exact pull-in of a film, and the
balance of energy: along a curve the source does the work d(elastic + electric) = V dQ.
"""

import json
import math

from bending_reference import exact_mid_rotation
from scene import program_and_ranks, require, side_by_side, validated

FORMULATIONS = {  # name: formulation, degree, cells; all with the same nodes
    "Q1 standard": ("standard", 1, (4, 20)),
    "Q1 selective reduced": ("selective reduced", 1, (4, 20)),
    "Q1/P0": ("mean dilatation", 1, (4, 20)),
    "Q1 enhanced": ("enhanced strain", 1, (4, 20)),
    "Q2 standard": ("standard", 2, (2, 10)),
    "Q2 selective reduced": ("selective reduced", 2, (2, 10)),
    "Q2/P1": ("mean dilatation", 2, (2, 10)),
}


def run(program, folder, name, *options, cells=None, ranks=1):
    """The plane actuator with one of the formulations."""
    formulation, degree, own_cells = FORMULATIONS[name]
    n1, n3 = cells or own_cells
    return program.run("bending_actuator_plane", folder,
                       "--set", f"Discretisation/Formulation={formulation}",
                       "--set", f"Discretisation/Degree={degree}",
                       "--set", f"Mesh/Parameters=n1: {n1}, n3: {n3}",
                       "--set", "Output/Fields=none", *options, ranks=ranks)


def rotation_error(program, folder, name, field, theta, alpha, **more):
    """Relative error of the rotation to mid-length."""
    case = run(program, folder, name, "--set", f"Loading/Target={field}",
               "--set", f"Temperature/Value={theta}",
               "--set", f"Materials/elastomer/Thermal expansion={alpha}", **more)
    computed = case.curve("mid_rotation_deg")["mid_rotation_deg"][-1]
    return computed / exact_mid_rotation(program.source, alpha, theta, field) - 1


def check_locking(program, folder):
    """All formulations on meshes with the same nodes."""
    errors = {name: rotation_error(program, folder, name, 0.5, 353.0, 1.8e-4)
              for name in FORMULATIONS}
    for name, error in errors.items():
        print(f"{name}, {FORMULATIONS[name][2]} cells: error of the rotation {100 * error:.2f} %")
    require(errors["Q1 standard"] < -0.9, "the standard linear element does not lock")
    require(errors["Q2 standard"] < -0.05, "the standard quadratic element does not lock")
    require(-0.25 < errors["Q1/P0"] < -0.15, "Q1/P0 has no parasitic shear")
    require(abs(errors["Q1 selective reduced"] - errors["Q1/P0"]) < 1e-3,
            "selective reduction and Q1/P0 differ")
    require(abs(errors["Q1 enhanced"]) < 0.2 * abs(errors["Q2/P1"]) + 1e-3,
            "the enhanced element is worse than Q2/P1 with the same nodes")


def check_parasitic_shear(program, folder):
    """Small rotations against the stiffness 1 + (a/t)^2/4 - 1/(2 n^2) of the linear element."""
    for n1, n3 in [(4, 20), (4, 40), (8, 20)]:
        error = rotation_error(program, folder, "Q1/P0", 0.05, 293.0, 0.0, cells=(n1, n3))
        stiffness, expected = 1 / (1 + error), 1 + (20 / n3) ** 2 / 4 - 1 / (2 * n1**2)
        print(f"Q1/P0, {n1} x {n3} cells: stiffness {stiffness:.4f}, by hand {expected:.4f}")
        validated("bending_actuator_plane", f"stiffness of Q1/P0 with parasitic shear, {n1} x {n3}",
                  "by hand, small rotations", stiffness / expected - 1)
        require(abs(stiffness / expected - 1) < 0.01, "the parasitic stiffness is another")


def check_convergence(program, folder, ranks):
    """The enhanced element converges with order 2."""
    errors = [abs(rotation_error(program, folder, "Q1 enhanced", 0.5, 353.0, 1.8e-4,
                                 cells=(2, n3), ranks=ranks)) for n3 in (6, 10)]
    order = math.log(errors[0] / errors[1]) / math.log(10 / 6)
    print(f"Q1 enhanced, {ranks} rank(s), 2 x 6 and 2 x 10 cells: errors "
          f"{errors[0]:.1e} {errors[1]:.1e}, order {order:.2f}")
    require(errors[1] < 0.003 and order > 1.8, "the enhanced element does not converge")


def check_energy(program, folder):
    """The work of the source, by the trapezoidal rule, against the energies."""
    for name in FORMULATIONS:
        case = run(program, folder, name, "--set", "Loading/Target=0.5",
                   "--set", "Stepping/Initial step=0.01", "--set", "Stepping/Largest step=0.01")
        curve = case.curve("voltage_kV", "charge_uC", "energy_elastic_mJ", "energy_electric_mJ")
        voltage, charge = curve["voltage_kV"], curve["charge_uC"]
        work = sum((charge[i + 1] - charge[i]) * (voltage[i] + voltage[i + 1]) / 2
                   for i in range(len(voltage) - 1))
        stored = [a + b for a, b in zip(curve["energy_elastic_mJ"], curve["energy_electric_mJ"])]
        gained = stored[-1] - stored[0]
        print(f"{name}: work of the source {work:.6g} mJ, stored {gained:.6g} mJ, "
              f"difference {gained / work - 1:.1e}")
        require(abs(gained / work - 1) < 2e-5, "energy is not conserved")


def check_slender_cells(program, folder):
    """Enhanced cells narrow along a compression hourglass; Q2/P1 says that the body is stable."""
    for formulation, degree, cells, stable in [("mean dilatation", 2, (2, 4, 14), True),
                                               ("enhanced strain", 1, (2, 4, 20), True),
                                               ("enhanced strain", 1, (2, 8, 20), False)]:
        case = program.run("bending_actuator", folder,
                           "--set", f"Discretisation/Formulation={formulation}",
                           "--set", f"Discretisation/Degree={degree}",
                           "--set", "Mesh/Parameters=W: 2, n1: {}, n2: {}, n3: {}".format(*cells),
                           "--set", "Loading/Target=0.75", "--set", "Output/Fields=none")
        unstable = case.curve("unstable_directions")["unstable_directions"][-1]
        print(f"{formulation}, {cells} cells, 2 mm wide, e = 0.75: {unstable:.0f} unstable")
        require((unstable == 0) == stable, "stability is not as expected")


def check_pull_in(program, folder):
    """The enhanced element in the homogeneous film, down to a stretch of 0.63."""
    program.run("planar_actuator", folder, "--set", "Discretisation/Formulation=enhanced strain",
                "--set", "Discretisation/Degree=1",
                "--set", "Output/Fields=none")
    pull_in = json.loads((folder / "run.json").read_text())["pull_in"]
    print("planar actuator, enhanced: pull-in", pull_in)
    require(pull_in["e_below"] < 0.687366 < pull_in["e_above"], "the pull-in is elsewhere")


def main():
    program, all_ranks = program_and_ranks(__doc__)
    side_by_side(program, (check_energy,), (check_slender_cells,), (check_locking,),
                 (check_parasitic_shear,), *((check_convergence, ranks) for ranks in all_ranks),
                 (check_pull_in,))


main()
