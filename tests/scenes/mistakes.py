"""Every row of doc/mistakes.md: exit code 1, and sentences that name the entry and the remedy.

Usage: mistakes.py THELMA_BINARY MPIEXEC SOURCE_DIR RANKS...
"""

import re
import shlex
import subprocess
import tempfile
from concurrent.futures import ThreadPoolExecutor

from scene import program_and_ranks, require

SCENE = "prm/planar_actuator.prm"


def rows(program):
    """Number, arguments, and the two parts of the sentence, of each mistake."""
    text = (program.source / "doc/mistakes.md").read_text(encoding="utf8")
    for number, *cells in re.findall(r"^\| (\d+) \| (.*) \| (.*) \| (.*) \|$", text, re.MULTILINE):
        written, place, remedy = (cell.strip("`").strip() for cell in cells)
        yield int(number), shlex.split(written), place, remedy


def answer(program, arguments, folder):
    """Exit code and standard error of a run with these arguments."""
    if arguments[0] in ("--set", "--sweep", "--ouput"):
        arguments = [SCENE, "--output", folder, *arguments]
    done = subprocess.run(program.command(arguments, 1), cwd=program.source, capture_output=True,
                          text=True, check=False, timeout=60)
    return done.returncode, done.stderr


def main():
    program, _ = program_and_ranks(__doc__)
    mistakes = list(rows(program))
    require([number for number, *_ in mistakes] == list(range(1, 51)), "there are not 50 rows")
    with tempfile.TemporaryDirectory() as folder, ThreadPoolExecutor(2) as pool:
        answers = list(pool.map(lambda row: answer(program, row[1], folder), mistakes))
    for (number, arguments, place, remedy), (code, text) in zip(mistakes, answers):
        print(f"{number} {shlex.join(arguments)}: {text.strip()}")
        require(code == 1, f"row {number}: exit code {code}, not 1")
        require(place in text, f"row {number}: no word of {place}")
        require(remedy in text, f"row {number}: no word of {remedy}")


main()
