"""doc/tutorial.md: its files are written and its commands run one by one, as a reader would.

Usage: tutorial.py THELMA_BINARY MPIEXEC SOURCE_DIR RANKS...
"""

import csv
import os
import re
import subprocess
import tempfile
from pathlib import Path

from scene import program_and_ranks, require

BLOCK = re.compile(r"^```(\w+)(?: (\S+))?\n(.*?)^```$", re.MULTILINE | re.DOTALL)


def run(command, folder, expected):
    """Runs a command; `expected` are lines that it says when it fails, as the tutorial wants."""
    done = subprocess.run(command, shell=True, cwd=folder, capture_output=True, text=True,
                          check=False, env={**os.environ, "THELMA": str(folder / "build/bin/thelma")})
    text = done.stdout + done.stderr
    print(f"$ {command}\n{text}")
    require(done.returncode == (1 if expected else 0), f"exit code {done.returncode}: {command}")
    for line in expected:
        require(line in text, f"'{line}' is not said by {command}")


def tips(folder):
    """Temperature in K -> deflection of the tip in mm at the end, of every case of the study."""
    with open(folder / "study.csv", newline="") as file:
        rows = list(csv.DictReader(file))
    require(len(rows) == 5, f"{len(rows)} cases, not 5")
    return {float(row["theta_K"]): float(row["tip_u1_mm"]) for row in rows}


def require_bent_further_when_warm(tip):
    """The strain at a voltage goes with 1/mu, and the backing's resistance stays the same."""
    bent = [abs(tip[theta]) for theta in sorted(tip)]
    require(all(a < b for a, b in zip(bent, bent[1:])), f"not bent further when warmer: {tip}")


def require_material(folder):
    """The numbers of the tutorial are those of this material, with errors of 1 % drawn at random."""
    true = {"Shear modulus": 60.0, "Gent limit": 40.0, "Branch 1/Modulus": 25.0, "Branch 1/Relaxation time": 30.0}
    with open(folder / "parameters.csv", newline="") as file:
        for row in csv.DictReader(file):
            width = float(row["high"]) / float(row["value"])
            error = abs(float(row["value"]) / true.pop(row["parameter"]) - 1)
            require(error < 2 * (width - 1), f"{row} is off by {error}")
    require(not true, f"not fitted: {true}")


def main():
    """Writes and runs in a folder that looks like that of Thelma."""
    program, _ = program_and_ranks(__doc__)
    blocks = BLOCK.findall((program.source / "doc/tutorial.md").read_text())
    require(len(blocks) > 8, f"only {len(blocks)} blocks found")
    with tempfile.TemporaryDirectory() as name:
        folder = Path(name)
        (folder / "build/bin").mkdir(parents=True)
        (folder / "build/bin/thelma").symlink_to(Path(program.binary).resolve())
        (folder / "scripts").symlink_to(program.source.resolve() / "scripts")
        for number, (kind, file, text) in enumerate(blocks):
            if file:
                (folder / file).write_text(text)
            elif kind == "sh":
                answer = blocks[number + 1] if number + 1 < len(blocks) else ("", "", "")
                expected = answer[2].splitlines() if answer[0] == "text" else []
                for command in text.strip().splitlines():
                    run(command, folder, expected)
        for page in ("mine/run/report.html", "mine/study/report.html"):
            require((folder / page).is_file(), f"there is no {page}")
        tip = tips(folder / "mine/study")
        print(tip)
        require_bent_further_when_warm(tip)
        require_material(folder / "mine/fit")


main()
