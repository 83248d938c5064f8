"""Point physics of doc/theory.md (eqs. 2 to 13), written anew for numpy.

Every function takes complex numbers as well: tangents are complex-step derivatives of P and D, exact
to rounding, and share no formula with the program's own.
"""

from dataclasses import dataclass, replace

import numpy as np

from validation import laws

STEP = 1e-30  # of a complex-step derivative: no difference is taken, so it cannot be too small


def law(coefficients, theta):
    """c_0 + c_1 x + c_2 x^2 + ... with x = 1000 K / theta."""
    x = 1000.0 / theta
    return sum(c * x**n for n, c in enumerate(coefficients))


@dataclass(frozen=True)
class Material:
    """A dielectric rubber at a temperature theta, a number or one for each point."""

    elastic: str = "neo-Hookean"
    parameter: object = 0.0  # of the elastic law (laws.py)
    mu_law: tuple = (1.5180 / 3, -1.078 / 3, 0.2001 / 3)
    eps_law: tuple = (3.98e-5,)
    K: float = 56.552
    alpha: float = 0.0
    theta_0: float = 293.0
    theta: object = 293.0
    dielectric: str = "ideal"
    electric: object = 0.0  # c_1, c_2 of an electrostrictive dielectric, P_s of a saturating one

    def at(self, theta):
        """The same material at another temperature."""
        return replace(self, theta=theta)

    @property
    def mu(self):
        """Shear modulus in MPa."""
        return law(self.mu_law, self.theta)

    @property
    def eps(self):
        """Permittivity in N/kV^2."""
        return law(self.eps_law, self.theta)

    @property
    def split(self):
        """s of F_EM = s F."""
        return np.exp(-self.alpha * (self.theta - self.theta_0))

    def slopes(self, stretches):
        """dpsi/dlambda_i without the field, of three principal stretches (first index)."""
        s, f = self.split, self.theta / self.theta_0
        a = [s * stretch for stretch in stretches]
        volume = self.K * np.log(a[0] * a[1] * a[2])
        shear = laws.slopes(self.elastic, self.parameter, a)
        return np.array([f * s * (self.mu * shear[i] + volume / a[i]) for i in range(3)])

    def field_slopes(self, stretches, E):
        """What a nominal field along lambda_3 takes from them."""
        return laws.field_slopes(self.dielectric, self.electric, self.eps, stretches, E)

    def stress(self, F, E):
        """(P, D) of a deformation gradient and a nominal field."""
        s, f = self.split, self.theta / self.theta_0
        P, D = laws.field_stress(self.dielectric, self.electric, self.eps, F, E)
        volume = self.K * np.log(s**3 * np.linalg.det(F)) * np.linalg.inv(F).T
        return P + f * (s * self.mu * laws.stress(self.elastic, self.parameter, s * F) + volume), D

    def tangent(self, F, E):
        """The 12 x 12 second derivatives of psi by (Grad u, Grad phi), E = -Grad phi."""
        result = np.zeros((12, 12))
        for column in range(12):
            dF, dE = np.array(F, dtype=complex), np.array(E, dtype=complex)
            if column < 9:
                dF[column // 3, column % 3] += 1j * STEP
            else:
                dE[column - 9] -= 1j * STEP
            P, D = self.stress(dF, dE)
            result[:9, column], result[9:, column] = P.imag.ravel() / STEP, D.imag / STEP
        return result


def newton(residual, start, tolerance=1e-12, iterations=60):
    """The root of a vector function of complex numbers; None where Newton's method finds none."""
    y = np.array(start, dtype=float)
    for _ in range(iterations):
        value, slope = linearised(residual, y)
        if not np.all(np.isfinite(value)) or not np.all(np.isfinite(slope)):
            return None
        try:
            step = np.linalg.solve(slope, value)
        except np.linalg.LinAlgError:
            return None
        y = y - step
        if np.max(np.abs(step)) < tolerance * max(1.0, np.max(np.abs(y))):
            return y
    return None


def linearised(residual, y):
    """A vector function and its Jacobian."""
    columns = []
    for i in range(len(y)):
        probe = np.array(y, dtype=complex)
        probe[i] += 1j * STEP
        columns.append(residual(probe).imag / STEP)
    return residual(np.array(y, dtype=complex)).real, np.array(columns).T
