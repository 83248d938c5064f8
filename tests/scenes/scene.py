"""Runs the program for the scene tests and reads what it leaves."""

import contextlib
import io
import multiprocessing
import subprocess
import sys
import tempfile
from concurrent.futures import ProcessPoolExecutor
from dataclasses import dataclass
from pathlib import Path

from thelma import study
from thelma.launch import sentences, on_ranks  # noqa: F401

SCRIPTS = Path(__file__).resolve().parents[2] / "scripts"
sys.path.append(str(SCRIPTS))  # tests of what belongs to a script alone


@dataclass
class Program:
    """How to start the program."""

    binary: str
    mpiexec: str
    source: Path

    def command(self, arguments, ranks):
        """The command line that starts the program on so many ranks."""
        command = [str(Path(self.binary).resolve()), *arguments]
        if ranks > 1:
            command = [*on_ranks(self.mpiexec, ranks), *command]
        return command

    def run(self, scene, output, *options, ranks=1, exit_code=0):
        """Runs prm/SCENE.prm in the source directory, into output; requires the exit code."""
        command = self.command([f"prm/{scene}.prm", *options, "--output", str(output)], ranks)
        done = subprocess.run(command, cwd=self.source, stdout=subprocess.PIPE,
                              stderr=subprocess.STDOUT, text=True, check=False)
        if done.returncode != exit_code:
            print(" ".join(command), done.stdout, sep="\n")
        require(done.returncode == exit_code, f"exit code {done.returncode}, not {exit_code}")
        return study.Case(Path(output))


def settings(entries):
    """The program's options that give these entries their values."""
    return [word for entry in entries.items() for word in ("--set", "=".join(entry))]


def validated(scene, quantity, reference, error):
    """A row of doc/validation.md: what was compared with which reference, and by how much it is
    off: relative, but stretches and e along a path absolute and temperatures in K."""
    print(f"VALIDATED | {scene} | {quantity} | {reference} | {abs(error):.1e}")


def largest_error(curve, names, exact):
    """The largest difference of the named columns from exact(row), a tuple of their values, in all
    rows of a curve."""
    rows = [dict(zip(curve, values)) for values in zip(*curve.values())]
    return max(abs(row[name] - value) for row in rows for name, value in zip(names, exact(row)))


def require(condition, sentence):
    """Ends the test with the sentence unless the condition holds."""
    if not condition:
        sys.exit(f"FAILED: {sentence}")


def outcome(program, check, *arguments):
    """What a check prints, in a folder of its own, and the exception that ends it."""
    printed = io.StringIO()
    with contextlib.redirect_stdout(printed), tempfile.TemporaryDirectory() as folder:
        try:
            check(program, Path(folder), *arguments)
        except (Exception, SystemExit) as exception:
            return printed.getvalue(), exception
    return printed.getvalue(), None


def side_by_side(program, *checks):
    """Runs check(program, folder, *arguments) for every (check, *arguments), two at a time."""
    # As a copy of this process, which has the check; Python 3.14 would start the test anew.
    with ProcessPoolExecutor(2, multiprocessing.get_context("fork")) as pool:
        for running in [pool.submit(outcome, program, *check) for check in checks]:
            printed, exception = running.result()
            print(printed, end="", flush=True)
            if exception:
                pool.shutdown(cancel_futures=True)
                raise exception


def program_and_ranks(usage):
    """The command line THELMA_BINARY MPIEXEC SOURCE_DIR RANKS..."""
    if len(sys.argv) < 5:
        sys.exit(usage)
    return Program(sys.argv[1], sys.argv[2], Path(sys.argv[3])), [int(n) for n in sys.argv[4:]]
