"""Loads one after the other: each is applied, whatever came before, and the voltage that follows
others finds its pull-in.

    stages.py THELMA_BINARY MPIEXEC SOURCE_DIR RANKS...
"""

import math
import tempfile
from pathlib import Path

from scipy.optimize import fsolve, minimize_scalar

from scene import program_and_ranks, require, settings, validated
from thelma import planar_exact

STRESS = 0.4 / 5.0  # MPa, of the film's weight on its face
BRACKET = 1e-4  # the default

# A film whose upper electrode has two parts.
TWO_PARTS = """Point(1) = {0, 0, 0};
l1[] = Extrude {2.5, 0, 0} { Point{1}; Layers{1}; };
l2[] = Extrude {2.5, 0, 0} { Point{l1[0]}; Layers{1}; };
a1[] = Extrude {0, 5, 0} { Line{l1[1]}; Layers{1}; Recombine; };
a2[] = Extrude {0, 5, 0} { Line{l2[1]}; Layers{1}; Recombine; };
b1[] = Extrude {0, 0, 1} { Surface{a1[1]}; Layers{1}; Recombine; };
b2[] = Extrude {0, 0, 1} { Surface{a2[1]}; Layers{1}; Recombine; };
Physical Volume("film") = {b1[1], b2[1]};
Physical Surface("bottom") = {a1[1], a2[1]};
Physical Surface("left") = b1[0];
Physical Surface("right") = b2[0];
Physical Surface("x2_min") = {b1[2], b2[2]};
Physical Surface("x1_min") = b1[5];
"""


def weighted(lambda_3, material):
    """(lambda_1, lambda_2, e) of the film under its weight, with the energy of dead_loads.py
    stationary at this lambda_3; neo-Hookean, homogeneous."""
    mu, K = material.mu(293), material.K

    def forces(state):
        l_1, l_2, square = state  # e^2
        pressure = K * math.log(l_1 * l_2 * lambda_3) / mu - 1
        maxwell = square * l_1 * l_2 / lambda_3 / 2
        return (l_1**2 + pressure - maxwell - STRESS / mu * l_1,
                l_2**2 + pressure - maxwell, lambda_3**2 + pressure + maxwell)

    l_1, l_2, square = fsolve(forces, (1.8, 0.8, 0.1), xtol=1e-13)
    return l_1, l_2, math.sqrt(max(square, 0.0))


def check_pull_in(program, folder, ranks):
    """After the weight; its bracket is as wide as the file wants, also where the stage goes further
    than the target."""
    material = planar_exact.Material()
    exact = -minimize_scalar(lambda l_3: -weighted(l_3, material)[2], bounds=(0.4, 0.72),
                             method="bounded", options={"xatol": 1e-8}).fun
    below, above = program.run("verification/dead_load", folder, ranks=ranks, *settings(
        {"Loading/Target": "0.5", "Loading/Stages": "force 1, voltage 3",
         "Loading/Expected end": "pull-in"})).pull_in()
    print(f"{ranks} rank(s): pull-in under the weight between e = {below:.6f} and {above:.6f}, "
          f"exact {exact:.6f}")
    validated("dead_load", "pull-in e", "exact, homogeneous", (below + above) / 2 / exact - 1)
    require(below - 1e-6 < exact < above + 1e-6, "the pull-in is not the exact one")
    require(above - below < 1.01 * BRACKET, f"the bracket is {above - below} wide")


def check_weight_of_passive_film(program, folder):
    """A voltage that has nothing to act on leaves the force behind it alone."""
    curve = program.run("verification/dead_load", folder, *settings(
        {"Regions/Passive": "film", "Electrodes/Potential": "",
         "Loading/Stages": "voltage 1, force 1"})).curve("lambda_1")
    require(curve["lambda_1"][-1] > 1.5, "the film is not stretched")


def check_return_of_snapped_film(program, folder):
    """Limit points that a path has passed end nothing."""
    curve = program.run("hard/snap_through", folder, *settings(
        {"Materials/elastomer/Gent limit": "8", "Loading/Target": "0.75", "Loading/Until": "",
         "Loading/Stages": "voltage 1, voltage 0.5"})).curve("e", "event")
    require("limit point" in list(curve["event"]), "the film has not snapped")
    require(abs(curve["e"][-1] - 0.375) < 1e-9, f"the second stage ends at e = {curve['e'][-1]}")


def check_floating_film_warmed(program, folder):
    """Charged, disconnected and warmed to 353 K: the stretch of that charge there, by homogeneous
    states, however temperature and deformation are coupled."""
    material = planar_exact.Material()
    entropic, eps = material.factor(353), material.eps(353)
    mu, K = entropic * material.mu(353), entropic * material.K
    field = material.field(0.4, 293)
    l_1, l_3 = planar_exact.stable_state(material, 293, field)
    D = material.eps(293) * field * l_1**2 / l_3  # charge per undeformed area

    def forces(state):
        l_1, l_3 = state
        pressure = (K * math.log(l_1**2 * l_3) - mu) / mu
        maxwell = D**2 * l_3 / (2 * eps * l_1**2) / mu
        return l_1**2 + pressure - maxwell, l_3**2 + pressure + maxwell

    exact = fsolve(forces, (l_1, l_3), xtol=1e-13)[1]
    for coupling in ("staggered", "monolithic"):
        curve = program.run("planar_actuator", folder, *settings(
            {"Loading/Target": "0.4", "Loading/Expected end": "target",
             "Loading/Stages": "voltage 1, disconnect top", "Temperature/Model": "transient",
             "Temperature/Fixed": "bottom: 353, top: 353", "Time/End": "2000",
             "Time/Coupling": coupling, "Expectations/Final values": "", "Output/Fields": "none",
             "Mesh/Parameters": "L1: 5, L2: 5, L3: 1, n1: 1, n2: 1, n3: 2"})).curve("lambda_3")
        error = curve["lambda_3"][-1] - exact
        print(f"{coupling}: a charged film at 353 K has lambda_3 = {curve['lambda_3'][-1]:.8f}, "
              f"exact {exact:.8f}")
        validated("planar_actuator", f"lambda_3, charged and warmed, {coupling}",
                  "exact, homogeneous", error)
        require(abs(error) < 1e-6, f"lambda_3 is off by {error}")


def check_electrode_of_two_parts(program, folder):
    """The nodes between two electrodes of one potential have their charge once: q V is twice the
    energy of an ideal dielectric."""
    folder.mkdir()
    (folder / "parts.geo").write_text(TWO_PARTS)
    curve = program.run("planar_actuator", folder / "run", *settings(
        {"Mesh/File": str(folder / "parts.geo"), "Mesh/Parameters": "", "Loading/Target": "0.3",
         "Loading/Expected end": "target", "Electrodes/Potential": "bottom: 0, left: 1, right: 1",
         "Observables/lambda_3/To": "left", "Expectations/Final values": "",
         "Output/Fields": "none"})).curve("charge_uC", "voltage_kV", "energy_electric_mJ")
    work = curve["charge_uC"][-1] * curve["voltage_kV"][-1]
    require(abs(work / (2 * curve["energy_electric_mJ"][-1]) - 1) < 1e-9,
            f"q V is {work} mJ, the energy {curve['energy_electric_mJ'][-1]} mJ")


def main():
    """On every number of ranks."""
    program, all_ranks = program_and_ranks(__doc__)
    with tempfile.TemporaryDirectory() as name:
        folder = Path(name)
        for ranks in all_ranks:
            check_pull_in(program, folder / f"pull_in_{ranks}", ranks)
        check_weight_of_passive_film(program, folder / "passive")
        check_return_of_snapped_film(program, folder / "return")
        check_floating_film_warmed(program, folder / "warmed")
        check_electrode_of_two_parts(program, folder / "parts")


main()
