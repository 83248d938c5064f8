"""A slab with both faces stepped from 293 to 353 K against its Fourier series, and small time steps.

Usage: slab_heating.py THELMA_BINARY MPIEXEC SOURCE_DIR RANKS...
"""

import math
import tempfile
from pathlib import Path

from scene import program_and_ranks, require, validated
from slab_exact import DIFFUSION_TIME, START, WALL, mid_temperature


def run(program, folder, entries, ranks=1):
    """The curve of a run with steps of equal length, and with these entries."""
    options = [word for entry in entries for word in ("--set", entry)]
    case = program.run("verification/slab_heating", folder, "--set", "Time/Tolerance=0",
                       "--set", "Output/Fields=none", *options, ranks=ranks)
    return case.curve("time_s", "probe_theta_K", "theta_min_K", "theta_max_K")


def check_order(program, folder, scheme, order):
    """Halving dt halves the error, or quarters it."""
    errors = []
    for n in (20, 40, 80):
        curve = run(program, folder, [
            "Discretisation/Degree=2", f"Time/Scheme={scheme}", f"Time/Initial step={1.2 / n}"])
        errors.append(abs(curve["probe_theta_K"][-1] - mid_temperature(1.2)))
    orders = [math.log2(a / b) for a, b in zip(errors, errors[1:])]
    print(f"{scheme}: errors at 1.2 s in K {' '.join(f'{e:.2e}' for e in errors)} with steps of 1/20, "
          f"1/40, 1/80, orders {' '.join(f'{o:.2f}' for o in orders)}")
    validated("slab_heating", f"temperature of mid-thickness in K after 1.2 s, {scheme}, 80 steps",
              "Fourier series", errors[-1])
    require(min(orders) > order - 0.1, f"{scheme}: order {min(orders):.2f} is not {order}")


def check_adaptive_steps(program, folder):
    """The error over all steps falls with the tolerance of one, by its power 2/3 for a scheme of
    second order."""
    errors = []
    for tolerance in (0.01, 0.001):
        case = program.run("verification/slab_heating", folder, "--set", "Discretisation/Degree=2",
                           "--set", f"Time/Tolerance={tolerance}")
        curve = case.curve("time_s", "probe_theta_K")
        errors.append(max(abs(theta - mid_temperature(t)) for t, theta in
                          zip(curve["time_s"], curve["probe_theta_K"]) if t > 0))
        print(f"adapted steps, {tolerance} K per step: {len(curve['time_s'])} steps, largest error "
              f"{errors[-1]:.3f} K")
    require(errors[1] < errors[0] / 3, "the error does not fall with the tolerance")


def check_first_step(program, folder):
    """However long the first step to try, that which is taken keeps the tolerance: 60 K arrive at
    the wall at once."""
    first = []
    for initial in (1.2, 1e-6):
        case = program.run("verification/slab_heating", folder, "--set",
                           f"Time/Initial step={initial}")
        curve = case.curve("time_s", "probe_theta_K")
        error = max(abs(theta - mid_temperature(t)) for t, theta in
                    zip(curve["time_s"], curve["probe_theta_K"]) if t > 0)
        first.append(curve["time_s"][1])
        print(f"first step to try {initial:g} s: taken {first[-1]:.1e} s, {len(curve['time_s'])} "
              f"rows, largest error {error:.3f} K")
        require(error < 0.05, f"begun with {initial} s, the temperature is {error:.3f} K off")
    require(first[0] < 1e-3, f"{first[0]} s are too long for a first step")


def check_small_steps(program, folder, name, entries, bound, ranks):
    """Steps of 1e-4 of the diffusion time keep every node between the extreme temperatures."""
    step = 1e-4 * DIFFUSION_TIME
    curve = run(program, folder, [*entries, f"Time/Initial step={step}", f"Time/End={20 * step}"],
                ranks)
    below = START - min(curve["theta_min_K"])
    above = max(curve["theta_max_K"]) - WALL
    print(f"steps of 1e-4 diffusion times, {name}: {below:.1e} K below, {above:.1e} K above")
    require(max(below, above) <= bound, f"{name}: leaves the range by {max(below, above):.1e} K")


def main():
    program, all_ranks = program_and_ranks(__doc__)
    with tempfile.TemporaryDirectory() as name:
        folder = Path(name)
        check_order(program, folder, "backward Euler", 1)
        check_order(program, folder, "BDF2", 2)
        check_adaptive_steps(program, folder)
        check_first_step(program, folder)
        cube = "Mesh/Parameters=L1: 0.5, L2: 0.5, L3: 0.5, n1: 6, n2: 6, n3: 6"
        for ranks in all_ranks:
            for scheme in ("backward Euler", "BDF2"):
                check_small_steps(program, folder, f"slab, Q1, {scheme}, {ranks} rank(s)",
                                  [f"Time/Scheme={scheme}"], 1e-9, ranks)
        check_small_steps(program, folder, "cube heated at two faces, Q1",
                          [cube, "Temperature/Fixed=bottom: 353, x1_max: 353"], 1e-9, 1)
        check_small_steps(program, folder, "slab, Q2",
                          ["Discretisation/Degree=2"], 0.015 * (WALL - START), 1)


main()
