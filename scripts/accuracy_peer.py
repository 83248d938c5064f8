"""Runs the peer, benchmarks/peer, for scripts/accuracy."""

import csv
import subprocess
import tempfile
from dataclasses import replace
from pathlib import Path

from thelma import interpreter
from accuracy_cases import PEER_PROGRAMS, ROOT
from accuracy_run import AccuracyError

SCRIPT = ROOT / "benchmarks/peer/bending_fenicsx.py"
PROGRAMS = dict(zip(("dolfinx", "gathered"), PEER_PROGRAMS))  # by its ways of assembly
PATIENCE = 900  # seconds; the first run of an element compiles its forms


def require():
    """Whether it can run here."""
    command = [interpreter.SYSTEM, "-c", "import dolfinx.fem.petsc, petsc4py"]
    if subprocess.run(command, capture_output=True, check=False).returncode != 0:
        raise AccuracyError(f"--peer needs FEniCSx for {interpreter.SYSTEM}, which has none; "
                            "benchmarks/peer/README.md names the packages.")


def converted(record, row):
    """A line of the peer's CSV as a row like Thelma's."""
    iterations, tip = int(record["newton_iterations"]), float(record["tip"])
    return replace(row, program=PROGRAMS[record["assembly"]], unknowns=int(record["unknowns"]),
                   steps=None, newton_iterations=iterations, factorisations=iterations,
                   solve_seconds=round(float(record["seconds"]), 5), peak_memory_MB=None,
                   value=tip, relative_error=tip / row.reference - 1, outcome="reached")


def measure(row):
    """The peer's rows on the mesh and with the element of Thelma's row."""
    name = f"{row.element} {row.cells.replace(' ', '')}"
    with tempfile.TemporaryDirectory() as folder:
        path = Path(folder) / "peer.csv"
        command = [interpreter.SYSTEM, str(SCRIPT), "--case", name, "--output", str(path)]
        try:
            result = subprocess.run(command, capture_output=True, text=True, timeout=PATIENCE,
                                    check=False)
        except subprocess.TimeoutExpired as error:
            raise AccuracyError(f"the peer takes over {PATIENCE} s for {name}.") from error
        if result.returncode != 0:
            last = (result.stderr.strip() or "no message").splitlines()[-1]
            raise AccuracyError(f"the peer fails for {name}: {last}")
        with open(path, newline="", encoding="utf8") as file:
            return [converted(record, row) for record in csv.DictReader(file)]
