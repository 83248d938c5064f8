"""What the page shows of each run: its files, read."""

import json
import re
import shlex
from dataclasses import dataclass, field

import numpy as np
from thelma import study


@dataclass
class Run:
    """A run, alone or a case of a study; files that it did not leave are empty here."""

    case: study.Case
    label: str
    columns: dict  # of curve.csv: name -> list of numbers, texts for `event`
    report: dict  # run.json
    changed: list = field(default_factory=list)  # (entry, value, default, unit)
    estimates: list = field(default_factory=list)  # rows of estimate.csv

    @property
    def failed(self):
        """Whether the run ended otherwise than its file expects."""
        return self.report.get("exit_code", self.case.exit_code) != 0

    @property
    def plane(self):
        """Whether the body is a section in plane strain."""
        return any("plane strain" in line for line in self.report.get("modelled", []))

    @property
    def unfinished(self):
        """Whether it runs or was killed, so that nobody has said how it ended."""
        return not self.report and not self.case.outcome


def load(directory):
    """The runs of a folder; at least one of them left something to show."""
    if (directory / "study.csv").is_file():
        cases = study.read_study(directory) + unfinished(directory)
    elif (directory / "curve.csv").is_file() or (directory / "run.json").is_file():
        cases = [study.Case(directory)]
    elif (directory / "command.txt").is_file():
        cases = unfinished(directory)
    else:
        raise study.StudyError(f"{directory} has neither study.csv nor curve.csv; give the folder "
                               "that --output named.")
    runs = [read(case) for case in cases]
    if not any(run.columns or run.report for run in runs):
        raise study.StudyError(f"nothing in {directory} has a first step to show; wait, or "
                               "start it again if it was killed.")
    return runs


def unfinished(directory):
    """Cases of a study that run, wait or were killed: study.csv has a row only for what ended."""
    return [study.Case(folder) for folder in sorted(directory.glob("*=*"))
            if not (folder / "run.json").is_file()]


def read(case):
    """One run."""
    folder = case.directory
    label = ", ".join(f"{short(name)} = {value}" for name, value in case.swept.items())
    report, columns = {}, {}
    if (folder / "run.json").is_file():
        report = json.loads((folder / "run.json").read_text())
    if (folder / "curve.csv").is_file():
        columns = {name: plain(values) for name, values in case.curve().items() if name}
    return Run(case, label or folder.resolve().name, columns, report,
               changed_entries(folder / "used.prm"), estimates(folder / "estimate.csv"))


def command(directory):
    """The command line that started the run or the study, and where; empty if nobody knows."""
    path = directory / "command.txt"
    if not path.is_file():
        return ""
    where, *arguments = path.read_text().splitlines()
    return f"{shlex.join(['thelma', *arguments])}, in {where}"


def short(entry):
    """An entry without the sections that its name does not need."""
    section, _, name = entry.rpartition("/")
    return section if name == "Value" else name


def plain(values):
    """A column as JSON takes it: what is no finite number is None."""
    if isinstance(values, np.ndarray):
        return [float(value) if np.isfinite(value) else None for value in values]
    return [str(value) for value in values]


def changed_entries(path):
    """Entries of used.prm that differ from their default, with the unit that the comment above
    names."""
    if not path.is_file():
        return []
    changed, sections, comment = [], [], ""
    for line in path.read_text().splitlines():
        line = line.strip()
        if line.startswith("#"):
            comment += " " + line.lstrip("# ")
            continue
        unit, comment = re.search(r"Unit: (.+?)\.( |$)", comment), ""
        if line.startswith("subsection "):
            sections.append(line[11:].strip())
        elif line == "end":
            sections.pop()
        elif found := re.match(r"set (.*?)\s*=\s*(.*?)\s*# default:\s*(.*)$", line):
            entry, value, default = found.groups()
            changed.append(("/".join([*sections, entry]), value, default,
                            unit[1] if unit else ""))
    return changed


def estimates(path):
    """Rows of estimate.csv: quantity, value, error, which is not a number where there is no limit."""
    if not path.is_file():
        return []
    return [(row["quantity"], float(row["value"]), float(row["error_estimate"]))
            for row in study.read_rows(path, ("quantity", "value", "error_estimate"))]


def common(values):
    """The value that all share, or None."""
    values = list(values)
    return values[0] if values and all(value == values[0] for value in values) else None

