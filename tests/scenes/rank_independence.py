"""The planar actuator gives the same curve on every number of ranks.

    rank_independence.py THELMA_BINARY MPIEXEC SOURCE_DIR RANKS...
"""

import tempfile
from pathlib import Path

import numpy as np

from scene import program_and_ranks, require

COLUMNS = ("e", "lambda_3", "charge_uC")
TOLERANCE = 1e-8  # relative to the largest value of the column


def compare(name, curve, reference):
    """Same number of rows, same values; returns the largest relative difference."""
    largest = 0.0
    for column in COLUMNS:
        a, b = curve[column], reference[column]
        require(len(a) == len(b), f"{name}: {len(a)} rows, not {len(b)}")
        difference = np.max(np.abs(a - b)) / np.max(np.abs(b))
        require(difference <= TOLERANCE, f"{name}: {column} differs by {difference}")
        largest = max(largest, difference)
    return largest


def main():
    """Compares every number of ranks with the first."""
    program, all_ranks = program_and_ranks(__doc__)
    curves = {}
    for ranks in all_ranks:
        with tempfile.TemporaryDirectory() as directory:
            case = program.run("planar_actuator", Path(directory) / "run", ranks=ranks)
            curves[ranks] = case.curve(*COLUMNS)
    reference = curves[all_ranks[0]]
    require(len(reference["e"]) > 1, f"the curve has {len(reference['e'])} rows")
    for ranks in all_ranks[1:]:
        largest = compare(f"{ranks} ranks", curves[ranks], reference)
        print(f"{ranks} ranks: largest relative difference {largest:.1e}")


if __name__ == "__main__":
    main()
