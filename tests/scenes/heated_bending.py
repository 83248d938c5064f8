"""The heated bending actuator: its ledger of energy and entropy, and the circle it ends as.

Usage: heated_bending.py THELMA_BINARY MPIEXEC SOURCE_DIR RANKS...
"""

import math
import subprocess

from bending_reference import exact_mid_rotation
from scene import program_and_ranks, require, side_by_side, validated
import accuracy_steps

MISSING = ["ledger_energy_missing_mJ", "ledger_entropy_missing_mJ_per_K"]
STOCK = ["ledger_heat_mJ", "ledger_entropy_mJ_per_K"]


def check_end(program, folder, ranks):
    """Warm throughout it stands at e = 0.75, 353 K. Its path does not depend on the ranks."""
    turns = []
    for n in ranks:
        case = program.run("heated_bending", folder, "--set", "Output/Fields=none", ranks=n)
        curve = case.curve("time_s", "mid_rotation_deg", "unstable_directions", *MISSING, *STOCK)
        turns.append(curve["mid_rotation_deg"])
        require(max(curve["unstable_directions"]) == 0, "a state is unstable")
    exact = exact_mid_rotation(program.source, 1.8e-4, 353.0, 0.75)
    error = turns[0][-1] / exact - 1
    print(f"after 40 s mid-length turns {turns[0][-1]:.3f} degrees, exactly {exact:.3f}, "
          f"relative error {error:.1e}")
    validated("heated_bending", "rotation of mid-length after 40 s", "exact circle at 353 K", error)
    require(abs(error) < 1e-3, f"error {error:.1e}")
    difference = max(abs(turn[-1] - turns[0][-1]) for turn in turns)
    require(difference < 1e-6 and len({len(turn) for turn in turns}) == 1,
            f"{difference:.1e} degrees between numbers of ranks")
    capacity = curve[MISSING[0]][-1] / curve[STOCK[0]][-1]
    print(f"the paper's H with a constant capacity misses {100 * capacity:.2f} % of the heat")
    require(abs(capacity) < 0.01, "more than the 1 % by which the capacity is wrong")


def missing(program, folder, coupling, scheme, steps):
    """What the laws of energy and entropy miss after 4 s, as parts of what came in."""
    case = program.run(
        "heated_bending", folder, "--set", "Mesh/Parameters=n1: 4, n3: 10",
        "--set", "Output/Fields=none", "--set", "Time/Structural heat=entropy",
        "--set", "Time/Wall amplitude=sin(pi*t/8)^2", "--set", "Time/Tolerance=0",
        "--set", "Time/End=4", "--set", f"Time/Initial step={4 / steps}",
        "--set", f"Time/Scheme={scheme}", "--set", f"Time/Coupling={coupling}")
    curve = case.curve(*MISSING, *STOCK)
    return [abs(curve[m][-1] / (curve[s][-1] - curve[s][0])) for m, s in zip(MISSING, STOCK)]


def check_balance(program, folder):
    """Both laws are closed to the order of the differences."""
    for coupling in ("monolithic", "staggered"):
        for scheme, order in (("backward Euler", 1), ("BDF2", 2)):
            errors = [missing(program, folder, coupling, scheme, n) for n in (40, 80, 160)]
            for name, values in zip(("energy", "entropy"), zip(*errors)):
                orders = [math.log2(a / b) for a, b in zip(values, values[1:])]
                print(f"{coupling}, {scheme}: {name} missing {' '.join(f'{v:.1e}' for v in values)} "
                      f"of what came in with 40, 80, 160 steps, orders "
                      f"{' '.join(f'{o:.2f}' for o in orders)}")
                require(min(orders) > order - 0.2, f"order {min(orders):.2f} is not {order}")


def check_jump(program, folder):
    """Two cells across the actuator, one of them hot at once: in one go too much for Newton's
    method, however short the time step."""
    for coupling in ("monolithic", "staggered"):
        turns = []
        for initial in (1e-6, 1e-3, 0.02):
            case = program.run(
                "heated_bending", folder, "--set", "Mesh/Parameters=L: 20, H: 1, n1: 2, n3: 8",
                "--set", "Output/Fields=none", "--set", f"Time/Initial step={initial}",
                "--set", "Time/End=0.3", "--set", f"Time/Coupling={coupling}")
            turns.append(case.curve("mid_rotation_deg")["mid_rotation_deg"][-1])
        difference = max(turns) - min(turns)
        print(f"{coupling}, coarse: begun with 1e-6, 1e-3 and 0.02 s, mid-length turns "
              f"{turns[0]:.2f} degrees after 0.3 s, {difference:.1e} between them")
        require(difference < 0.05, f"{difference:.1e} degrees for another first step")


def check_cost(program, folder):
    """A step in time on the paper's mesh against one of the isothermal curve. Seconds are printed,
    factorisations of displacement and potential checked, since those of the temperature are small
    (one a step)."""
    rows = []
    for name in accuracy_steps.SETTINGS:
        command = program.command(accuracy_steps.arguments(name, folder), 1)
        subprocess.run(command, cwd=program.source, stdout=subprocess.DEVNULL, check=True)
        rows.append(accuracy_steps.measured(name, folder))
    still, moving = (row.factorisations / row.steps for row in rows)
    print(f"paper's mesh: {rows[1].steps} steps in time of {rows[1].value:.4f} s against "
          f"{rows[0].steps} isothermal ones of {rows[0].value:.4f} s, ratio "
          f"{accuracy_steps.ratio(rows):.2f}; factorisations a step {moving - 1:.2f} and {still:.2f}")
    require(moving - 1 < accuracy_steps.MOST * still, "a step in time takes too many factorisations")


def main():
    program, ranks = program_and_ranks(__doc__)
    side_by_side(program, (check_balance,), (check_end, ranks), (check_jump,))
    side_by_side(program, (check_cost,))  # its seconds are of a run alone


main()
