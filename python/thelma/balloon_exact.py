"""Exact states of an inflated spherical balloon with electrodes on both faces of its wall.

A shell A < R < B stays one, r(R), under a pressure p inside and a voltage V across it. With
lambda_r = r', lambda_t = r/R and the nominal electric displacement D = c/R^2 of the free energy
(doc/theory.md, eqs. 5 to 13; Gent's, eq. (6), with j = J_m/(J_m - I + 3) in place of 1)

    P_r = mu (j lambda_r - 1/lambda_r) + K ln J/lambda_r + D^2/(2 eps lambda_t^2)
    P_t = mu (j lambda_t - 1/lambda_t) + K ln J/lambda_t - D^2 lambda_r/(2 eps lambda_t^3)

are balanced by P_r' = 2 (P_t - P_r)/R, with P_r(A) = -p lambda_t(A)^2, P_r(B) = 0 and
V = int D lambda_r/(eps lambda_t^2) dR. That is integrated from A for a guess of r(A), p and c
(Dormand and Prince of order 8) until both ends and the voltage are right.

Of a thin incompressible wall, with e the dimensionless field, what is left is

    p A/(H mu) = 2 (j (lambda^-1 - lambda^-7) - e^2 lambda).

Units: mm, N, MPa, kV.
"""

from dataclasses import dataclass

import numpy as np
from scipy.integrate import solve_ivp
from scipy.optimize import brentq, fsolve, minimize_scalar

from thelma import planar_exact


@dataclass(frozen=True)
class State:
    """One equilibrium."""

    pressure: float  # MPa
    voltage: float  # kV
    inner: float  # deformed radii in mm
    outer: float

    @property
    def volume(self):
        """Of the inside of the whole balloon in mm^3."""
        return 4 / 3 * np.pi * self.inner**3


@dataclass(frozen=True)
class Balloon:
    """A shell of the default material, neo-Hookean or with Gent's J_m."""

    radius: float = 10.0  # A in mm
    thickness: float = 1.0
    J_m: float = np.inf
    material: planar_exact.Material = planar_exact.Material()
    theta: float = 293.0

    def stresses(self, l_r, l_t, D):
        """P_r and P_t in MPa."""
        mu, K, eps = self.material.mu(self.theta), self.material.K, self.material.eps(self.theta)
        j = 1 / (1 - (l_r**2 + 2 * l_t**2 - 3) / self.J_m)
        ln_J = np.log(l_r * l_t**2)
        return (mu * (j * l_r - 1 / l_r) + K * ln_J / l_r + D**2 / (2 * eps * l_t**2),
                mu * (j * l_t - 1 / l_t) + K * ln_J / l_t - D**2 * l_r / (2 * eps * l_t**3))

    def radial_stretch(self, P_r, l_t, D):
        """lambda_r that makes this P_r."""
        middle = l_t**-2
        return brentq(lambda l_r: self.stresses(l_r, l_t, D)[0] - P_r, 0.9 * middle, 1.1 * middle,
                      xtol=1e-15, rtol=1e-15)

    def integrate(self, inner, pressure, c):
        """(outer radius, P_r(B), V) from the inner face."""
        eps = self.material.eps(self.theta)

        def slopes(R, y):
            r, P_r, _ = y
            l_t, D = r / R, c / R**2
            l_r = self.radial_stretch(P_r, l_t, D)
            return l_r, 2 * (self.stresses(l_r, l_t, D)[1] - P_r) / R, D * l_r / (eps * l_t**2)

        A, B = self.radius, self.radius + self.thickness
        start = (inner, -pressure * (inner / A)**2, 0.0)
        return solve_ivp(slopes, (A, B), start, method="DOP853", rtol=1e-12, atol=1e-13).y[:, -1]

    def thin_pressure(self, stretch, e):
        """Pressure in MPa of the thin incompressible wall."""
        j = 1 / (1 - (2 * stretch**2 + stretch**-4 - 3) / self.J_m)
        elastic = j * (stretch**-1 - stretch**-7)
        mu = self.material.mu(self.theta)
        return 2 * mu * self.thickness / self.radius * (elastic - e**2 * stretch)

    def at_radius(self, inner, voltage=0.0):
        """The state with this inner radius, on any branch."""
        mu, eps = self.material.mu(self.theta), self.material.eps(self.theta)
        stretch = inner / self.radius
        c_of_V = eps * stretch**4 * (self.radius + self.thickness / 2)**2 / self.thickness

        def errors(unknown):
            pressure, c = unknown[0] * mu, unknown[1] * c_of_V
            _, P_r, V = self.integrate(inner, pressure, c)
            return P_r / mu, V - voltage

        e = self.material.e(voltage / self.thickness, self.theta)
        guess = (self.thin_pressure(stretch, e) / mu, voltage)
        found, _, success, message = fsolve(errors, guess, xtol=1e-13, full_output=True)
        if success != 1 and max(np.abs(errors(found))) > 1e-11:
            raise ValueError(message)
        outer = self.integrate(inner, found[0] * mu, found[1] * c_of_V)[0]
        return State(float(found[0] * mu), voltage, inner, float(outer))

    def at_pressure(self, pressure, voltage, low, high):
        """The state whose inner radius is between these two."""
        inner = brentq(lambda r: self.at_radius(r, voltage).pressure - pressure, low, high,
                       xtol=1e-12, rtol=1e-14)
        return self.at_radius(inner, voltage)

    def limit_point(self, voltage, low, high, sign=1):
        """The state of the largest pressure between two inner radii, or of the smallest (-1)."""
        found = minimize_scalar(lambda r: -sign * self.at_radius(r, voltage).pressure, bounds=(low, high),
                                method="bounded", options={"xatol": 1e-9})
        return self.at_radius(float(found.x), voltage)
