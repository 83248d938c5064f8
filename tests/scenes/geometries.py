"""Bodies of any shape that gmsh meshes, with hexahedra and curved cells, against exact solutions.

Usage: geometries.py THELMA_BINARY MPIEXEC SOURCE_DIR RANKS...

The tube's boundary value problem (tests/reference/tube.csv) on quadratic cells; a spherical capacitor by
Gauss' law and a plate with a hole from a STEP file, whose field is uniform, on subdivided tetrahedra.
"""

import csv
import math

from scene import program_and_ranks, require, settings, side_by_side, validated

PERMITTIVITY = 3.98e-5  # uC/(kV mm)
VOLTAGE = 1e-6  # kV: nothing moves


def charge(program, folder, scene, ranks=1, **entries):
    """In uC."""
    case = program.run(f"../tests/geometries/{scene}", folder, *settings(entries), ranks=ranks)
    return abs(case.curve("charge_uC")["charge_uC"][-1])


def check_tube(program, folder, ranks):
    """Quadratic cells from gmsh are as good as arcs."""
    with open(program.source / "tests/reference/tube.csv") as file:
        row = next(row for row in csv.DictReader(file) if float(row["V_kV"]) > 0)
    case = program.run("verification/thermo_electric_tube", folder, *settings({
        "Mesh/File": "tests/geometries/tube.geo", "Mesh/Curved": "as meshed", "Loading/Target": row["V_kV"],
        "Mesh/Parameters": "n1: 8, n3: 12", "Mesh/Refinements": "1",
        "Temperature/Fixed": f"inner: {row['theta_inner_K']}, outer: {row['theta_outer_K']}",
        "Expectations/Final values": "", "Output/Fields": "none"}), ranks=ranks)
    curve = case.curve("tip_u1_mm", "centre_u1_mm")
    errors = [1 + curve["tip_u1_mm"][-1] - float(row["r_inner_mm"]),
              2 + curve["centre_u1_mm"][-1] - float(row["r_outer_mm"])]
    error = max(map(abs, errors))
    print(f"tube of quadratic cells, {ranks} ranks: error of the radii {error:.1e} mm")
    validated("thermo_electric_tube", "radii, quadratic cells", "boundary value problem, two codes", error)
    require(error < 1e-6, "the radii are off")


def check_shell(program, folder, ranks):
    """The charge converges; straight edges miss 1 % of it, edges without faces lose an order."""
    exact = 4 * math.pi * PERMITTIVITY * VOLTAGE * 2 / 8

    def error(what, parameters):
        found = charge(program, folder / what, "shell", ranks, **{"Mesh/Parameters": parameters})
        print(f"shell, {what}, {ranks} ranks: charge {found:.8e} uC (exact {exact:.8e}), relative error "
              f"{found / exact - 1:.1e}")
        return abs(found / exact - 1)

    curved = error("27 nodes", "size: 0.7")
    require(curved < 2e-4, "the charge is off")
    if ranks > 1:
        return
    straight, edges = error("8 nodes", "order: 1"), error("20 nodes", "incomplete: 1")
    require(curved < straight / 6, "quadratic cells are no better than straight ones")
    require(edges < straight / 6, "20 nodes are no better than straight edges")
    fine = error("27 nodes, finer", "size: 0.5")
    require(fine < curved / 3, "the charge does not converge")
    validated("geometries", "charge of a spherical shell", "Gauss' law", fine)


def check_plate(program, folder, ranks):
    """A uniform field: all that is missing is the difference of quadratic edges from a circle."""
    exact = PERMITTIVITY * VOLTAGE * (400 - 16 * math.pi)
    error = charge(program, folder, "plate_with_hole", ranks) / exact - 1
    print(f"plate with a hole, {ranks} ranks: relative error of the charge {error:.1e}")
    validated("geometries", "charge of a plate with a hole (STEP)", "uniform field", error)
    require(abs(error) < 1e-5, "the charge is off")


def check_cuts(program, folder, ranks):
    """Elements of a .msh, cut in their middles, fill the film as before."""
    for name, dimension, area in (("triangles", 2, 4), ("prisms", 3, 8), ("tetrahedra", 3, 8)):
        for refinements in (0, 1):
            fixed = "u1 u3" if dimension == 2 else "u1 u2 u3"
            found = charge(program, folder / f"{name}{refinements}", "../inputs/film", ranks, **{
                "Dimension": str(dimension), "Mesh/File": f"{name}.msh", "Mesh/Cells": "subdivided",
                "Mesh/Refinements": str(refinements), "Supports/Fixed": f"base: {fixed}, lid: {fixed}",
                "Loading/Target": str(VOLTAGE)})
            error = found / (PERMITTIVITY * VOLTAGE * area) - 1
            print(f"{name}, subdivided, refined {refinements} times, {ranks} ranks: relative error {error:.1e}")
            require(abs(error) < 1e-10, "the charge is off")


def main():
    program, all_ranks = program_and_ranks(__doc__)
    side_by_side(program, *((check, ranks) for ranks in all_ranks
                            for check in (check_tube, check_shell, check_plate, check_cuts)))


if __name__ == "__main__":
    main()
