"""A stack, a gripper and a membrane against exact states, and the membrane against a thin one.

    actuators.py THELMA_BINARY MPIEXEC SOURCE_DIR RANKS...
"""

import itertools
import math

from membrane_reference import Membrane
from scene import largest_error, program_and_ranks, require, side_by_side, validated
from thelma import bending_exact
from thelma import planar_exact

THETA = 293.0
LAYER, LENGTH, OFFSET = 0.5, 20.0, 8.0  # mm, of a finger; OFFSET to the plane of symmetry
STACK_STRAIN = 0.0842  # with margins at e = 0.5: of finer meshes (doc/actuators.md)


def check_full_stack(program, folder, ranks):
    """Electrodes that cover the layers: every layer is a planar actuator."""
    curve = program.run("stack", folder, "--set", "Mesh/Parameters=m: 0, n1: 2, n2: 1",
                        "--set", "Expectations/Final values=", "--set", "Output/Fields=none",
                        ranks=ranks).curve("e", "lambda_1", "lambda_3")
    material = planar_exact.Material()
    worst = largest_error(curve, ("lambda_1", "lambda_3"), lambda row: planar_exact.stable_state(
        material, THETA, material.field(row["e"], THETA)))
    print(f"{ranks} rank(s): stack without margins, {len(curve['e'])} states to lambda_3 = "
          f"{curve['lambda_3'][-1]:.6f}, largest error {worst:.1e}")
    validated("stack", "lambda_1, lambda_3 without margins", "exact, homogeneous", worst)
    require(worst < 1e-8, f"a stretch is off by {worst}")


def check_margins(program, folder, ranks):
    """Margins hold the stack back; the mesh matters little."""
    found = 1 - program.run("stack", folder, "--set", "Output/Fields=none", ranks=ranks).curve(
        "lambda_3")["lambda_3"][-1]
    material = planar_exact.Material()
    free = 1 - planar_exact.stable_state(material, THETA, material.field(0.5, THETA))[1]
    print(f"{ranks} rank(s): with margins it shortens by {found:.5f}, without by {free:.5f}")
    validated("stack", "actuation strain with margins", "finer meshes",
              found / STACK_STRAIN - 1)
    require(abs(found / STACK_STRAIN - 1) < 2e-3, "not the strain of finer meshes")
    require(found < free, "margins do not hold it back")


def gap(circle):
    """mm between the inner corners of the fingers' ends: the palm holds the bond line, the curvature
    is that of the exact circle."""
    bond, inner = (LAYER * stretch / circle.curvature for stretch in (circle.stretch, circle.inner))
    turned = math.radians(circle.rotation(LENGTH / LAYER))
    return 2 * (OFFSET + LAYER - bond + inner * math.cos(turned))


def check_gripper(program, folder, ranks):
    """Rotation of the middle and gap between the tips at three voltages."""
    fields, gaps, errors = (0.1, 0.2, 0.3), [], []
    for circle in bending_exact.circles(planar_exact.Material(), THETA, fields):
        curve = program.run("gripper", folder, "--set", f"Loading/Target={circle.e}",
                            "--set", "Mesh/Parameters=n1: 4, n3: 40",
                            "--set", "Observables/end_rotation/Section=10",
                            "--set", "Expectations/Final values=", "--set", "Output/Fields=none",
                            ranks=ranks).curve("tip_u1_mm", "end_rotation_deg", "voltage_kV")
        turn = -curve["end_rotation_deg"][-1] / circle.rotation(LENGTH / LAYER / 2) - 1
        gaps.append(2 * (OFFSET + curve["tip_u1_mm"][-1]))
        errors.append((abs(turn), abs(gaps[-1] / gap(circle) - 1)))
        print(f"{ranks} rank(s): {curve['voltage_kV'][-1]:.3f} kV, gap {gaps[-1]:.4f} mm, exactly "
              f"{gap(circle):.4f}; relative error of the rotation {turn:.1e}")
    turn, apart = (max(column) for column in zip(*errors))
    validated("gripper", "rotation of mid-length, 4 x 40 cells", "exact circle", turn)
    validated("gripper", "gap between the tips", "exact circle", apart)
    require(turn < 1e-4, f"the rotation is off by {turn}")
    # The free end, without the stresses of a section, is not quite a circle.
    require(apart < 1e-3, f"the gap is off by {apart}")


def check_membrane(program, folder, ranks):
    """The thin membrane is the limit of fine meshes and thin films."""
    material = planar_exact.Material(alpha=0.182321556793955, theta_0=294)
    thin, errors = Membrane(material, THETA, 5, 15), []
    exact = 5 * (thin.state(material.field(0.5, THETA))[0] - 1)
    for n, nr, h in ((2, 2, 0.25), (4, 4, 0.125), (8, 8, 0.0625)):
        curve = program.run("membrane", folder, "--set", "Output/Fields=none",
                            "--set", f"Mesh/Parameters=n: {n}, nr: {nr}, nR: {2 * nr}, h: {h}",
                            "--set", f"Loading/Film thickness={h}",
                            "--set", "Stepping/Initial step=0.5", "--set", "Stepping/Largest step=1",
                            "--set", "Expectations/Final values=", ranks=ranks).curve(
                                "tip_u1_mm", "lambda_3")
        errors.append(abs(curve["tip_u1_mm"][-1] / exact - 1))
    at_rest = abs(curve["lambda_3"][0] - thin.thinned(1.0))
    print(f"{ranks} rank(s): the electrode grows by {exact:.5f} mm in a thin film; errors "
          f"{' '.join(f'{error:.1e}' for error in errors)}; at rest lambda_3 is off by {at_rest:.1e}")
    validated("membrane", "lambda_3 at rest", "exact, homogeneous", at_rest)
    validated("membrane", "growth of the electrode at e = 0.5, h = 0.0625 mm",
              "thin membrane in plane stress", errors[-1])
    require(at_rest < 1e-8, "not the prestretch")
    require(errors[-1] < 1e-2 and all(b < a / 2 for a, b in zip(errors, errors[1:])),
            "it does not tend to the thin membrane")


def main():
    program, all_ranks = program_and_ranks(__doc__)
    checks = (check_membrane, check_gripper, check_full_stack, check_margins)
    side_by_side(program, *itertools.product(checks, all_ranks))


main()
