"""The buckling pump: buckling field, post-buckling path and pull-in against an independent code.

Usage: buckling_pump.py THELMA_BINARY MPIEXEC SOURCE_DIR RANKS...

The references come from an independent finite element code with the same elements and meshes
(K = 1000 mu); the thin limits from doc/theory.md, "Buckling pump".
"""

import json
import math
import re
import tempfile
from pathlib import Path

from scene import program_and_ranks, require, study, validated
from thelma import buckling

LENGTH, THICKNESS = 20.0, 1.0  # mm
TOLERANCE = 1e-2  # relative, of fields and deflections
QUARTER = "buckling_pump_quarter"
PAPER = ["--set", "Discretisation/Degree=1",
         "--set", "Discretisation/Formulation=selective reduced",
         "--set", "Mesh/Parameters=n1: 4, n2: 8, n3: 20, quarter: 1"]
HELD_WIDTH = ["--set", "Mesh/Parameters=n1: 2, n2: 2, n3: 20, quarter: 1", "--set",
              "Supports/Fixed=x3_min: u1 u2 u3, x3_max: u3, x2_min: u2, x2_max: u2"]
NO_PULL_IN = ["--set", "Loading/Expected end=target", "--set", "Expectations/Final values="]
PERFECT = [*NO_PULL_IN, "--set", "Mesh/Imperfection=0", "--set", "Loading/Target=0.3"]

# Buckling field of the perfect layer: what, options, independent code, thin limit.
BUCKLING = [
    ("paper's mesh and element", PAPER, 0.2536, None),
    ("Q2/P1", [], 0.2204, math.sqrt(2) * math.pi * THICKNESS / LENGTH),
    ("Q2/P1, width held", HELD_WIDTH, 0.182, 2 * math.pi / math.sqrt(3) * THICKNESS / LENGTH),
]
DEFLECTION = {0.25: 0.620, 0.30: 1.117, 0.40: 1.925, 0.50: 2.765, 0.60: 3.842}  # mm by e; 2 x 2 x 5
PULL_IN = 0.683


def heated(theta):
    """Options of a layer that would expand."""
    return ["--set", f"Temperature/Value={theta}",
            "--set", "Materials/elastomer/Thermal expansion=1.8e-4"]


def require_near(what, value, reference, tolerance=TOLERANCE):
    """Within the relative tolerance."""
    print(f"{what}: {value:.5g}, reference {reference:.5g}, {100 * (value / reference - 1):+.2f} %")
    validated("buckling_pump", what, "thin strip" if "thin" in what else
              "its quarter" if "quarter" in what else "independent code", value / reference - 1)
    require(abs(value / reference - 1) <= tolerance, f"{what}: {value}, not {reference}")


def check_perfect(program, folder, what, options, reference, thin_limit=None, ranks=1):
    """The straight layer is stable up to the buckling field and the run ends there."""
    case = program.run(QUARTER, folder, *PERFECT, *options, ranks=ranks, exit_code=3)
    curve = case.curve("e", "event", "unstable_directions")
    event = curve["event"][-1]
    require(event == "bifurcation", f"{what}: the last event is '{event}'")
    require(not any(curve["unstable_directions"]), f"{what}: an unstable state was accepted")
    require_near(f"{what}, {ranks} ranks", curve["e"][-1], reference)
    if thin_limit:
        require_near(f"{what}, thin limit", curve["e"][-1], thin_limit)


def check_heat(program, folder):
    """A clamped layer that would expand buckles earlier, and by heat alone 61.5 K above 293 K."""
    for theta, reference in [(313, 0.217), (333, 0.162)]:
        check_perfect(program, folder, f"paper's element, {theta} K", [*PAPER, *heated(theta)],
                      reference)
    case = program.run(QUARTER, folder, *PERFECT, *PAPER, *heated(360), exit_code=3)
    reason = json.loads((case.directory / "run.json").read_text())["reason"]
    require_near("buckles by heat alone at K above 293",
                 float(re.search(r"beyond ([\d.]+) K", reason)[1]) - 293, 61.5)


def check_imperfect(program, folder):
    """The paper's scene leaves the straight path at the buckling field of the perfect layer."""
    options = [*NO_PULL_IN, "--set", "Loading/Target=0.255"]
    case = program.run("buckling_pump", folder, *options)
    curve = case.curve("e", "centre_u1_mm")
    require_near("paper's scene, Southwell",
                 buckling.buckling_field(curve["e"], curve["centre_u1_mm"], THICKNESS), 0.2536)
    quarter = program.run(QUARTER, folder, *PAPER, *options).curve("centre_u1_mm")
    require_near("deflection of the whole layer in mm, reference its quarter",
                 curve["centre_u1_mm"][-1], quarter["centre_u1_mm"][-1], 1e-6)


def check_path(program, folder):
    """It follows the buckled path, to the side of the imperfection, up to pull-in."""
    case = program.run(QUARTER, folder, *PAPER)
    curve = case.curve("e", "centre_u1_mm", "event")
    w = curve["centre_u1_mm"]
    require(all(w[1:] > w[:-1]), "the deflection does not grow all the way")
    require(curve["event"][-1] == "pull-in", f"the last event is '{curve['event'][-1]}'")
    require_near("pull-in, paper's element", case.pull_in()[0], PULL_IN)
    require_near("pull-in, Q2/P1", program.run(QUARTER, folder).pull_in()[0], PULL_IN)
    require(0.27 < w[-1] / LENGTH < 0.30, f"deflection {w[-1]} mm at pull-in, not about 0.285 L")


def check_deflection(program, folder):
    """Behind the bifurcation, to the side of the imperfection."""
    program.run(QUARTER, folder, *NO_PULL_IN, "--sweep",
                "Loading/Target=" + ",".join(map(str, DEFLECTION)),
                "--set", "Mesh/Parameters=n1: 2, n2: 4, n3: 10, quarter: 1")
    for case, (e, reference) in zip(study.read_study(folder), DEFLECTION.items()):
        deflection = case.curve("centre_u1_mm")["centre_u1_mm"][-1]
        require_near(f"Q2/P1 at e = {e}, deflection in mm", deflection, reference)


def main():
    program, all_ranks = program_and_ranks(__doc__)
    with tempfile.TemporaryDirectory() as directory:
        folder = Path(directory)
        for row in BUCKLING:
            check_perfect(program, folder, *row)
        for ranks in all_ranks[1:]:
            check_perfect(program, folder, *BUCKLING[0], ranks=ranks)
        check_heat(program, folder)
        check_imperfect(program, folder)
        check_path(program, folder)
        check_deflection(program, folder / "study")


main()
