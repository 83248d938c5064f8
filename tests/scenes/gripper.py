"""The gripper: its fingers against the exact circle of a bending actuator.

    gripper.py THELMA_BINARY MPIEXEC SOURCE_DIR RANKS...
"""

import math
import tempfile
from pathlib import Path

from scipy.optimize import brentq

from scene import program_and_ranks, require, validated
import bending_exact
import planar_exact

LENGTH, LAYER, APART = 20.0, 0.5, 14.0  # mm of prm/gripper.prm


def exact(e):
    """Rotation in degrees between the sections at 5 and 15 mm, and the gap between fingers that are
    circles from their roots on; the inner layer keeps its area."""
    fields = [e * part / 20 for part in range(21)]
    circle = bending_exact.circles(planar_exact.Material(), 293, fields)[-1]
    inner = brentq(lambda y: circle.stretch * y - circle.curvature * y**2 / 2 - 1, 0.5, 1.5)
    angle = circle.curvature * LENGTH / LAYER
    tip = LAYER * (circle.tip(LENGTH / LAYER) + inner * math.cos(angle) - 1)
    return circle.rotation(10 / LAYER), APART - 2 * tip


def check(program, folder, ranks):
    """Every state on the scene's mesh, the last on a finer one."""
    curve = program.run("gripper", folder, ranks=ranks).curve(
        "e", "tip_u1_mm", "mid_rotation_deg", "end_rotation_deg")
    for row in (len(curve["e"]) // 2, -1):
        e = curve["e"][row]
        rotation, gap = exact(e)
        turned = curve["end_rotation_deg"][row] - curve["mid_rotation_deg"][row]
        found = APART - 2 * curve["tip_u1_mm"][row]
        print(f"{ranks} rank(s), e = {e:.3f}: a finger turns by {turned:.5f} degrees between 5 and "
              f"15 mm, exactly {rotation:.5f}; gap {found:.4f} mm, of circles {gap:.4f}")
        validated("gripper", f"rotation between 5 and 15 mm of a finger at e = {e:.2f}",
                  "exact circle", turned / rotation - 1)
        validated("gripper", f"gap between the tips at e = {e:.2f}, as a part of 14 mm",
                  "circles clamped at their roots", (found - gap) / APART)
        require(abs(turned / rotation - 1) < 1e-4, "a finger is no circle")
        require(abs(found - gap) < 0.01 * APART, "the gap is not that of circles")


def main():
    program, all_ranks = program_and_ranks(__doc__)
    for ranks in all_ranks:
        with tempfile.TemporaryDirectory() as folder:
            check(program, Path(folder) / "gripper", ranks)


main()
