"""Films under strong fields end where the body does, whatever the law, the prestretch, the mesh and
the steps.

    strong_fields.py THELMA_BINARY MPIEXEC SOURCE_DIR RANKS...

Truth: the fold of the homogeneous state and, for films whose sides are held and for counts of
unstable directions, a numpy element of its own with full integration on the same mesh
(scripts/validation/film.py).
"""

import json
import math

import numpy as np
from scene import program_and_ranks, require, settings, side_by_side, study, validated
from validation.film import Film, Waves, first_fold, first_wave
from validation.material import Material

LAWS = {"neo-Hookean": ("", 0.0), "Gent 15": ("Gent limit", 15.0), "Gent 30": ("Gent limit", 30.0),
        "Mooney-Rivlin 0.3": ("Second share", 0.3), "Mooney-Rivlin 0.5": ("Second share", 0.5),
        "Mooney-Rivlin 0.7": ("Second share", 0.7)}
ELEMENT = {"Discretisation/Formulation": "mean dilatation", "Discretisation/Degree": "2"}
SIDE = 5.0  # mm, of a film 1 mm thick
BOUND = 1.0001e-4  # relative, beside the bracket's own half width


def material(law):
    """The law at 293 K, with the default moduli."""
    return Material(elastic=law.split()[0], parameter=LAWS[law][1])


def law_options(law):
    """Entries that choose it."""
    entry, value = LAWS[law]
    chosen = {"Materials/elastomer/Elastic law": law.split()[0]}
    return chosen | ({f"Materials/elastomer/{entry}": str(value)} if entry else {})


def mesh(cells):
    """Entries of a film of so many cells."""
    return {"Mesh/Parameters": f"L1: {SIDE}, L2: {SIDE}, L3: 1, " +
                               ", ".join(f"n{i + 1}: {n}" for i, n in enumerate(cells))}


def free(law):
    """(film, entries) of a free film."""
    return Film(material(law)), {}


def pulled(law, load):
    """Under a dead load along x1, in multiples of mu."""
    stress = load * float(material(law).mu)
    return Film(material(law), load=(stress, 0.0)), {"Loads/Force": f"x1_max: {stress * SIDE} 0 0",
                                                     "Loading/Stages": "force 1, voltage 1"}


def held(law, stretch):
    """Stretched in its plane, then held at its sides."""
    way = SIDE * (stretch - 1)
    return (Film(material(law), held=(stretch, stretch)),
            {"Supports/Moved": f"x1_max: u1 {way}, x2_max: u2 {way}",
             "Loading/Stages": "move 1, voltage 1"})


def bracket(case):
    """(below, above) of the end, in kV/mm: the last state, and half the largest bracket on."""
    curve = case.curve("voltage_kV", "e")
    V, e = curve["voltage_kV"][-1], curve["e"][-1]
    return V, V * (1 + 1e-4 / e)


def check_end(program, folder, law, name, make, cells, *values):
    """The run ends at the first instability of the exact film on that mesh."""
    film, entries = make(law, *values)
    unit = math.sqrt(film.material.mu / film.material.eps)
    fold = first_fold(film, 3 * unit) if None in film.held else None
    limit = fold.field if fold else 20 * unit
    exact = first_wave(film, cells, limit)
    options = ELEMENT | law_options(law) | mesh(cells) | entries | {
        "Loading/Control": "voltage", "Loading/Target": str(1.5 * exact), "Output/Fields": "none",
        "Expectations/Final values": ""}
    is_fold = fold is not None and exact > (1 - 1e-5) * fold.field
    case = program.run("planar_actuator", folder, *settings(options), exit_code=0 if is_fold else 3)
    below, above = bracket(case)
    middle = (below + above) / 2
    print(f"{law}, {name}, {cells} cells: ends between {below:.5f} and {above:.5f} kV/mm, exactly "
          f"{exact:.5f}")
    validated("planar_actuator", f"end of a film, {law}, {name}, {cells} cells Q2/P1",
              "fold or first wave, numpy", middle / exact - 1)
    require(abs(middle - exact) < BOUND * exact + (above - below) / 2, "the film ends elsewhere")


def check_plane(program, folder, law):
    """In plane strain, where a film thins far before its fold."""
    film = Film(material(law), held=(None, 1.0))
    fold = first_fold(film, 3 * math.sqrt(film.material.mu / film.material.eps))
    case = program.run("verification/plane_film", folder, *settings(law_options(law)))
    below, above = case.pull_in()
    exact = fold.field * math.sqrt(film.material.eps / film.material.mu)
    print(f"{law} in plane strain: pull-in at {below:.6f} to {above:.6f}, exactly {exact:.6f}")
    validated("verification/plane_film", f"pull-in e, {law}", "exact, homogeneous",
              (below + above) / 2 / exact - 1)
    require(below - 1e-6 < exact < above + 1e-6, "the pull-in is elsewhere")


def check_counts(program, folder, law, cells):
    """The count of unstable directions of every state of the unstable branch."""
    case = program.run("hard/pull_in_loop", folder, *settings(
        ELEMENT | law_options(law) | mesh(cells) | {"Expectations/Final values": ""}))
    names = ("lambda_3", "voltage_kV", "unstable_directions", "event")
    curve = case.curve(*names)
    film, compared = Film(material(law)), 0
    waves = Waves(film, cells)
    for l_3, field, count, event in zip(*(curve[name] for name in names)):
        state = film.at_thickness(l_3, np.array([l_3**-0.5, l_3**-0.5, l_3]), field)
        if event or state is None:
            continue
        compared += 1
        require(count == waves.count(*state), f"{law}, lambda_3 = {l_3}: {count:.0f} unstable "
                                              f"directions, not {waves.count(*state)}")
    print(f"{law}, {cells} cells: the same unstable directions in {compared} states, "
          f"{curve['unstable_directions'][-1]:.0f} in the last one")
    require(compared > 10, "too few states were compared")


def check_artefacts(program, folder):
    """The modes of the enhanced element end films that are stable. Where they live within cells the run
    suspects them; not where Q2/P1 finds the film's own waves."""
    for formulation, degree, scene, entries, low, high, suspects in (
            ("enhanced strain", 1, "hard/creasing", {}, 1.17, 1.19, False),
            ("enhanced strain", 1, "planar_actuator", held("neo-Hookean", 1.3)[1] | mesh((4, 4, 2)),
             0.76, 0.78, True),
            ("mean dilatation", 2, "planar_actuator", held("neo-Hookean", 3.0)[1] | mesh((2, 2, 1)),
             0.331, 0.333, False)):
        program.run(scene, folder, *settings(entries | {
            "Discretisation/Formulation": formulation, "Discretisation/Degree": str(degree),
            "Loading/Target": "1.6", "Output/Fields": "none", "Expectations/Final values": ""}),
            exit_code=3)
        report = json.loads((folder / "run.json").read_text())
        e = study.Case(folder).curve("e")["e"][-1]
        print(f"{formulation}, {scene}: {e:.4f}, {report['reason']}")
        require(low < e < high, f"{scene} ends at {e}")
        require(("suspect the element" in report["reason"]) == suspects, report["reason"])


def check_steps(program, folder):
    """A state 0.1 % below the limit point of coarse cells, whose stabilisation answers to it, is the same
    however long the steps that lead there."""
    tips = []
    for step in (0.02, 0.05, 0.1):
        program.run("balloon", folder, *settings({
            "Mesh/Parameters": "R: 10, H: 1.39, n: 3, nr: 2", "Discretisation/Degree": "1",
            "Materials/elastomer/Elastic law": "Mooney-Rivlin", "Temperature/Value": "282",
            "Materials/elastomer/Second share": "0.5584946745657272",
            "Materials/elastomer/Bulk modulus": "12.182262650577876",
            "Materials/elastomer/Shear modulus": "0.015068770126823589",
            "Materials/elastomer/Permittivity": "2e-05, 6e-06",
            "Loads/Pressure": "inner: 0.0006226930549667217", "Loading/Target": "19.834",
            "Loading/Film thickness": "1.39", "Stepping/Initial step": f"{step}",
            "Stepping/Largest step": f"{step}", "Output/Fields": "none",
            "Expectations/Final values": ""}))
        tips.append(study.Case(folder).curve("tip_u1_mm")["tip_u1_mm"][-1])
    print(f"balloon, Q1/P0, tip at 19.834 kV: {tips} mm")
    require(max(tips) - min(tips) < 1e-6 * max(tips), f"the tips differ: {tips}")


def main():
    program, _ = program_and_ranks(__doc__)
    ends = [("neo-Hookean", "free", free, (2, 2, 2)), ("Gent 15", "free", free, (1, 1, 1)),
            ("Mooney-Rivlin 0.7", "free", free, (2, 2, 1)),
            ("Gent 15", "load 0.6 mu", pulled, (2, 2, 1), 0.6),
            ("Mooney-Rivlin 0.3", "load 1.5 mu", pulled, (1, 1, 1), 1.5),
            ("neo-Hookean", "held at 1.3", held, (2, 2, 1), 1.3),
            ("Gent 15", "held at 2", held, (2, 2, 1), 2.0),
            ("neo-Hookean", "held at 3", held, (2, 2, 1), 3.0),
            ("Gent 30", "held at 4", held, (1, 1, 1), 4.0),
            ("Mooney-Rivlin 0.7", "held at 4", held, (2, 2, 1), 4.0)]
    side_by_side(program, *((check_end, *end) for end in ends),
                 *((check_plane, law) for law in ("neo-Hookean", "Mooney-Rivlin 0.5")),
                 *((check_counts, law, cells) for law, cells in [
                     ("neo-Hookean", (2, 2, 1)), ("Gent 30", (1, 1, 1)),
                     ("Mooney-Rivlin 0.5", (2, 2, 1))]), (check_artefacts,), (check_steps,))


if __name__ == "__main__":
    main()
