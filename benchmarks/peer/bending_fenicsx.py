#!/usr/bin/python3
"""The bending actuator in FEniCSx: the peer of Thelma's seconds (README.md).

    benchmarks/peer/bending_fenicsx.py                           all cases: a table
    benchmarks/peer/bending_fenicsx.py --output peer.csv         and as CSV
    benchmarks/peer/bending_fenicsx.py --case "Q2/P1 2x1x8"      some cases; repeatable
"""

import argparse
import csv
import os
import sys
from dataclasses import asdict, dataclass, fields

os.environ["OMP_NUM_THREADS"] = os.environ["OPENBLAS_NUM_THREADS"] = "1"  # read by the imports

from actuator import ELEMENTS, TIP, Actuator  # noqa: E402
from path import Path, PathError  # noqa: E402
from tangent import ASSEMBLIES  # noqa: E402

CASES = ("Q1 selective reduced 4x8x20", "Q1/P0 4x8x20", "Q2/P1 4x8x20", "Q1/P0 16x1x80",
         "Q1/P0 24x1x120", "Q2/P1 2x1x8", "Q2/P1 2x1x10", "Q2/P1 2x1x14")
REPETITIONS = 4
SHORT = 5.0  # seconds; shorter runs are repeated


@dataclass
class Row:
    """The fastest run of a case."""

    element: str
    cells: str
    assembly: str
    unknowns: int
    newton_iterations: int
    seconds: float
    assembly_seconds: float
    factorisation_seconds: float
    tip: float  # u_1/L
    relative_error: float


def measure(case, assembly):
    """The Row of a case."""
    element, _, mesh = case.rpartition(" ")
    actuator = Actuator(ELEMENTS[element], tuple(map(int, mesh.split("x"))))
    path, best = Path(actuator, assembly), None
    for _ in range(REPETITIONS):
        seconds = path.run()
        if best is None or seconds < best[0]:
            best = seconds, path.seconds
        if seconds > SHORT:
            break
    return Row(element, mesh.replace("x", " x "), assembly, len(actuator.state.x.array),
               path.iterations, best[0], best[1]["assembly"], best[1]["factorisation"],
               actuator.tip(), actuator.tip() / TIP - 1)


def arguments():
    """The command line."""
    parser = argparse.ArgumentParser(description=__doc__,
                                     formatter_class=argparse.RawDescriptionHelpFormatter)
    parser.add_argument("--output", metavar="CSV")
    parser.add_argument("--assembly", choices=ASSEMBLIES, action="append",
                        help="repeatable; default: all")
    parser.add_argument("--case", choices=CASES, action="append", metavar="CASE",
                        help="repeatable; default: all of " + ", ".join(CASES))
    return parser.parse_args()


def main():
    """A line per case and way of assembly as soon as it is measured."""
    options, rows = arguments(), []
    print(f"{'element':22}{'cells':14}{'assembly':10}{'unknowns':>9}{'its':>5}{'s':>9}"
          f"{'assemble':>10}{'factor':>9}{'tip u_1/L':>12}{'error':>10}")
    for case in options.case or CASES:
        for assembly in options.assembly or ASSEMBLIES:
            try:
                row = measure(case, assembly)
            except PathError as error:
                print(f"bending_fenicsx: {case}: {error}", file=sys.stderr)
                return 3
            rows.append(row)
            print(f"{row.element:22}{row.cells:14}{row.assembly:10}{row.unknowns:9d}"
                  f"{row.newton_iterations:5d}{row.seconds:9.3f}{row.assembly_seconds:10.3f}"
                  f"{row.factorisation_seconds:9.3f}{row.tip:12.6f}"
                  f"{100 * row.relative_error:9.3f}%", flush=True)
    if options.output:
        with open(options.output, "w", newline="", encoding="utf8") as file:
            writer = csv.DictWriter(file, [field.name for field in fields(Row)])
            writer.writeheader()
            writer.writerows(map(asdict, rows))
    return 0


if __name__ == "__main__":
    sys.exit(main())
