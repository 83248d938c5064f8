"""A whole curve by the block solver is the direct solver's, on one rank and on several; and the run
says that it does not know whether a state is stable."""

import csv
import json
import sys
import tempfile
from pathlib import Path

from scene import program_and_ranks, require, validated

OPTIONS = ["--set", "Mesh/Parameters=L: 20, W: 1, H: 1, n1: 2, n2: 1, n3: 20"]


def curve(program, folder, solver, ranks):
    """Its rows, and what was modelled."""
    program.run("benchmarks/bilayer", folder, *OPTIONS, "--set", f"Linear solver/Solver={solver}",
                ranks=ranks)
    with open(Path(folder) / "curve.csv", encoding="utf-8") as file:
        rows = list(csv.DictReader(file))
    return rows, " ".join(json.loads((Path(folder) / "run.json").read_text())["modelled"])


def main():
    """Compare."""
    program, all_ranks = program_and_ranks(__doc__)
    with tempfile.TemporaryDirectory() as folder:
        direct, _ = curve(program, f"{folder}/direct", "direct", 1)
        for ranks in all_ranks:
            block, modelled = curve(program, f"{folder}/block{ranks}", "block", ranks)
            require("stable remains unknown" in modelled, modelled)
            require(len(block) == len(direct), "the steps differ")
            error = max(abs(float(b[name]) - float(d[name])) / 20
                        for b, d in zip(block, direct) for name in ("tip_u1_mm", "tip_u3_mm"))
            validated("bilayer", f"tip over a curve, block solver, {ranks} rank(s)",
                      "direct solver", error)
            require(error < 1e-7, f"the curves differ by {error} of the length")


sys.exit(main())
