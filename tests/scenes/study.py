"""A study gives the same study.csv on any number of ranks, however often it was interrupted.

Usage: study.py THELMA_BINARY MPIEXEC SOURCE_DIR RANKS...
"""

import csv
import os
import shutil
import subprocess
import tempfile
import time
from pathlib import Path

from scene import program_and_ranks, require

# Six cases: the exit codes are 0, 3 (pull-in before the target), 1, 1 (no such temperature), 0, 3.
STUDY = """# Comments and blanks are skipped; the scene is found from this file.

scenes/planar_actuator.prm
--set Output/Fields = none
--sweep Temperature/Value = 293, -5, 333
  --sweep Loading/Expected end = pull-in, target
"""
CODES = ["0", "3", "1", "1", "0", "3"]
SECONDS = ("run_seconds", "seconds")


class Study:
    """The study file and a copy of the scene that it names, in a folder of their own."""

    def __init__(self, program, folder):
        self.program = program
        self.folder = Path(folder) / "copy"  # whose neighbours the scene cannot mean by ../
        for name, kept in (("prm", "scenes"), ("meshes", "meshes")):
            shutil.copytree(program.source / name, self.folder / kept)
        (self.folder / "all.study").write_text(STUDY)

    def command(self, output, *options, ranks=1):
        """The command line that runs the study into a folder."""
        return self.program.command(
            [f"@{self.folder}/all.study", "--output", str(output), *options], ranks)

    def run(self, output, *options, ranks=1):
        """Runs the study; returns what it printed."""
        done = subprocess.run(self.command(output, *options, ranks=ranks), cwd=self.folder,
                              capture_output=True, text=True, check=False, timeout=120)
        print(f"{ranks} rank(s), exit code {done.returncode}:", done.stdout, done.stderr, sep="\n")
        require(done.returncode == 3, f"exit code {done.returncode}, not the largest, 3")
        return done.stdout


def table(output):
    """The cells of study.csv without the seconds."""
    with open(output / "study.csv", newline="", encoding="utf8") as file:
        rows = list(csv.reader(file))
    kept = [i for i, name in enumerate(rows[0]) if name not in SECONDS]
    return [[row[i] for i in kept] for row in rows]


def reports(output):
    """When each run.json was written."""
    return {path.parent.name: path.stat().st_mtime_ns for path in output.glob("*/run.json")}


def is_bad(name):
    """Whether the case is run again every time because the input may have been mended."""
    return "=-5" in name


def check_rows(rows):
    """Every case is a row in order; those that fail say why."""
    codes = [row[rows[0].index("exit_code")] for row in rows[1:]]
    require(codes == CODES, f"exit codes {codes}, not {CODES}")
    for row in rows[1:]:
        require(row[rows[0].index("reason")], f"no reason in {row}")
    values = [row[rows[0].index("lambda_3")] for row in rows[1:]]
    require([value == "" for value in values] == [code == "1" for code in CODES],
            f"final values {values}")


def check_console(text, first, last):
    """A line for each case that was run, counted without a gap."""
    counts = [line.split()[0] for line in text.splitlines() if f" of {len(CODES)}  " in line]
    expected = [str(n) for n in range(first, last + 1)]
    require(sorted(counts) == expected, f"console counts {counts}, not {expected}")


def check_resumed(study, output, reference, lost, ranks):
    """Only the lost cases (and bad input) are run again; the table is the same as ever."""
    before = reports(output)
    text = study.run(output, ranks=ranks)
    after = reports(output)
    for name in after:
        again = name in lost or is_bad(name)
        require((before.get(name) != after[name]) == again,
                f"{name} was {'not ' if again else ''}run again")
    n_kept = sum(name not in lost and not is_bad(name) for name in after)
    require(f"{n_kept} of {len(CODES)} cases are already finished" in text or n_kept == 0,
            f"not a word of {n_kept} finished cases")
    check_console(text, n_kept + 1, len(CODES))
    require(table(output) == reference, "study.csv of the continued study differs")


def killed_in_the_middle(study):
    """Kills a study in its last case, as kill -9 does; returns its folder and that case's name."""
    name = "Temperature.Value=333,Loading.Expected_end=target"
    for attempt in range(10):
        output = study.folder / f"killed {attempt}"
        with subprocess.Popen(study.command(output), cwd=study.folder,
                              stdout=subprocess.DEVNULL) as process:
            while not (output / name / "curve.csv").exists() and process.poll() is None:
                time.sleep(0.002)
            process.kill()
        if not (output / name / "run.json").exists():
            require(len(table(output)) == len(CODES), "study.csv lacks a finished case")
            return output, name
    raise RuntimeError("the last case is too fast to be killed")


def main():
    program, all_ranks = program_and_ranks(__doc__)
    with tempfile.TemporaryDirectory() as folder:
        study = Study(program, folder)
        first = study.folder / f"on {all_ranks[0]}"
        check_console(study.run(first, ranks=all_ranks[0]), 1, len(CODES))
        reference = table(first)
        check_rows(reference)
        for ranks in all_ranks[1:]:
            output = study.folder / f"on {ranks}"
            check_console(study.run(output, ranks=ranks), 1, len(CODES))
            require(table(output) == reference, f"study.csv differs on {ranks} ranks")

        most = all_ranks[-1]
        check_resumed(study, first, reference, [], most)
        deleted = "Temperature.Value=293,Loading.Expected_end=target"
        shutil.rmtree(first / deleted)
        check_resumed(study, first, reference, [deleted], most)
        killed, last = killed_in_the_middle(study)
        check_resumed(study, killed, reference, [last], 1)

        everything = [row[reference[0].index("directory")] for row in reference[1:]]
        os.utime(study.folder / "meshes/box.geo")
        check_resumed(study, first, reference, everything, most)
        study.run(first, "--set", "Loading/Bracket=1e-3", ranks=most)
        require(table(first) != reference, "a changed parameter changed nothing")
        check_resumed(study, first, reference, everything, most)

        shared = study.folder / "shared"
        study.run(shared, "--ranks-per-case", "2", ranks=2)
        check_rows(table(shared))


main()
