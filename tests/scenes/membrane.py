"""The prestretched membrane against the limit of a thin one (scripts/membrane_exact.py).

    membrane.py THELMA_BINARY MPIEXEC SOURCE_DIR RANKS...
"""

import tempfile
from pathlib import Path

from scene import program_and_ranks, require, validated
import membrane_exact

RADIUS, FIELD, PRESTRETCH = 4.0, 0.3, 1.5  # of prm/membrane.prm
PARAMETERS = "A: 4, B: 12, H: {}, n: {}, na: {}, nb: {}, n2: 1"


def run(program, folder, thickness, cells, ranks):
    """Stretch of the electrode and of the thickness before the voltage, then with it."""
    parameters = PARAMETERS.format(thickness, *cells)
    case = program.run("membrane", folder, "--set", f"Mesh/Parameters={parameters}", "--set",
                       f"Loading/Film thickness={thickness / 2}", "--set",
                       "Expectations/Final values=", ranks=ranks)
    curve = case.curve("load", "tip_u1_mm", "lambda_2")
    held = list(curve["load"]).index(1)
    return [(1 + curve["tip_u1_mm"][row] / RADIUS, curve["lambda_2"][row]) for row in (held, -1)]


def check(program, folder, ranks):
    """Prestretch, then the electrode of ever thinner membranes."""
    membrane = membrane_exact.Membrane(prestretch=PRESTRETCH)
    exact = membrane.electrode_stretch(FIELD)
    cells = (3, 2, 5)
    (held, thin), (stretch, _) = run(program, folder, 0.5, cells, ranks)
    require(abs(held - PRESTRETCH) < 1e-8, f"prestretched {held} times")
    require(abs(thin * PRESTRETCH**2 - 1) < 2e-3, f"thickness {thin} under the prestretch")
    errors = [(stretch - PRESTRETCH) / (exact - PRESTRETCH) - 1]
    if ranks == 1:
        for thickness, finer in ((0.5, (6, 4, 10)), (0.25, (6, 4, 10))):
            found = run(program, folder, thickness, finer, ranks)[1][0]
            errors.append((found - PRESTRETCH) / (exact - PRESTRETCH) - 1)
    print(f"{ranks} rank(s): the electrode widens from {held:.5f} to {stretch:.5f}, in the thin limit "
          f"to {exact:.5f}; widening off by {', '.join(f'{error:.2e}' for error in errors)}")
    validated("membrane", "stretch of the electrode at e = 0.3, 0.5 mm thick",
              "thin membrane, boundary value problem", stretch / exact - 1)
    require(abs(errors[0]) < 1e-2, "not the thin membrane")
    if ranks == 1:
        require(abs(errors[2]) < 0.7 * abs(errors[1]), "no thin limit")


def main():
    program, all_ranks = program_and_ranks(__doc__)
    for ranks in all_ranks:
        with tempfile.TemporaryDirectory() as folder:
            check(program, Path(folder) / "membrane", ranks)


main()
