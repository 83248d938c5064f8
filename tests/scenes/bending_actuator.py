"""The bending actuator against the exact circle and, on the paper's mesh, an independent code.

Usage: bending_actuator.py THELMA_BINARY MPIEXEC SOURCE_DIR RANKS...

bending_reference.py says where the circle comes from. The two angles of the paper's mesh come from an
independent finite element code.
"""

import csv
import json
import math
import tempfile
from pathlib import Path

from bending_reference import exact_mid_rotation
from scene import program_and_ranks, require, validated


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
        validated("bending_actuator_plane", f"rotation of mid-length at e = {field}, {theta} K, "
                  f"alpha = {alpha}, 4 x 40 cells", "exact circle", errors[1])
        require(errors[1] < 1e-4, f"error {errors[1]:.1e} is not below 0.01 %")
        require(order > 3.5, f"order {order:.2f} is not about 4")


def check_curves(program, folder, ranks):
    """Five temperatures, without and with expansion, to e = 0.87, over 700 degrees at 273 K."""
    alphas, thetas = (0.0, 1.8e-4), (273.0, 293.0, 313.0, 333.0, 353.0)
    program.run("bending_actuator_plane", folder,
                "--set", "Mesh/Parameters=n1: 8, n3: 100", "--set", "Output/Fields=none",
                "--sweep", "Materials/elastomer/Thermal expansion=" + ",".join(map(str, alphas)),
                "--sweep", "Temperature/Value=" + ",".join(map(str, thetas)), ranks=ranks)
    with open(folder / "study.csv", newline="", encoding="utf8") as file:
        for row in csv.DictReader(file):
            alpha = float(row["Materials/elastomer/Thermal expansion"])
            theta = float(row["Temperature/Value"])
            exact = exact_mid_rotation(program.source, alpha, theta, 0.87)
            error = float(row["mid_rotation_deg"]) / exact - 1
            print(f"alpha {alpha} theta {theta} e 0.87: exact {2 * exact:.3f} degrees over the "
                  f"length, relative error {error:.1e}")
            require(abs(error) < 1e-4, f"error {error:.1e} is not below 0.01 %")


def check_iterations(program, folder):
    """The whole curve at 353 K takes at most 60 iterations."""
    program.run("bending_actuator_plane", folder)
    iterations = json.loads((folder / "run.json").read_text())["newton_iterations"]
    print(f"{iterations} Newton iterations to e = 0.87")
    require(iterations <= 60, f"{iterations} iterations are more than 60")


def check_plane_against_space(program, folder, ranks):
    """On matching meshes plane strain and the body held at its sides are the same, up to fields at which
    waves across its width would matter (doc/theory.md, eq. 30)."""
    values = []
    for scene, mesh in [("bending_actuator_plane", "n1: 2, n3: 14"),
                        ("bending_actuator", "n1: 2, n2: 1, n3: 14")]:
        values.append(last_value(program, scene, folder, "mid_rotation_deg", 0.75,
                                 "--set", f"Mesh/Parameters={mesh}",
                                 "--set", "Discretisation/Degree=2",
                                 "--set", "Discretisation/Formulation=mean dilatation",
                                 ranks=ranks))
    difference = abs(values[1] / values[0] - 1)
    print(f"{ranks} rank(s): plane and space differ by {difference:.1e}")
    require(difference < 1e-6, f"plane and space differ by {difference:.1e}")


def main():
    program, all_ranks = program_and_ranks(__doc__)
    with tempfile.TemporaryDirectory() as folder:
        check_convergence(program, Path(folder), 1)
        for ranks in all_ranks:
            check_plane_against_space(program, Path(folder), ranks)
        check_curves(program, Path(folder) / "study", max(all_ranks))
        check_iterations(program, Path(folder) / "whole")
        for field, angle in [(0.5, 81.5), (0.87, 335.0)]:
            found = last_value(program, "bending_actuator", Path(folder), "end_rotation_deg", field)
            print(f"paper's mesh and element, e = {field}: end face turns {found:.2f} degrees "
                  f"({angle})")
            validated("bending_actuator", f"rotation of the end face at e = {field}, paper's mesh "
                      "and element", "independent code, same element", found / angle - 1)
            require(abs(found / angle - 1) < 0.01, f"it turns {found:.2f} degrees, not {angle}")


main()
