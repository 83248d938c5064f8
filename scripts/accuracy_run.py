"""Starts the program for scripts/accuracy and measures."""

import json
import os
import shutil
import subprocess
import tempfile
from dataclasses import dataclass
from pathlib import Path

from thelma import launch
from accuracy_cases import MODELS, ROOT, TARGETS, reference
from accuracy_table import Row

SHORT = 0.5  # seconds; shorter runs are repeated
REPETITIONS = 3
PATIENCE = 600  # seconds until a run counts as failed
DEGREES = (1, 2, 3)


class AccuracyError(Exception):
    """One sentence for the user."""


@dataclass
class Program:
    """How to start thelma."""

    binary: Path
    patience: int = PATIENCE  # seconds

    def command(self, arguments, ranks):
        """The command line for so many ranks."""
        command = [str(self.binary), *arguments]
        if ranks == 1:
            return command
        mpirun = shutil.which("mpirun")
        if not mpirun:
            raise AccuracyError("there is no mpirun on the PATH; install Open MPI.")
        return [*launch.on_ranks(mpirun, ranks), *command]

    def start(self, arguments, ranks=1):
        """(exit code, printed text, peak memory in MB of the largest process)."""
        code, text, usage = self.used(arguments, ranks)
        return code, text, usage.ru_maxrss / 1024

    def used(self, arguments, ranks=1):
        """(exit code, printed text, what all its processes used, as os.wait4 says it)."""
        environment = {**os.environ, "OMP_NUM_THREADS": "1", "OPENBLAS_NUM_THREADS": "1"}
        with tempfile.TemporaryFile("w+") as text:
            process = subprocess.Popen(
                ["timeout", "--foreground", str(self.patience), *self.command(arguments, ranks)],
                cwd=ROOT, env=environment, stdout=text, stderr=subprocess.STDOUT)
            _, status, usage = os.wait4(process.pid, 0)
            process.returncode = os.waitstatus_to_exitcode(status)
            text.seek(0)
            return process.returncode, text.read(), usage

    def listed_formulations(self):
        """What --list offers."""
        code, text, _ = self.start(["--list"])
        _, _, rest = text.partition("element formulations")
        names = []
        for line in rest.splitlines()[1:]:
            if not line.startswith("  "):
                break
            names.append(line.strip().split("  ")[0])
        if not names:
            raise AccuracyError(f"{self.binary} --list (exit code {code}) names no element "
                                "formulations.")
        return names

    def elements(self, scene="prm/bending_actuator_plane.prm"):
        """Pairs of formulation and degree that the program accepts."""
        pairs = [(name, degree) for name in self.listed_formulations() for degree in DEGREES]
        return [(name, degree) for name, degree in pairs
                if self.start([scene, "--check", "--set", f"Discretisation/Formulation={name}",
                               "--set", f"Discretisation/Degree={degree}"])[0] == 0]

    def run(self, case, e, ranks):
        """(contents of run.json, peak memory in MB, what went wrong)."""
        with tempfile.TemporaryDirectory() as folder:
            arguments = [MODELS[case.scene, case.model].file, "--output", folder]
            for entry, value in case.settings(e).items():
                arguments += ["--set", f"{entry}={value}"]
            code, text, memory = self.start(arguments, ranks)
            path = Path(folder) / "run.json"
            if code in (0, 2, 3) and path.is_file():
                report = json.loads(path.read_text(encoding="utf8"))
                return report, memory, "" if code == 0 else report["reason"] or report["outcome"]
        last = text.strip().splitlines()[-1] if text.strip() else "no message"
        return None, memory, "out of time" if code == 124 else f"exit code {code}: {last}"


def solve_seconds(report):
    """Time of the run without start-up, mesh and setup."""
    phases = report["seconds_per_phase"]
    return report["seconds"] - phases.get("mesh", 0.0) - phases.get("setup", 0.0)


def fastest(program, case, target, ranks, repeat):
    """The run with the smallest time; short ones are repeated."""
    best = None
    for _ in range(REPETITIONS if repeat and target.timed else 1):
        report, memory, failure = program.run(case, target.e, ranks)
        if report is None or failure:
            return report, memory, failure
        if best is None or solve_seconds(report) < solve_seconds(best[0]):
            best = report, memory, failure
        if solve_seconds(report) > SHORT:
            break
    return best


def measure(program, case, target, ranks=1, repeat=True):
    """The Row of a case at a target."""
    report, memory, failure = fastest(program, case, target, ranks, repeat)
    row = Row(case.scene, case.model, case.formulation, case.degree,
              " x ".join(map(str, case.cells)), ranks, target.e, target.observable,
              peak_memory_MB=round(memory, 1), reference=reference(case.scene, target),
              outcome=failure or "reached")
    if report:
        row.unknowns = sum(report["unknowns"].values())
        row.steps, row.newton_iterations = report["steps"], report["newton_iterations"]
        row.factorisations = report["factorisations"]
        row.solve_seconds = round(solve_seconds(report), 5)
        final = report["final_values"]
        if not failure and abs(final["e"] - target.e) < 1e-9:
            # The pump buckles to the side of its imperfection; its mirror image is a solution too.
            row.value = abs(final[target.column]) / target.unit
            row.relative_error = row.value / row.reference - 1
    return row


def targets(case, fields):
    """Those of the case at the fields e."""
    return [target for target in TARGETS[case.scene] if target.e in fields]
