"""Exact states of the planar actuator: a homogeneous block between two electrodes.

The block is free to expand in its plane, lambda_1 = lambda_2, and carries the nominal field E
through its thickness. From the free energy of the material (doc/theory.md), per reference volume,

    psi = f [mu/2 (s^2 (2 lambda_1^2 + lambda_3^2) - 3 - 2 x) + K/2 x^2]
          - eps/2 (lambda_1^2 / lambda_3) E^2,
    f = theta/theta_0,  s = exp(-alpha (theta - theta_0)),  x = ln(s^3 lambda_1^2 lambda_3),

the two equations dpsi/dlambda_1 = dpsi/dlambda_3 = 0 follow. Their combinations

    lambda_1/2 dpsi/dlambda_1 + lambda_3 dpsi/dlambda_3 = 0   (free of E),
    lambda_1/2 dpsi/dlambda_1 - lambda_3 dpsi/dlambda_3 = 0   (free of K)

give lambda_1 and E for every lambda_3, past the largest voltage (the limit point, pull-in) too.

Units: mm, N, MPa, kV, K. Fields are nominal, in kV/mm; multiply by the thickness for kV. The
dimensionless field is e = E sqrt(eps/mu(theta)).
"""

from dataclasses import dataclass
from functools import lru_cache

import numpy as np


def law(coefficients, theta):
    """c_0 + c_1 x + c_2 x^2 + ... with x = 1000 K / theta."""
    x = 1000.0 / theta
    return sum(c * x**n for n, c in enumerate(coefficients))


@dataclass(frozen=True)
class Material:
    """Neo-Hookean ideal dielectric; the defaults are those of the program."""

    alpha: float = 0.0  # linear thermal expansion, 1/K
    K: float = 56.552  # bulk modulus, MPa
    theta_0: float = 293.0  # reference temperature, K
    mu_law: tuple = (1.5180 / 3, -1.078 / 3, 0.2001 / 3)  # shear modulus, MPa
    eps_law: tuple = (3.98e-5,)  # permittivity, N/kV^2

    def mu(self, theta):
        """Shear modulus in MPa at theta in K."""
        return law(self.mu_law, theta)

    def eps(self, theta):
        """Permittivity in N/kV^2 at theta in K."""
        return law(self.eps_law, theta)

    def factor(self, theta):
        """Entropic factor theta/theta_0."""
        return theta / self.theta_0

    def split(self, theta):
        """s of F_EM = s F."""
        return np.exp(-self.alpha * (theta - self.theta_0))

    def field(self, e, theta):
        """Nominal field in kV/mm of the dimensionless field e."""
        return e * np.sqrt(self.mu(theta) / self.eps(theta))

    def e(self, field, theta):
        """Dimensionless field of a nominal field in kV/mm."""
        return field * np.sqrt(self.eps(theta) / self.mu(theta))


def psi(material, theta, lambda_1, lambda_3, field):
    """Free energy in MPa, without its parts that depend on temperature alone."""
    m, s = material, material.split(theta)
    x = np.log(s**3 * lambda_1**2 * lambda_3)
    invariant = s**2 * (2 * lambda_1**2 + lambda_3**2)
    elastic = m.mu(theta) / 2 * (invariant - 3 - 2 * x) + m.K / 2 * x**2
    return m.factor(theta) * elastic - m.eps(theta) / 2 * lambda_1**2 / lambda_3 * field**2


def stresses(material, theta, lambda_1, lambda_3, field):
    """P_11 = (dpsi/dlambda_1)/2 and P_33 = dpsi/dlambda_3 in MPa."""
    m, f, s2 = material, material.factor(theta), material.split(theta) ** 2
    mu, maxwell = m.mu(theta), m.eps(theta) / 2 * lambda_1**2 / lambda_3 * field**2
    pressure = m.K * np.log(s2**1.5 * lambda_1**2 * lambda_3) - mu
    p_1 = f * (mu * s2 * lambda_1**2 + pressure) - maxwell
    p_3 = f * (mu * s2 * lambda_3**2 + pressure) + maxwell
    return p_1 / lambda_1, p_3 / lambda_3


def scaled_lambda_1(ratio, scaled_lambda_3):
    """s lambda_1 for s lambda_3 without lateral force, ratio = K/mu (vectorised)."""
    a_3 = np.asarray(scaled_lambda_3, dtype=float)
    a_1 = a_3**-0.5
    for _ in range(50):
        residual = a_1**2 + a_3**2 - 2 + 2 * ratio * np.log(a_1**2 * a_3)
        step = residual / (2 * a_1 + 4 * ratio / a_1)
        a_1 = a_1 - step
        if np.all(np.abs(step) < 1e-15 * a_1):
            break
    return a_1


def curve(material, theta, lambda_3):
    """(lambda_1, E in kV/mm) of the equilibrium with thickness stretch lambda_3 (vectorised).

    Stable above the lambda_3 of the limit point, unstable under voltage control below it.
    """
    s, mu = material.split(theta), material.mu(theta)
    a_3 = s * np.asarray(lambda_3, dtype=float)
    a_1 = scaled_lambda_1(material.K / mu, a_3)
    e2 = material.factor(theta) * s * (1 - a_3 / a_1) * (1 + a_3 / a_1) * a_3
    return a_1 / s, material.field(np.sqrt(np.maximum(e2, 0.0)), theta)


def bisect(function, low, high):
    """Root of a function that is positive at low and negative at high, to the last digit."""
    while True:
        middle = (low + high) / 2
        if not low < middle < high:
            return middle
        if function(middle) > 0:
            low = middle
        else:
            high = middle


@dataclass(frozen=True)
class LimitPoint:
    """The largest voltage an equilibrium can carry."""

    e: float  # dimensionless field
    lambda_1: float
    lambda_3: float
    field: float  # nominal, kV/mm: the voltage in kV of a block 1 mm thick


@lru_cache(maxsize=None)
def limit_point(material, theta):
    """Pull-in under voltage control at theta in K."""
    s, ratio = material.split(theta), material.K / material.mu(theta)

    def slope(a_3):
        """d(e^2)/d(a_3) up to a positive factor, along the equilibria; a = s lambda."""
        a_1 = float(scaled_lambda_1(ratio, a_3))
        da_1 = -(a_3 + ratio / a_3) / (a_1 + 2 * ratio / a_1)
        return 1 - 3 * (a_3 / a_1) ** 2 + 2 * (a_3 / a_1) ** 3 * da_1

    lambda_3 = bisect(slope, 0.2, 1.0) / s
    lambda_1, field = (float(value) for value in curve(material, theta, lambda_3))
    return LimitPoint(float(material.e(field, theta)), lambda_1, lambda_3, field)


def free_expansion(material, theta):
    """Stretch without a field."""
    return 1 / material.split(theta)


def stable_state(material, theta, field):
    """(lambda_1, lambda_3) on the stable branch at a nominal field in kV/mm, to rounding.

    Raises ValueError past the limit point.
    """
    limit = limit_point(material, theta)
    if field > limit.field:
        raise ValueError(f"no equilibrium at {field} kV/mm: pull-in is at {limit.field} kV/mm")

    def excess(lambda_3):
        return float(curve(material, theta, lambda_3)[1]) - field

    lambda_3 = bisect(excess, limit.lambda_3, float(free_expansion(material, theta)))
    return float(curve(material, theta, lambda_3)[0]), lambda_3


def charge_per_area(material, theta, lambda_1, lambda_3, field):
    """Nominal electric displacement D = -dpsi/dE in N/(kV mm), that is uC/mm^2."""
    return material.eps(theta) * lambda_1**2 / lambda_3 * field
