"""When a strip between rigid walls buckles by heat, exactly.

Before it buckles F = diag(lambda_1, 1, 1) with free faces. Its ends slide along the walls, so that
the small displacements u_1 = U(X_1) cos(k X_3), u_3 = W(X_1) sin(k X_3), k = pi/L, fulfil the
conditions there, and the linearised balance of the stressed body with the moduli

    A_iJkL = f [mu s^2 d_ik d_JL + (mu - K x) G_iL G_kJ + K G_iJ G_kL],  x = ln det F_EM,

becomes ordinary differential equations across the thickness. It buckles where they have a
solution without forces on both faces.
"""

import math

import numpy as np
from scipy.linalg import expm
from scipy.optimize import brentq

from thelma import planar_exact


def moduli(material, theta):
    """A as a function of i, J, k, L (0, 2 for x1, x3)."""
    mu, K, s = material.mu(theta), material.K, material.split(theta)

    def force(l_1):
        return mu * s**2 * l_1**2 + K * math.log(s**3 * l_1) - mu

    lambda_1 = brentq(force, 0.9, 1.5, xtol=1e-15)
    x, G = math.log(s**3 * lambda_1), np.diag([1 / lambda_1, 1, 1])

    def A(i, J, k, L):
        return material.factor(theta) * (mu * s**2 * (i == k) * (J == L)
                                         + (mu - K * x) * G[i, L] * G[k, J] + K * G[i, J] * G[k, L])
    return A


def face_determinant(material, theta, length, thickness):
    """Zero where the strip buckles."""
    A, k = moduli(material, theta), math.pi / length
    # y' = M y with y = (U, W, p, q) and p, q the amplitudes of P_11, P_31.
    M = np.zeros((4, 4))
    M[0] = [0, -k * A(0, 0, 2, 2), 1, 0]
    M[0] /= A(0, 0, 0, 0)
    M[1] = [k * A(2, 0, 0, 2), 0, 0, 1]
    M[1] /= A(2, 0, 2, 0)
    # p' = k (k A_1313 U - A_1331 W'),  q' = k (A_3311 U' + k A_3333 W)
    M[2] = -k * A(0, 2, 2, 0) * M[1]
    M[2, 0] += k**2 * A(0, 2, 0, 2)
    M[3] = k * A(2, 2, 0, 0) * M[0]
    M[3, 1] += k**2 * A(2, 2, 2, 2)
    return np.linalg.det(expm(thickness * M)[2:, :2])


def linear_estimate(material, length, thickness):
    """Temperature rise at which 6 mu alpha dT is Euler's stress of the modulus 4 mu."""
    return math.pi**2 / (18 * material.alpha) * (thickness / length) ** 2


def buckling_temperature(alpha, length, thickness):
    """(exact, linear estimate) in K."""
    material = planar_exact.Material(alpha=alpha)
    estimate = linear_estimate(material, length, thickness)
    theta_0 = material.theta_0
    exact = brentq(lambda theta: face_determinant(material, theta, length, thickness),
                   theta_0 + 0.8 * estimate, theta_0 + 1.2 * estimate)
    return exact, theta_0 + estimate
