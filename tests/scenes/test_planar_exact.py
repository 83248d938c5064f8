"""The exact planar actuator against derivatives of its energy and published values."""

import unittest
from pathlib import Path

import numpy as np

from thelma import planar_exact as exact

TEMPERATURES = (273.0, 293.0, 313.0, 333.0, 353.0)  # K
ACRYLIC = 1.8e-4  # thermal expansion, 1/K

# Dimensionless fields of the limit points by temperature, for both thermal expansions.
LIMIT_FIELDS = {
    0.0: (0.66349, 0.68737, 0.71044, 0.73278, 0.75447),
    ACRYLIC: (0.66469, 0.68737, 0.70916, 0.73015, 0.75041),
}
LIMIT_VOLTAGES = (30.61, 25.91, 22.18, 19.58, 18.27)  # kV over 1 mm, alpha = 0
SHEAR_MODULI = (0.084714, 0.056552, 0.038798, 0.028423, 0.023333)  # MPa


def complex_step(function, x):
    """Derivative of an analytic function to rounding."""
    return function(x + 1e-30j).imag / 1e-30


def hessian(m, theta, l1, l3, field):
    """Second derivative of psi with respect to (lambda_1, lambda_3) in MPa."""
    rows = []
    for weight, row in ((2, 0), (1, 1)):
        rows.append([
            weight * complex_step(lambda x: exact.stresses(m, theta, x, l3, field)[row], l1),
            weight * complex_step(lambda x: exact.stresses(m, theta, l1, x, field)[row], l3)])
    return np.array(rows)


def states():
    """Material, temperature, stretches and field of points off equilibrium."""
    for alpha in LIMIT_FIELDS:
        for theta in TEMPERATURES:
            yield exact.Material(alpha=alpha), theta, 1.13, 0.81, 11.7


class Derivatives(unittest.TestCase):
    def test_stresses(self):
        for m, theta, l1, l3, field in states():
            p_1, p_3 = exact.stresses(m, theta, l1, l3, field)
            dl1 = complex_step(lambda x: exact.psi(m, theta, x, l3, field), l1)
            dl3 = complex_step(lambda x: exact.psi(m, theta, l1, x, field), l3)
            self.assertAlmostEqual(p_1, dl1 / 2, delta=1e-15 * m.K)
            self.assertAlmostEqual(p_3, dl3, delta=1e-15 * m.K)

    def test_charge(self):
        for m, theta, l1, l3, field in states():
            slope = complex_step(lambda x: exact.psi(m, theta, l1, l3, x), field)
            self.assertAlmostEqual(exact.charge_per_area(m, theta, l1, l3, field), -slope,
                                   delta=1e-16)

    def test_energy_agrees_with_three_dimensional_form(self):
        """psi of C and E, written with tensors, at F = diag(lambda_1, lambda_1, lambda_3)."""
        for m, theta, l1, l3, field in states():
            F, E = np.diag([l1, l1, l3]), np.array([0, 0, field])
            J, J_theta = np.linalg.det(F), np.exp(3 * m.alpha * (theta - m.theta_0))
            C = F.T @ F
            J_em, C_em = J / J_theta, J_theta ** (-2 / 3) * C
            elastic = m.mu(theta) / 2 * (np.trace(C_em) - 3 - 2 * np.log(J_em))
            elastic += m.K / 2 * np.log(J_em) ** 2
            electric = -m.eps(theta) / 2 * J * E @ np.linalg.inv(C) @ E
            self.assertAlmostEqual(exact.psi(m, theta, l1, l3, field),
                                   theta / m.theta_0 * elastic + electric, delta=1e-14)


class Equilibria(unittest.TestCase):
    def test_curve_is_in_equilibrium(self):
        for alpha in LIMIT_FIELDS:
            m = exact.Material(alpha=alpha)
            for theta in TEMPERATURES:
                l3 = np.linspace(0.4, 0.99, 60)
                l1, field = exact.curve(m, theta, l3)
                for stress in exact.stresses(m, theta, l1, l3, field):
                    self.assertLess(np.max(np.abs(stress)), 3e-14 * m.K)

    def test_stable_state(self):
        for alpha in LIMIT_FIELDS:
            m = exact.Material(alpha=alpha)
            for theta in TEMPERATURES:
                limit = exact.limit_point(m, theta)
                for part in (0.0, 1e-3, 0.3, 0.9, 0.9999, 1.0):
                    field = part * limit.field
                    l1, l3 = exact.stable_state(m, theta, field)
                    self.assertGreaterEqual(l3, limit.lambda_3)
                    stress = exact.stresses(m, theta, l1, l3, field)
                    self.assertLess(np.max(np.abs(stress)), 1e-14 * m.K)

    def test_stable_state_is_stable(self):
        """Positive definite second derivative before the limit point, not after it."""
        m = exact.Material()
        limit = exact.limit_point(m, 293.0)
        for l3, stable in ((limit.lambda_3 + 1e-3, True), (limit.lambda_3 - 1e-3, False)):
            l1, field = exact.curve(m, 293.0, l3)
            self.assertEqual(np.linalg.det(hessian(m, 293.0, float(l1), l3, float(field))) > 0,
                             stable)

    def test_free_expansion(self):
        m = exact.Material(alpha=ACRYLIC)
        for stretch in exact.stable_state(m, 353.0, 0.0):
            self.assertAlmostEqual(stretch, np.exp(ACRYLIC * 60), delta=1e-15)

    def test_no_state_past_the_limit_point(self):
        m = exact.Material()
        with self.assertRaises(ValueError):
            exact.stable_state(m, 293.0, 1.0001 * exact.limit_point(m, 293.0).field)


class LimitPoints(unittest.TestCase):
    def test_shear_modulus(self):
        for theta, mu in zip(TEMPERATURES, SHEAR_MODULI):
            self.assertAlmostEqual(exact.Material().mu(theta), mu, delta=1e-6)

    def test_published_values(self):
        for alpha, values in LIMIT_FIELDS.items():
            for theta, e in zip(TEMPERATURES, values):
                limit = exact.limit_point(exact.Material(alpha=alpha), theta)
                self.assertAlmostEqual(limit.e, e, delta=1e-5)

    def test_nearly_incompressible(self):
        """e_c ~ sqrt(theta/theta_0) exp(-alpha dT/2), lambda_3c = 2^(-2/3) exp(alpha dT)."""
        for alpha in LIMIT_FIELDS:
            for theta in TEMPERATURES:
                limit = exact.limit_point(exact.Material(alpha=alpha), theta)
                stretch = np.exp(alpha * (theta - 293))
                e = np.sqrt(0.75 * theta / 293 / stretch) * 2 ** (-1 / 3)
                self.assertAlmostEqual(limit.e, e, delta=1e-5)
                self.assertAlmostEqual(limit.lambda_3, 2 ** (-2 / 3) * stretch, delta=5e-5)

    def test_voltage_falls_with_temperature(self):
        for theta, voltage in zip(TEMPERATURES, LIMIT_VOLTAGES):
            limit = exact.limit_point(exact.Material(), theta)
            self.assertAlmostEqual(limit.field, voltage, delta=0.005)

    def test_largest_field_of_the_curve(self):
        for alpha in LIMIT_FIELDS:
            m = exact.Material(alpha=alpha)
            for theta in TEMPERATURES:
                limit = exact.limit_point(m, theta)
                field = exact.curve(m, theta, limit.lambda_3 + np.linspace(-1e-3, 1e-3, 2001))[1]
                self.assertLessEqual(np.max(field), limit.field * (1 + 1e-15))
                self.assertAlmostEqual(np.max(field), limit.field, delta=1e-12 * limit.field)

    def test_incompressible(self):
        """e^2 = (theta/theta_0) (lambda^-2 - lambda^-8), largest at lambda = 2^(1/3)."""
        mu = exact.Material().mu(293.0)
        m = exact.Material(K=1e10 * mu)
        limit = exact.limit_point(m, 293.0)
        self.assertAlmostEqual(limit.e, np.sqrt(0.75) * 2 ** (-1 / 3), delta=1e-9)
        self.assertAlmostEqual(limit.e, 0.687365, delta=1e-6)
        self.assertAlmostEqual(limit.lambda_3, 2 ** (-2 / 3), delta=1e-8)
        l1, field = exact.curve(m, 293.0, 0.8)
        stretch = 0.8**-0.5
        self.assertAlmostEqual(float(l1), stretch, delta=1e-9)
        self.assertAlmostEqual(float(m.e(field, 293.0)),
                               np.sqrt(stretch**-2 - stretch**-8), delta=1e-9)

    def test_collapse(self):
        """Without expansion e_c grows like sqrt(theta/theta_0) if K/mu is kept."""
        for theta in TEMPERATURES:
            m = exact.Material()
            scaled = exact.Material(K=1000 * m.mu(theta))
            limit = exact.limit_point(scaled, theta)
            cold = exact.limit_point(exact.Material(K=1000 * m.mu(293.0)), 293.0)
            self.assertAlmostEqual(limit.e, cold.e * np.sqrt(theta / 293), delta=1e-14)
            self.assertAlmostEqual(limit.lambda_3, cold.lambda_3, delta=1e-12)


if __name__ == "__main__":
    unittest.main()
