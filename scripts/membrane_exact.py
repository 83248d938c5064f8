"""Exact states of a thin circular membrane with an electrode in its middle.

The membrane of radius B is stretched by lambda_p in all directions and held by a rigid frame; its
electrode covers R < A. In the limit of small thickness every stress across it is that of the field
alone, and the state is one function r(R): with lambda_1 = r', lambda_2 = r/R and the free energy of a
homogeneous film (doc/theory.md, eqs. 5 to 10),

    lambda_i P_i = mu (lambda_i^2 - 1) + K ln J - eps/2 E^2 lambda_1 lambda_2/lambda_3,  i = 1, 2,
    lambda_3 P_3 = mu (lambda_3^2 - 1) + K ln J + eps/2 E^2 lambda_1 lambda_2/lambda_3 = 0

which gives lambda_3, the balance is (R P_1)' = P_2. Within the electrode the
equal-biaxial state lambda_1 = lambda_2 = lambda is a solution, and the only one that is regular in the
middle; from R = A on, r and P_1 go on continuously without field, until r(B) = lambda_p B finds lambda.

Units: mm, N, MPa, kV.
"""

from dataclasses import dataclass

import numpy as np
from scipy.integrate import solve_ivp
from scipy.optimize import brentq

import planar_exact


@dataclass(frozen=True)
class Membrane:
    """A membrane of the default material."""

    electrode: float = 4.0  # A in mm
    frame: float = 12.0  # B
    prestretch: float = 1.2
    material: planar_exact.Material = planar_exact.Material()
    theta: float = 293.0

    def forces(self, l_1, l_2, field):
        """P_1 and P_2 in MPa, with lambda_3 of P_3 = 0."""
        m = self.material
        mu, half = m.mu(self.theta), m.eps(self.theta) / 2 * field**2
        area = l_1 * l_2

        def thickness_force(l_3):
            return mu * (l_3**2 - 1) + m.K * np.log(area * l_3) + half * area / l_3

        l_3 = brentq(thickness_force, 0.5 / area, 1.5 / area, xtol=1e-15, rtol=1e-15)
        pressure, maxwell = m.K * np.log(area * l_3) - mu, half * area / l_3
        return ((mu * l_1**2 + pressure - maxwell) / l_1, (mu * l_2**2 + pressure - maxwell) / l_2)

    def radial_stretch(self, P_1, l_2):
        """lambda_1 of the passive part with this P_1."""
        return brentq(lambda l_1: self.forces(l_1, l_2, 0.0)[0] - P_1, 0.3, 5.0, xtol=1e-15,
                      rtol=1e-15)

    def passive(self, stretch, e):
        """r(B) for a stretch of the electrode."""
        P_1 = self.forces(stretch, stretch, self.material.field(e, self.theta))[0]

        def slopes(R, y):
            l_1 = self.radial_stretch(y[1], y[0] / R)
            return l_1, (self.forces(l_1, y[0] / R, 0.0)[1] - y[1]) / R

        return solve_ivp(slopes, (self.electrode, self.frame), (stretch * self.electrode, P_1),
                         method="DOP853", rtol=1e-11, atol=1e-12).y[0, -1]

    def electrode_stretch(self, e):
        """lambda within the electrode at a dimensionless field, up to where it wrinkles."""
        return brentq(lambda stretch: self.passive(stretch, e) - self.prestretch * self.frame,
                      self.prestretch, 1.5 * self.prestretch, xtol=1e-11)
