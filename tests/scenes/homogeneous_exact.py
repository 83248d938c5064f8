"""Exact stresses of homogeneous tests: uniaxial, pure shear or equibiaxial, with a field through the thickness
and a temperature that may change. In principal stretches, by SciPy's integrators.

With the laws of viscoelastic_exact.py, c_i = (s lambda_i)^2, the isochoric e_i = J^(-2/3) c_i exp(-a_i) of a
branch whose C_v is diag(exp a_i), and f, s, mu_0 as there, the stresses (of Kirchhoff) and the flow are

    t_i = f [m c_i - mu_0 + K ln J + sum G (e_i - mean e)] + z_i eps/2 e^2 J/(s^3 lambda_3^2),  z = (-1, -1, 1),
    a_i' = (e_i - mean e)/tau,

where J = s^3 lambda_1 lambda_2 lambda_3; t vanishes along the axes that are free. Without an elastic K that is
infinite; units as there.
"""

from dataclasses import dataclass, replace

import numpy as np
from scipy.integrate import solve_ivp

FREE = {"uniaxial": (1, 2), "pure shear": (2,), "equibiaxial": (2,)}
SIGNS = np.array([-1.0, -1.0, 1.0])


@dataclass
class Test:
    """A film (viscoelastic_exact.Film, whose branches may depend on theta) and the rows (t, stretch, theta, e)
    of a test."""

    film: object
    mode: str
    rows: np.ndarray

    __test__ = False  # for pytest

    def at(self, theta):
        """The film at a temperature."""
        return replace(self.film, theta=theta)

    def fixed(self, stretch):
        """Logarithms of the stretches, those that are free for a guess."""
        x = np.log(stretch)
        return {"uniaxial": np.array([x, -x / 2, -x / 2]), "pure shear": np.array([x, 0, -x]),
                "equibiaxial": np.array([x, x, -2 * x])}[self.mode]

    def stresses(self, film, x, a, field):
        """t, its derivatives to the logarithms x of the stretches, and e of the branches, at (2, n) values a."""
        f, growth = film.theta / film.theta_0, film.alpha * (film.theta - film.theta_0)
        c, volume = np.exp(2 * (x - growth)), x.sum() - 3 * growth
        m, slope = film.law.modulus(c.sum())
        e = np.exp(-2 * volume / 3) * c[:, None] * np.exp(-np.array([a[0], a[1], -a[0] - a[1]]))
        viscous = e - e.mean(axis=0)
        electric = film.eps / 2 * field**2 * np.exp(x.sum() - 2 * x[2])
        t = f * (m * c - film.law.modulus(3.0)[0] + film.K * volume + viscous @ film.G) + SIGNS * electric
        change = 2 * m * np.diag(c) + 2 * slope * np.outer(c, c) + film.K
        for G, one in zip(film.G, e.T):
            deviator = np.eye(3) - 1 / 3
            change += 2 * G * deviator @ np.diag(one) @ deviator
        return t, f * change - electric * np.outer(SIGNS, SIGNS), e

    def balance(self, film, stretch, a, field):
        """(nominal stress, e) where the free axes carry no stress."""
        x, free = self.fixed(stretch), list(FREE[self.mode])
        for _ in range(100):
            t, change, e = self.stresses(film, x, a, field)
            step = np.linalg.solve(change[np.ix_(free, free)], t[free])
            x[free] -= step / max(1.0, np.max(np.abs(step)) / 0.3)
            if np.max(np.abs(step)) < 1e-14:
                break
        t, _, e = self.stresses(film, x, a, field)
        return t[0] / stretch, e

    def relaxed(self):
        """Stresses of the rows in equilibrium."""
        return np.array([self.balance(self.resting(theta), stretch, np.zeros((2, 0)), field)[0]
                         for _, stretch, theta, field in self.rows])

    def resting(self, theta):
        """Without branches."""
        return replace(self.film, theta=theta, branches=())

    def in_time(self):
        """Stresses of the rows, from a first one in equilibrium at the stretch 1 without a field."""
        n = len(self.film.branches)
        a, result = np.zeros(2 * n), []
        for before, now in zip([self.rows[0], *self.rows], self.rows):
            if now[0] > before[0]:
                def slopes(t, a, before=before, now=now):
                    _, stretch, theta, field = before + (t - before[0]) / (now[0] - before[0]) * (now - before)
                    film = self.at(theta)
                    e = self.balance(film, stretch, a.reshape(2, n), field)[1]
                    return ((e - e.mean(axis=0)) / film.tau)[:2].ravel()
                found = solve_ivp(slopes, (before[0], now[0]), a, "DOP853", rtol=1e-11, atol=1e-12)
                a = found.y[:, -1]
            result.append(self.balance(self.at(now[2]), now[1], a.reshape(2, n), now[3])[0])
        return np.array(result)
