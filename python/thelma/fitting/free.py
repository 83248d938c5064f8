"""Which numbers of a parameter file are free: those of entries with a comment that begins with `free`.

    set Modulus         = 26 kPa  # free
    set Relaxation time = 6.5     # free from 0.1 to 1000
    set WLF constants   = 5, 100  # free as shift

`from A to B` are bounds in the unit of the entry; entries that are free `as` the same name have the same value.
"""

import math
import re
from dataclasses import dataclass

from thelma.errors import ThelmaError
from thelma.prm import numbers

MARK = re.compile(r"free(?P<rest>\b.*)$")
OPTIONS = re.compile(r"(?:\s+as\s+(?P<name>.+?))?(?:\s+from\s+(?P<low>\S+)\s+to\s+(?P<high>\S+))?\s*$")


@dataclass(frozen=True)
class Parameter:
    """A free number; positive ones without a companion that is not are sought by their logarithm."""

    name: str
    unit: str
    start: float
    low: float
    high: float
    is_positive: bool

    @property
    def scale(self):
        """Of a linear step."""
        return abs(self.start) or 1.0

    def coordinate(self, value):
        """What the least squares see."""
        return math.log(value) if self.is_positive else value / self.scale

    def value(self, coordinate):
        """Of a coordinate."""
        return math.exp(coordinate) if self.is_positive else coordinate * self.scale

    @property
    def bounds(self):
        """Of the coordinate."""
        low = max(self.low, 0.0) if self.is_positive else self.low
        return (-math.inf if self.is_positive and low == 0 else self.coordinate(low),
                math.inf if math.isinf(self.high) else self.coordinate(self.high))


@dataclass(frozen=True)
class FreeEntry:
    """An entry with its numbers' parameters, by their place in the list of all, and what follows each number."""

    name: str
    places: tuple
    tails: tuple

    def text(self, values):
        """Its value at these values of all parameters."""
        return ", ".join(f"{float(values[place])!r}{tail}" for place, tail in zip(self.places, self.tails))


def marked(entry, where):
    """The parameters of an entry and the name it shares, or None if it is not free."""
    mark = MARK.match(entry.comment)
    if not mark:
        return None
    options = OPTIONS.match(mark["rest"])
    where = f"{where}:{entry.lines[0] + 1}, entry '{entry.path[-1]}'"
    if entry.path[0] != "Materials":
        raise ThelmaError(f"{where}: it is not in the section Materials; only a material can be fitted")
    if not options:
        raise ThelmaError(f"{where}: '# {entry.comment}' is not understood; write `# free`, `# free from 1 to "
                          "10` or `# free as NAME`")
    try:
        parts = numbers(entry.value)
        low, high = float(options["low"] or "-inf"), float(options["high"] or "inf")
    except ValueError:
        raise ThelmaError(f"{where}: '{entry.value}' with '# {entry.comment}' is not made of numbers; only "
                          "numbers can be free") from None
    if not low < high or any(not low <= number <= high for number, _ in parts):
        raise ThelmaError(f"{where}: the value {entry.value} is not between the bounds {low:g} and {high:g}")
    is_positive = all(number > 0 for number, _ in parts) and (low == -math.inf or low >= 0)
    return parts, options["name"], low, high, is_positive


def free(text):
    """(parameters, entries) of a parameter file."""
    parameters, entries, shared = [], [], {}
    for entry in text.entries.values():
        found = marked(entry, text.name)
        if not found:
            continue
        parts, name, low, high, is_positive = found
        if name in shared:
            places = shared[name]
            if len(places) != len(parts):
                raise ThelmaError(f"{text.name}:{entry.lines[0] + 1}, entry '{entry.path[-1]}': it is free as "
                                  f"{name}, which has {len(places)} numbers, but has {len(parts)}")
        else:
            places = tuple(range(len(parameters), len(parameters) + len(parts)))
            title = name or "/".join(entry.path[2:])
            for i, (number, tail) in enumerate(parts, 1):
                parameters.append(Parameter(title + (f" [{i}]" if len(parts) > 1 else ""), tail.strip(), number,
                                            low, high, is_positive))
            if name:
                shared[name] = places
        entries.append(FreeEntry(entry.name, places, tuple(tail for _, tail in parts)))
    if not parameters:
        raise ThelmaError(f"{text.name}: no parameter is free; write `# free` behind the entries of the material "
                          "that are sought")
    return parameters, entries


def material_of(entries, name):
    """The one material that is fitted."""
    names = sorted({entry.name.split("/")[1] for entry in entries})
    if len(names) > 1:
        raise ThelmaError(f"{name}: parameters of the materials {' and '.join(names)} are free; fit one at a time")
    return names[0]
