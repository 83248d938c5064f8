"""What a step of a run through time costs, against one of an isothermal run on the same mesh."""

import csv
import json
import tempfile
from pathlib import Path

from accuracy_table import Row, select

SCENE, OBSERVABLE = "time step", "seconds a step"
ISOTHERMAL, TRANSIENT = "isothermal", "transient, staggered"
MOST = 1.5  # times the isothermal step

# The paper's bending actuator: its curve to e = 0.87 at 353 K, and its way from 293 to 353 K, heated
# from one face under the voltage of that end.
FILE = "prm/bending_actuator.prm"
SETTINGS = {
    ISOTHERMAL: {},
    TRANSIENT: {"Temperature/Value": "293", "Loading/Control": "voltage",
                "Loading/Target": "9.0798", "Temperature/Model": "transient",
                "Temperature/Fixed": "back: 353", "Time/End": "40", "Time/Initial step": "0.001",
                "Time/Tolerance": "0.02"},
}


def arguments(name, folder):
    """Of the program."""
    entries = {**SETTINGS[name], "Output/Fields": "none"}
    sets = [text for entry in entries.items() for text in ("--set", "=".join(entry))]
    return [FILE, "--output", str(folder), *sets]


def measured(name, folder):
    """The row of a run that has ended in the folder; the steps that bend a transient one before its
    time begins do not count."""
    report = json.loads((Path(folder) / "run.json").read_text(encoding="utf8"))
    with open(Path(folder) / "curve.csv", newline="", encoding="utf8") as file:
        curve = list(csv.DictReader(file))
    first = sum(float(line["time_s"]) == 0 for line in curve) - 1 if name == TRANSIENT else 0
    last = len(curve) - 1
    seconds = float(curve[last]["seconds"]) - float(curve[first]["seconds"])
    return Row(SCENE, name, "selective reduced", 1, "4 x 8 x 20", 1, float(curve[last]["e"]),
               OBSERVABLE, unknowns=sum(report["unknowns"].values()), steps=last - first,
               newton_iterations=report["newton_iterations"],
               factorisations=report["factorisations"], solve_seconds=seconds,
               value=seconds / (last - first), outcome=report["outcome"])


def measure(program):
    """Both rows."""
    rows = []
    for name in SETTINGS:
        with tempfile.TemporaryDirectory() as folder:
            program.start(arguments(name, folder))
            rows.append(measured(name, folder))
    return rows


def ratio(rows):
    """Of the seconds a step, or None."""
    found = [select(rows, scene=SCENE, model=name) for name in (TRANSIENT, ISOTHERMAL)]
    return found[0][0].value / found[1][0].value if all(found) else None
