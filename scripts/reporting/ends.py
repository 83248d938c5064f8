"""What the runs of a study end with, over an entry that was swept."""

import re

from reporting import data


def numbers(values):
    """Of entries that are numbers with the same unit, else nothing."""
    found = [re.fullmatch(r"\s*([-+]?\d*\.?\d+(?:e[-+]?\d+)?)(.*)", value, re.IGNORECASE) for value in values]
    same = all(found) and len({one[2] for one in found}) == 1
    return [float(one[1]) for one in found] if same else []


def curves(ends):
    """(curves, x): `ends` are pairs of the swept entries and the last row of a run, x is the swept
    entry of the most numbers. There is a curve of points for each combination of the other entries,
    none if no entry is a number."""
    swept = {name: numbers([entries[name] for entries, _ in ends]) for name in ends[0][0]} if ends else {}
    swept = {name: values for name, values in swept.items() if len(set(values)) > 1}
    if not swept:
        return [], ""
    x = max(swept, key=lambda name: len(set(swept[name])))
    groups = {}
    for i, (entries, last) in enumerate(ends):
        others = ", ".join(f"{data.short(name)} = {value}" for name, value in entries.items() if name != x)
        row = {**{name: values[i] for name, values in swept.items()}, **last}
        groups.setdefault(others or "all runs", []).append(row)
    return [curve(label, sorted(rows, key=lambda row: row[x])) for label, rows in groups.items()], x


def curve(label, rows):
    """As the page's script takes it, without a colour."""
    names = dict.fromkeys(name for row in rows for name in row)
    return {"label": label, "columns": {name: [row.get(name) for row in rows] for name in names},
            "events": [""] * len(rows), "unstable": [False] * (len(rows) - 1)}
