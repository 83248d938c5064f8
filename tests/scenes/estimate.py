"""The error estimate of --estimate against the true error.

Usage: estimate.py THELMA_BINARY MPIEXEC SOURCE_DIR RANKS...

Truth: the exact circle (tests/reference/bilayer_bending.csv) and the exact limit point of the
planar actuator, which every mesh meets.
"""

import csv
import tempfile
from pathlib import Path

from bending_reference import exact_mid_rotation
from scene import program_and_ranks, require


def estimates(folder):
    """{quantity: (value, error estimate)}."""
    with open(folder / "estimate.csv", newline="", encoding="utf8") as file:
        return {row["quantity"]: (float(row["value"]), float(row["error_estimate"]))
                for row in csv.DictReader(file)}


def check_bending(program, folder, ranks):
    """The estimate is as large as the error, and not many times larger."""
    program.run("bending_actuator_plane", folder, "--estimate", "--set", "Loading/Target=0.5",
                ranks=ranks)
    value, estimate = estimates(folder)["mid_rotation_deg"]
    error = abs(value - exact_mid_rotation(program.source, 1.8e-4, 353.0, 0.5))
    print(f"{ranks} rank(s): rotation {value:.4f} degrees, error {error:.1e}, "
          f"estimate {estimate:.1e}")
    require(error < estimate < 3 * error, "the estimate is not of the size of the error")


def check_planar(program, folder):
    """A homogeneous body has no mesh error: what is left is the bracket."""
    program.run("planar_actuator", folder, "--estimate", "--set", "Output/Fields=none")
    value, estimate = estimates(folder)["pull_in_e"]
    print(f"pull-in at e = {value:.6f} +- {estimate:.1e}")
    require(abs(value - 0.687366) < estimate < 3e-4, "the pull-in is outside its estimate")


def main():
    program, all_ranks = program_and_ranks(__doc__)
    with tempfile.TemporaryDirectory() as folder:
        for ranks in all_ranks:
            check_bending(program, Path(folder) / str(ranks), ranks)
        check_planar(program, Path(folder) / "planar")


main()
