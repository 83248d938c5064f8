"""Planar films: free, under dead loads, prestretched with held sides, in plane strain.

A state is homogeneous: every element has it to Newton's tolerance, 1e-10 mu of stress, whose stretch error is
that over the smallest stiffness of the free stretches; 20 times this, and 1e-9, is allowed. An instability is

    of homogeneous stretches: within the bracket, 1e-4 of the field, and as much for its middle;
    of waves: between the field at which quadratic elements, fully integrated, lose their stability on the
    mesh halved in the plane, and that on the mesh itself (elements of degree 2) or the homogeneous one.
"""

import numpy as np

from validation import draw
from validation.film import Film, Waves, first_fold, first_wave
from validation.material import newton
from validation.scene import LAYERS, ROOT, Case, Verdict

BRACKET = 1e-4


class Drawn:
    """A film and its critical fields."""

    def __init__(self, film, cells):
        self.film, self.cells = film, cells
        one = draw.of_one(film.material)
        # Free films fold below e = 1.1; what is stable up to here goes on to where chains are stretched out.
        cap = 4 * film.held[0] * one if film.held[0] else 2 * one
        fold = first_fold(film, cap)
        self.fold = fold
        self.cap, self.hom = cap, fold.field if fold else cap
        self.wave = first_wave(film, cells, self.hom)
        fine = tuple(n if axis == 2 else 2 * n for axis, n in enumerate(cells))
        below = self.wave * (1 - 1e-5)
        y = film.at_field(below)
        self.low = self.wave
        if y is None or not Waves(film, fine).stable(y, below):
            self.low = first_wave(film, fine, self.wave, BRACKET / 4)
        self.waves_first = self.low < self.hom * (1 - BRACKET) or not fold
        self.is_pull_in = bool(fold) and fold.kind == "limit point" and not self.waves_first

    def interval(self, degree):
        """Between which fields an instability may be found."""
        if degree == 2 or not self.fold:
            longwave = self.wave < self.low * (1 + 2e-3)
            return self.low, self.wave if degree == 2 or longwave else np.inf
        return self.low, self.hom


def plane_or_not(rng):
    """(how the film is held, the film but for loads, cells)."""
    m = draw.material(rng)
    how = str(rng.choice(["free", "dead load", "biaxial load", "held", "plane strain"]))
    if how not in ("plane strain", "dead load") and rng.random() < 0.2:  # fibres that stay stretched
        m = draw.with_fibres(rng, m)
    if rng.random() < 0.3:
        m = draw.polarised(rng, m)
    cells = [(1, 1, 1), (2, 2, 1), (2, 2, 2)][rng.integers(3)]
    mu = float(m.mu * m.theta / m.theta_0)
    if how == "plane strain":
        size = (float(rng.uniform(2, 6)), 1.0, 1.0)
        return how, Film(m, size, held=(None, 1.0)), (int(rng.integers(1, 5)), 1, int(rng.integers(1, 3)))
    load, held = (0.0, 0.0), (None, None)
    if how == "dead load":
        load = (mu * float(rng.uniform(0.1, 1.5)), 0.0)
    if how == "biaxial load":
        first = mu * float(rng.uniform(0.1, 1.2))
        load = (first, first * float(rng.choice([1.0, rng.uniform(0.5, 1.0)])))
    if how == "held":
        first = float(rng.uniform(1.05, 4))
        held = (first, first if rng.random() < 0.5 else float(rng.uniform(1.05, 4)))
        if m.elastic == "Gent" and held[0]**2 + held[1]**2 > 0.7 * m.parameter:
            held = (1 + 0.2 * (held[0] - 1), 1 + 0.2 * (held[1] - 1))
    return how, Film(m, (5.0, 5.0, 1.0), load, held), cells


def case(rng, element):
    """A film in one of five ways, below an instability or up to one."""
    how, film, cells = plane_or_not(rng)
    if how == "held":  # where linear elements end elsewhere, and are not recommended: doc/elements.md
        element = element if element[1] == 2 else ("mean dilatation", 2)
    m, drawn = film.material, Drawn(film, cells)
    past = rng.random() < 0.6 and drawn.wave < 0.98 * drawn.cap
    voltage = drawn.wave * float(rng.uniform(1.1, 3)) if past else \
        drawn.low * draw.log_uniform(rng, 0.02, 0.93)
    follow = bool(past and drawn.fold and not drawn.waves_first and rng.random() < 0.4)
    entries = {"Temperature/Value": m.theta, "Loading/Control": "voltage", "Loading/Target": voltage,
               "Loading/Film thickness": 1, "Loading/Bracket": BRACKET * drawn.wave / draw.of_one(m),
               "Loading/Expected end": "pull-in" if past and not follow and drawn.is_pull_in else "target",
               "Stepping/Initial step": float(rng.choice([0.01, 0.05, 0.2])),
               **(plane_entries() if how == "plane strain" else space_entries(film))}
    if follow:
        entries["Stepping/Continuation"] = "automatic"
        entries["Loading/Until"] = f"{thickness(film)}: {float(0.85 * drawn.fold.stretches[2])!r}"
    if how == "plane strain":
        mesh, region = LAYERS, {"a": m, "b": m}
        parameters = {"L": film.size[0], "ha": 0.5, "hb": 0.5, "na": cells[2], "nb": cells[2], "n3": cells[0]}
        drawn.cells = (cells[0], 1, 2 * cells[2])
    else:
        mesh, region = ROOT / "meshes/box.geo", {"film": m}
        parameters = dict(zip(("n1", "n2", "n3"), cells))
    sides = " ".join("free" if stretch is None else f"{stretch:.4g}" for stretch in film.held)
    story = (f"film, {how}, {draw.told(m)}, " + " x ".join(map(str, drawn.cells)) + " cells, "
             f"load {film.load[0] / m.mu:.2g}, {film.load[1] / m.mu:.2g} mu, sides {sides}, to "
             f"{voltage / drawn.wave:.3g} of the critical field" + (", followed" if follow else ""))
    return Case("film", element, mesh, parameters, region, entries, story,
                lambda run: compare(run, drawn, element, voltage, past, follow))


def thickness(film):
    """The column with lambda_3 of the film."""
    return "lambda_1" if film.held[1] == 1 and film.held[0] is None else "lambda_3"


def plane_entries():
    """In the plane the thickness is along x1."""
    return {"Dimension": 2, "Supports/Fixed": "outer: u1, root: u3",
            "Electrodes/Potential": "outer: 0, back: 1", "Output/Observables": "lambda_1",
            "Observables/lambda_1/From": "outer", "Observables/lambda_1/To": "back"}


def space_entries(film):
    """Loads, held sides and supports of the film in space."""
    entries = {"Dimension": 3, "Supports/Fixed": "x1_min: u1, x2_min: u2, bottom: u3",
               "Electrodes/Potential": "bottom: 0, top: 1", "Output/Observables": "lambda_3",
               "Observables/lambda_3/From": "bottom", "Observables/lambda_3/To": "top"}
    forces = [f"x{i + 1}_max: " + " ".join(repr(float(load * 5.0)) if j == i else "0" for j in range(3))
              for i, load in enumerate(film.load) if load]
    stages = ["voltage 1"]
    if forces:
        entries["Loads/Force"] = ", ".join(forces)
        stages.insert(0, "force 1")
    if film.held[0]:
        entries["Supports/Moved"] = ", ".join(
            f"x{i + 1}_max: u{i + 1} {float(5.0 * (stretch - 1))!r}" for i, stretch in enumerate(film.held))
        stages.insert(0, "move 1")
    entries["Loading/Stages"] = ", ".join(stages)
    return entries


def compare(run, drawn, element, voltage, past, follow):
    """End, states and counts."""
    verdict, film = Verdict(), drawn.film
    low, high = drawn.interval(element[1])
    one = draw.of_one(film.material)
    if past and not follow:
        if run.bracket:
            middle = sum(run.bracket) / 2 * one
            verdict.errors.append(max(0.0, low / middle - 1, middle / high - 1))
            if not low * (1 - 1.5 * BRACKET) <= middle <= high * (1 + 1.5 * BRACKET):
                verdict.ends_wrongly(f"unstable at {middle:.6g} kV for {low:.6g} to {high:.6g} kV: {run.told()}")
            elif drawn.is_pull_in and run.exit_code != 0:
                verdict.ends_wrongly(f"a limit point, but {run.told()}")
        elif not (run.at_target and voltage < high):
            verdict.ends_wrongly(f"unstable at {low:.6g} to {high:.6g} kV, but {run.told()}")
    elif follow:
        compare_path(run, drawn, element, verdict)
    elif not run.at_target:
        verdict.ends_wrongly(f"stable up to {low:.6g} kV, target {voltage:.6g} kV, but {run.told()}")
    compare_states(run, drawn, element, verdict)
    return verdict


def compare_states(run, drawn, element, verdict):
    """Every row with a voltage below the first instability: its thickness, and that it is stable."""
    film, y, E = drawn.film, drawn.film.rest(), 0.0
    end = next((row for _, row in run.events()), None)  # behind an event are other branches
    rows = [row for row, V in enumerate(list(run.curve.get("voltage_kV", []))[:end])
            if 0 < V < min(drawn.low, drawn.hom) * 0.98]
    for row in rows[:40]:
        V = run.curve["voltage_kV"][row]
        if V < E:
            break  # the path has turned round
        for part in np.linspace(E, V, 12)[1:]:
            y = newton(lambda z, part=part: film.residual(z, part), y)
        E = V
        weakest = np.min(np.linalg.eigvalsh(film.hessian(y, E)))
        verdict.value(f"lambda_3 at {V:.5g} kV", run.curve[thickness(film)][row], y[-1],
                      1e-9 + 2e-9 / weakest)
        if run.curve.get("unstable_directions", [0] * (row + 1))[row]:
            verdict.disagreements.append(f"{run.curve['unstable_directions'][row]:.0f} unstable directions at "
                                         f"{V:.5g} kV, stable")


def compare_path(run, drawn, element, verdict):
    """The limit point or bifurcation, and the states and counts behind it."""
    film, fold, events = drawn.film, drawn.fold, run.events()
    name = fold.kind
    if not events:
        verdict.ends_wrongly(f"no {name} at {fold.field:.6g} kV: {run.told()}")
        return
    first, row = events[0]
    verdict.value(f"field of the {first}", run.curve["voltage_kV"][row], fold.field, 1e-6)
    if first != name:
        verdict.ends_wrongly(f"{first} for a {name}")
    if not run.at_target and "reached" not in run.told():
        verdict.ends_wrongly(f"the path goes on to its end, but {run.told()}")
    if name != "limit point":
        return
    waves = Waves(film, drawn.cells)
    y, E = film.at_field(fold.field * 0.98), fold.field
    for row in range(row + 1, len(run.curve["voltage_kV"])):
        found = film.at_thickness(run.curve[thickness(film)][row], y, E)
        if found is None:
            break
        y, E = found
        if any(row == at for _, at in events):
            continue  # the count of either side
        verdict.value("field on the unstable branch", run.curve["voltage_kV"][row], E, 1e-7)
        count, said = waves.count(y, E), run.curve["unstable_directions"][row]
        # A softer element may already see what full integration sees on a finer mesh.
        most = count if said <= count else Waves(film, [2 * n for n in drawn.cells]).count(y, E)
        if not (count <= said <= most if element[1] == 2 else said):
            verdict.disagreements.append(
                f"{said:.0f} unstable directions for {count} to {most} at lambda_3 {y[-1]:.5f}")
            break
