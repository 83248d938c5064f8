"""Heat through surfaces and from sources, amplitudes over time, and how a transient run can end.

Usage: heat_loads.py THELMA_BINARY MPIEXEC SOURCE_DIR RANKS...

The slab is 0.5 mm thick with k = 0.16 N/(s K) and c = 1.92 MPa/K; all answers are linear or
quadratic in space or time.
"""

import json
import tempfile
from pathlib import Path

from scene import program_and_ranks, require, validated

SLAB = "verification/slab_heating"


def run(program, folder, scene, entries, ranks=1, exit_code=0):
    """A run with these entries."""
    options = [word for entry in entries for word in ("--set", entry)]
    return program.run(scene, folder, "--set", "Output/Fields=none", *options, ranks=ranks,
                       exit_code=exit_code)


def check_value(what, found, exact, tolerance):
    print(f"{what}: {found:.9f} K, exactly {exact} K")
    validated("heat loads", f"temperature in K, {what}", "exact, by hand", found - exact)
    require(abs(found - exact) < tolerance, f"{what}: {found} K, not {exact} K")


def check_steady(program, folder, ranks):
    """Bottom at 353 K: k/L (353 - x) = h (x - 293) with h = k/L; q L/k = 1 K; R L^2/(2k) = 0.5 K; a
    source r x3 gives r L^3/(3k) = 1/6 K, which Q2 has at the nodes; a flux of the same mean as
    before the same mean."""
    for what, entries, exact in [
            ("convection", ["Heat/Convection=top: 0.32", "Heat/Surroundings=top: 293"], 323.0),
            ("flux", ["Heat/Flux=top: 0.32"], 354.0),
            ("flux of x1", ["Heat/Flux=top: 0.32 + 2*(x1 - 0.05)"], 354.0),
            ("source", ["Heat/Source=film: 0.64"], 353.5),
            ("source of x3", ["Heat/Source=film: 0.64*x3", "Discretisation/Degree=2"], 353 + 1 / 6)]:
        case = run(program, folder, SLAB, ["Temperature/Model=steady", *entries], ranks)
        check_value(f"{what}, {ranks} rank(s)", case.curve("probe_theta_K")["probe_theta_K"][-1],
                    exact, 1e-9)


def check_transient(program, folder):
    """The mean temperature of an otherwise insulated slab is the integral of what comes in."""
    insulated = ["Temperature/Fixed=", "Time/End=2", "Time/Initial step=0.05", "Time/Tolerance=0",
                 "Heat/Flux=bottom: 0.96"]
    for what, amplitude, exact in [
            ("step", "1", 295.0), ("ramp", "min(t, 1)", 294.5), ("table", "0: 0, 1: 1", 294.5),
            ("pulse", "0: 1, 0.5: 1, 0.5000001: 0", 293.5)]:
        case = run(program, folder, SLAB, [*insulated, f"Time/Heat amplitude={amplitude}"])
        # The ramp's kink and the first step cost the order, not the limit.
        check_value(f"flux as a {what}", case.curve("theta_K")["theta_K"][-1], exact, 0.03)


def check_expressions_in_time(program, folder):
    """The insulated slab under a flux 2 q t and a source of the same power: c L (theta - 293) = 2 q t^2/2
    each, the second times an amplitude of 1/2."""
    for what, entries, exact in [
            ("flux of t", ["Heat/Flux=bottom: 0.96*t"], 295.0),
            ("source of t and x3", ["Heat/Source=film: 15.36*x3*t", "Time/Heat amplitude=0.5"], 295.0)]:
        case = run(program, folder, SLAB, ["Temperature/Fixed=", "Time/End=2", "Time/Initial step=0.05",
                                           "Time/Tolerance=0", *entries])
        # The first step, of first order, is off by its square times a quarter of the rate's rate.
        check_value(what, case.curve("theta_K")["theta_K"][-1], exact, 0.01)


def check_nothing_is_stepped_over(program, folder):
    """In steps that the error chooses, a second of 1 K/s in a hundred is not missed, and a voltage of
    10 Hz has 30 periods in 3 s."""
    case = run(program, folder, SLAB, ["Temperature/Fixed=", "Time/End=100", "Heat/Flux=bottom: 0.96",
                                       "Time/Heat amplitude=(t > 50)*(t < 51)"])
    check_value("pulse as an expression", case.curve("theta_K")["theta_K"][-1], 294, 0.02)
    case = run(program, folder, "planar_actuator",
               ["Temperature/Model=transient", "Loading/Target=0.1", "Loading/Expected end=target",
                "Time/Voltage amplitude=sin(2*pi*10*t)", "Time/End=3",
                "Expectations/Final values="])
    e = case.curve("e")["e"]
    turns = sum(a < 0 <= b for a, b in zip(e, e[1:]))
    print(f"10 Hz for 3 s: {len(e)} steps, {turns} turns from below to above 0, up to {max(e)}")
    require(turns in (29, 30) and max(e) > 0.099, "periods are stepped over")


def check_wall_amplitude(program, folder):
    """A wall follows its table: half-way from 293 to 353 K after 1 s."""
    case = run(program, folder, SLAB, ["Time/Wall amplitude=0: 0, 2: 1", "Time/End=1"])
    check_value("wall", case.curve("theta_max_K")["theta_max_K"][-1], 323.0, 1e-9)


def check_no_conduction(program, folder):
    """With k = 0 every point keeps what its source gives, R t/c, and a wall that jumps to 353 K stays
    alone; with expansion the body moves."""
    for formulation, degree in (("enhanced strain", 1), ("mean dilatation", 2)):
        for coupling in ("staggered", "monolithic"):
            case = run(program, folder, SLAB, [
                "Materials/elastomer/Conductivity=0", "Heat/Source=film: 0.64", "Time/End=1",
                "Materials/elastomer/Thermal expansion=1.8e-4", "Time/Initial step=0.25",
                "Time/Tolerance=0", "Mesh/Parameters=L1: 0.1, L2: 0.1, L3: 0.5, n1: 1, n2: 1, n3: 4",
                f"Discretisation/Formulation={formulation}", f"Discretisation/Degree={degree}",
                f"Time/Coupling={coupling}"])
            curve = case.curve("probe_theta_K", "theta_max_K")
            what = f"no conduction, {formulation}, {coupling}"
            check_value(what, curve["probe_theta_K"][-1], 293 + 0.64 / 1.92, 1e-8)
            check_value(f"{what}, wall", curve["theta_max_K"][-1], 353, 1e-9)


def check_pull_in(program, folder):
    """A voltage that rises in time past the limit of the film, e = 0.68737, pulls it in; where that
    was not expected, the exit code is 3."""
    for coupling, expected, code in (("staggered", "pull-in", 0), ("monolithic", "target", 3)):
        case = run(program, folder, "planar_actuator",
                   ["Temperature/Model=transient", "Time/Voltage amplitude=t",
                    "Time/Initial step=0.05", "Time/Largest step=0.05",
                    f"Time/Coupling={coupling}", "Loading/Expected end=" + expected,
                    "Expectations/Final values="], exit_code=code)
        curve = case.curve("time_s", "e")
        reason = json.loads((folder / "run.json").read_text())["reason"]
        print(f"{coupling}: stopped at e = {curve['e'][-1]:.6f}; {reason}")
        require(abs(curve["e"][-1] - 0.687366) < 1e-6, "this is not where the film pulls in")
        require("pull-in between t" in reason, "the reason does not say so")


def main():
    program, all_ranks = program_and_ranks(__doc__)
    with tempfile.TemporaryDirectory() as name:
        folder = Path(name)
        for ranks in all_ranks:
            check_steady(program, folder, ranks)
        check_transient(program, folder)
        check_expressions_in_time(program, folder)
        check_nothing_is_stepped_over(program, folder)
        check_wall_amplitude(program, folder)
        check_no_conduction(program, folder)
        check_pull_in(program, folder)


main()
