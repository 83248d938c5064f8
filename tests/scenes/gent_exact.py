"""Exact homogeneous states of a planar film of Gent's rubber at 293 K.

With a = J_m/(J_m - 2 lambda_1^2 - lambda_3^2 + 3) and the ratio K/mu, dpsi/dlambda_i = 0 gives

    a (lambda_1^2 + lambda_3^2) - 2 + 2 (K/mu) ln(lambda_1^2 lambda_3) = 0,
    e^2 = a lambda_3 (1 - (lambda_3/lambda_1)^2).
"""

import math

from scipy.optimize import brentq, minimize_scalar


def stiffening(J_m, lambda_1, lambda_3):
    return J_m / (J_m - 2 * lambda_1**2 - lambda_3**2 + 3)


def field(J_m, ratio, lambda_3):
    """(lambda_1, e); ratio None: incompressible."""
    lambda_1 = lambda_3**-0.5
    if ratio:
        def residual(l_1):
            a = stiffening(J_m, l_1, lambda_3)
            return (a * (l_1**2 + lambda_3**2) - 2) / (2 * ratio) + math.log(l_1**2 * lambda_3)
        largest = math.sqrt((J_m + 3 - lambda_3**2) / 2) * (1 - 1e-12)
        lambda_1 = brentq(residual, 0.5 * lambda_1, min(2 * lambda_1, largest), xtol=1e-15)
    a = stiffening(J_m, lambda_1, lambda_3)
    return lambda_1, math.sqrt(max(a * lambda_3 * (1 - (lambda_3 / lambda_1) ** 2), 0.0))


def limit_points(J_m, ratio):
    """[(e, lambda_1)] of the peak and of the valley."""
    points = []
    for sign, low, high in ((-1, 0.3, 0.95), (1, 0.022, 0.3)):
        found = minimize_scalar(lambda l_3: sign * field(J_m, ratio, l_3)[1], method="bounded",
                                bounds=(low, high), options={"xatol": 1e-10})
        lambda_1, e = field(J_m, ratio, found.x)
        points.append((e, lambda_1))
    return points
