"""Exit codes 2 and 3, and what is kept when a run ends early, on any number of ranks.

Usage: exit_codes.py THELMA_BINARY MPIEXEC SOURCE_DIR RANKS...
"""

import csv
import json
import subprocess
import tempfile
from pathlib import Path

from scene import program_and_ranks, require

CASES = [
    ("unexpected pull-in", "planar_actuator", 3, "pull-in",
     ["--set", "Loading/Expected end=target"]),
    ("pull-in that does not come", "planar_actuator", 2, "target reached",
     ["--set", "Loading/Target=0.3", "--set", "Expectations/Final values="]),
    ("pull-in in time that does not come", "delayed_pull_in", 2, "target reached",
     ["--set", "Loading/Target=0.6"]),
    ("failed expectation", "planar_actuator", 2, "pull-in",
     ["--set", "Expectations/Final values=e: 0.5"]),
    ("tolerance below rounding", "heated_bending", 3, "no convergence",
     ["--set", "Time/Tolerance=1e-15", "--set", "Mesh/Parameters=n1: 4, n3: 10"]),
]


def main():
    program, all_ranks = program_and_ranks(__doc__)
    for name, scene, code, outcome, options in CASES:
        for ranks in all_ranks:
            with tempfile.TemporaryDirectory() as folder:
                command = program.command(
                    [f"prm/{scene}.prm", "--output", folder, *options], ranks)
                done = subprocess.run(command, cwd=program.source, capture_output=True, text=True,
                                      check=False, timeout=60)
                report = json.loads((Path(folder) / "run.json").read_text())
                with open(Path(folder) / "curve.csv", newline="", encoding="utf8") as file:
                    rows = list(csv.DictReader(file))
                print(f"{name} ({ranks}): exit code {done.returncode}, {report['reason']}")
                require(done.returncode == code, f"{name}: exit code {done.returncode}, not {code}")
                require(report["exit_code"] == code, f"{name}: run.json has another exit code")
                require(report["outcome"] == outcome, f"{name}: outcome {report['outcome']}")
                require(report["reason"], f"{name}: no reason")
                require(len(rows) == report["steps"] > 3, f"{name}: {len(rows)} rows")
                require((rows[-1]["event"] == "pull-in") == (outcome == "pull-in"),
                        f"{name}: the last event is '{rows[-1]['event']}'")


main()
