"""A thin round film, clamped at its rim, inflated and charged across its thickness: a membrane.

With the stretches lambda_s along the meridian, lambda_t = r/R and lambda_3, that of plane stress
(membrane_reference.py), and the tensions T_i = h P_i, the membrane inclined by alpha is balanced by

    d(R T_s cos alpha)/dR = T_t - p r lambda_s sin alpha,   R T_s sin alpha = p r^2/2,
    r' = lambda_s cos alpha,   z' = -lambda_s sin alpha.

The stretch of the middle is that with which the rim does not move.
"""

import numpy as np
from scipy.integrate import solve_ivp
from scipy.optimize import brentq, fsolve

from membrane_reference import Membrane


class Diaphragm(Membrane):
    """Radius and thickness in mm."""

    def __init__(self, material, theta, radius, thickness):
        super().__init__(material, theta, radius, radius)
        self.thickness = thickness

    def shape(self, middle, pressure, voltage):
        """(radius of the rim, height of the middle) if the middle were stretched so much."""
        field, h = voltage / self.thickness, self.thickness
        start = np.array([middle, middle, self.thinned(middle, field)])
        tension = h * self.forces(start, field)[0] / middle
        guess = [middle, start[2]]

        def slope(R, y):
            r, along, _ = y
            up = pressure * r**2 / (2 * R)
            pull = np.hypot(along, up)

            def unbalanced(z):
                s, _, across = self.forces(np.array([z[0], r / R, z[1]]), field) / self.mu
                return [s - pull / (h * self.mu) * z[0], across]

            guess[:] = fsolve(unbalanced, guess, xtol=1e-10)
            now = np.array([guess[0], r / R, guess[1]])
            around = h * self.forces(now, field)[1] / now[1]
            cosine, sine = along / pull, up / pull
            return [now[0] * cosine, (around - along - pressure * r * now[0] * sine) / R,
                    now[0] * sine]

        first = 1e-6 * self.frame
        end = solve_ivp(slope, (first, self.frame), [middle * first, tension, 0.0], method="DOP853",
                        rtol=1e-10, atol=1e-12).y[:, -1]
        return end[0], end[2]

    def height(self, pressure, voltage):
        """Of the middle above the rim in mm."""
        middle = brentq(lambda l: self.shape(l, pressure, voltage)[0] - self.frame, 1.05, 1.5,
                        xtol=1e-12)
        return self.shape(middle, pressure, voltage)[1]
