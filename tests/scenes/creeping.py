"""The bending actuator that creeps under a voltage: every state against the exact circle, the first and the
last against equilibria, temperatures against each other. A film that pulls in at several temperatures.

    creeping.py THELMA_BINARY MPIEXEC SOURCE_DIR RANKS...
"""

import math
from dataclasses import replace

import numpy as np

from scene import program_and_ranks, require, settings, side_by_side, validated
from thelma import bending_exact
from thelma import creeping_exact
from thelma import viscoelastic_exact

SCENE = "creeping_bending_actuator"
TEMPERATURES = (273.0, 293.0, 313.0, 333.0, 353.0)
LENGTH = 20  # of half of the actuator, in thicknesses of a layer
DEGREES = "mid_rotation_deg"


def run(program, folder, entries, ranks=1):
    """A run and its curve."""
    case = program.run(SCENE, folder / "run", *settings({"Output/Fields": "none", **entries}), ranks=ranks)
    curve = case.curve(DEGREES, "e", "unstable_directions")
    require(max(curve["unstable_directions"]) == 0, "a state is unstable")
    return case, curve


def creep(program, folder, entries, ranks=1):
    """A run in time, and its curve from the sudden state on."""
    case, curve = run(program, folder, entries, ranks)
    sudden = np.flatnonzero(curve["time_s"] == 0)[-1]
    return case, {name: values[sudden:] for name, values in curve.items()}


def exact(case, theta, curve):
    """Rotations of the exact circle in its states, and in equilibrium."""
    material, e = case.material(), curve["e"][-1]
    states = creeping_exact.creep(material, theta, creeping_exact.BRANCHES, e, curve["time_s"])
    equilibrium = bending_exact.circles(material, theta, [e])[0]
    return np.array([state.rotation(LENGTH) for state in states]), equilibrium.rotation(LENGTH)


def mesh(n):
    """The entry that has the cells of the scene halved n times."""
    return {"Mesh/Parameters": f"n1: {2 * 2**n}, n3: {20 * 2**n}"}


def errors(program, folder, theta, entries, ranks=1):
    """Number of steps in time, rotations, and their errors relative to that in equilibrium."""
    case, curve = creep(program, folder, {"Temperature/Value": repr(theta), **entries}, ranks)
    known, equilibrium = exact(case, theta, curve)
    require(abs(known[-1] / equilibrium - 1) < 1e-5, "the exact circle does not end in equilibrium")
    return len(known) - 1, curve[DEGREES], (curve[DEGREES] - known) / equilibrium


def check_history(program, folder, theta, ranks, name="Q2/P1", entries=None):
    """The whole history at a temperature."""
    steps, rotation, error = errors(program, folder, theta, entries or {}, ranks)
    print(f"{theta} K, {name}, {ranks} rank(s): mid-length turns by {rotation[0]:.4f}, after {steps} steps by "
          f"{rotation[-1]:.4f} degrees; errors {error[0]:.1e}, {error[-1]:.1e}, largest {max(abs(error)):.1e}")
    validated(SCENE, f"rotation of mid-length at all times, {theta} K, {name}", "exact circle in time",
              max(abs(error)))
    require(max(abs(error)) < 2e-3, "too far from the exact circle")


def check_limits(program, folder, theta):
    """It begins where a static scene with branches that had no time ends, and rests where one with relaxed
    branches does."""
    entries = {"Temperature/Value": repr(theta)}
    _, curve = creep(program, folder, entries)
    for states, row in (("instantaneous", 0), ("relaxed", -1)):
        rest = run(program, folder / states, {
            **entries, "Stepping/Static states": states, "Time/Analysis": "automatic"})[1][DEGREES][-1]
        error = curve[DEGREES][row] / rest - 1
        print(f"{theta} K, static, {states}: {rest:.6f} degrees, in time {error:.1e} from it")
        validated(SCENE, f"rotation {'at once' if row == 0 else 'at rest'}, {theta} K",
                  f"static scene, {states}", error)
        require(abs(error) < (1e-9 if row == 0 else 1e-5), f"not the {states} state")


def check_mesh(program, folder):
    """The error of both limits falls with the fourth power of the cells' length."""
    both = [errors(program, folder / str(n), 293.0, mesh(n))[2] for n in (0, 1)]
    for row, name in ((0, "at once"), (-1, "at rest")):
        coarse, fine = (abs(error[row]) for error in both)
        order = math.log2(coarse / fine)
        print(f"{name}: errors {coarse:.1e} on 2 x 20, {fine:.1e} on 4 x 40 cells, order {order:.2f}")
        validated(SCENE, f"rotation {name}, 293.0 K, 4 x 40 cells", "exact circle", fine)
        require(order > 3.5, f"order {order}")


def check_tolerance(program, folder):
    """A step's error is of third order: a thousandth of the tolerance takes a hundredth of the error."""
    found = []
    for tolerance in ("1e-3", "1e-4", "1e-5"):
        steps, _, error = errors(program, folder / tolerance, 293.0, {
            **mesh(1), "Time/Strain tolerance": tolerance})
        found.append(max(abs(error)))
        print(f"Strain tolerance {tolerance}: {steps} steps, largest error {found[-1]:.1e}")
        validated(SCENE, f"rotation of mid-length at all times, 293.0 K, 4 x 40 cells, tolerance {tolerance}",
                  "exact circle in time", found[-1])
    require(all(a > 3 * b for a, b in zip(found, found[1:])), "a tenth of the tolerance does not help enough")


def check_superposition(program, folder):
    """Without expansion the same comes to pass at every temperature, faster by the shift, under a voltage
    that pulls in proportion to the entropic stiffness."""
    curves = []
    for theta in (293.0, 353.0):
        shift = creeping_exact.BRANCHES[0].tau(theta) / creeping_exact.BRANCHES[0].tau(293.0)
        _, curve = creep(program, folder / str(theta), {
            "Temperature/Value": repr(theta), "Materials/VHB/Thermal expansion": "0",
            "Loading/Target": repr(4.75 * math.sqrt(theta / 293)), "Time/End": repr(1e4 * shift),
            "Time/Initial step": repr(1e-3 * shift)})
        curves.append((curve["time_s"] / shift, curve[DEGREES]))
    require(len(curves[0][0]) == len(curves[1][0]), "other steps at another temperature")
    error = max(np.max(abs(one - other) / np.max(one)) for one, other in zip(*curves))
    print(f"293 and 353 K, shifted by {shift:.4f}: {error:.1e} between them")
    validated(SCENE, "rotation of mid-length at 353 K", "that at 293 K, shifted in time", error)
    require(error < 1e-6, "temperature does more than to shift")


def check_film(program, folder, rate, theta):
    """Pull-in of a case of prm/studies/pull_in_rate.study."""
    shifts = {f"Materials/VHB/Branch {i}/Shift": "Arrhenius" for i in (1, 2, 3)}
    case = program.run("pull_in_rate", folder / "run", *settings({
        **shifts, "Time/Voltage amplitude": f"{rate}*t", "Time/End": "200", "Temperature/Value": repr(theta)}))
    time = case.curve("time_s")["time_s"][-1]
    vhb = viscoelastic_exact.vhb(K=viscoelastic_exact.STIFF)
    film = replace(vhb, theta=theta, branches=tuple(
        replace(branch, tau=viscoelastic_exact.arrhenius(branch.tau, 50e3, 293.0)) for branch in vhb.branches))
    known = viscoelastic_exact.ramped(film, rate * math.sqrt(viscoelastic_exact.G_VHB), method="LSODA").t
    error = time / known - 1
    print(f"film, {rate} /s, {theta} K: pull-in after {time:.6f} s (exact {known:.6f}), error {error:.1e}")
    validated("pull_in_rate", f"field at pull-in, ramp {rate} /s, {theta} K, Arrhenius", "exact, homogeneous", error)
    require(abs(error) < 5e-4, f"the pull-in is off by {error}")


def main():
    program, all_ranks = program_and_ranks(__doc__)
    enhanced = {"Discretisation/Degree": "1", "Discretisation/Formulation": "enhanced strain",
                "Mesh/Parameters": "n1: 4, n3: 80"}
    side_by_side(program, (check_tolerance,), (check_mesh,),
                 *((check_history, theta, 1) for theta in TEMPERATURES),
                 *((check_history, 293.0, ranks) for ranks in all_ranks if ranks > 1),
                 (check_history, 293.0, 1, "enhanced strain, 4 x 80 cells", enhanced),
                 *((check_limits, theta) for theta in (273.0, 293.0, 353.0)), (check_superposition,),
                 *((check_film, rate, theta) for rate in (0.01, 1) for theta in (273.0, 353.0)))


if __name__ == "__main__":
    main()
