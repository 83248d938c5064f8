"""The exact circle of the bending actuator against the table of an independent program."""

import csv
import unittest
from collections import defaultdict
from pathlib import Path

import numpy as np

ROOT = Path(__file__).resolve().parents[2]
from thelma import bending_exact
from thelma import creeping_exact
from thelma.planar_exact import Material
from thelma.viscoelastic_exact import Branch


def reference():
    """(alpha, theta) -> rows of (e, curvature, interface radius)."""
    table = defaultdict(list)
    with open(ROOT / "tests/reference/bilayer_bending.csv", newline="") as file:
        for row in csv.DictReader(file):
            table[float(row["alpha_per_K"]), float(row["theta_K"])].append(
                [float(row[name]) for name in ("e", "curvature_times_layer_thickness_rad",
                                               "interface_radius_over_layer_thickness")])
    return table


class Bending(unittest.TestCase):
    def test_table(self):
        table = reference()
        self.assertEqual(len(table), 10)
        for (alpha, theta), rows in table.items():
            states = bending_exact.circles(Material(alpha=alpha), theta, [row[0] for row in rows])
            for state, (_, curvature, radius) in zip(states, rows):
                self.assertAlmostEqual(state.curvature, curvature, delta=2e-9 + 1e-8 * curvature)
                self.assertAlmostEqual(state.stretch / state.curvature / radius, 1, delta=2e-6)

    def test_gradient(self):
        """Gradient and Hessian of Pi belong together, with and without branches."""
        creeping = creeping_exact.CreepingBilayer(Material(alpha=1.8e-4), 353.0,
                                                  [Branch(0.05, 1.0), Branch(0.1, 2.0)])
        creeping.a += 0.3 * np.sin(np.arange(creeping.a.size)).reshape(creeping.a.shape)
        for bilayer in (bending_exact.Bilayer(Material(alpha=1.8e-4), 353.0), creeping):
            self.check_gradient(bilayer)

    def check_gradient(self, bilayer):
        y, e = bilayer.start(), 0.6
        y += 0.01 * np.sin(np.arange(len(y)))
        y[-1] = 0.1
        hessian = bilayer.system(y, e)[1]
        step = 1e-6 * np.cos(np.arange(len(y)))
        difference = bilayer.system(y + step, e)[0] - bilayer.system(y - step, e)[0]
        error = np.max(np.abs(difference - 2 * hessian @ step))
        self.assertLess(error, 1e-6 * np.max(np.abs(difference)))

    def test_small_field(self):
        """kappa h = 3/16 e^2."""
        state = bending_exact.circles(Material(), 293.0, [0.02])[0]
        self.assertAlmostEqual(state.curvature / 0.02**2, 3 / 16, delta=1e-3)

    def test_small_creep(self):
        """A branch as stiff as the rest: half of that at once, the rest in 2 tau."""
        m = Material()
        times = np.array([0.0, 1.0, 5.0])
        states = creeping_exact.creep(m, 293.0, [Branch(m.mu(293.0), 1.5)], 0.02, times)
        for state, t in zip(states, times):
            part = 1 - np.exp(-t / 3) / 2
            self.assertAlmostEqual(state.curvature / 0.02**2, 3 / 16 * part, delta=1e-3)

    def test_no_field(self):
        """Free expansion in the plane, and no bending."""
        state = bending_exact.circles(Material(alpha=1.8e-4), 353.0, [0.0])[0]
        self.assertAlmostEqual(state.curvature, 0, delta=1e-12)
        self.assertAlmostEqual(state.tip(40), 0, delta=1e-9)
        self.assertAlmostEqual(state.stretch, np.exp(1.5 * 1.8e-4 * 60), delta=1e-4)


if __name__ == "__main__":
    unittest.main()
