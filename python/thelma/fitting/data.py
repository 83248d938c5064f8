"""Test data: CSV files with a row per state.

Columns: `stretch`, `stress_UNIT` (nominal; an empty cell is a state that was not measured) and, if there are
any, `time_UNIT`, `temperature_UNIT`, `field_UNIT` (nominal, through the thickness), `mode` (uniaxial, which is
the default, pure shear, equibiaxial) and `test`, a name for the rows that belong together. `#` begins a comment.
"""

import csv
import difflib
from dataclasses import dataclass
from pathlib import Path

import numpy as np

from thelma.errors import ThelmaError

QUANTITIES = ("stretch", "stress", "time", "temperature", "field")
TEXTS = ("test", "mode")


@dataclass(frozen=True)
class TestData:
    """One test: what was imposed, and the stresses that were measured."""

    name: str
    mode: str
    units: dict  # of the columns
    columns: dict  # name -> array
    place: str  # file and lines

    __test__ = False  # for pytest

    @property
    def stress(self):
        """Measured; nan where it was not."""
        return self.columns["stress"]

    @property
    def measured(self):
        """Where it was."""
        return np.isfinite(self.stress)

    @property
    def scale(self):
        """The largest stress, beside which errors are counted."""
        return float(np.max(np.abs(self.stress[self.measured])))

    @property
    def label(self):
        """For a legend."""
        return self.name if self.mode == "uniaxial" else f"{self.name}, {self.mode}"

    def request(self):
        """As the program takes it."""
        imposed = {name: {"unit": self.units[name], "values": list(values)}
                   for name, values in self.columns.items() if name != "stress"}
        return {"name": self.name, "mode": self.mode, "columns": imposed,
                "stress unit": self.units["stress"]}


def column_names(header, path):
    """Header -> (name, unit)."""
    found = {}
    for title in header:
        name, _, unit = title.strip().partition("_")
        if name not in QUANTITIES + TEXTS:
            close = difflib.get_close_matches(name, QUANTITIES + TEXTS, 1)
            raise ThelmaError(f"{path}: unknown column '{title}'" +
                              (f"; did you mean '{close[0]}'?" if close else "") +
                              f" Known: {', '.join(QUANTITIES + TEXTS)}")
        if name in (one for one, _ in found.values()):
            raise ThelmaError(f"{path}: two columns {name}; keep one")
        found[title] = name, unit
    names = {name for name, _ in found.values()}
    for name in ("stretch", "stress"):
        if name not in names:
            raise ThelmaError(f"{path}: there is no column {name}; the first line must name the columns, such "
                              "as `stretch, stress_kPa, time_s`")
    for name, unit in found.values():
        if not unit and name in QUANTITIES[1:]:
            raise ThelmaError(f"{path}: the column {name} has no unit; write {name}_"
                              + {"stress": "kPa", "time": "s", "temperature": "degC", "field": "kV/mm"}[name])
    return found


def number(cell, where, may_be_empty):
    """Of a cell; nan if it is empty."""
    if not cell:
        if may_be_empty:
            return np.nan
        raise ThelmaError(f"{where} is empty; only a stress may be left out")
    try:
        value = float(cell)
    except ValueError:
        value = np.nan
    if not np.isfinite(value):
        raise ThelmaError(f"{where}: '{cell}' is no number")
    return value


def read(path):
    """The tests of a file."""
    path = Path(path)
    try:
        lines = path.read_text(encoding="utf-8-sig").splitlines()
    except (OSError, UnicodeDecodeError):
        raise ThelmaError(f"{path}: cannot read these test data; give a CSV file") from None
    numbered = [(i, line) for i, line in enumerate(lines, 1) if line.strip() and not line.lstrip().startswith("#")]
    if len(numbered) < 2:
        raise ThelmaError(f"{path}: it has no data; a line with the columns and a row per state are needed")
    rows = list(csv.reader((line for _, line in numbered), skipinitialspace=True))
    titles = column_names(rows[0], path)
    tests = {}
    for (line, _), row in zip(numbered[1:], rows[1:]):
        if len(row) != len(rows[0]):
            raise ThelmaError(f"{path}:{line}: {len(row)} cells in place of {len(rows[0])}; decimals are "
                              "written with a point")
        cells = {titles[title][0]: cell.strip() for title, cell in zip(rows[0], row)}
        name = cells.get("test") or path.stem
        test = tests.setdefault(name, {"mode": "", "first": line, "columns": {}})
        mode = cells.get("mode", "").replace("_", " ") or test["mode"] or "uniaxial"
        if test["mode"] not in ("", mode):
            raise ThelmaError(f"{path}:{line}: the test '{name}' is {test['mode']} above and {mode} here; give "
                              "tests different names")
        test["mode"] = mode
        for title, (quantity, _) in titles.items():
            if quantity in QUANTITIES:
                value = number(cells[quantity], f"{path}:{line}, column {title.strip()}", quantity == "stress")
                test["columns"].setdefault(quantity, []).append(value)
    units = dict(titles.values())
    return [finished(name, test, units, path) for name, test in tests.items()]


def finished(name, test, units, path):
    """A test with something to fit."""
    columns = {key: np.array(values) for key, values in test["columns"].items()}
    result = TestData(name, test["mode"], units, columns, f"{path}:{test['first']}")
    if not result.measured.any() or not result.scale > 0:
        raise ThelmaError(f"{result.place}: the test '{name}' has no stress; one that is not zero is needed")
    return result


def read_all(paths):
    """The tests of several files, with names of their own and columns in one unit."""
    tests = [test for path in paths for test in read(path)]
    for name in QUANTITIES[1:]:
        units = sorted({test.units[name] for test in tests if name in test.units})
        if len(units) > 1:
            raise ThelmaError(f"the column {name} is in {' and '.join(units)}; use one unit in all files")
    names = [test.name for test in tests]
    for name in names:
        if names.count(name) > 1:
            places = " and ".join(test.place for test in tests if test.name == name)
            raise ThelmaError(f"{places}: both are named '{name}'; give them different names in a column test")
    return tests
