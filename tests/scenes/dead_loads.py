"""Dead loads: homogeneous states under a weight and a voltage, and the buckling of a column.

    dead_loads.py THELMA_BINARY MPIEXEC SOURCE_DIR RANKS...
"""

import math
import tempfile
from pathlib import Path

from scipy.optimize import fsolve

from scene import largest_error, program_and_ranks, require, settings, validated
from thelma import planar_exact

AREA = 5.0  # mm^2 of the film's loaded face


def stretches(material, stress, field):
    """lambda_1, lambda_2, lambda_3 under a nominal stress (MPa) along x1 and a nominal field
    (kV/mm), which make

        W + K/2 x^2 - eps/2 E^2 lambda_1 lambda_2/lambda_3 - stress lambda_1,  x = ln J,

    stationary."""
    mu, K, eps = material.mu(293), material.K, material.eps(293)

    def forces(stretch):
        l_1, l_2, l_3 = stretch
        pressure = K * math.log(l_1 * l_2 * l_3) - mu
        maxwell = eps / 2 * field**2 * l_1 * l_2 / l_3
        return ((mu * l_1**2 + pressure - maxwell - stress * l_1) / mu,
                (mu * l_2**2 + pressure - maxwell) / mu, (mu * l_3**2 + pressure + maxwell) / mu)

    return fsolve(forces, (1.5, 0.8, 0.8), xtol=1e-13)


def check_film(program, folder, ranks):
    """Every row, first of the force, then of the voltage."""
    curve = program.run("verification/dead_load", folder, ranks=ranks).curve(
        "load", "e", "lambda_1", "lambda_3")
    material = planar_exact.Material()

    def exact(row):
        return stretches(material, 0.4 * min(row["load"], 1) / AREA,
                         material.field(row["e"], 293))[::2]

    worst = largest_error(curve, ("lambda_1", "lambda_3"), exact)
    print(f"{ranks} rank(s): {len(curve['e'])} states of the film under weight and voltage up to "
          f"lambda_1 = {curve['lambda_1'][-1]:.5f}, largest error {worst:.1e}")
    validated("dead_load", "lambda_1, lambda_3 of every state", "exact, homogeneous", worst)
    require(worst < 1e-8, f"a stretch is off by {worst}")


def check_film_in_time(program, folder, ranks):
    """Weight and voltage follow their amplitudes through time, without a temperature field."""
    def force(t):
        return 1 + 0.5 * math.sin(3 * t)

    entries = {"Time/Analysis": "transient", "Time/End": "2", "Time/Initial step": "0.1",
               "Time/Largest step": "0.2", "Time/Force amplitude": "1 + 0.5*sin(3*t)",
               "Time/Voltage amplitude": "0: 0.5, 1: 1, 2: 0.2"}
    curve = program.run("verification/dead_load", folder, *settings(entries), ranks=ranks).curve(
        "load", "time_s", "e", "lambda_1", "lambda_3")
    material = planar_exact.Material()

    def exact(row):
        level = force(row["time_s"]) if row["time_s"] > 0 else min(row["load"], 1)
        return stretches(material, 0.4 * level / AREA, material.field(row["e"], 293))[::2]

    worst = largest_error(curve, ("lambda_1", "lambda_3"), exact)
    voltages = [0.3 * (0.5 + 0.5 * t if t < 1 else 1 - 0.8 * (t - 1)) for t in curve["time_s"]]
    off = max(abs(e - v) for t, e, v in zip(curve["time_s"], curve["e"], voltages) if t > 0)
    print(f"{ranks} rank(s): {sum(t > 0 for t in curve['time_s'])} states of the film in time, "
          f"largest error {worst:.1e}, of e {off:.1e}")
    validated("dead_load in time", "lambda_1, lambda_3 of every state", "exact, homogeneous", worst)
    require(worst < 1e-8 and off < 1e-12 and curve["time_s"][-1] == 2, "wrong states in time")


def check_column(program, folder, ranks):
    """Euler's load of the clamped column, 4 mu for its modulus in plane strain."""
    case = program.run("verification/column", folder, ranks=ranks)
    curve = case.curve("load", "event", "tip_u1_mm", "unstable_directions")
    row = list(curve["event"]).index("bifurcation")
    found = 0.0002 * curve["load"][row]
    euler = math.pi**2 * 4 * planar_exact.Material().mu(293) / 12 / (4 * 20**2)
    print(f"{ranks} rank(s): the column buckles under {found:.6e} N/mm, Euler's load "
          f"{euler:.6e}, and bends by {curve['tip_u1_mm'][-1]:.3f} mm")
    validated("column", "buckling force", "Euler, slender limit", found / euler - 1)
    # Compressed before it buckles, and sheared: off by the square of its slenderness.
    require(abs(found / euler - 1) < 1 / 20**2 * 4, "not Euler's load")
    require(abs(curve["tip_u1_mm"][-1]) > 1 and not curve["unstable_directions"][-1],
            "the column is not bent")


def check_ledger(program, folder):
    """Energy of the loaded film while it is warmed: the work of the weight closes the balance, to
    the second order of BDF2."""
    missing = []
    for steps in (40, 80, 160):
        entries = {"Loading/Stages": "force 1", "Electrodes/Potential": "",
                   "Regions/Passive": "film", "Temperature/Model": "transient",
                   "Temperature/Fixed": "bottom: 353", "Temperature/Value": "293",
                   "Materials/elastomer/Thermal expansion": "1.8e-4", "Time/End": "4",
                   "Time/Initial step": str(4 / steps), "Time/Tolerance": "0",
                   "Time/Structural heat": "entropy", "Time/Wall amplitude": "sin(pi*t/8)^2",
                   "Output/Observables": "lambda_1, lambda_3, ledger", "Output/Fields": "none"}
        curve = program.run("verification/dead_load", folder, *settings(entries)).curve(
            "ledger_energy_missing_mJ", "ledger_load_work_mJ")
        missing.append(abs(curve["ledger_energy_missing_mJ"][-1]))
        work = curve["ledger_load_work_mJ"][-1]
    orders = [math.log2(a / b) for a, b in zip(missing, missing[1:])]
    print(f"the weight does {work:.4f} mJ; missing {' '.join(f'{m:.3f}' for m in missing)} mJ, orders "
          f"{' '.join(f'{order:.2f}' for order in orders)}")
    require(min(orders) > 1.8 and missing[-1] < 0.1 * work, "energy is missing")


def check_couplings(program, folder):
    """The weight stays on the film while it is warmed, however the equations are solved."""
    stretches = []
    for coupling in ("staggered", "monolithic"):
        entries = {"Loading/Stages": "force 1", "Electrodes/Potential": "",
                   "Regions/Passive": "film", "Temperature/Model": "transient",
                   "Temperature/Fixed": "bottom: 353", "Time/End": "0.2", "Time/Initial step": "0.01",
                   "Time/Tolerance": "0", "Time/Coupling": coupling, "Output/Fields": "none"}
        curve = program.run("verification/dead_load", folder, *settings(entries)).curve("lambda_1")
        stretches.append(curve["lambda_1"][-1])
    print(f"warmed for 0.2 s: lambda_1 = {stretches[0]:.6f} staggered, {stretches[1]:.6f} monolithic")
    require(abs(stretches[1] / stretches[0] - 1) < 1e-3, "the couplings differ")


def main():
    program, all_ranks = program_and_ranks(__doc__)
    for ranks in all_ranks:
        with tempfile.TemporaryDirectory() as folder:
            check_film(program, Path(folder) / "film", ranks)
            check_film_in_time(program, Path(folder) / "time", ranks)
            check_column(program, Path(folder) / "column", ranks)
    with tempfile.TemporaryDirectory() as folder:
        check_ledger(program, folder)
        check_couplings(program, folder)


main()
