"""Bodies of revolution in space and as half a section: unknowns and time at equal error."""

import csv
import json
import tempfile
from dataclasses import dataclass
from pathlib import Path

from accuracy_run import solve_seconds
from accuracy_table import Row, select

ROOT = Path(__file__).resolve().parents[1]
SPACE, SECTION = "3-D", "axisymmetric"
FEWER, FASTER = 20, 10  # unknowns and time of the section against those in space, at least
REPETITIONS = 3
SCENES = "balloon", "tube", "membrane"
OBSERVABLES = {"balloon": "radii and enclosed volume", "tube": "radii", "membrane": "growth"}

# Growth of the electrode of the membrane of 0.25 mm in mm: Q2/P1 on half sections with 8 and 16 cells
# through the film agree to all digits. In space doc/actuators.md has 0.4668, extrapolated.
GROWTH = 0.466714

RING = "prm/verification/thermo_electric_tube_axisymmetric.prm"
TUBE = {"Dimension": "3", "Geometry": "plane strain", "Mesh/File": "meshes/tube_quarter.geo",
        "Mesh/Curved": "around x2",
        "Supports/Fixed": "x1_axis: u3, x3_axis: u1, x2_min: u2, x2_max: u2"}


@dataclass(frozen=True)
class Model:
    """A parameter file, what differs from it, and the meshes, coarsest first."""

    file: str
    parameters: str  # of the mesh, by the numbers of cells
    meshes: tuple
    entries: tuple = ()


MODELS = {
    ("balloon", SPACE): Model("prm/balloon.prm", "R: 10, H: 1, n: {}, nr: {}",
                              ((2, 1), (4, 1), (6, 1), (8, 2))),
    ("balloon", SECTION): Model("prm/balloon_axisymmetric.prm", "Ri: 10, Ro: 11, n1: {}, n3: {}",
                                ((2, 4), (2, 6), (2, 8), (2, 12), (2, 16), (2, 24))),
    ("tube", SPACE): Model(RING, "H: 0.125, n1: {}, n2: {}, n3: {}",
                           ((4, 1, 6), (8, 1, 12), (16, 1, 24)), tuple(TUBE.items())),
    ("tube", SECTION): Model(RING, "Ri: 1, Ro: 2, H: 0.125, n1: {}, n3: {}",
                             ((2, 1), (4, 1), (6, 1), (8, 1), (12, 1), (16, 1), (24, 1))),
    ("membrane", SPACE): Model("prm/membrane.prm", "R: 15, Re: 5, h: 0.25, n: {}, nr: {}, nR: {}, n3: 1",
                               ((4, 3, 8), (8, 6, 16), (12, 9, 24))),
    ("membrane", SECTION): Model("prm/membrane_axisymmetric.prm",
                                 "R: 15, Re: 5, h: 0.25, n1: {}, n2: {}, n3: 1, coarser: {}",
                                 ((3, 4, 2.0), (4, 6, 1.8), (6, 8, 1.5), (8, 10, 1.5), (12, 16, 1.3))),
}


def tube():
    """The row of tests/reference/tube.csv with 10 kV and 353 K inside, 293 K outside."""
    with open(ROOT / "tests/reference/tube.csv", newline="", encoding="utf8") as file:
        return next(row for row in csv.DictReader(file) if float(row["V_kV"]) == 10
                    and float(row["theta_inner_K"]) == 353 and float(row["theta_outer_K"]) == 293)


def error(scene, model, final):
    """The largest relative one of the observables, from the final values of a run."""
    if scene == "membrane":
        return abs(final["tip_u1_mm"] / GROWTH - 1)
    if scene == "tube":
        exact = tube()
        return max(abs((1 + final["tip_u1_mm"]) / float(exact["r_inner_mm"]) - 1),
                   abs((2 + final["centre_u1_mm"]) / float(exact["r_outer_mm"]) - 1))
    from thelma import balloon_exact  # with NumPy, which --check does without

    exact = balloon_exact.Balloon().at_pressure(0.004, 15, 9.99, 13.3)
    share = 8 if model == SPACE else 2
    return max(abs((10 + final["tip_u1_mm"]) / exact.inner - 1),
               abs((11 + final["centre_u1_mm"]) / exact.outer - 1),
               abs(share * final["enclosed_volume_mm3"] / exact.volume - 1))


def run(program, scene, model, cells):
    """The row of the fastest of some runs."""
    choice = MODELS[scene, model]
    entries = {**dict(choice.entries), "Mesh/Parameters": choice.parameters.format(*cells),
               "Output/Fields": "none", "Expectations/Final values": ""}
    sets = [text for entry in entries.items() for text in ("--set", "=".join(entry))]
    reports = []
    for _ in range(REPETITIONS):
        with tempfile.TemporaryDirectory() as folder:
            program.start([choice.file, "--output", folder, *sets])
            reports.append(json.loads((Path(folder) / "run.json").read_text(encoding="utf8")))
    report = min(reports, key=solve_seconds)
    return Row(scene, model, "mean dilatation", 2, " x ".join(str(n) for n in cells if isinstance(n, int)), 1,
               report["final_values"]["e"], OBSERVABLES[scene],
               unknowns=sum(report["unknowns"].values()), steps=report["steps"],
               newton_iterations=report["newton_iterations"],
               factorisations=report["factorisations"], solve_seconds=round(solve_seconds(report), 5),
               relative_error=error(scene, model, report["final_values"]), outcome=report["outcome"])


def measure(program):
    """All rows."""
    return [run(program, scene, model, cells)
            for scene, model in MODELS for cells in MODELS[scene, model].meshes]


def pairs(rows):
    """(row in space, the section with the fewest unknowns that is as accurate or None)."""
    found = []
    for scene in SCENES:
        sections = select(rows, scene=scene, model=SECTION)
        for whole in select(rows, scene=scene, model=SPACE):
            as_good = [row for row in sections if row.error <= whole.error]
            found.append((whole, min(as_good, key=lambda row: row.unknowns, default=None)))
    return found


HEADER = ["scene", "3-D cells", "unknowns", "s", "error", "axisymmetric cells", "unknowns", "s",
          "error", "fewer unknowns", "times faster"]
TEXT = f"""Scenes in space and, as half a section through a body of revolution (`Geometry = axisymmetric`), on the
coarsest mesh that is as accurate, all Q2/P1 on one rank. Balloon at 4 kPa and 15 kV (radii and volume)
and tube at 10 kV between 353 and 293 K (radii; a quarter with one cell along its axis): errors against
their boundary value problems. Membrane of 0.25 mm at e = 0.5: growth of the electrode against {GROWTH} mm
of fine sections; errors against the thin membrane are in [actuators.md](actuators.md). The runs of a scene
are made one after the other; their ratio is what matters. Load before the first: {{}}.
"""


def lines(rows):
    """Of the table."""
    found = []
    for whole, section in pairs(rows):
        line = [whole.scene, whole.cells, whole.unknowns, f"{whole.solve_seconds:.3f}",
                f"{whole.error:.1e}"]
        if section is None:
            found.append(line + ["none as accurate", *[""] * 5])
            continue
        found.append(line + [section.cells, section.unknowns, f"{section.solve_seconds:.3f}",
                             f"{section.error:.1e}", f"{whole.unknowns / section.unknowns:.0f}",
                             f"{whole.solve_seconds / section.solve_seconds:.0f}"])
    return found


def least(rows):
    """(smallest factor in unknowns, in time) of the scenes, on the finest meshes in space; nothing
    where a scene has not been run."""
    finest = {whole.scene: (whole, section) for whole, section in pairs(rows) if section}
    if len(finest) < len(SCENES):
        return ()
    return (min(whole.unknowns / section.unknowns for whole, section in finest.values()),
            min(whole.solve_seconds / section.solve_seconds for whole, section in finest.values()))
