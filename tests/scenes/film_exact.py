"""Exact limit points of homogeneous films of any law at 293 K: free in their plane, or in plane strain.

With w_i = lambda_i dW/dlambda_i / mu and e^2 lambda_1 lambda_2/lambda_3 the Maxwell stress over mu,
w_1 + w_3 = 0 and e^2 lambda_1 lambda_2/lambda_3 = w_1 - w_3 at the states without forces.
"""

import math

from scipy.optimize import brentq, minimize_scalar

NEO_HOOKEAN = ("neo-Hookean", 0)
GENT = ("Gent", 30)  # J_m
MOONEY_RIVLIN = ("Mooney-Rivlin", 0.5)  # share of the second invariant


def w(law, stretches, ratio):
    """(w_1, w_3) for K/mu = ratio (doc/theory.md, eqs. 13, 6, 8)."""
    name, number = law
    squares = [stretch**2 for stretch in stretches]
    pressure = ratio * math.log(math.prod(stretches))
    if name == "Gent":
        a = number / (number - sum(squares) + 3)
        return [a * square - 1 + pressure for square in squares[::2]]
    m = number
    return [(1 - m + m * (sum(squares) - square)) * square - 1 - m + pressure
            for square in squares[::2]]


def state(law, dimension, ratio, lambda_3):
    """(lambda_1, e)."""
    def stretches(l_1):
        return l_1, l_1 if dimension == 3 else 1.0, lambda_3

    l_1 = lambda_3**(-0.5 if dimension == 3 else -1)
    l_1 = brentq(lambda x: sum(w(law, stretches(x), ratio)), 0.97 * l_1, 1.03 * l_1, xtol=1e-15)
    w_1, w_3 = w(law, stretches(l_1), ratio)
    return l_1, math.sqrt((w_1 - w_3) * lambda_3 / math.prod(stretches(l_1)[:2]))


def limit_point(law, dimension, ratio):
    """e of the first limit point; Gent's film has none in plane strain."""
    thinnest = 0.35 if dimension == 3 else 0.18
    best = minimize_scalar(lambda l_3: -state(law, dimension, ratio, l_3)[1], method="bounded",
                           bounds=(thinnest, 0.95), options={"xatol": 1e-10})
    return -best.fun
