"""What scripts/accuracy runs: scenes, meshes, targets, references, the peer's published times."""

import csv
import math
from dataclasses import dataclass, field
from pathlib import Path

ROOT = Path(__file__).resolve().parents[1]
LENGTH, LAYER = 20.0, 0.5  # mm, of the bending actuator
ORDER_AT = 0.5  # the field e at which orders of convergence are measured

# The same for every run: about three equal steps, as many as suit the peer too. The predictor
# carries them to e = 0.87 with few iterations.
STEPPING = {"Stepping/Initial step": "0.34", "Stepping/Largest step": "0.34",
            "Output/Fields": "none"}

# Deflection in mm of the pump's centre at e = 0.5: with Q2/P1 a quarter of n x n x 5 n cells gives
# 2.78246, 2.78848, 2.79108, 2.79310 for n = 2, 3, 4, 6, that is 2.7954 - 0.0389/n^1.58.
PUMP = 2.7954

# u_1/L of the tip at e = 0.475, 353 K, alpha = 1.8e-4 1/K: an independent code, converged.
TIP = 0.664257


@dataclass(frozen=True)
class Target:
    """A run to the field e and the observable whose error is measured there."""

    e: float
    observable: str
    column: str  # of curve.csv
    unit: float  # of the observable, in units of the column
    timed: bool = True  # else run once, for the order of convergence only


TARGETS = {
    "bending": (Target(0.475, "tip u_1/L", "tip_u1_mm", LENGTH),
                Target(ORDER_AT, "mid rotation", "mid_rotation_deg", 1, timed=False),
                Target(0.87, "mid rotation", "mid_rotation_deg", 1)),
    "pump": (Target(0.5, "centre u_1", "centre_u1_mm", 1),),
}


@dataclass(frozen=True)
class Model:
    """A parameter file and how its mesh is refined."""

    file: str
    parameters: str  # of the mesh, by the numbers of cells
    options: dict = field(default_factory=dict)
    factors: tuple = (1, 1, 1)  # the geometry counts the cells of the whole body

    def mesh(self, cells):
        """Mesh/Parameters."""
        return self.parameters.format(*(n * f for n, f in zip(cells, self.factors)))


NO_PULL_IN = {"Loading/Expected end": "target", "Expectations/Final values": ""}
BLOCK = "n1: {}, n2: {}, n3: {}"
MODELS = {
    ("bending", "plane"): Model("prm/bending_actuator_plane.prm", "n1: {}, n3: {}"),
    ("bending", "3-D"): Model("prm/bending_actuator.prm", BLOCK),
    ("pump", "quarter"): Model("prm/buckling_pump_quarter.prm", BLOCK + ", quarter: 1", NO_PULL_IN,
                               (1, 2, 2)),
    ("pump", "3-D"): Model("prm/buckling_pump.prm", BLOCK, NO_PULL_IN),
}


@dataclass(frozen=True)
class Case:
    """A scene on one mesh with one element."""

    scene: str
    model: str
    formulation: str
    degree: int
    cells: tuple

    def settings(self, e):
        """Entries that differ from the parameter file."""
        model = MODELS[self.scene, self.model]
        return {**STEPPING, **model.options, "Mesh/Parameters": model.mesh(self.cells),
                "Discretisation/Formulation": self.formulation,
                "Discretisation/Degree": str(self.degree), "Loading/Target": f"{e:g}"}


# Programs of benchmarks/peer: with the package's assembler, as published, and with a faster one.
PEER_PROGRAMS = "FEniCSx", "FEniCSx, gathered"
PEER_TO = 0.475  # where the peer ends


@dataclass(frozen=True)
class Peer:
    """Published by the strongest peer: a range of seconds where several runs differ."""

    iterations: str
    seconds: tuple
    error: float  # of the tip
    factor: float  # Thelma must be so much faster


MEAN, REDUCED = "mean dilatation", "selective reduced"
PEERS = {
    Case("bending", "3-D", REDUCED, 1, (4, 8, 20)): Peer("89", (2.4,), 0.129, 3),
    Case("bending", "3-D", MEAN, 1, (4, 8, 20)): Peer("39", (1.2,), 0.129, 3),
    Case("bending", "3-D", MEAN, 2, (4, 8, 20)): Peer("29-33", (17.0, 20.0), 7e-5, 4),
    Case("bending", "3-D", MEAN, 1, (16, 1, 80)): Peer("48", (2.2,), 0.0084, 3),
    Case("bending", "3-D", MEAN, 1, (24, 1, 120)): Peer("", (5.7,), 0.0037, 3),
    Case("bending", "3-D", MEAN, 2, (2, 1, 8)): Peer("33", (0.23,), 0.0026, 4),
    Case("bending", "3-D", MEAN, 2, (2, 1, 10)): Peer("", (0.30,), 0.0011, 4),
    Case("bending", "3-D", MEAN, 2, (2, 1, 14)): Peer("", (0.42,), 3e-4, 4),
}

# Meshes by scene, model and degree; for every formulation that has the degree.
MESHES = {
    ("bending", "plane", 1): ((4, 20), (4, 40), (8, 80), (16, 160)),
    ("bending", "plane", 2): ((2, 6), (2, 8), (2, 10), (2, 14), (2, 20), (2, 28), (4, 40)),
    ("bending", "3-D", 1): ((4, 1, 40), (16, 1, 80)),
    ("bending", "3-D", 2): ((2, 1, 8), (2, 1, 14)),
    ("pump", "quarter", 1): ((4, 4, 10), (4, 4, 20), (4, 4, 40)),
    ("pump", "quarter", 2): ((1, 1, 5), (2, 1, 10), (2, 1, 20), (2, 1, 40)),
    ("pump", "3-D", 1): ((4, 8, 20),),
}
# But full integration locks and selectively reduced integration gives the answers of mean
# dilatation in more iterations: a few meshes show it.
FEW_MESHES = {
    "standard": {("bending", "plane", 1): ((4, 20), (8, 80)),
                 ("bending", "plane", 2): ((2, 6), (2, 14), (4, 40))},
    "selective reduced": {("bending", "plane", 1): ((4, 20), (8, 80)),
                          ("bending", "plane", 2): ((2, 6), (2, 14), (4, 40)),
                          ("bending", "3-D", 1): ((4, 1, 40),),
                          ("pump", "quarter", 1): ((4, 4, 10), (4, 4, 20)),
                          ("pump", "quarter", 2): ((1, 1, 5), (2, 1, 10)),
                          ("pump", "3-D", 1): ((4, 8, 20),)},
}
QUICK_MESHES = {
    ("bending", "plane", 1): ((4, 20), (4, 40)),
    ("bending", "plane", 2): ((2, 6), (2, 10), (2, 14)),
    ("pump", "quarter", 1): ((4, 4, 10),),
    ("pump", "quarter", 2): ((1, 1, 5),),
}
# Meshes that halve both cell lengths, for the order in the rotation.
HALVED = {1: ((4, 20), (8, 40), (16, 80), (32, 160)), 2: ((2, 10), (4, 20), (8, 40), (16, 80))}


def halved(degree, meshes=4):
    """Cases of a sequence of mean dilatation in the plane, coarsest first."""
    return [Case("bending", "plane", MEAN, degree, cells) for cells in HALVED[degree][:meshes]]


def plan(elements, quick):
    """The fields e to run to, by case; elements are pairs of formulation and degree."""
    cases = {case: None for case in PEERS} if not quick else {}
    for formulation, offered in elements:
        meshes = QUICK_MESHES if quick else FEW_MESHES.get(formulation, MESHES)
        for (scene, model, degree), refined in meshes.items():
            for cells in refined if offered == degree else ():
                cases[Case(scene, model, formulation, degree, cells)] = None
    fields = {case: [target.e for target in TARGETS[case.scene] if target.timed]
              for case in cases}
    for degree in (2,) if quick else (1, 2):
        for case in halved(degree, 2 if quick else 4):
            fields.setdefault(case, []).append(ORDER_AT)
    return fields


def interpolated(x, xs, ys, points=10):
    """The polynomial through the nearest points, at x."""
    nearest = sorted(range(len(xs)), key=lambda i: abs(xs[i] - x))[:points]
    return sum(ys[i] * math.prod((x - xs[j]) / (xs[i] - xs[j]) for j in nearest if j != i)
               for i in nearest)


def exact_mid_rotation(e, theta=353.0, alpha=1.8e-4):
    """Degrees that the section at mid-length of the exact circle turns.

    Interpolates curvature / e^2, a smooth function of e^2; the error is below 1e-7.
    """
    with open(ROOT / "tests/reference/bilayer_bending.csv", newline="", encoding="utf8") as file:
        rows = [row for row in csv.DictReader(file)
                if float(row["alpha_per_K"]) == alpha and float(row["theta_K"]) == theta]
    squares = [float(row["e"]) ** 2 for row in rows]
    ratios = [float(row["curvature_times_layer_thickness_rad"]) / square
              for row, square in zip(rows, squares)]
    return math.degrees(interpolated(e * e, squares, ratios) * e * e / LAYER * LENGTH / 2)


def reference(scene, target):
    """The value without discretisation error."""
    if scene == "pump":
        return PUMP
    return TIP if target.observable.startswith("tip") else exact_mid_rotation(target.e)
