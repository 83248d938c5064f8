"""The rows that scripts/accuracy measures: kept as CSV, judged by pure functions."""

import csv
import math
from dataclasses import asdict, dataclass, fields

THELMA = "thelma"


@dataclass
class Row:
    """A run to one field e; numbers that a failed run has not reached are None."""

    scene: str
    model: str
    formulation: str
    degree: int
    cells: str  # as 4 x 8 x 20
    ranks: int
    e: float
    observable: str
    unknowns: int = None
    steps: int = None
    newton_iterations: int = None
    factorisations: int = None
    solve_seconds: float = None  # without start-up, mesh and setup
    peak_memory_MB: float = None  # of the largest rank
    value: float = None
    reference: float = None
    relative_error: float = None  # signed
    outcome: str = ""
    program: str = THELMA  # or the peer

    @property
    def error(self):
        """Magnitude; infinite for a failed run."""
        return math.inf if self.relative_error is None else abs(self.relative_error)

    @property
    def family(self):
        """What refinement keeps."""
        return self.scene, self.model, self.formulation, self.degree, self.ranks

    @property
    def element(self):
        """Short name."""
        if self.formulation == "mean dilatation":
            return f"Q{self.degree}/P{self.degree - 1}"
        return f"Q{self.degree} {self.formulation}"


TYPES = {field.name: field.type for field in fields(Row)}


def write(path, rows, notes):
    """CSV with the notes, a dictionary of texts, as comments in front."""
    with open(path, "w", newline="", encoding="utf8") as file:
        for name, text in notes.items():
            file.write(f"# {name}: {text}\n")
        writer = csv.DictWriter(file, list(TYPES))
        writer.writeheader()
        for row in rows:
            writer.writerow({name: "" if value is None else f"{value:.10g}"
                             if isinstance(value, float) else value
                             for name, value in asdict(row).items()})


def read(path):
    """(rows, notes) of a file that write() left."""
    with open(path, newline="", encoding="utf8") as file:
        lines = file.readlines()
    notes = dict(line[2:].rstrip("\n").split(": ", 1) for line in lines if line.startswith("# "))
    records = csv.DictReader(line for line in lines if not line.startswith("# "))
    return [Row(**{name: TYPES[name](text) if text or TYPES[name] is str else None
                   for name, text in record.items()}) for record in records], notes


def select(rows, **wanted):
    """Rows with these values."""
    return [row for row in rows
            if all(getattr(row, name) == value for name, value in wanted.items())]


def families(rows):
    """Rows by family, coarsest mesh first."""
    groups = {}
    for row in sorted(rows, key=lambda row: row.unknowns or 0):
        groups.setdefault(row.family, []).append(row)
    return groups


def observed_orders(errors, ratio=2):
    """Orders of convergence between meshes, each `ratio` times finer than the one before."""
    return [math.log(abs(coarse / fine), ratio) for coarse, fine in zip(errors, errors[1:])]


def choose(rows, tolerance):
    """The fastest row whose error is within the tolerance, or None.

    A mesh counts only if all finer ones of its family are as good: an error that passes through
    zero by chance is not a recommendation.
    """
    good = []
    for family in families(rows).values():
        for row in reversed(family):
            if row.error > tolerance:
                break
            good.append(row)
    return min(good, key=lambda row: row.solve_seconds, default=None)
