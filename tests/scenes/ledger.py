"""Voltage, charge and ledger where electrodes float, supports move and no time passes.

    ledger.py THELMA_BINARY MPIEXEC SOURCE_DIR RANKS...

Against exact homogeneous states, and the energy balance to the second order of the load steps.
"""

import math
import subprocess

from scipy.integrate import quad
from scipy.optimize import brentq

from scene import program_and_ranks, require, settings, side_by_side, validated
import constant_charge
from thelma import planar_exact

# Three layers with electrodes between them.
THREE_LAYERS = """Point(1) = {0, 0, 0};
line[] = Extrude {2, 0, 0} { Point{1}; Layers{1}; };
area[] = Extrude {0, 2, 0} { Line{line[1]}; Layers{1}; Recombine; };
a[] = Extrude {0, 0, 0.3} { Surface{area[1]}; Layers{1}; Recombine; };
b[] = Extrude {0, 0, 0.5} { Surface{a[0]}; Layers{1}; Recombine; };
c[] = Extrude {0, 0, 0.2} { Surface{b[0]}; Layers{1}; Recombine; };
Physical Volume("film") = {a[1], b[1], c[1]};
Physical Surface("bottom") = area[1];
Physical Surface("s12") = a[0];
Physical Surface("s23") = b[0];
Physical Surface("top") = c[0];
Physical Surface("x1_min") = Surface In BoundingBox {-1e-6, -1e-6, -1e-6, 1e-6, 3, 2};
Physical Surface("x1_max") = Surface In BoundingBox {2-1e-6, -1e-6, -1e-6, 3, 3, 2};
Physical Surface("x2_min") = Surface In BoundingBox {-1e-6, -1e-6, -1e-6, 3, 1e-6, 2};
Physical Surface("x2_max") = Surface In BoundingBox {-1e-6, 2-1e-6, -1e-6, 3, 3, 2};
"""
HEIGHTS, SIDE = (0.3, 0.5, 0.2), 2.0  # mm


def check_stack(program, folder, ranks):
    """Two electrodes without charge between three layers whose sides are held: the applied voltage is
    that of the curve, and the charge that of the electrode which has it."""
    (folder / "layers.geo").write_text(THREE_LAYERS)
    material, target = planar_exact.Material(), 12.0
    curve = program.run("planar_actuator", folder / "run", *settings(
        {"Mesh/File": str(folder / "layers.geo"), "Mesh/Parameters": "", "Loading/Control": "voltage",
         "Loading/Target": f"{target}", "Loading/Expected end": "target", "Expectations/Final values":
         "", "Output/Fields": "none", "Output/Observables": "lambda_3, charge, electrodes, ledger",
         "Supports/Fixed": "x1_min: u1, x1_max: u1, x2_min: u2, x2_max: u2, bottom: u3",
         "Electrodes/Potential": "bottom: 0, top: 1", "Electrodes/Floating": "s12: 1, s23: -0.5",
         }), ranks=ranks).curve("load", "voltage_kV", "e", "charge_uC", "top_charge_uC",
                                "s12_voltage_kV", "s23_voltage_kV", "ledger_electrode_work_mJ")

    def thickness(D):  # stretch across the layers
        mu, eps = material.mu(293), material.eps(293)
        return brentq(lambda l: mu * (l - 1 / l) + material.K * math.log(l) / l + D**2 / (2 * eps),
                      0.5, 1, xtol=1e-15)

    D = brentq(lambda D: D * thickness(D) / material.eps(293) - target, 0, 1e-3, xtol=1e-18)
    charge = D * SIDE**2
    work = SIDE**2 * quad(lambda D: D * thickness(D) / material.eps(293), 0, D)[0]
    error = curve["charge_uC"][-1] / charge - 1
    print(f"{ranks} rank(s), stack: {curve['charge_uC'][-1]:.9f} uC at {curve['voltage_kV'][-1]} kV, "
          f"relative error {error:.1e}")
    validated("planar_actuator", "charge_uC, two floating electrodes between", "exact, homogeneous",
              error)
    require(abs(error) < 1e-8, "not the exact charge")
    require(max(abs(curve["voltage_kV"] - target * curve["load"])) < 1e-12, "not the applied voltage")
    require(abs(curve["e"][-1] / material.e(target, 293) - 1) < 1e-9, "not the e applied")
    require(max(abs(curve["charge_uC"] - curve["top_charge_uC"])) < 1e-15, "no electrode's charge")
    for name, part in (("s12", HEIGHTS[0]), ("s23", HEIGHTS[0] + HEIGHTS[1])):
        require(abs(curve[f"{name}_voltage_kV"][-1] - part * target) < 1e-8, f"potential of {name}")
    require(abs(curve["ledger_electrode_work_mJ"][-1] / work - 1) < 1e-3, "not the work done")


def check_beside_another(program, folder):
    """One of two electrodes is cut off: the voltage is that of the other, which is still driven."""
    (folder / "layers.geo").write_text(THREE_LAYERS)
    curve = program.run("planar_actuator", folder / "run", *settings(
        {"Mesh/File": str(folder / "layers.geo"), "Mesh/Parameters": "", "Loading/Target": "0.3",
         "Loading/Expected end": "target", "Loading/Stages": "voltage 1, disconnect s12, voltage 0.5",
         "Electrodes/Potential": "bottom: 0, s12: 0.4, top: 1", "Expectations/Final values": "",
         "Supports/Fixed": "x1_min: u1, x1_max: u1, x2_min: u2, x2_max: u2, bottom: u3",
         "Output/Fields": "none", "Output/Observables": "lambda_3, charge, electrodes"})).curve(
             "load", "e", "charge_uC", "s12_charge_uC", "top_charge_uC")
    cut = list(curve["load"]).index(1)
    before, after = slice(0, cut + 1), slice(cut + 1, None)
    driven = curve["s12_charge_uC"] + curve["top_charge_uC"]
    require(abs(curve["e"][-1] - 0.15) < 1e-12, f"e is {curve['e'][-1]}, not the 0.15 applied")
    require(max(abs(curve["charge_uC"] - driven)[before]) < 1e-15, "not the charge of both")
    require(max(abs(curve["charge_uC"] - curve["top_charge_uC"])[after]) < 1e-15, "not top's charge")
    require(max(abs(curve["s12_charge_uC"][after] - curve["s12_charge_uC"][cut])) < 1e-12,
            "the electrode that is cut off does not keep its charge")


def orders(values):
    return [math.log2(a / b) for a, b in zip(values, values[1:])]


def check_static(program, folder):
    """The film of stages `force` and `voltage`: what is missing is of second order in the steps."""
    missing = []
    for step in (0.1, 0.05, 0.025):
        curve = program.run("verification/dead_load", folder, *settings(
            {"Stepping/Initial step": f"{step}", "Stepping/Largest step": f"{step}",
             "Output/Observables": "lambda_1, lambda_3, ledger", "Output/Fields": "none"})).curve(
                 "ledger_energy_missing_mJ", "ledger_electrode_work_mJ", "ledger_load_work_mJ")
        missing.append(abs(curve["ledger_energy_missing_mJ"][-1]))
    found, done = orders(missing), curve["ledger_load_work_mJ"][-1]
    print(f"weight and voltage do {done:.5f} and {curve['ledger_electrode_work_mJ'][-1]:.5f} mJ; "
          f"missing {' '.join(f'{m:.2e}' for m in missing)}, orders {found[0]:.2f} {found[1]:.2f}")
    require(min(found) > 1.8 and missing[-1] < 1e-2 * done, "energy is missing")


def check_generator(program, folder):
    """Once around the generator's cycle nothing is stored: its electrodes give what the grips do,
    which is the difference of exact states at constant charge."""
    material = planar_exact.Material()
    sums = []
    for step in (0.04, 0.02):
        curve = program.run("hard/generator", folder, *settings(
            {"Stepping/Initial step": f"{step}", "Stepping/Largest step": f"{step}",
             "Output/Observables": "lambda_1, lambda_3, electrodes, reaction, ledger",
             "Output/Fields": "none"})).curve(
                 "load", "top_charge_uC", "ledger_electrode_work_mJ", "ledger_support_work_mJ",
                 "ledger_energy_missing_mJ")
        sums.append(abs(curve["ledger_energy_missing_mJ"][-1]))
    most = max(curve["top_charge_uC"]) / 25

    def gain(D):
        return 25 * (constant_charge.state(material, 293, 1.0, D)[2]
                     - constant_charge.state(material, 293, 1.5, D)[2])

    exact = quad(gain, 0, most, epsrel=1e-9)[0]
    electric, moved = curve["ledger_electrode_work_mJ"][-1], curve["ledger_support_work_mJ"][-1]
    print(f"a cycle takes {moved:.6f} mJ from the grips and gives {-electric:.6f} mJ, exactly "
          f"{exact:.6f}; missing {sums[0]:.1e}, {sums[1]:.1e} mJ, order {orders(sums)[0]:.2f}")
    validated("generator", "work of the electrodes over a cycle", "exact, homogeneous",
              -electric / exact - 1)
    validated("generator", "work of the moved grips over a cycle", "exact, homogeneous",
              moved / exact - 1)
    require(max(abs(electric + exact), abs(moved - exact)) < 3e-3 * exact, "not the exact work")
    require(orders(sums)[0] > 1.8, "the missing energy is not of second order")


def check_cut_off(program, folder):
    """Charged, cut off and warmed in time: no charge moves, and the electrodes do nothing."""
    curve = program.run("planar_actuator", folder, *settings(
        {"Loading/Target": "0.4", "Loading/Expected end": "target",
         "Loading/Stages": "voltage 1, disconnect top", "Temperature/Model": "transient",
         "Temperature/Fixed": "bottom: 353, top: 353", "Time/End": "0.5",
         "Time/Structural heat": "entropy", "Expectations/Final values": "", "Output/Fields": "none",
         "Output/Observables": "lambda_3, charge, ledger",
         "Mesh/Parameters": "L1: 5, L2: 5, L3: 1, n1: 1, n2: 1, n3: 2"})).curve(
             "voltage_kV", "ledger_electrode_work_mJ", "ledger_electric_mJ")
    require(max(abs(curve["ledger_electrode_work_mJ"])) < 1e-9 * max(curve["ledger_electric_mJ"]),
            "electrodes without source do work")
    require(abs(curve["voltage_kV"][-1] / max(curve["voltage_kV"]) - 1) > 0.01, "nothing changes")


def check_refused(program, folder):
    """Heat that flows for ever has no ledger."""
    command = program.command(["prm/verification/thermo_electric_tube.prm", *settings(
        {"Output/Observables": "ledger", "Expectations/Final values": ""}), "--output",
                               str(folder)], 1)
    done = subprocess.run(command, cwd=program.source, capture_output=True, text=True, check=False)
    require(done.returncode == 1 and "the ledger" in done.stderr, done.stderr)


def main():
    """The stack on every number of ranks."""
    program, all_ranks = program_and_ranks(__doc__)
    side_by_side(program, *((check_stack, ranks) for ranks in all_ranks), (check_beside_another,),
                 (check_static,), (check_generator,), (check_cut_off,), (check_refused,))


main()
