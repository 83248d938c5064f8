"""The inflated balloon against its radial boundary value problem (python/thelma/balloon_exact.py).

    balloon.py THELMA_BINARY MPIEXEC SOURCE_DIR RANKS...
"""

import itertools
import math

from scipy.optimize import brentq

from scene import program_and_ranks, require, settings, side_by_side, validated
from thelma import balloon_exact

PRESSURE, TARGET = 0.004, 15.0  # MPa, kV of prm/balloon.prm
COLUMNS = ("load", "event", "voltage_kV", "tip_u1_mm", "centre_u1_mm", "enclosed_volume_mm3",
           "unstable_directions")


def errors(curve, row):
    """Relative errors of the inner radius, the outer one and the enclosed volume."""
    pressure = PRESSURE * min(curve["load"][row], 1)
    exact = balloon_exact.Balloon().at_pressure(pressure, curve["voltage_kV"][row], 9.99, 13.3)
    return ((10 + curve["tip_u1_mm"][row]) / exact.inner - 1,
            (11 + curve["centre_u1_mm"][row]) / exact.outer - 1,
            curve["enclosed_volume_mm3"][row] / (exact.volume / 8) - 1)


def check_states(program, folder, ranks):
    """Radii and volume after both stages, on two meshes."""
    found = []
    for n in (2, 4) if ranks == 1 else (2,):
        case = program.run("balloon", folder, "--set", f"Mesh/Parameters=R: 10, H: 1, n: {n}, nr: 1",
                           ranks=ranks)
        curve = case.curve(*COLUMNS)
        inflated, driven = errors(curve, list(curve["load"]).index(1)), errors(curve, -1)
        found.append([max(map(abs, inflated)), max(map(abs, driven))])
        print(f"{ranks} rank(s), 3 x {n} x {n} cells: radii and volume are {inflated[0]:.1e}, "
              f"{inflated[1]:.1e}, {inflated[2]:.1e} off at 4 kPa, {driven[0]:.1e}, {driven[1]:.1e}, "
              f"{driven[2]:.1e} with 15 kV")
        for state, off in (("4 kPa", inflated), ("4 kPa and 15 kV", driven)):
            for quantity, error in (("radii", max(map(abs, off[:2]))),
                                    ("enclosed volume", off[2])):
                validated("balloon", f"{quantity} at {state}, 3 x {n} x {n} cells",
                          "radial boundary value problem", error)
        require(not any(curve["unstable_directions"]), "a stable balloon is called unstable")
    require(max(found[0]) < 2e-4, f"12 cells are off by {max(found[0])}")
    for coarse, fine in zip(found[0], found[-1]) if ranks == 1 else ():
        require(math.log2(coarse / fine) > 3.5, f"from {coarse} to {fine}: no convergence")


def check_maximum(program, folder, ranks):
    """Along the arc length through the largest pressure: of a neo-Hookean wall the only one, of
    Gent's with J_m = 20 followed by a smallest."""
    for law, J_m, until in (("neo-Hookean", math.inf, 2000), ("Gent", 20.0, 5000)):
        sets = {"Loads/Pressure": "inner: 10 kPa", "Loading/Stages": "pressure 1",
                "Loading/Until": f"enclosed_volume_mm3: {until}",
                "Stepping/Continuation": "automatic", "Regions/Passive": "wall",
                "Electrodes/Potential": "", "Materials/elastomer/Elastic law": law,
                "Expectations/Final values": "", "Output/Observables": "tip, centre, enclosed_volume"}
        if law == "Gent":
            sets["Materials/elastomer/Gent limit"] = f"{J_m}"
        curve = program.run("balloon", folder, *settings(sets), ranks=ranks).curve(*COLUMNS)
        balloon = balloon_exact.Balloon(J_m=J_m)
        worst = 0.0
        for load, tip in list(zip(curve["load"], curve["tip_u1_mm"]))[1::ranks * ranks]:
            worst = max(worst, abs(0.01 * load / balloon.at_radius(10 + tip).pressure - 1))
        rows = [row for row, event in enumerate(curve["event"]) if event == "limit point"]
        exact = [balloon.limit_point(0, 12, 17)]
        if law == "Gent":
            exact.append(balloon.limit_point(0, 15, 24, -1))
        off = [0.01 * curve["load"][row] / state.pressure - 1 for row, state in zip(rows, exact)]
        print(f"{ranks} rank(s), {law}: {len(curve['load'])} states, largest error of the pressure "
              f"{worst:.1e}; limit points at {[round(1e3 * state.pressure, 5) for state in exact]} kPa, "
              f"off by {[f'{error:.1e}' for error in off]}")
        for name, error in zip(("largest", "smallest"), off):
            validated("balloon", f"{name} pressure, {law}", "radial boundary value problem", error)
        validated("balloon", f"pressure of every state on both branches, {law}",
                  "radial boundary value problem", worst)
        require(len(rows) == len(exact), f"{len(rows)} limit points")
        require(max(map(abs, off)) < 1e-4 and worst < 5e-4, "not the exact pressure")


def check_pull_in(program, folder):
    """The voltage at which the largest pressure that the balloon bears is the one in it."""
    sets = {"Loading/Target": "17 kV", "Loading/Expected end": "pull-in",
            "Expectations/Final values": ""}
    case = program.run("balloon", folder, *settings(sets))
    balloon = balloon_exact.Balloon()
    exact = brentq(lambda V: balloon.limit_point(V, 10.5, 18).pressure - PRESSURE, 16, 16.3,
                   xtol=1e-6)
    last = case.curve("voltage_kV", "e")
    per_e = last["voltage_kV"][-1] / last["e"][-1]
    below, above = (e * per_e for e in case.pull_in())
    print(f"pull-in at 4 kPa between {below:.4f} and {above:.4f} kV, exactly {exact:.4f}")
    validated("balloon", "pull-in voltage at 4 kPa, middle of the bracket",
              "radial boundary value problem", (below + above) / 2 / exact - 1)
    require(below < exact < above, "the pull-in is not in its bracket")


def check_ledger(program, folder):
    """The inflated balloon while it is warmed from outside: the pressure does p dV, and no energy is
    missing, to the second order of BDF2."""
    missing = []
    for steps in (40, 80):
        sets = {"Loading/Stages": "pressure 1", "Electrodes/Potential": "", "Regions/Passive": "wall",
                "Temperature/Model": "transient", "Temperature/Fixed": "outer: 313",
                "Materials/elastomer/Thermal expansion": "1.8e-4", "Discretisation/Degree": "1",
                "Time/End": "4", "Time/Initial step": f"{4 / steps}", "Time/Tolerance": "0",
                "Time/Structural heat": "entropy", "Time/Wall amplitude": "sin(pi*t/8)^2",
                "Output/Observables": "tip, centre, enclosed_volume, ledger",
                "Expectations/Final values": "", "Output/Fields": "none"}
        curve = program.run("balloon", folder, *settings(sets)).curve(
            "time_s", "enclosed_volume_mm3", "ledger_energy_missing_mJ", "ledger_load_work_mJ")
        missing.append(abs(curve["ledger_energy_missing_mJ"][-1]))
        start = list(curve["time_s"] > 0).index(True) - 1
        volumes = curve["enclosed_volume_mm3"]
        work = PRESSURE * (volumes[-1] - volumes[start])
        off = curve["ledger_load_work_mJ"][-1] / work - 1
    order = math.log2(missing[0] / missing[1])
    print(f"the pressure does {work:.5f} mJ, the ledger says {off:.1e} more; missing "
          f"{missing[0]:.3f}, {missing[1]:.3f} mJ, order {order:.2f}")
    validated("balloon", "work of the pressure in the ledger", "p dV", off)
    require(abs(off) < 1e-6 and order > 1.8, "the ledger does not add up")


def main():
    program, all_ranks = program_and_ranks(__doc__)
    side_by_side(program, *itertools.product((check_maximum, check_states), all_ranks),
                 (check_ledger,), (check_pull_in,))


main()
