"""Scenes that are written to a folder, run, and read back."""

import json
import os
import re
import shutil
import subprocess
from dataclasses import dataclass, field
from pathlib import Path

import numpy as np
from thelma import launch
from thelma import study

from validation import laws

ROOT = Path(__file__).resolve().parents[2]
LAYERS = Path(__file__).resolve().parent / "layers.geo"
ELEMENTS = (("enhanced strain", 1), ("mean dilatation", 1), ("mean dilatation", 2), ("standard", 2))
OWN_ENTRIES = {"Gent": "Gent limit", "Mooney-Rivlin": "Second share", "Yeoh": "Yeoh ratios",
               "electrostrictive": "Electrostriction", "saturating": "Saturation polarisation"}
TIMEOUT = -1000  # in place of an exit code
OF_THE_PAPER = (("selective reduced", 1), ("selective reduced", 2))


@dataclass
class Case:
    """A scene that was drawn, and what it must come to."""

    kind: str  # film, bilayer, tube, balloon or column
    element: tuple  # formulation and degree
    mesh: Path
    parameters: dict
    materials: dict  # region -> Material
    entries: dict  # Section/Entry -> value
    story: str  # what was drawn, in a few words
    compare: object = None  # function of a Run to a Verdict
    ranks: int = 1


@dataclass
class Verdict:
    """Outcome of a comparison."""

    disagreements: list = field(default_factory=list)
    errors: list = field(default_factory=list)  # relative, of the values compared
    wrong_end: bool = False

    def ends_wrongly(self, sentence):
        """Notes an ending that is not the exact one."""
        self.disagreements.append(sentence)
        self.wrong_end = True

    def value(self, name, found, exact, tolerance, scale=None):
        """Compares a value, relative to itself or to a scale."""
        error = abs(found - exact) / max(abs(exact) if scale is None else scale, 1e-300)
        self.errors.append(error)
        if not error <= tolerance:  # nan is none
            self.disagreements.append(f"{name} {found:.8g} for {exact:.8g}: off by {error:.1e}, "
                                      f"tolerance {tolerance:.1e}")


@dataclass
class Run:
    """What the program has left."""

    exit_code: int
    report: dict
    curve: dict
    last_line: str

    @property
    def bracket(self):
        """(e below, e above) of the instability that ended the run, or None."""
        found = self.report.get("pull_in")
        if found:
            return found["e_below"], found["e_above"]
        found = re.search(r"between e = (\S+) and ([0-9.e+-]+)", self.report.get("reason", ""))
        return (float(found[1]), float(found[2])) if found else None

    @property
    def at_target(self):
        """Whether the run has gone all its way."""
        return self.exit_code == 0 and self.bracket is None

    @property
    def crashed(self):
        """Whether it ended as no run should: by a signal, an error in the program, bad input, never."""
        return self.exit_code not in (0, 2, 3)

    def events(self):
        """[(event, row)] of the curve."""
        return [(event.strip(), row) for row, event in enumerate(self.curve.get("event", []))
                if isinstance(event, str) and event.strip()]

    def told(self):
        """How it ended, for a reader."""
        return f"exit {self.exit_code}, \"{self.report.get('reason') or self.last_line}\""


def listed(numbers):
    """As an entry has them."""
    return ", ".join(repr(float(number)) for number in numbers)


def own_entries(material):
    """Those that only one law has."""
    entries = {}
    for law, parameter in ((material.elastic, material.parameter), (material.dielectric, material.electric)):
        if law == "Ogden":
            entries["Ogden terms"] = ", ".join(f"{alpha!r}: {mu!r}" for alpha, mu in laws.moduli(parameter))
        elif law == "fibres":
            k_1, k_2, *angles = parameter
            entries.update({"Fibre stiffness": listed(k_1 * c for c in material.mu_law),
                            "Fibre exponent": k_2, "Fibre angles": listed(angles)})
        elif law in OWN_ENTRIES:
            entries[OWN_ENTRIES[law]] = listed(np.atleast_1d(parameter))
    return entries


def material_entries(name, material):
    """Entries of a section of Materials."""
    entries = {"Elastic law": material.elastic, "Dielectric law": material.dielectric,
               "Bulk modulus": material.K, "Shear modulus": listed(material.mu_law),
               "Permittivity": listed(material.eps_law), "Thermal expansion": material.alpha,
               "Reference temperature": material.theta_0, **own_entries(material)}
    return {f"Materials/{name}/{entry}": value for entry, value in entries.items()}


def text(case):
    """The parameter file."""
    numbers = ", ".join(f"{name}: {value}" for name, value in case.parameters.items())
    known = list(dict.fromkeys(case.materials.values()))  # a material of two regions has one section
    names = {region: f"m{known.index(material)}" for region, material in case.materials.items()}
    entries = {"Mesh/File": case.mesh.name, "Mesh/Parameters": numbers,
               "Regions/Materials": ", ".join(f"{r}: {n}" for r, n in names.items()),
               "Discretisation/Formulation": case.element[0], "Discretisation/Degree": case.element[1],
               "Output/Fields": "none"}
    for region, material in case.materials.items():
        entries.update(material_entries(names[region], material))
    entries.update(case.entries)
    lines = [f"# {case.story}", f"set Dimension = {entries.pop('Dimension')}"]
    sections = {}
    for path, value in entries.items():
        *section, entry = path.split("/")
        sections.setdefault(tuple(section), []).append(f"set {entry} = {value}")
    for section, settings in sections.items():
        lines += [*(f"subsection {name}" for name in section), *settings, *("end" for _ in section)]
    return "\n".join(lines) + "\n"


def command(program, mpiexec, ranks):
    """How the program is started in the folder of the scene."""
    start = [str(program), "scene.prm", "--output", "run"]
    if ranks > 1:
        start = [*launch.on_ranks(mpiexec, ranks), *start]
    return start


def run(case, folder, program, mpiexec, timeout):
    """Writes the scene, runs it and reads what it leaves."""
    folder.mkdir(parents=True, exist_ok=True)
    (folder / "scene.prm").write_text(text(case))
    shutil.copy(case.mesh, folder)
    environment = {**os.environ, "OMP_NUM_THREADS": "1", "OPENBLAS_NUM_THREADS": "1"}
    with subprocess.Popen(command(program, mpiexec, case.ranks), cwd=folder, env=environment,
                          stdout=subprocess.PIPE, stderr=subprocess.STDOUT, text=True,
                          errors="replace") as process:
        try:
            said, _ = process.communicate(timeout=timeout)
            code = process.returncode
        except subprocess.TimeoutExpired:
            process.terminate()  # mpirun ends its ranks; killed it would leave them behind
            code, said = TIMEOUT, process.communicate()[0] + f"\nnot done within {timeout} s"
    (folder / "log.txt").write_text(said)
    report, curve = folder / "run/run.json", folder / "run/curve.csv"
    lines = [line.strip() for line in launch.sentences(said)] or [""]
    return Run(code, json.loads(report.read_text()) if code != TIMEOUT and report.is_file() else {},
               study.read_columns(curve, ()) if code != TIMEOUT and curve.is_file() else {}, lines[-1])
