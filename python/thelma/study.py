"""Reads what `thelma --sweep ... --output DIR` leaves in DIR.

    study.csv            a row per case: the swept entries (columns Section/Entry), directory,
                         exit_code, outcome, ...
    CASE/curve.csv       a row per accepted step
    CASE/run.json        the outcome; "pull_in": {"e_below": x, "e_above": y} when bracketed
    CASE/used.prm        every parameter of the case
"""

import csv
import json
import re
from dataclasses import dataclass, field
from pathlib import Path

import numpy as np

from thelma import planar_exact
from thelma import stability
from thelma.errors import ThelmaError

TEMPERATURE = "Temperature/Value"


class StudyError(ThelmaError):
    """One sentence for the user."""


@dataclass
class Case:
    """One run of a study."""

    directory: Path
    swept: dict = field(default_factory=dict)  # entry -> value, as written
    exit_code: int = 0
    outcome: str = ""  # and the reason, if there is one

    def curve(self, *required):
        """Columns of curve.csv by name: arrays of numbers, texts for `event`."""
        return read_columns(self.directory / "curve.csv", required)

    def frame(self):
        """curve.csv as a pandas.DataFrame."""
        return data_frame(self.curve())

    def report(self):
        """run.json: outcome, counts, timings, final values."""
        return json.loads(existing(self.directory / "run.json").read_text())

    def fields(self, at=None):
        """The fields (fields.Fields) at the end, or at the state that is nearest to a load or a second."""
        from thelma.fields import read_fields  # pylint: disable=import-outside-toplevel  # needs VTK
        return read_fields(self.directory, at)

    @staticmethod
    def unstable_pieces(table):
        """Which pieces between the rows of a curve are unstable; none if it does not say."""
        events = list(table["event"]) if "event" in table else None
        rows = len(next(iter(table.values()), []))
        return stability.unstable_pieces(table.get("unstable_directions", np.zeros(rows)), events)

    def pull_in(self):
        """(e_below, e_above) of the pull-in bracket, or None."""
        bracket = self.report().get("pull_in")
        return (bracket["e_below"], bracket["e_above"]) if bracket else None

    def material(self):
        """The material in used.prm (the first, if there are several)."""
        return read_material(existing(self.directory / "used.prm"))


def existing(path):
    """The path, if there is such a file."""
    if not path.is_file():
        raise StudyError(f"there is no file {path}.")
    return path


def read_rows(path, required):
    """Rows of a CSV file as dictionaries, if it has the required columns."""
    with open(existing(path), newline="") as file:
        reader = csv.DictReader(file, skipinitialspace=True)
        header = reader.fieldnames or []
        missing = [name for name in required if name not in header]
        if missing:
            raise StudyError(f"{path} has no column {', '.join(missing)}.")
        return list(reader)


def read_columns(path, required):
    """Columns of a CSV file: arrays of numbers; texts where a cell is none; empty cells are nan."""
    rows = read_rows(path, required)
    return {name: column([row[name] for row in rows]) for name in (rows[0] if rows else required)}


def column(cells):
    """An array of numbers if the cells are numbers, else the texts."""
    try:
        if any(cells):
            return np.array([float(cell) if cell else np.nan for cell in cells])
    except ValueError:
        pass
    return cells


def read_study(directory):
    """The cases of a study, in the order of study.csv."""
    cases = []
    for row in read_rows(Path(directory) / "study.csv", ("directory", "exit_code", "outcome")):
        swept = {name: value for name, value in row.items() if "/" in name}
        outcome = ": ".join(text for text in (row["outcome"], row.get("reason")) if text)
        cases.append(Case(Path(directory) / row["directory"], swept, int(row["exit_code"]),
                          outcome))
    return cases


def study_frame(directory):
    """study.csv as a pandas.DataFrame: a row per case."""
    return data_frame(read_columns(Path(directory) / "study.csv", ("directory", "exit_code", "outcome")))


def data_frame(columns):
    """Of columns by name."""
    import pandas  # pylint: disable=import-outside-toplevel  # optional
    return pandas.DataFrame(columns)


def prm_entry(text, name):
    """Value of the first line `set NAME = VALUE # comment` of a parameter file."""
    found = re.search(rf"^\s*set\s+{re.escape(name)}\s*=\s*([^#\n]*)", text, re.MULTILINE)
    if not found:
        raise StudyError(f"used.prm has no entry '{name}'.")
    return found.group(1).strip()


def read_material(path):
    """The planar_exact.Material of a used.prm."""
    text = path.read_text()

    def numbers(name):
        entry = prm_entry(text, name)
        if ":" in entry:
            raise StudyError(f"used.prm has a table for '{name}', which the exact states do not know.")
        return tuple(float(value) for value in entry.split(","))

    return planar_exact.Material(
        alpha=numbers("Thermal expansion")[0], K=numbers("Bulk modulus")[0],
        theta_0=numbers("Reference temperature")[0], mu_law=numbers("Shear modulus"),
        eps_law=numbers("Permittivity"))
