"""The planar actuator at five temperatures against its exact solution, with and without expansion.

    planar_actuator.py THELMA_BINARY MPIEXEC SOURCE_DIR RANKS...
"""

import tempfile
from pathlib import Path

from scene import program_and_ranks, require, study, validated
from thelma import planar_exact as exact

SWEEP = study.TEMPERATURE + "=273,293,313,333,353"  # K
# Dimensionless field of pull-in by thermal expansion (1/K) and temperature, as documented.
PULL_IN = {
    "0": (0.66349, 0.68737, 0.71044, 0.73278, 0.75447),
    "1.8e-4": (0.66469, 0.68737, 0.70916, 0.73015, 0.75041),
}
THICKNESS, AREA = 1.0, 25.0  # mm, mm^2
FIELD_TOLERANCE = 1e-3  # of the ends of the bracket, in e
BRACKET_WIDTH = 1.0001e-4  # in e
ROUNDING = 1e-8  # of solved equilibria, in e
STRETCH_TOLERANCE = 1e-6  # in lambda_3
CHARGE_TOLERANCE = 1e-6  # in uC; about 0.05 at pull-in


def check_pull_in(name, case, documented, limit):
    """The bracket is narrow and holds the exact e_c; its ends are near the documented one."""
    bracket = case.pull_in()
    require(bracket is not None, f"{name}: run.json holds no pull-in bracket")
    below, above = bracket
    require(0 <= above - below <= BRACKET_WIDTH, f"{name}: the bracket is {above - below} wide")
    require(below - ROUNDING <= limit.e <= above + ROUNDING,
            f"{name}: the exact pull-in {limit.e} is not in [{below}, {above}]")
    for end in bracket:
        for what, value in (("exact", limit.e), ("documented", documented)):
            require(abs(end - value) <= FIELD_TOLERANCE,
                    f"{name}: pull-in at {end}, {what} value {value}")


def check_curve(name, case, material, theta, limit):
    """Every accepted state is the exact stable one at its voltage; returns the largest error."""
    curve = case.curve("e", "voltage_kV", "lambda_3", "charge_uC", "event")
    require(len(curve["e"]) > 1, f"{name}: the curve has {len(curve['e'])} rows")
    require(curve["event"][-1] == "pull-in", f"{name}: the last row is not marked pull-in")
    largest = 0.0
    rows = zip(curve["e"], curve["voltage_kV"], curve["lambda_3"], curve["charge_uC"])
    for e, voltage, lambda_3, charge in rows:
        place, field = f"{name}, {voltage} kV", voltage / THICKNESS
        require(abs(e - material.e(field, theta)) <= ROUNDING, f"{place}: e = {e}")
        require(e <= limit.e + ROUNDING, f"{place}: the exact pull-in is at {limit.field} kV/mm")
        field = min(field, limit.field)
        stretches = exact.stable_state(material, theta, field)
        error = abs(lambda_3 - stretches[1])
        require(error <= STRETCH_TOLERANCE, f"{place}: lambda_3 = {lambda_3} is off by {error}")
        exact_charge = AREA * exact.charge_per_area(material, theta, *stretches, field)
        require(abs(charge - exact_charge) <= CHARGE_TOLERANCE,
                f"{place}: charge {charge} uC, exact {exact_charge}")
        largest = max(largest, error)
    return largest


def check_study(output, alpha, ranks):
    """All temperatures of one study."""
    cases = study.read_study(output)
    require(len(cases) == len(PULL_IN[alpha]), f"{len(cases)} cases in study.csv")
    material = exact.Material(alpha=float(alpha))
    for case, documented in zip(cases, PULL_IN[alpha]):
        theta = float(case.swept[study.TEMPERATURE])
        name = f"alpha = {alpha}, {theta:g} K, {ranks} ranks"
        require(case.exit_code == 0, f"{name}: exit code {case.exit_code}, {case.outcome}")
        limit = exact.limit_point(material, theta)
        check_pull_in(name, case, documented, limit)
        largest = check_curve(name, case, material, theta, limit)
        below, above = case.pull_in()
        print(f"{name}: e_c in [{below:.6f}, {above:.6f}], exact {limit.e:.6f}, "
              f"largest error of lambda_3 {largest:.1e}")
        validated("planar_actuator", f"lambda_3 of every state, alpha = {alpha}, {theta:g} K",
                  "exact, homogeneous", largest)
        validated("planar_actuator", f"pull-in e, alpha = {alpha}, {theta:g} K",
                  "exact, homogeneous", (below + above) / 2 / limit.e - 1)


def main():
    """Both expansions on each number of ranks."""
    program, all_ranks = program_and_ranks(__doc__)
    for ranks in all_ranks:
        for alpha in PULL_IN:
            with tempfile.TemporaryDirectory() as directory:
                output = Path(directory) / "study"
                program.run("planar_actuator", output, "--sweep", SWEEP, "--set",
                            f"Materials/elastomer/Thermal expansion={alpha}", ranks=ranks)
                check_study(output, alpha, ranks)


if __name__ == "__main__":
    main()
