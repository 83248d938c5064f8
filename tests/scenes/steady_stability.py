"""Where a strip between rigid walls leaves its straight state at a steady temperature, one or two of
its faces: by its incremental equations, in which the temperature answers (strip_stability.py).

    steady_stability.py THELMA_BINARY MPIEXEC SOURCE_DIR RANKS...

And that runs which cannot count unstable directions do not take entries that need the count.
"""

import subprocess

from scene import program_and_ranks, require, settings, side_by_side, validated
from thelma import planar_exact
import strip_stability

LENGTH, VALUE = 10, 293  # mm, K at which e is defined
STRIP = {"Regions/Passive": "", "Loads/Force": "", "Loading/Stages": "voltage 1",
         "Electrodes/Potential": "outer: 0, back: 1", "Supports/Fixed":
         "x3_min: u3, x3_max: u3, pin: u1", "Temperature/Model": "steady", "Temperature/Value":
         f"{VALUE}", "Stepping/Largest step": "0.2", "Stepping/Initial step": "0.1",
         "Output/Fields": "none"}


def strip(temperatures, alpha, target, cells, **more):
    """Entries of the strip between two temperatures."""
    return settings({**STRIP, "Loading/Target": f"{target}",
                     "Mesh/Parameters": f"L: {LENGTH}, H: 1, n1: {cells[0]}, n3: {cells[1]}",
                     "Materials/elastomer/Thermal expansion": f"{alpha}",
                     "Temperature/Fixed": f"outer: {temperatures[0]}, back: {temperatures[1]}",
                     **more})


def check_bifurcations(program, folder, ranks):
    """Both of the strip of one temperature, on the straight path; then it is twice unstable."""
    case = program.run("verification/column", folder, *strip(
        (303, 303), 1e-5, 0.38, (2, 20), **{"Stepping/Branch": "none"}), ranks=ranks)
    curve = case.curve("e", "event", "unstable_directions")
    found = [e for e, event in zip(curve["e"], curve["event"]) if event == "bifurcation"]
    require(len(found) == 2 and curve["unstable_directions"][-1] == 2, f"bifurcations at {found}")
    for waves, e in enumerate(found, 1):
        exact = strip_stability.bifurcation(planar_exact.Material(alpha=1e-5), LENGTH, 1, (303, 303),
                                            e, VALUE, waves)
        print(f"{ranks} rank(s), 303 K: the strip branches at e = {e:.7f}, exactly {exact:.7f}")
        validated("column", f"bifurcation {waves} of a strip at a steady 303 K",
                  "incremental equations", e / exact - 1)
        require(abs(e / exact - 1) < 3e-4, "not the exact field")


def check_response(program, folder):
    """The answer of the temperature moves the bifurcation; the run finds the one with it, from
    there the bent strip, which is stable."""
    material, walls = planar_exact.Material(alpha=1.8e-4), (293, 333)
    curve = program.run("verification/column", folder, *strip(walls, 1.8e-4, 0.12, (4, 40))).curve(
        "e", "event", "unstable_directions")
    e = curve["e"][list(curve["event"]).index("bifurcation")]
    exact, frozen = (strip_stability.bifurcation(material, LENGTH, 1, walls, e, VALUE,
                                                 responds=responds) for responds in (True, False))
    print(f"{walls[0]} and {walls[1]} K: the strip branches at e = {e:.7f}, exactly {exact:.7f}, at a "
          f"temperature that does not answer {frozen:.7f}")
    validated("column", f"bifurcation of a strip between {walls[0]} and {walls[1]} K",
              "incremental equations", e / exact - 1)
    require(abs(e - exact) < 0.2 * abs(frozen - exact), "the answer of the temperature is not in it")
    require(not curve["unstable_directions"][-1], "the bent strip is unstable")


def check_rejection(program, folder):
    """Without continuation the run ends where the strip is no longer stable."""
    case = program.run("verification/column", folder, exit_code=3, *strip(
        (303, 303), 1e-5, 0.3, (2, 20), **{"Stepping/Branch": "none", "Stepping/Continuation": "load"}))
    e = case.curve("e")["e"][-1]
    exact = strip_stability.bifurcation(planar_exact.Material(alpha=1e-5), LENGTH, 1, (303, 303),
                                        0.164972, VALUE)
    require(0 < exact - e < 2e-3, f"the last stable state is at e = {e}, exactly {exact}")


def check_refusals(program, folder):
    """Entries that need a count of unstable directions, with a solver that does not factorise."""
    for entries in ({"Stepping/Continuation": "automatic"}, {"Stepping/Unstable states": "reject"},
                    {"Stepping/Continuation": "automatic", "Stepping/Branch": "plus"},
                    {"Stepping/Unstable states": "reject", "Temperature/Model": "steady",
                     "Temperature/Fixed": "bottom: 303"}):
        command = program.command(["prm/planar_actuator.prm", *settings(
            {"Linear solver/Solver": "block", "Discretisation/Formulation": "mean dilatation",
             **entries}), "--output", str(folder)], 1)
        done = subprocess.run(command, cwd=program.source, capture_output=True, text=True, check=False)
        require(done.returncode == 1 and "'block'" in done.stderr and "choose direct" in done.stderr,
                f"{entries}: {done.returncode} {done.stderr}")


def main():
    """On every number of ranks."""
    program, all_ranks = program_and_ranks(__doc__)
    side_by_side(program, *((check_bifurcations, ranks) for ranks in all_ranks), (check_response,),
                 (check_rejection,), (check_refusals,))


main()
