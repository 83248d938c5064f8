"""doc/accuracy.md and the lines in README.md, from the rows of scripts/accuracy."""

import math
import re

import accuracy_steps
from accuracy_cases import HALVED, MEAN, REDUCED, ORDER_AT, PEER_PROGRAMS, PEER_TO, PEERS, halved
from accuracy_table import THELMA, choose, observed_orders, select

BEGIN, END = "<!-- accuracy: written by scripts/accuracy -->", "<!-- accuracy: end -->"
TOLERANCES = (0.05, 0.01, 0.001)
HALF_WAY = "0.475"  # where the peer ends, not the scene
GOALS = (("bending to e = 0.475", "bending", 0.475), ("bending to e = 0.87", "bending", 0.87),
         ("pump at e = 0.5", "pump", 0.5))
TIME_BARS = ((0.475, 0.01, 0.05), (0.475, 0.001, 0.10), (0.87, 0.01, 0.2))  # e, error, seconds
MOST_ITERATIONS = 60  # of Q2/P1 to e = 0.87

PUMP = """Buckling
pump at 293 K: deflection of the centre at e = 0.5, compared with {:.4f} mm, extrapolated from
Q2/P1 on quarters of up to 6 x 6 x 30 cells and itself good to about 1e-4. The clamped edges are
singular: Q2/P1 converges to this number with an order of 1.6 only."""

HEAD = """# Error against time

*Written by `scripts/accuracy`; the numbers, and more of them, are in [accuracy.csv](accuracy.csv).*

![Error against seconds](figures/accuracy.png)

Bending actuator at 353 K, alpha = 1.8e-4 1/K. The tip's u_1/L at e = 0.475 is compared with
0.664257 (an independent code, converged, free end included), the rotation of the section at
mid-length at e = 0.5 and 0.87 with the exact circle ([theory.md](theory.md), "Bending"). {pump}

Seconds are those of `run.json` without start-up, mesh and setup: the smallest of several runs where
they are short. *Plane* is the bending actuator in plane strain, *quarter* the pump by its two
symmetry planes, *3-D* the whole body. Q2/P1 is mean dilatation of degree 2, Q1/P0 of degree 1. MB
is the peak memory of the largest rank, start-up included. *its* are Newton iterations, *LU* the
factorisations among them.

Every run has the same settings: {settings}.

Program: {program}. Machine: {machine}; load before the first run: {load}.{warning}
"""
WARNING = " **The machine was busy: the seconds are too large.**"


def percent(error):
    """Two digits."""
    return f"{float(f'{100 * error:.2g}'):g} %"


def seconds(value):
    """Three digits or milliseconds."""
    return "" if value is None else f"{value:.3f}" if value < 1 else f"{value:.2f}"


def markdown(header, rows):
    """A table."""
    lines = [header, ["---"] * len(header), *rows]
    return "\n".join("| " + " | ".join(map(str, line)) + " |" for line in lines) + "\n"


def holds(value, bar):
    """Whether it is at most the bar, and by how much it misses."""
    return "holds" if value <= bar else f"**fails**: {value / bar:.2g} times"


def setting(row):
    """How to get a row."""
    return f"{row.model} {row.element} {row.cells} ({seconds(row.solve_seconds)} s)"


def solved(rows, scene, e, **more):
    """Thelma's one-rank rows of a goal."""
    return select(rows, scene=scene, e=e, ranks=1, program=THELMA, **more)


def find(rows, case, e, ranks=1, program=THELMA):
    """The row of a case, or None."""
    found = select(rows, scene=case.scene, model=case.model, formulation=case.formulation,
                   degree=case.degree, cells=" x ".join(map(str, case.cells)), e=e, ranks=ranks,
                   program=program)
    return found[0] if found else None


def recommendations(rows):
    """Settings by goal and tolerance."""
    lines = []
    for name, scene, e in GOALS:
        reliable = [row for row in solved(rows, scene, e) if row.formulation != REDUCED]
        chosen = [choose(reliable, tolerance) for tolerance in TOLERANCES]
        lines.append([name, *(setting(row) if row else "none measured" for row in chosen)])
    return lines


def summary(rows):
    """For README.md: the diagram, and one line with the settings for whole curves."""
    goals = []
    for name, *settings in recommendations(rows):
        if not name.endswith(HALF_WAY):
            goals.append(f"{name}, " + ", ".join(
                f"{percent(tolerance)}: {text}" for tolerance, text in zip(TOLERANCES, settings)))
    return ("![Error against seconds of every element](doc/figures/accuracy.png)\n\n"
            "Cheapest setting for an error below 5 %, 1 %, 0.1 %: **" + "; ".join(goals) +
            "** ([doc/accuracy.md](doc/accuracy.md)).\n")


def insert(text, lines):
    """The text with the lines between the markers."""
    pattern = re.compile(re.escape(BEGIN) + ".*?" + re.escape(END), re.DOTALL)
    if not pattern.search(text):
        raise ValueError(f"README.md has no lines '{BEGIN}' and '{END}'.")
    return pattern.sub(lambda _: f"{BEGIN}\n{lines}{END}", text)


def peer_lines(rows):
    """Peer and Thelma on the same mesh with the same element: published, here, two ranks."""
    lines = []
    for case, peer in PEERS.items():
        row, shared = find(rows, case, PEER_TO), find(rows, case, PEER_TO, 2)
        if row is None:
            continue
        packaged, gathered = (find(rows, case, PEER_TO, program=name) for name in PEER_PROGRAMS)
        line = [row.element, row.cells, peer.iterations,
                "-".join(f"{value:g}" for value in peer.seconds)]
        line += [packaged.newton_iterations if packaged else "",
                 *(seconds(other.solve_seconds) if other else "" for other in (packaged, gathered)),
                 percent(packaged.error if packaged else peer.error)]
        if row.relative_error is None:
            lines.append(line + ["", "", row.outcome, "", "", "", peer.factor, "**fails**"])
            continue
        ratio = (packaged.solve_seconds if packaged else min(peer.seconds)) / row.solve_seconds
        lines.append(line + [
            row.newton_iterations, seconds(row.solve_seconds), percent(row.error),
            seconds(shared.solve_seconds) if shared else "", f"{ratio:.1f}",
            f"{gathered.solve_seconds / row.solve_seconds:.1f}" if gathered else "",
            f"{peer.factor:g}", holds(peer.factor, ratio)])
    return lines


PEER_HEADER = ["element", "cells", "published its", "published s", "peer its", "peer s",
               "gathered s", "peer error", "its", "s", "error", "s, 2 ranks", "times faster",
               "than gathered", "required", ""]
PEER_TEXT = """Bending actuator, 3-D, to e = 0.475, one core, with a FEniCSx script: compiled
kernels, MUMPS LDL^T, OpenBLAS. *published*: its times on another machine. *peer*: those of
[benchmarks/peer](../benchmarks/peer/README.md) in the same session and on the same machine as
Thelma's, {measured}; *gathered* replaces the assembler of the package by a faster one of the
script. *Times faster*, and the requirement, refer to the peer where it was measured, else to what
was published. Errors are those of the tip.
"""


def bar_lines(rows):
    """The requirements on time and iterations."""
    lines = []
    for e, tolerance, bar in TIME_BARS:
        what = f"plane model to e = {e:g}, error below {percent(tolerance)}"
        row = choose(solved(rows, "bending", e, model="plane"), tolerance)
        lines.append([what, f"{bar:.2f} s", setting(row) if row else "none measured",
                      holds(row.solve_seconds, bar) if row else "**fails**"])
    ratio = accuracy_steps.ratio(rows)
    if ratio:
        lines.append(["a step in time (staggered), in isothermal steps; see below",
                      accuracy_steps.MOST, f"{ratio:.2f}", holds(ratio, accuracy_steps.MOST)])
    whole = [row for row in solved(rows, "bending", 0.87, formulation=MEAN, degree=2)
             if row.relative_error is not None]
    if whole:
        worst = max(whole, key=lambda row: row.newton_iterations)
        lines.append(["Newton iterations of Q2/P1 to e = 0.87, the most on any mesh",
                      MOST_ITERATIONS,
                      f"{worst.newton_iterations} ({worst.model}, {worst.cells} cells)",
                      holds(worst.newton_iterations, MOST_ITERATIONS)])
    return lines


def order_lines(rows):
    """Errors and orders of mean dilatation on meshes that halve both cell lengths."""
    lines = []
    for degree in HALVED:
        found = [find(rows, case, ORDER_AT) for case in halved(degree)]
        found = [row for row in found if row and row.relative_error]
        orders = ["", *(f"{q:.2f}" for q in observed_orders([row.error for row in found]))]
        lines += [[row.element, row.cells, f"{row.error:.2e}", order, 2 * degree]
                  for row, order in zip(found, orders)]
    return lines


STEP_TEXT = """The paper's bending actuator on its mesh: the isothermal curve to e = 0.87 at 353 K,
and the way from 293 to 353 K, heated from one face under voltage. Seconds are those of a step,
iterations and factorisations those of the run, with what bends it before its time begins. The two
runs follow each other; their ratio is what counts.
"""


def step_lines(rows):
    """Isothermal and transient."""
    return [[row.model, row.unknowns, row.steps, row.newton_iterations, row.factorisations,
             f"{row.value:.4f}"] for row in select(rows, scene=accuracy_steps.SCENE)]


def outcome(row, form="{:.1e}"):
    """Signed error, or why there is none."""
    if row is None:
        return ""
    return row.outcome if row.relative_error is None else form.format(row.relative_error)


def effort(row):
    """Iterations, factorisations, seconds."""
    if row is None or row.relative_error is None:
        return ["", "", ""]
    return [row.newton_iterations, row.factorisations, seconds(row.solve_seconds)]


def case_lines(rows, scene, fields):
    """A line per mesh and number of ranks: effort and error at each field e of `fields`."""
    groups = {}
    for row in select(rows, scene=scene, program=THELMA):
        groups.setdefault((row.model, row.element, row.cells, row.ranks), {})[row.e] = row
    lines = []
    for (model, element, cells, ranks), by_field in sorted(
            groups.items(), key=lambda item: (item[0][0], item[0][1], item[0][3])):
        if fields[0] not in by_field:
            continue
        memory = max(row.peak_memory_MB for row in by_field.values())
        line = [model, element, cells, ranks, by_field[fields[0]].unknowns or "",
                f"{memory:.0f}"]
        for e in fields:
            line += [*effort(by_field.get(e)), outcome(by_field.get(e))]
        lines.append(line)
    return lines


CASE_HEADER = ["model", "element", "cells", "ranks", "unknowns", "MB"]


def document(rows, about):
    """doc/accuracy.md."""
    busy = float(about["load"]) > 0.5
    pump = next((row.reference for row in select(rows, scene="pump")), float("nan"))
    about_pump = "The pump is\nnot in this table yet." if math.isnan(pump) else PUMP.format(pump)
    part = [HEAD.format(**about, pump=about_pump, warning=WARNING if busy else "")]
    part += ["## Cheapest setting\n", "One rank; a mesh counts only if the finer ones of its "
             "family are as good. Selective reduction, the paper's, is no choice: under strong fields it\nis "
             "unstable where the body is not ([elements.md](elements.md)).\n",
             markdown(["error below", *map(percent, TOLERANCES)], recommendations(rows))]
    measured = any(select(rows, program=name) for name in PEER_PROGRAMS)
    part += ["## Against the strongest peer\n",
             PEER_TEXT.format(measured="case by case" if measured else "not measured this time"),
             markdown(PEER_HEADER, peer_lines(rows))]
    part += ["## Requirements\n", markdown(["what", "at most", "measured", ""], bar_lines(rows))]
    part += ["## Order of convergence\n", "Rotation to mid-length at e = 0.5, plane; theory: 2p.\n",
             markdown(["element", "cells", "error", "order", "theory"], order_lines(rows))]
    part += ["## A step in time\n", STEP_TEXT, markdown(
        ["run", "unknowns", "steps", "its", "LU", "s a step"], step_lines(rows))]
    part += ["## Bending actuator, all runs\n", markdown(
        CASE_HEADER + ["its", "LU", "s", "tip, 0.475", "its", "LU", "s", "rotation, 0.87"],
        case_lines(rows, "bending", (0.475, 0.87)))]
    part += ["## Buckling pump, all runs\n", markdown(
        CASE_HEADER + ["its", "LU", "s", "deflection, 0.5"],
        case_lines(rows, "pump", (0.5,)))]
    return "\n".join(part)
