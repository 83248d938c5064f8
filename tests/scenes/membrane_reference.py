"""A thin round membrane in a rigid frame with an electrode in its middle, in plane stress.

Per volume of the mesh, with the stretches lambda_r = r', lambda_t = r/R and lambda_3,

    psi = f [mu/2 (s^2 (lambda_r^2 + lambda_t^2 + lambda_3^2) - 3 - 2 x) + K/2 x^2]
          - eps/2 E^2 lambda_r lambda_t/lambda_3,   x = ln(s^3 lambda_r lambda_t lambda_3),

E = 0 outside the electrode; s is the prestretch. lambda_3 makes psi stationary, and the radius obeys

    d(R P_r)/dR = P_t,   P_r = dpsi/dlambda_r,   P_t = dpsi/dlambda_t.

Under the electrode r is proportional to R; outside the equation is integrated up to the frame, and the
stretch under the electrode is that with which the frame does not move.
"""

import numpy as np
from scipy.integrate import solve_ivp
from scipy.optimize import brentq, fsolve


class Membrane:
    """Radii in mm, stresses in MPa."""

    def __init__(self, material, theta, electrode, frame):
        self.f, self.s = material.factor(theta), material.split(theta)
        self.mu, self.K, self.eps = material.mu(theta), material.K, material.eps(theta)
        self.electrode, self.frame = electrode, frame

    def forces(self, stretches, field):
        """lambda_i dpsi/dlambda_i for i = r, t, 3."""
        x = np.log(self.s**3 * np.prod(stretches))
        maxwell = self.eps / 2 * field**2 * stretches[0] * stretches[1] / stretches[2]
        elastic = self.mu * (self.s**2 * np.square(stretches) - 1) + self.K * x
        return self.f * elastic - maxwell * np.array([1, 1, -1])

    def thinned(self, in_plane, field=0.0):
        """lambda_3 of a stretch that is the same in all directions of the plane."""
        return brentq(lambda l_3: self.forces(np.array([in_plane, in_plane, l_3]), field)[2],
                      0.05, 2, xtol=1e-15)

    def frame_radius(self, in_plane, field):
        """Where the frame would be if the electrode were stretched so much."""
        start = np.array([in_plane, in_plane, self.thinned(in_plane, field)])
        guess = [start[0], start[2]]

        def stretches(R, y):
            def unbalanced(z):
                along, _, across = self.forces(np.array([z[0], y[0] / R, z[1]]), 0.0) / self.mu
                return [along - y[1] / self.mu * z[0], across]

            guess[:] = fsolve(unbalanced, guess, xtol=1e-10)
            return np.array([guess[0], y[0] / R, guess[1]])

        def slope(R, y):
            now = stretches(R, y)
            return [now[0], (self.forces(now, 0.0)[1] / now[1] - y[1]) / R]

        ends = (self.electrode, self.frame)
        begin = [in_plane * self.electrode, self.forces(start, field)[0] / in_plane]
        return solve_ivp(slope, ends, begin, method="DOP853", rtol=1e-9, atol=1e-11).y[0, -1]

    def state(self, field):
        """Stretch of the electrode and its lambda_3 under a nominal field in kV/mm."""
        in_plane = brentq(lambda l: self.frame_radius(l, field) - self.frame, 0.99, 1.3, xtol=1e-12)
        return in_plane, self.thinned(in_plane, field)
