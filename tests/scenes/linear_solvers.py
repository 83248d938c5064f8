"""A whole curve by the block solver is the direct solver's, on one rank and on several; and the run
says that it does not know whether a state is stable."""

import csv
import json
import sys
import tempfile
from pathlib import Path

from scene import program_and_ranks, require, settings, validated

CUBIC = ["--set", "Mesh/Parameters=L: 20, W: 1, H: 1, n1: 2, n2: 1, n3: 20"]


FLAT = ["--set", "Mesh/Parameters=L: 20, W: 10, H: 1, n1: 4, n2: 2, n3: 4",
        "--set", "Loading/Target=0.25"]


def curve(program, folder, solver, ranks, options):
    """Its rows, and what was modelled."""
    program.run("benchmarks/bilayer", folder, *options, "--set",
                f"Linear solver/Solver={solver}", ranks=ranks)
    with open(Path(folder) / "curve.csv", encoding="utf-8") as file:
        rows = list(csv.DictReader(file))
    return rows, " ".join(json.loads((Path(folder) / "run.json").read_text())["modelled"])


def difference(block, direct):
    """Of the tip over two curves, in lengths of the body."""
    require(len(block) == len(direct), "the steps differ")
    return max(abs(float(b[name]) - float(d[name])) / 20
               for b, d in zip(block, direct) for name in ("tip_u1_mm", "tip_u3_mm"))


def check_columns(program, folder):
    """All fields at once in time: as many names as values, and the count of unstable directions only
    where it is known."""
    for solver in ("direct", "block"):
        program.run("planar_actuator", f"{folder}/{solver} in time", *settings(
            {"Discretisation/Formulation": "mean dilatation", "Linear solver/Solver": solver,
             "Temperature/Model": "transient", "Temperature/Fixed": "bottom: 313", "Time/End": "0.1",
             "Time/Coupling": "monolithic", "Loading/Target": "0.3", "Loading/Expected end": "target",
             "Expectations/Final values": "", "Output/Fields": "none"}))
        with open(f"{folder}/{solver} in time/curve.csv", encoding="utf-8") as file:
            names, *rows = list(csv.reader(file))
        require(rows and all(len(row) == len(names) for row in rows), f"{solver}: {names} {rows[-1]}")
        require(("unstable_directions" in names) == (solver == "direct")
                and ("linear_iterations" in names) == (solver == "block"), f"{solver}: {names}")
        require(not any(row[-1] for row in rows), f"{solver}: an event where nothing happens")


def main():
    """Compare."""
    program, all_ranks = program_and_ranks(__doc__)
    with tempfile.TemporaryDirectory() as folder:
        check_columns(program, folder)
        for name, options, limit in (("near-cubic", CUBIC, 60), ("flat", FLAT, 100)):
            direct, _ = curve(program, f"{folder}/direct {name}", "direct", 1, options)
            for ranks in all_ranks:
                block, modelled = curve(program, f"{folder}/block {name} {ranks}", "block", ranks,
                                        options)
                require("stable remains unknown" in modelled, modelled)
                error = difference(block, direct)
                validated("bilayer", f"tip over a curve, {name} cells, block solver, {ranks} "
                          "rank(s)", "direct solver", error)
                require(error < 1e-7, f"the curves differ by {error} of the length")
                most = max(int(row["linear_iterations"]) / int(row["newton_iterations"])
                           for row in block)
                print(f"  {name} cells: at most {most:.1f} iterations per Newton step")
                require(most < limit, f"{most} iterations per Newton step")


sys.exit(main())
