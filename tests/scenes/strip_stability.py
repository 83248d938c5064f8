"""When a strip between rigid walls, under a voltage and between two temperatures, leaves its straight
state: exactly, by its incremental equations.

The strip is F = diag(lambda_1(X_1), 1, 1) with free faces of given potential and temperature; D_1 and
Q_1 do not depend on X_1. Its ends slide along the walls, so that small changes

    u_1 = U cos, u_3 = W sin, phi = Phi cos, theta = T cos   (of k X_3, k = pi m/L)

fulfil the conditions there, and the balances of the changes of P, D and Q are ordinary differential
equations for (U, W, Phi, T, P_11, P_31, D_1, Q_1) across the thickness. The strip branches where they
have a solution with P_11 = P_31 = Phi = T = 0 on both faces. At a temperature that does not answer, T
and Q are left out. Derivatives of P, D and Q are complex-step ones, of the equations in
doc/theory.md.
"""

import math

import numpy as np
from scipy.optimize import brentq, fsolve

CONDUCTIVITY = 0.16  # W/(m K), as any other value
STEPS = 16  # of Runge and Kutta's method across the thickness


def fluxes(material, F, E, theta, gradient):
    """P_11, P_13, P_31, P_33, D_1, D_3, Q_1, Q_3 of an in-plane F = (F_11, F_13, F_31, F_33)."""
    F = np.array([[F[0], F[1]], [F[2], F[3]]])
    J = F[0, 0] * F[1, 1] - F[0, 1] * F[1, 0]
    inverse = np.array([[F[1, 1], -F[0, 1]], [-F[1, 0], F[0, 0]]]) / J
    G, s = inverse.T, material.split(theta)
    mu, eps = material.mu(theta), material.eps(theta)
    g = G @ E
    d = inverse @ g
    elastic = mu * (s**2 * F - G) + material.K * np.log(s**3 * J) * G
    P = material.factor(theta) * elastic + eps * J * (np.outer(g, d) - (g @ g) / 2 * G)
    return np.concatenate([P.ravel(), eps * J * d,
                           -CONDUCTIVITY * J * (inverse @ (inverse.T @ gradient))])


class Strip:
    """Of a thickness, between two temperatures, at a voltage."""

    def __init__(self, material, thickness, temperatures, voltage):
        self.material, self.h = material, thickness / STEPS
        self.temperatures = temperatures
        start = (material.eps(293) * voltage / thickness,
                 -CONDUCTIVITY * (temperatures[1] - temperatures[0]) / thickness)
        scale = np.array([start[0] or 1.0, abs(start[1]) or 1.0])

        def misfit(x):
            theta, phi = self.across(x * scale)
            return [(phi - voltage) / (voltage or 1), theta - temperatures[1]]

        self.D, self.Q = fsolve(misfit, start / scale, xtol=1e-12) * scale

    def local(self, theta, D):
        """lambda_1 and E_1 without P_11."""
        m, s = self.material, self.material.split(theta)
        mu, f, maxwell = m.mu(theta), m.factor(theta), D**2 / (2 * m.eps(theta))
        l_1 = 1 / s
        for _ in range(20):  # P_11 = 0
            force = f * (mu * (s**2 * l_1 - 1 / l_1) + m.K * math.log(s**3 * l_1) / l_1) + maxwell
            change = f * (mu * s**2 + (mu + m.K * (1 - math.log(s**3 * l_1))) / l_1**2)
            l_1 -= force / change
        return l_1, D * l_1 / m.eps(theta)

    def across(self, given, y=None, slope=None):
        """theta and the drop of phi at the far face for (D, Q), and `y` integrated beside them."""
        D, Q = given

        def slopes(state):
            l_1, E = self.local(state[0], D)
            gradient = -Q * l_1 / CONDUCTIVITY
            own = np.array([gradient, E])
            return own, slope(state[0], l_1, E, gradient) if slope else None

        state, h = np.array([self.temperatures[0], 0.0]), self.h
        for _ in range(STEPS):
            k1, m1 = slopes(state)
            k2, m2 = slopes(state + h / 2 * k1)
            k3, m3 = slopes(state + h / 2 * k2)
            k4, m4 = slopes(state + h * k3)
            state = state + h / 6 * (k1 + 2 * k2 + 2 * k3 + k4)
            if slope:
                s1 = m1 @ y
                s2 = m2 @ (y + h / 2 * s1)
                s3 = m3 @ (y + h / 2 * s2)
                s4 = m4 @ (y + h * s3)
                y = y + h / 6 * (s1 + 2 * s2 + 2 * s3 + s4)
        return y if slope else state

    def matrix(self, k, responds):
        """y' = M(X_1) y of the changes."""
        def slope(theta, l_1, E, gradient):
            base = np.array([l_1, 0, 0, 1, E, 0, theta, gradient, 0], dtype=complex)
            C = np.empty((8, 9))
            for column in range(9):
                x = base.copy()
                x[column] += 1e-30j
                C[:, column] = fluxes(self.material, x[:4], x[4:6], x[6], x[7:]).imag / 1e-30
            # From (U, W, Phi, T) and their slopes to what `fluxes` takes, amplitudes of cos or sin.
            zero, to = np.zeros((9, 4)), np.zeros((9, 4))
            to[0, 0] = to[2, 1] = to[7, 3] = 1
            to[4, 2] = -1
            zero[1, 0], zero[3, 1], zero[5, 2], zero[6, 3], zero[8, 3] = -k, k, k, 1, -k
            normal, along = C[[0, 2, 4, 6]], C[[1, 3, 5, 7]]
            n = 4 if responds else 3
            inverse = np.linalg.inv((normal @ to)[:n, :n])
            up = np.hstack([-inverse @ (normal @ zero)[:n, :n], inverse])
            # P_11' = -k P_13, P_31' = k P_33, D_1' = -k D_3, Q_1' = -k Q_3
            sign = k * np.array([-1, 1, -1, -1])[:n, None]
            down = sign * ((along @ zero)[:n, :n] @ np.eye(n, 2 * n) + (along @ to)[:n, :n] @ up)
            return np.vstack([up, down])
        return slope

    def determinant(self, k, responds=True):
        """Zero where the strip branches."""
        n = 4 if responds else 3
        free, zero = [0, 1, *range(n + 2, 2 * n)], [*range(2, n), n, n + 1]
        y = np.zeros((2 * n, n))
        y[free, range(n)] = 1
        return np.linalg.det(self.across((self.D, self.Q), y, self.matrix(k, responds))[zero])


def bifurcation(material, length, thickness, temperatures, nearby, theta, waves=1, responds=True):
    """Field e, defined at theta, between 0.999 and 1.001 of one nearby."""
    def determinant(e):
        voltage = material.field(e, theta) * thickness
        strip = Strip(material, thickness, temperatures, voltage)
        return strip.determinant(math.pi * waves / length, responds)
    return brentq(determinant, 0.999 * nearby, 1.001 * nearby, xtol=1e-9)
