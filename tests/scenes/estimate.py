"""The errors that --estimate claims against the true ones: never too small, at most five times too
large, of the mesh and of the time steps.

Usage: estimate.py THELMA_BINARY MPIEXEC SOURCE_DIR RANKS...

Truth: exact solutions alone, the circle, the tube, the balloon, the film with half an electrode, the
slab's series, its thermal wave and the homogeneous film.
"""

import cmath
import csv
import math
import os

from bending_reference import exact_mid_rotation
from scene import program_and_ranks, require, settings, side_by_side
from slab_exact import CAPACITY, CONDUCTIVITY, mid_temperature
from thelma import balloon_exact
from thelma import planar_exact

MOST = 5.0  # estimates over one error
ROUNDING = 1e-8  # relative; below, errors are those of Newton's method

# A film of 4 x 1 mm whose electrodes end at its middle.
HALF_COVERED = """Point(1) = {{0, 0, 0}};
covered[] = Extrude {{2, 0, 0}} {{ Point{{1}}; Layers{{2 * {n}}}; }};
bare[] = Extrude {{2, 0, 0}} {{ Point{{covered[0]}}; Layers{{2 * {n}}}; }};
under[] = Extrude {{0, 0, 1}} {{ Line{{covered[1]}}; Layers{{{n}}}; Recombine; }};
beside[] = Extrude {{0, 0, 1}} {{ Line{{bare[1]}}; Layers{{{n}}}; Recombine; }};
Physical Surface("film") = {{under[1], beside[1]}};
Physical Curve("bottom") = {{covered[1], bare[1]}};
Physical Curve("low") = covered[1];
Physical Curve("high") = under[0];
Physical Point("edge") = Point In BoundingBox {{1.9, -1, 0.9, 2.1, 1, 1.1}};
"""
HALF_COVERED_SCENE = """set Dimension = 2
subsection Mesh
  set File = film.geo
end
subsection Regions
  set Materials = film: elastomer
end
subsection Discretisation
  set Degree = 2
  set Formulation = mean dilatation
end
subsection Supports
  set Fixed = bottom: u1 u3
end
subsection Electrodes
  set Potential = low: 0, high: 1
end
subsection Loading
  set Control = voltage
  set Target = 20 V
  set Film thickness = 1
end
subsection Output
  set Observables = charge, tip, energy
  set Fields = none
end
subsection Observables
  subsection tip
    set At = edge
  end
end
"""


def estimates(folder):
    """{quantity: (value, error estimate, of the mesh, of time, remark)}."""
    with open(folder / "estimate.csv", newline="", encoding="utf8") as file:
        rows = list(csv.DictReader(file))
    require(list(rows[0])[:3] == ["quantity", "value", "error_estimate"], "other columns")
    return {row["quantity"]: (*(float(row[name]) for name in
                                ("value", "error_estimate", "mesh_error", "time_error")),
                              row["remark"]) for row in rows}


def judge(case, found, exact):
    """One line for each quantity that is known exactly; none may be claimed too exact."""
    for quantity, truth in exact.items():
        value, estimate, mesh, time, remark = found[quantity]
        error = abs(value - truth)
        ratio = estimate / error if error > 0 else math.inf
        print(f"{case:52} {quantity:20} error {error:.2e}, estimate {estimate:.2e} (mesh {mesh:.1e}, "
              f"time {time:.1e}): {ratio:.2f}")
        require(not remark, f"{case}, {quantity}: {remark}")
        require(ratio >= 1, f"{case}, {quantity}: the estimate is too small")
        require(ratio <= MOST or error < ROUNDING * abs(truth),
                f"{case}, {quantity}: the estimate is too large")


def check_bending(program, folder, rank_numbers):
    """Degrees, formulations, meshes and temperatures; on several ranks the same."""
    for degree, formulation, mesh, (theta, alpha) in (
            (2, "mean dilatation", (2, 14), (353, 1.8e-4)), (2, "mean dilatation", (2, 20), (293, 0)),
            (2, "selective reduced", (2, 14), (273, 1.8e-4)), (2, "standard", (2, 14), (353, 1.8e-4)),
            (1, "mean dilatation", (4, 20), (353, 1.8e-4)), (1, "enhanced strain", (2, 14), (293, 0)),
            (1, "selective reduced", (2, 20), (353, 1.8e-4))):
        entries = {"Discretisation/Degree": str(degree), "Discretisation/Formulation": formulation,
                   "Mesh/Parameters": f"L: 20, H: 1, n1: {mesh[0]}, n3: {mesh[1]}",
                   "Temperature/Value": str(theta), "Loading/Target": "0.5",
                   "Materials/elastomer/Thermal expansion": str(alpha), "Output/Fields": "none"}
        ranks = rank_numbers if formulation == "enhanced strain" else [1]
        found = []
        for n in ranks:
            program.run("bending_actuator_plane", folder, "--estimate", *settings(entries), ranks=n)
            found.append(estimates(folder)["mid_rotation_deg"])
        judge(f"circle, degree {degree}, {formulation}, {mesh[0]} x {mesh[1]}, {theta} K",
              {"mid_rotation_deg": found[0]},
              {"mid_rotation_deg": exact_mid_rotation(program.source, alpha, theta, 0.5)})
        require(all(abs(one[1] / found[0][1] - 1) < 1e-3 for one in found),
                "another estimate on several ranks")


def check_coarser(program, folder):
    """Where a mesh is refined already, and too fine for two more, its order is measured from the
    coarser one."""
    entries = {"Mesh/Refinements": "2", "Time/Tolerance": "0", "Time/Initial step": "0.06",
               "Time/End": "0.3", "Output/Fields": "none",
               "Mesh/Parameters": "L1: 0.1, L2: 0.1, L3: 0.5, n1: 1, n2: 1, n3: 2"}
    program.run("verification/slab_heating", folder, "--estimate", *settings(entries))
    require((folder / "coarser").is_dir() and not (folder / "finest").exists(),
            "no coarser mesh was compared")
    judge("slab, BDF2, 0 K a step, degree 1, 2 cells refined twice", estimates(folder),
          {"probe_theta_K": mid_temperature(0.3)})


def check_tube(program, folder):
    """Voltage and temperature gradient."""
    with open(program.source / "tests/reference/tube.csv", newline="", encoding="utf8") as file:
        row = next(row for row in csv.DictReader(file) if
                   (row["V_kV"], row["theta_inner_K"], row["theta_outer_K"]) == ("10", "353", "293"))
    exact = [float(row["r_inner_mm"]) - 1, float(row["r_outer_mm"]) - 2,
             float(row["phi_at_R_1.5_kV"]), float(row["theta_at_R_1.5_K"])]
    program.run("verification/thermo_electric_tube", folder, "--estimate",
                *settings({"Mesh/Parameters": "n1: 4, n3: 6", "Expectations/Final values": "",
                           "Output/Fields": "none"}))
    judge("tube, 4 x 6", estimates(folder), dict(zip(
        ("tip_u1_mm", "centre_u1_mm", "probe_phi_kV", "probe_theta_K"), exact)))


def check_balloon(program, folder):
    """Of a body in space only two meshes are compared."""
    program.run("balloon", folder, "--estimate", "--set", "Output/Fields=none")
    state = balloon_exact.Balloon().at_pressure(0.004, 15.0, 9.99, 13.3)
    judge("balloon, 3 x 2 x 2", estimates(folder),
          {"tip_u1_mm": state.inner - 10, "centre_u1_mm": state.outer - 11,
           "enclosed_volume_mm3": state.volume / 8})


def check_homogeneous(program, folder):
    """No error of the mesh: what is left is the bracket of a pull-in, or Newton's tolerance."""
    program.run("planar_actuator", folder, "--estimate", "--set", "Output/Fields=none")
    value, estimate = estimates(folder)["pull_in_e"][:2]
    limit = planar_exact.limit_point(planar_exact.Material(), 293.0).e
    print(f"pull-in at e = {value:.6f} +- {estimate:.1e}, exactly {limit:.6f}")
    require(abs(value - limit) < estimate < 3e-4, "the pull-in is outside its estimate")
    target = 0.6
    program.run("planar_actuator", folder, "--estimate", *settings(
        {"Output/Fields": "none", "Loading/Target": str(target), "Loading/Expected end": "target",
         "Expectations/Final values": ""}))
    found = estimates(folder)
    material = planar_exact.Material()
    exact = planar_exact.stable_state(material, 293.0, float(material.field(target, 293.0)))[1]
    judge("film at e = 0.6", found, {"lambda_3": exact})


def check_singular(program, folder):
    """At the edge of an electrode the field is singular: the order is 1 whatever the degree. In a free
    surface displacements there have no limit."""
    for n in (2, 3):
        (folder / "film.geo").write_text(HALF_COVERED.format(n=n))
        (folder / "film.prm").write_text(HALF_COVERED_SCENE)
        program.run(os.path.relpath(folder / "film", program.source / "prm"), folder / "out",
                    "--estimate")
        found = estimates(folder / "out")
        exact = planar_exact.Material().eps(293) * 0.02 * (2 + math.log(2) / math.pi)
        judge(f"half-covered film, {n} cells a mm", found, {"charge_uC": exact})
        for quantity in ("tip_u1_mm", "energy_elastic_mJ"):
            require(found[quantity][4] == "no limit" and math.isnan(found[quantity][1]),
                    f"{quantity} is given a limit")


def wave(time, omega, depth):
    """Temperature in K of an insulated face @p depth mm behind a wall at 293 + 20 sin(omega t) K."""
    root = cmath.sqrt(1j * omega * CAPACITY / CONDUCTIVITY)
    return 293 + 20 * (cmath.exp(1j * omega * time) / cmath.cosh(root * depth)).imag


def check_time(program, folder):
    """Steps of one length and adapted ones, of both orders, on coarse meshes."""
    for scheme in ("backward Euler", "BDF2"):
        for tolerance, step, degree, n in ((0, 0.06, 1, 4), (0.1, 1e-3, 2, 2)):
            entries = {"Time/Scheme": scheme, "Time/Tolerance": str(tolerance),
                       "Time/Initial step": str(step), "Discretisation/Degree": str(degree),
                       "Mesh/Parameters": f"L1: 0.1, L2: 0.1, L3: 0.5, n1: 1, n2: 1, n3: {n}",
                       "Output/Fields": "none"}
            program.run("verification/slab_heating", folder, "--estimate", *settings(entries))
            judge(f"slab, {scheme}, {tolerance} K a step, degree {degree}, {n} cells",
                  estimates(folder), {"probe_theta_K": mid_temperature(1.2)})
    omega = 2 * math.pi / 1.5
    entries = {"Time/End": "12", "Time/Initial step": "0.1", "Time/Tolerance": "0",
               "Time/Wall amplitude": f"sin({float(omega)!r}*t)", "Temperature/Fixed": "bottom: 313",
               "Mesh/Parameters": "L1: 0.1, L2: 0.1, L3: 0.5, n1: 1, n2: 1, n3: 3",
               "Output/Fields": "none"}
    program.run("verification/slab_heating", folder, "--estimate", *settings(entries))
    judge("thermal wave", estimates(folder), {"probe_theta_K": wave(12, omega, 0.5)})


def main():
    program, ranks = program_and_ranks(__doc__)
    side_by_side(program, (check_bending, ranks), (check_time,), (check_singular,), (check_tube,),
                 (check_balloon,), (check_coarser,), (check_homogeneous,))


main()
