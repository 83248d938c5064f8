"""The bending actuator against the exact circle and, on the paper's mesh, an independent code.

Usage: bending_actuator.py THELMA_BINARY MPIEXEC SOURCE_DIR RANKS...

tests/reference/bilayer_bending.csv: curvature of the exact circle (doc/theory.md, "Bending") from
the one-dimensional boundary value problem, solved to 1e-11 by an independent program. The two
angles of the paper's mesh come from an independent finite element code.
"""

import csv
import math
import tempfile
from pathlib import Path

from scene import program_and_ranks, require

LENGTH, LAYER = 20.0, 0.5  # mm


def exact_mid_rotation(source, alpha, theta, field):
    """Degrees that the section X3 = L/2 turns."""
    with open(source / "tests/reference/bilayer_bending.csv", newline="", encoding="utf8") as file:
        for row in csv.DictReader(file):
            if (float(row["alpha_per_K"]), float(row["theta_K"]), float(row["e"])) == (
                    alpha, theta, field):
                return math.degrees(
                    float(row["curvature_times_layer_thickness_rad"]) / LAYER * LENGTH / 2)
    raise LookupError(f"no row for alpha {alpha}, theta {theta}, e {field}")


def last_value(program, scene, folder, column, field, *options, ranks=1):
    """The newest value of a column after a run to the field e."""
    case = program.run(scene, folder, "--set", f"Loading/Target={field}", *options, ranks=ranks)
    return case.curve(column)[column][-1]


def check_convergence(program, folder, ranks):
    """Q2/P1 in the plane converges to the circle with order 2p = 4 in the rotation."""
    for alpha, theta, field in [(0.0, 293.0, 0.5), (1.8e-4, 353.0, 0.5), (1.8e-4, 273.0, 0.5)]:
        exact = exact_mid_rotation(program.source, alpha, theta, field)
        errors = []
        for n1, n3 in [(2, 20), (4, 40)]:
            value = last_value(
                program, "bending_actuator_plane", folder, "mid_rotation_deg", field,
                "--set", f"Mesh/Parameters=n1: {n1}, n3: {n3}",
                "--set", f"Temperature/Value={theta}",
                "--set", f"Materials/elastomer/Thermal expansion={alpha}", ranks=ranks)
            errors.append(abs(value / exact - 1))
        order = math.log2(errors[0] / errors[1])
        print(f"alpha {alpha} theta {theta} e {field}: exact {exact:.4f} degrees, relative errors "
              f"{errors[0]:.1e} {errors[1]:.1e}, order {order:.2f}")
        require(errors[1] < 1e-4, f"error {errors[1]:.1e} is not below 0.01 %")
        require(order > 3.5, f"order {order:.2f} is not about 4")


def main():
    program, all_ranks = program_and_ranks(__doc__)
    with tempfile.TemporaryDirectory() as folder:
        for ranks in all_ranks:
            check_convergence(program, Path(folder), ranks)
        angle = last_value(program, "bending_actuator", Path(folder), "end_rotation_deg", 0.5)
        print(f"paper's mesh and element, e = 0.5: end face turns {angle:.2f} degrees (81.5)")
        require(abs(angle / 81.5 - 1) < 0.01, f"end face turns {angle:.2f} degrees, not 81.5")


main()
