"""The stack with interdigitated electrodes: exact without margins, held back by them.

    stack.py THELMA_BINARY MPIEXEC SOURCE_DIR RANKS...
"""

import tempfile
from pathlib import Path

from scene import program_and_ranks, require, validated
import planar_exact

WHOLE = "low: 0, high: 1, low_margin: 0, high_margin: 1"


def strains(curve):
    """Contraction and extension at the end."""
    return 1 - curve["lambda_3"][-1], curve["lambda_1"][-1] - 1


def check(program, folder, ranks):
    """Every state without margins, then with them on two meshes."""
    whole = program.run("stack", folder, "--set", f"Electrodes/Potential={WHOLE}", "--set",
                        "Expectations/Final values=", ranks=ranks).curve("e", "lambda_1", "lambda_3")
    material, worst = planar_exact.Material(), 0.0
    for e, *stretches in zip(*(whole[name] for name in ("e", "lambda_1", "lambda_3"))):
        exact = planar_exact.stable_state(material, 293, material.field(e, 293))
        worst = max(worst, *(abs(a - b) for a, b in zip(stretches, exact)))
    validated("stack", "lambda_1, lambda_3 of every state, electrodes everywhere",
              "exact, homogeneous", worst)
    require(worst < 1e-8, f"a layer of the stack is no planar actuator: {worst} off")

    coarse = strains(program.run("stack", folder, ranks=ranks).curve("lambda_1", "lambda_3"))
    fine = strains(program.run(
        "stack", folder, "--set", "Mesh/Parameters=L: 20, W: 4, h: 1, m: 2, N: 3, n1: 4, nc: 12, "
        "n2: 2, n3: 2", ranks=ranks).curve("lambda_1", "lambda_3"))
    full = strains(whole)
    print(f"{ranks} rank(s): electrodes everywhere {worst:.1e} off; contraction {full[0]:.5f}, "
          f"with margins {coarse[0]:.5f}, {fine[0]:.5f} on a mesh twice as fine")
    validated("stack", "contraction with margins", "mesh twice as fine", coarse[0] / fine[0] - 1)
    require(abs(coarse[0] / fine[0] - 1) < 5e-3, "the contraction changes with the mesh")
    # Between the share of the length that carries a field, 16 of 20 mm, and all of it.
    require(0.8 * full[0] < fine[0] < full[0] and 0 < fine[1] < full[1],
            f"margins do not hold back: {fine} against {full}")


def main():
    program, all_ranks = program_and_ranks(__doc__)
    for ranks in all_ranks:
        with tempfile.TemporaryDirectory() as folder:
            check(program, Path(folder) / "stack", ranks)


main()
