"""Films of Yeoh's and Ogden's rubber, of an energy as a formula and with fibres, against exact homogeneous states.

    laws.py THELMA_BINARY MPIEXEC SOURCE_DIR RANKS...
"""

from dataclasses import replace

import numpy as np
from laws_exact import TERMS, along, as_expression, limit_point, ogden, series_of_chains, with_fibres, yeoh
from scene import largest_error, program_and_ranks, require, settings, side_by_side, validated

FREE = {"Mesh/Parameters": "L1: 5, L2: 5, L3: 1, n1: 2, n2: 1, n3: 1",
        "Output/Observables": "lambda_1, lambda_3",
        "Observables/lambda_1/From": "x1_min", "Observables/lambda_1/To": "x1_max"}
TO_THE_TARGET = {"Loading/Expected end": "target"}


def compare(case, rubber, columns, normal=2, held=None):
    """Every state of a curve has the exact e, and the exact stretches in the columns (axis: name), at its thickness."""
    curve = case.curve("e", *columns.values())
    exact = list(along(rubber, curve[columns[normal]], normal, held))
    worst = max(abs(row - e) for row, (_, e) in zip(curve["e"], exact))
    for axis, name in columns.items():
        worst = max(worst, *(abs(row - stretches[axis]) for row, (stretches, _) in zip(curve[name], exact)))
    return worst


def check_pull_in(program, folder, ranks, what, rubber, known):
    """A free film up to its pull-in; its e and lambda_1 without change of volume are known."""
    e, stretches = limit_point(replace(rubber, ratio=1e6))
    print(f"{what}: exact pull-in at {e:.5f}, lambda_1 {stretches[0]:.4f} without change of volume")
    if known:
        require(abs(e - known[0]) < 6e-6 and abs(stretches[0] - known[1]) < 6e-5, f"known: {known}")
    case = program.run(rubber.scene, folder, *settings(rubber.options() | FREE), ranks=ranks)
    worst = compare(case, rubber, {0: "lambda_1", 2: "lambda_3"})
    (below, above), exact = case.pull_in(), limit_point(rubber)[0]
    print(f"{what}, {ranks} rank(s): pull-in in [{below:.6f}, {above:.6f}], exact {exact:.6f}; states off by "
          f"{worst:.1e}")
    validated(rubber.scene, f"e, lambda_1 of every state, {what}", "exact, homogeneous", worst)
    validated(rubber.scene, f"pull-in e, {what}", "exact, homogeneous", (below + above) / 2 / exact - 1)
    require(worst < 1e-7, "a state is wrong")
    require(below - 1e-8 < exact < above + 1e-8 and above - below < 1.0001e-4, "the pull-in is elsewhere")


def check_fibres(program, folder, what, rubber, target):
    """A free film with fibres in its plane."""
    case = program.run("planar_actuator", folder, *settings(
        rubber.options() | FREE | TO_THE_TARGET | {"Loading/Target": f"{target}"}))
    worst = compare(case, rubber, {0: "lambda_1", 2: "lambda_3"})
    print(f"{what}: states up to e = {target} off by {worst:.1e}")
    validated("planar_actuator", f"e, lambda_1 of every state, {what}", "exact, homogeneous", worst)
    require(worst < 1e-7, "a state is wrong")
    return case


def check_stiff_fibres(program, folder):
    """Fibres that keep x2 leave a film in plane strain, e^2 = 1 - lambda_1^-4, which does not pull in."""
    rubber = replace(with_fibres(0.05, 5e3, 0.0, [90.0]), ratio=1e5)
    curve = check_fibres(program, folder, "one stiff family", rubber, 0.98).curve("e", "lambda_1")
    worst = largest_error(curve, ["e"], lambda row: [np.sqrt(max(1 - row["lambda_1"]**-4, 0))])
    print(f"one stiff family: off e^2 = 1 - lambda_1^-4 by {worst:.1e}")
    require(worst < 1e-4, "the fibres give way")


def check_plane(program, folder):
    """In plane strain, the film in the x2-x3 plane with fibres across each other."""
    rubber, what = with_fibres(0.05, 0.05, 0.1, [45.0, -45.0], "x2-x3"), "crossed fibres in plane strain"
    case = program.run("verification/plane_film", folder, *settings(
        rubber.options() | TO_THE_TARGET | {"Loading/Target": "1.6"}))
    worst = compare(case, rubber, {0: "lambda_1"}, normal=0, held=1)
    print(f"{what}: states up to e = 1.6 off by {worst:.1e}")
    validated("verification/plane_film", f"e of every state, {what}", "exact, homogeneous", worst)
    require(worst < 1e-7, "a state is wrong")


def check_block_solver(program, folder, ranks):
    """A bent plate, a hundred times as stiff along crossed fibres, by the block solver."""
    rubber = with_fibres(0.05, 5.0, 0.1, [45.0, -45.0], "x2-x3")
    entries = rubber.options() | TO_THE_TARGET | {
        "Mesh/Parameters": "L: 20, W: 10, H: 1, n1: 4, n2: 2, n3: 4", "Loading/Target": "1",
        "Newton/Tolerance": "1e-13", "Linear solver/Tolerance": "1e-10"}
    direct, block = (program.run("benchmarks/bilayer", folder / solver, *settings(
        entries | {"Linear solver/Solver": solver}), ranks=ranks).curve("e", "tip_u1_mm", "tip_u3_mm")
                     for solver in ("direct", "block"))
    require(list(direct["e"]) == list(block["e"]), "the steps differ")
    worst = max(max(abs(block[name] - direct[name])) / max(abs(direct[name])) for name in ("tip_u1_mm", "tip_u3_mm"))
    print(f"stiff fibres, {ranks} rank(s): tip {direct['tip_u1_mm'][-1]:.6f} mm by the direct solver, the block "
          f"solver's off by {worst:.1e}")
    validated("benchmarks/bilayer", f"tip over a curve, stiff fibres, block solver, {ranks} rank(s)",
              "direct solver", worst)
    require(worst < 1e-9, "the solvers differ")


def main():
    program, all_ranks = program_and_ranks(__doc__)
    heated = replace(ogden({2.5: 0.1, -1.5: -0.05}, (0.05, 0.02), 323.0), alpha=1.8e-4)
    side_by_side(
        program,
        *((check_pull_in, ranks, "Ogden's rubber", ogden(TERMS), (0.70413, 1.2637)) for ranks in all_ranks),
        (check_pull_in, 1, "Ogden's rubber, heated", heated, None),
        *((check_pull_in, ranks, "Yeoh, five terms of Arruda and Boyce", series_of_chains(), (0.70402, 1.2988))
          for ranks in all_ranks),
        (check_pull_in, 1, "Yeoh, softening", yeoh(0.1386, [-0.0128, 2.41e-4]), None),
        *((check_pull_in, ranks, "Yeoh as an expression", as_expression(0.1386, [-0.0128, 2.41e-4]), None)
          for ranks in all_ranks),
        *((check_block_solver, ranks) for ranks in all_ranks),
        (check_fibres, "fibres at 30 degrees", with_fibres(0.05, 0.05, 0.2, [30.0, -30.0]), 1.1),
        (check_stiff_fibres,), (check_plane,))


if __name__ == "__main__":
    main()
