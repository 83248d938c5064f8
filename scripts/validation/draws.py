"""One draw: its scene, its run, its result; and the summary of many."""

import shutil
import time
from dataclasses import dataclass
from statistics import median

import numpy as np

from validation import bent, films, round as rounded, scene

KINDS = {"film": films.case, "bilayer": bent.bilayer, "tube": rounded.tube, "balloon": rounded.balloon,
         "column": bent.column}
SHARES = {"film": 0.4, "bilayer": 0.3, "tube": 0.1, "balloon": 0.08, "column": 0.12}


@dataclass
class Result:
    """What came of a draw; can be sent between processes."""

    number: int
    kind: str
    element: tuple
    story: str
    disagreements: list
    errors: list
    wrong_end: bool
    crashed: bool
    seconds: tuple  # of the independent solution and of the run


def drawn(chosen, number):
    """The case of a number; each has random numbers of its own."""
    rng = np.random.default_rng([chosen.seed, number])
    kind = chosen.kind or str(rng.choice(list(SHARES), p=list(SHARES.values())))
    elements = scene.ELEMENTS + (scene.OF_THE_PAPER if chosen.all_elements else ())
    case = KINDS[kind](rng, elements[rng.integers(len(elements))])
    case.ranks = 2 if rng.random() < 0.12 else 1
    return case


def one(chosen, number, parent):
    """Draws, runs and compares."""
    begin = time.monotonic()
    case, folder = drawn(chosen, number), parent / str(number)
    solved = time.monotonic()
    run = scene.run(case, folder, chosen.program, chosen.mpiexec, chosen.timeout)
    ran = time.monotonic()
    if run.crashed or not run.curve:
        verdict = scene.Verdict([f"no result: {run.told()}"])
    else:
        verdict = case.compare(run)
    if chosen.only is None and chosen.output is None:
        shutil.rmtree(folder)
    return Result(number, case.kind, case.element, f"{case.story}, {case.ranks} rank(s)", verdict.disagreements,
                  [float(error) for error in verdict.errors], verdict.wrong_end,
                  run.crashed or not run.curve, (solved - begin, ran - solved))


def lines(result):
    """What is printed of a result."""
    worst = f"{max(result.errors):.1e}" if result.errors else "-"
    state = "differs" if result.disagreements else "ok"
    first = (f"{result.number:4d} {state:8s} {result.element[0]} {result.element[1]}, {result.story}; largest error "
             f"{worst}, {result.seconds[0]:.1f} + {result.seconds[1]:.1f} s")
    return [first, *(f"       - {sentence}" for sentence in result.disagreements)]


def summary(results):
    """Counts, and the median error of each kind of scene and element."""
    wrong, crashed, all_of_them = (sum(map(bool, values)) for values in (
        (r.wrong_end for r in results), (r.crashed for r in results), (r.disagreements for r in results)))
    said = [f"{len(results)} draws: {all_of_them} disagree, {wrong} wrong endings, {crashed} crashes or timeouts; "
            "median of the largest errors:"]
    groups = {}
    for result in results:
        groups.setdefault((result.kind, *result.element), []).append(result)
    for (kind, formulation, degree), group in sorted(groups.items()):
        errors = [max(result.errors) for result in group if result.errors]
        middle = f"{median(errors):.1e}" if errors else "-"
        bad = sum(bool(result.disagreements) for result in group)
        said.append(f"  {kind:8s} {formulation:17s} {degree}: {middle:>8s}  ({len(group)} draws, {bad} disagree)")
    return said
