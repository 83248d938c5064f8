"""The tube under voltage and a temperature gradient against its one-dimensional solution.

Usage: thermo_electric_tube.py THELMA_BINARY MPIEXEC SOURCE_DIR RANKS...

tests/reference/tube.csv: the radial boundary value problem, solved by an independent program.
"""

import csv
import math
import tempfile
from pathlib import Path

from scene import program_and_ranks, require, validated

COLUMNS = ["tip_u1_mm", "centre_u1_mm", "probe_phi_kV", "probe_theta_K"]


def run(program, folder, row, radial_cells, ranks=1):
    """r_i, r_o in mm, phi in kV and theta in K at R = 1.5 mm."""
    voltage = max(float(row["V_kV"]), 1e-9)
    walls = f"inner: {row['theta_inner_K']}, outer: {row['theta_outer_K']}"
    case = program.run(
        "verification/thermo_electric_tube", folder,
        "--set", f"Loading/Target={voltage}", "--set", f"Temperature/Fixed={walls}",
        "--set", f"Mesh/Parameters=n1: {radial_cells}, n3: {3 * radial_cells // 2}",
        "--set", "Expectations/Final values=", "--set", "Output/Fields=none", ranks=ranks)
    curve = case.curve(*COLUMNS)
    u_i, u_o, phi, theta = (curve[column][-1] for column in COLUMNS)
    return [1.0 + u_i, 2.0 + u_o, phi, theta]


def exact(row):
    return [float(row[name]) for name in
            ("r_inner_mm", "r_outer_mm", "phi_at_R_1.5_kV", "theta_at_R_1.5_K")]


def check_rows(program, folder, rows):
    """16 radial cells: radii to 1e-6 relative, phi (of 1 kV at least) and theta to 1e-5."""
    for row in rows:
        found, wanted = run(program, folder, row, 16), exact(row)
        errors = [abs(f - w) / max(abs(w), 1.0) for f, w in zip(found, wanted)]
        print(f"{row['V_kV']:>2} kV, {row['theta_inner_K']} K inside, {row['theta_outer_K']} K outside: "
              f"relative errors of r_i {errors[0]:.1e}, r_o {errors[1]:.1e}, phi {errors[2]:.1e}, "
              f"theta {errors[3]:.1e}")
        case = f"{row['V_kV']} kV, {row['theta_inner_K']} and {row['theta_outer_K']} K"
        validated("thermo_electric_tube", f"radii, {case}", "boundary value problem, two codes",
                  max(errors[:2]))
        validated("thermo_electric_tube", f"potential and temperature, {case}",
                  "boundary value problem, two codes", max(errors[2:]))
        require(max(errors[:2]) < 1e-6 and max(errors[2:]) < 1e-5, "an error is too large")


def check_orders(program, folder, row):
    """Halving the cells of degree 2 divides every error by at least 2^3; at the nodes by more."""
    errors = []
    for cells in (2, 4, 8):
        errors.append([abs(f - w) for f, w in zip(run(program, folder, row, cells), exact(row))])
    for name, values in zip(("r_i", "r_o", "phi", "theta"), zip(*errors)):
        orders = [math.log2(a / b) for a, b in zip(values, values[1:])]
        print(f"{name}: errors {' '.join(f'{v:.2e}' for v in values)} with 2, 4, 8 radial cells, "
              f"orders {' '.join(f'{o:.2f}' for o in orders)}")
        require(min(orders) > 2.9, f"order of {name} is {min(orders):.2f}")


def check_conduction_follows_deformation(program, folder, row):
    """With conduction in the undeformed tube theta(1.5) would be 317.892 K."""
    neglected = 353 - 60 * math.log(1.5) / math.log(2)
    found = run(program, folder, row, 8)[3]
    require(abs(found - neglected) > 0.3, "the deformation does not show in the temperature")


def check_stretch(program, folder, row):
    """The mean of x_1 over an arc is 2/pi times its radius."""
    case = program.run(
        "verification/thermo_electric_tube", folder,
        "--set", "Mesh/Parameters=n1: 4, n3: 6", "--set", "Expectations/Final values=",
        "--set", "Output/Observables=tip, centre, probe, lambda_1",
        "--set", "Observables/lambda_1/From=inner", "--set", "Observables/lambda_1/To=outer", "--set", "Output/Fields=none")
    wanted = float(row["r_outer_mm"]) - float(row["r_inner_mm"])
    error = case.curve("lambda_1")["lambda_1"][-1] - wanted
    print(f"mean stretch of the wall: {error:.1e} off")
    require(abs(error) < 5e-6, f"the mean stretch of the wall is off by {error}")


def main():
    program, all_ranks = program_and_ranks(__doc__)
    with open(program.source / "tests/reference/tube.csv", newline="", encoding="utf8") as file:
        rows = list(csv.DictReader(file))
    with tempfile.TemporaryDirectory() as name:
        folder = Path(name)
        check_rows(program, folder, rows)
        check_orders(program, folder, rows[2])
        check_conduction_follows_deformation(program, folder, rows[2])
        check_stretch(program, folder, rows[2])
        one, several = (run(program, folder, rows[2], 8, ranks) for ranks in
                        (min(all_ranks), max(all_ranks)))
        difference = max(abs(a - b) for a, b in zip(one, several))
        print(f"{min(all_ranks)} and {max(all_ranks)} rank(s) differ by {difference:.1e}")
        require(difference < 1e-8, "the number of ranks matters")


main()
