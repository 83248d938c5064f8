"""A parameter file with changed entries: written, checked, run, swept."""

import subprocess
from dataclasses import dataclass, field
from numbers import Integral, Real
from pathlib import Path

from thelma import program as programs
from thelma.errors import ThelmaError
from thelma.launch import on_ranks, sentences
from thelma.material_point import MaterialPoint
from thelma.prm import ParameterText
from thelma.study import Case, read_study

BAD_INPUT, INTERNAL_ERROR = 1, 70  # exit codes without results


def text_of(value):
    """A value as a parameter file has it."""
    if isinstance(value, bool):
        return str(value).lower()
    if isinstance(value, (list, tuple)):
        return ", ".join(map(text_of, value))
    if isinstance(value, dict):
        return ", ".join(f"{key}: {text_of(one)}" for key, one in value.items())
    return repr(float(value)) if isinstance(value, Real) and not isinstance(value, Integral) else str(value)


@dataclass(frozen=True)
class Scene:
    """A parameter file and entries, `Section/Entry`, that have other values than it says."""

    path: Path
    entries: dict = field(default_factory=dict)
    program: Path = None  # default: program.find()

    def __post_init__(self):
        object.__setattr__(self, "path", Path(self.path))
        if not self.path.is_file():
            raise ThelmaError(f"there is no parameter file {self.path}")

    def with_entries(self, entries):
        """The same with more changed."""
        return Scene(self.path, {**self.entries, **entries}, self.program)

    def text(self):
        """The parameter file, `prm.ParameterText`, with the changes in it."""
        text = ParameterText.read(self.path)
        for entry, value in self.entries.items():
            text.set(entry, text_of(value))
        return text

    def write(self, path):
        """As a parameter file of its own; a geometry beside the old one is found from the new one too."""
        text = self.text()
        mesh = text.entries.get(("Mesh", "File"))
        if mesh and (self.path.parent / mesh.value).is_file():
            text.set("Mesh/File", str((self.path.parent / mesh.value).resolve()))
        Path(path).write_text(str(text), encoding="utf8")
        return Scene(path, program=self.program)

    def options(self):
        """The program's, for the changed entries."""
        return [word for entry, value in self.entries.items() for word in ("--set", f"{entry}={text_of(value)}")]

    def call(self, *options, ranks=1):
        """The ended program; a ThelmaError with its sentences if the input is bad."""
        command = [str(programs.find(self.program)), str(self.path), *self.options(), *options]
        if ranks > 1:
            command = [*on_ranks("mpirun", ranks), *command]
        done = subprocess.run(command, text=True, capture_output=True, check=False)
        if done.returncode == BAD_INPUT or done.returncode >= INTERNAL_ERROR or done.returncode < 0:
            lines = [line.removeprefix("thelma: ") for line in sentences(done.stderr)]
            raise ThelmaError("\n".join(lines) or f"exit code {done.returncode}")
        return done

    def check(self):
        """What the program says of the scene without running it; a ThelmaError if anything is wrong."""
        return self.call("--check").stdout

    def run(self, output, ranks=1, options=()):
        """The results (study.Case), in the folder `output`. A run that does not converge has what it reached."""
        done = self.call("--output", str(output), *options, ranks=ranks)
        case = Case(Path(output), exit_code=done.returncode)
        case.outcome = case.report()["outcome"]
        return case

    def sweep(self, values, output, ranks=1, options=()):
        """The cases of all combinations of entry -> values; one rank runs one case at a time."""
        words = [word for entry, list_of in values.items()
                 for word in ("--sweep", f"{entry}=" + "; ".join([*map(text_of, list_of), ""]))]
        others = {entry: value for entry, value in self.entries.items() if entry not in values}
        Scene(self.path, others, self.program).call(*words, "--output", str(output), *options, ranks=ranks)
        return read_study(output)

    def material_point(self):
        """Stresses of its materials (MaterialPoint)."""
        return MaterialPoint(programs.find(self.program), self.path, self.options())
