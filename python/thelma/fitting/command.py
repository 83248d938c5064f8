"""The command thelma-fit."""

import argparse
import sys
from pathlib import Path

from thelma import program
from thelma.errors import ThelmaError
from thelma.fitting import data, report
from thelma.fitting.fit import fit

DESCRIPTION = """A material from test data: the parameters marked `# free` in a parameter file, by least squares.

    thelma-fit SCENE.prm DATA.csv...                 in a checkout scripts/fit
    thelma-fit SCENE.prm DATA.csv... --output DIR    default output/fit_SCENE

Prints the values with their intervals of confidence and the section to paste, and writes into DIR
parameters.csv, stresses.csv, fit.png (stresses and residuals), material.prm (the section) and scene.prm
(SCENE.prm with the fitted values). doc/fitting.md describes the files."""


def arguments():
    """The command line."""
    parser = argparse.ArgumentParser(description=DESCRIPTION, formatter_class=argparse.RawDescriptionHelpFormatter)
    parser.add_argument("scene", type=Path, help="parameter file with free parameters")
    parser.add_argument("data", type=Path, nargs="+", help="CSV files of tests")
    parser.add_argument("--output", type=Path, help="folder for the results")
    parser.add_argument("--program", type=Path, help="default: thelma of this checkout or installation")
    return parser.parse_args()


def main():
    """One sentence and exit code 1 for what the user can mend."""
    options = arguments()
    folder = options.output or Path("output") / f"fit_{options.scene.stem}"
    try:
        found = fit(program.find(options.program), options.scene, data.read_all(options.data))
        report.write(found, folder)
    except (ThelmaError, OSError) as error:
        print(f"fit: {error}", file=sys.stderr)
        return 1
    except KeyboardInterrupt:
        return 130
    print(report.table(found))
    print(found.section())
    print(f"written: {folder}/parameters.csv, stresses.csv, fit.png, material.prm, scene.prm")
    return 0
