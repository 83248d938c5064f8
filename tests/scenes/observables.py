"""Reaction, volume, det F and true field against exact homogeneous states.

    observables.py THELMA_BINARY MPIEXEC SOURCE_DIR RANKS...

Films that are heated, charged and held against expansion: in space in one direction, in the plane
in both. Two observables of one kind in a scene have the numbers that each has alone.
"""

import json
import tempfile
from pathlib import Path

import numpy as np
from scene import program_and_ranks, require, settings, validated
from thelma import planar_exact as exact

TOLERANCE = 1e-8  # relative
MATERIAL = exact.Material(alpha=1.8e-4)
THETA, BREAKDOWN = 333.0, 40.0  # K, kV/mm
OBSERVABLES = "reaction, volume, det_F, breakdown"
COMMON = ["--set", f"Temperature/Value={THETA}",
          "--set", f"Materials/elastomer/Thermal expansion={MATERIAL.alpha}",
          "--set", f"Observables/breakdown/Breakdown field={BREAKDOWN}"]

SPACE = [*COMMON, "--set", f"Output/Observables=lambda_3, {OBSERVABLES}",
         "--set", "Supports/Fixed=x1_min: u1, x1_max: u1, x2_min: u2, bottom: u3",
         "--set", "Observables/reaction/At=x1_max", "--set", "Loading/Target=0.5",
         "--set", "Loading/Expected end=target", "--set", "Expectations/Final values="]
PLANE = [*COMMON, "--set", f"Output/Observables=tip, mid_rotation, end_rotation, {OBSERVABLES}",
         "--set", "Regions/Passive=", "--set", "Loading/Target=0.5",
         "--set", "Electrodes/Potential=interface: 0, outer: 1, back: 1",
         "--set", "Supports/Fixed=x3_min: u3, x3_max: u3, pin: u1",
         "--set", "Observables/reaction/At=x3_max"]


def pressures(stretches, field):
    """P_i lambda_i of the two directions in the film and the one across it, in MPa."""
    m, f, s = MATERIAL, MATERIAL.factor(THETA), MATERIAL.split(THETA)
    a, b, n = stretches
    maxwell = m.eps(THETA) / 2 * a * b / n * field**2 * np.array([-1, -1, 1])
    elastic = m.mu(THETA) * ((s * stretches) ** 2 - 1) + m.K * np.log(s**3 * a * b * n)
    return f * elastic + maxwell


def held_state(free, field):
    """Stretches without force in the directions `free`; the others are one."""
    stretches = np.ones(3, dtype=complex)
    for _ in range(50):
        jacobian = np.zeros((len(free), len(free)))
        for column, direction in enumerate(free):
            nearby = stretches.copy()
            nearby[direction] += 1e-30j
            jacobian[:, column] = pressures(nearby, field)[free].imag / 1e-30
        stretches[free] -= np.linalg.solve(jacobian, pressures(stretches, field)[free].real)
    return stretches.real


def check(name, case, free, thickness, area, force):
    """The last row against the exact state; `force` is the column of the held direction."""
    curve = case.curve("voltage_kV", "volume_ratio", "max_det_F", "min_det_F",
                       "max_true_field_kV_mm", "breakdown_ratio", force)
    last = {column: values[-1] for column, values in curve.items()}
    field = last["voltage_kV"] / thickness
    stretches = held_state(free, field)
    volume, true_field = np.prod(stretches), field / stretches[2]
    expected = {"volume_ratio": volume, "max_det_F": volume, "min_det_F": volume,
                "max_true_field_kV_mm": true_field, "breakdown_ratio": true_field / BREAKDOWN,
                force: area * pressures(stretches, field)[0]}
    for column, value in expected.items():
        error = abs(last[column] / value - 1)
        print(f"{name}: {column} {last[column]:.9g}, relative error {error:.1e}")
        validated("planar_actuator", f"{column}, {name}", "exact, homogeneous", error)
        require(error < TOLERANCE, f"{name}: {column} is {last[column]}, exactly {value}")
    for column in curve:
        if column.startswith("reaction") and column != force:
            require(abs(last[column]) < TOLERANCE, f"{name}: {column} is {last[column]}, not 0")


def check_shared_edges(program, folder):
    """A film pulled along x2: all of the force is borne by the support across it, and nothing by
    one beside it, with which that shares an edge."""
    for name, forces in (("x2_min", [0, -0.02, 0]), ("x1_max", [None, 0, 0])):
        curve = program.run("planar_actuator", folder, *SPACE, *settings(
            {"Loads/Force": "x2_max: 0 0.02 0", "Loading/Stages": "force 1",
             "Observables/reaction/At": name})).curve(*(f"reaction_f{i}_N" for i in (1, 2, 3)))
        for i, force in enumerate(forces, 1):
            found = curve[f"reaction_f{i}_N"][-1]
            require(force is None or abs(found - force) < 1e-10,
                    f"component {i} of the reaction of {name} is {found}, not {force}")
    summary = json.loads((Path(folder) / "run.json").read_text())["modelled"]
    require(not any("reaction_f" in line for line in summary), "x1_max shares nothing")
    program.run("planar_actuator", folder, *SPACE, "--set",
                "Supports/Fixed=x1_max: u1 u3, x2_min: u2, x1_min: u1, bottom: u3")
    summary = json.loads((Path(folder) / "run.json").read_text())["modelled"]
    require(any("reaction_f3_N" in line and "'bottom'" in line for line in summary),
            "an edge that two supports hold is not told of")


def check_free_names(program, folder):
    """Two probes and two reactions in one scene against scenes with one of each."""
    surfaces = {"above": "top", "beside": "x1_max"}
    held = {"Supports/Fixed": "x1_min: u1, x1_max: u1, x2_min: u2, bottom: u3",
            "Loading/Target": "0.5", "Loading/Expected end": "target",
            "Expectations/Final values": ""}
    entries = {**held, "Output/Observables": "lambda_3, " + ", ".join(
        f"{name}_{kind}" for kind in ("probe", "reaction") for name in surfaces)}
    for name, surface in surfaces.items():
        for kind in ("probe", "reaction"):
            entries[f"Observables/{name}_{kind}/Kind"] = kind
            entries[f"Observables/{name}_{kind}/At"] = surface
    both = program.run("planar_actuator", Path(folder) / "both", *settings(entries)).curve()
    for name, surface in surfaces.items():
        alone = program.run("planar_actuator", Path(folder) / name, *settings(
            {**held, "Output/Observables": "lambda_3, probe, reaction",
             "Observables/probe/At": surface, "Observables/reaction/At": surface})).curve()
        columns = ["probe_phi_kV", *(f"reaction_f{i}_N" for i in (1, 2, 3))]
        for column in columns:
            require(np.array_equal(alone[column], both[f"{name}_{column}"]),
                    f"{name}_{column} is {both[f'{name}_{column}']}, alone {alone[column]}")
        require(len(both) == len(alone) + len(columns), f"the curve has the columns {list(both)}")
    for column in ("probe_phi_kV", "reaction_f1_N"):
        require(both[f"above_{column}"][-1] != both[f"beside_{column}"][-1],
                f"{column} is the same at both surfaces")


def main():
    program, all_ranks = program_and_ranks(__doc__)
    with tempfile.TemporaryDirectory() as folder:
        check_shared_edges(program, folder)
        check_free_names(program, folder)
        for ranks in all_ranks:
            case = program.run("planar_actuator", Path(folder), *SPACE, ranks=ranks)
            check(f"space, {ranks} ranks", case, [1, 2], thickness=1.0, area=5.0,
                  force="reaction_f1_N")
            case = program.run("bending_actuator_plane", Path(folder), *PLANE, ranks=ranks)
            check(f"plane, {ranks} ranks", case, [2], thickness=0.5, area=1.0,
                  force="reaction_f3_N")


main()
