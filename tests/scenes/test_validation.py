"""The independent solutions of scripts/validate against known numbers, and its verdicts."""

import csv
import math
import unittest
from pathlib import Path
from types import SimpleNamespace

import numpy as np

ROOT = Path(__file__).resolve().parents[2]
from scene import SCRIPTS  # noqa: F401  (first: finds the scripts)
from thelma import planar_exact
from validation import draws, scene
from validation.film import Film, Waves, first_fold, first_wave
from validation.layered import Layered, Solver
from validation.material import Material
from validation.strip import Strip


def dimensionless(film, field):
    return field * math.sqrt(film.material.eps / film.material.mu)


class Point(unittest.TestCase):
    def test_stress(self):
        """The gold values of an independent program, to all their digits."""
        m = Material(mu_law=(1.0,), eps_law=(1.0,), K=1000, alpha=2e-4, theta=320.0)
        P, D = m.stress(np.array([[1.1, .2, .05], [-.1, .95, .1], [.02, -.05, 1.05]]), np.array([.3, -.2, .5]))
        self.assertLess(np.max(np.abs(D - [.2797673461, -.3023365526, .5014645957])), 1e-10)
        gold = [[97.7615187739, 10.4430999135, -1.1721166319], [-20.6302681697, 112.1870458923, 5.6693437097],
                [-2.4893884127, -11.2717198995, 103.9004830036]]
        self.assertLess(np.max(np.abs(P - gold)), 1e-9)

    def test_laws_agree(self):
        """Slopes by principal stretches are the stress without a field; tangents are symmetric."""
        for law, parameter, dielectric, electric in (
                ("neo-Hookean", 0.0, "ideal", 0.0), ("Gent", 30.0, "ideal", 0.0), ("Mooney-Rivlin", 0.4, "ideal", 0.0),
                ("Yeoh", (-0.01, 4e-4), "electrostrictive", (0.2, -0.01)),
                ("Ogden", ((1.3, 0.9), (-2.0, 0.1)), "saturating", 4e-4),
                ("fibres", (2.0, 0.1, 30.0, -30.0), "saturating", 0.01)):
            m, l = Material(law, parameter, alpha=1e-4, theta=330.0, dielectric=dielectric, electric=electric), (
                1.4, 0.8, 0.95)
            for E in (0.0, 20.0):
                P, _ = m.stress(np.diag(l), np.array([0.0, 0.0, E]))
                self.assertLess(np.max(np.abs(m.slopes(l) - m.field_slopes(l, E) - np.diag(P))), 1e-12)
            A = m.tangent(np.diag(l) + 0.1 * np.eye(3)[::-1], np.array([3.0, 1.0, 20.0]))
            self.assertLess(np.max(np.abs(A - A.T)), 1e-12 * np.max(np.abs(A)))


class Films(unittest.TestCase):
    def test_pull_in(self):
        """The closed form of the free film, from 273 to 353 K."""
        for theta in (273.0, 293.0, 353.0):
            exact = planar_exact.limit_point(planar_exact.Material(alpha=1.8e-4), theta)
            found = first_fold(Film(Material(alpha=1.8e-4, theta=theta)), 40)
            self.assertAlmostEqual(found.field / exact.field, 1, delta=1e-8)
            self.assertEqual(found.kind, "limit point")

    def test_other_laws(self):
        """Mooney-Rivlin in space, neo-Hookean in plane strain; an equal dead load of mu (incompressible)."""
        for film, e, off in ((Film(Material("Mooney-Rivlin", 0.7, theta=303.0)), 0.89197, 1e-5),
                             (Film(Material(theta=303.0), held=(None, 1.0)), 1.01204, 1e-5),
                             (Film(Material(), load=(0.056552, 0.056552)), 0.358575, 1e-4)):
            self.assertAlmostEqual(dimensionless(film, first_fold(film, 50).field), e, delta=off)

    def test_treloar_and_kearsley(self):
        """Equal dead loads without a field: a Mooney-Rivlin sheet stays square only up to a load at
        which psi_11 = psi_12, here with the thickness in balance; neo-Hookean ones always do (Kearsley)."""
        for law, share, unequal in (("Mooney-Rivlin", 0.4, True), ("neo-Hookean", 0.0, False)):
            kinds = set()
            for load in np.linspace(0.5, 6, 12):
                film = Film(Material(law, share, (1.0,), K=1000), load=(load, load))
                y = film.rest()
                tangent = film.hessian(y, 0.0)
                kinds.add(bool(tangent[0, 0] < tangent[0, 1]))
            self.assertEqual(True in kinds, unequal)

    def test_prestretched(self):
        """A film stretched by 3 loses its ellipticity at sqrt(mu/eps (1 + 3/729)/9), incompressible."""
        m = Material(mu_law=(0.015,), K=1500, eps_law=(4.16e-5,))
        exact = math.sqrt(0.015 / 4.16e-5 / 9 * (1 + 3 / 729))
        found = first_wave(Film(m, held=(3.0, 3.0)), (2, 2, 2), 10.0)
        self.assertAlmostEqual(found / exact, 1, delta=2e-4)

    def test_stable_at_rest(self):
        """No unstable direction at rest, one behind the limit point of a single free film."""
        film = Film(Material(), (5.0, 5.0, 1.0))
        fold = first_fold(film, 40)
        waves = Waves(film, (1, 1, 1))
        self.assertEqual(waves.count(film.rest(), 0.0), 0)
        y, E = film.at_thickness(fold.stretches[2] * 0.99, film.at_field(fold.field * 0.99), fold.field)
        self.assertLess(E, fold.field)
        self.assertGreaterEqual(waves.count(y, E), 1)


class Curved(unittest.TestCase):
    def test_circle(self):
        """The table of an independent program."""
        with open(ROOT / "tests/reference/bilayer_bending.csv", newline="", encoding="utf8") as file:
            rows = [row for row in csv.DictReader(file) if 0 < float(row["e"]) < 0.7][::25]
        for row in rows:
            m = Material(alpha=float(row["alpha_per_K"]), theta=float(row["theta_K"]))
            solver = Solver(Layered("bilayer", ((1.0, m, True), (1.0, m, False))))
            y = solver.path(float(row["e"]) * math.sqrt(m.mu / m.eps), 12)
            self.assertAlmostEqual(-y[-1], float(row["curvature_times_layer_thickness_rad"]), delta=1e-8)

    def test_tube(self):
        """The table of an independent program."""
        with open(ROOT / "tests/reference/tube.csv", newline="", encoding="utf8") as file:
            rows = list(csv.DictReader(file))
        for row in rows:
            walls = (float(row["theta_inner_K"]), float(row["theta_outer_K"]))
            m, V = Material(alpha=1.8e-4, eps_law=(4.16138e-5,)), float(row["V_kV"])
            solver = Solver(Layered("tube", ((1.0, m, True),), 1.0, 0.0, walls))
            y = solver.path(V, 8)
            self.assertAlmostEqual(y[0], float(row["r_inner_mm"]), delta=1e-8)
            self.assertAlmostEqual(y[-1], float(row["r_outer_mm"]), delta=1e-8)
            self.assertAlmostEqual(solver.potential(y, V, 1.5), float(row["phi_at_R_1.5_kV"]), delta=1e-6)

    def test_balloon(self):
        """prm/balloon.prm, by the shooting of python/thelma/balloon_exact.py."""
        solver = Solver(Layered("balloon", ((1.0, Material(), True),), 10.0, 0.004))
        y = solver.path(15.0)
        self.assertAlmostEqual(y[0], 12.3709548, delta=1e-7)
        self.assertAlmostEqual(y[-1], 13.0537545, delta=1e-7)
        self.assertAlmostEqual(solver.limit(20.0), 16.1614, delta=1e-3)

    def test_column(self):
        """Euler's strain in the slender limit, with the second order of its slenderness."""
        for length in (20.0, 40.0, 80.0):
            euler = (math.pi / length)**2 / 12
            way, waves = Strip(Material(), length, 1.0).first_bifurcation(
                lambda way, length=length: (1 - way / length, 0.0), 2 * euler * length)
            self.assertEqual(waves, 1)
            self.assertAlmostEqual(way / length / euler, 1, delta=5 * euler + 1e-4)

    def test_charged_column(self):
        """A heated strip; the number is from an incremental analysis by another program."""
        m = Material(alpha=1e-5, theta=303.0)
        one = math.sqrt(m.mu / m.eps)
        found = Strip(m, 10.0, 1.0).first_bifurcation(lambda E: (1.0, E), 0.4 * one)
        self.assertAlmostEqual(found[0] / one, 0.181756, delta=1e-6)


class Draws(unittest.TestCase):
    def test_same_again(self):
        """A number and a seed are one scene, whatever else is drawn."""
        chosen = SimpleNamespace(seed=7, kind=None, all_elements=False)
        again = [scene.text(draws.drawn(chosen, number)) for number in (3, 5, 3)]
        self.assertEqual(again[0], again[2])
        self.assertNotEqual(again[0], again[1])

    def test_verdict(self):
        verdict = scene.Verdict()
        verdict.value("x", 1.0, 1.001, 1e-2)
        self.assertFalse(verdict.disagreements)
        verdict.value("x", math.nan, 1.0, 1e-2)
        verdict.value("x", 1.1, 1.0, 1e-2)
        self.assertEqual(len(verdict.disagreements), 2)


if __name__ == "__main__":
    unittest.main()
