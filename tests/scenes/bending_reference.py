"""Exact rotation of the bending actuator.

tests/reference/bilayer_bending.csv: curvature of the exact circle (doc/theory.md, "Bending") from
the one-dimensional boundary value problem, solved to 1e-11 by an independent program.
"""

import csv
import math

LENGTH, LAYER = 20.0, 0.5  # mm


def exact_mid_rotation(source, alpha, theta, field):
    """Degrees that the section X3 = L/2 turns, at a field between 0.55 and 0.9 or in the table.

    Between its rows, which are 0.05 apart, the polynomial through the upper eight is within 1e-5.
    """
    table = {}
    with open(source / "tests/reference/bilayer_bending.csv", newline="", encoding="utf8") as file:
        for row in csv.DictReader(file):
            if (float(row["alpha_per_K"]), float(row["theta_K"])) == (alpha, theta):
                table[float(row["e"])] = math.degrees(
                    float(row["curvature_times_layer_thickness_rad"]) / LAYER * LENGTH / 2)
    if field in table:
        return table[field]
    upper = {e: angle for e, angle in table.items() if e > 0.5}
    if not upper or not min(upper) <= field <= max(upper):
        raise LookupError(f"no rows for alpha {alpha}, theta {theta} around e {field}")
    return sum(angle * math.prod((field - other) / (e - other) for other in upper if other != e)
               for e, angle in upper.items())
