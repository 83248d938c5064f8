"""Exact homogeneous states of the neo-Hookean film with a given lambda_1 and a given charge.

At constant nominal electric displacement D the free faces make

    W + K/2 x^2 + D^2 lambda_3/(2 eps lambda_1 lambda_2),  x = ln(lambda_1 lambda_2 lambda_3),

stationary in lambda_2 and lambda_3.
"""

import math

from scipy.optimize import fsolve


def state(material, theta, lambda_1, D):
    """(lambda_2, lambda_3, nominal field in kV/mm)."""
    mu, K, eps = material.mu(theta), material.K, material.eps(theta)

    def forces(stretch):
        l_2, l_3 = stretch
        pressure = K * math.log(lambda_1 * l_2 * l_3) - mu
        maxwell = D**2 * l_3 / (2 * eps * lambda_1 * l_2)
        return (mu * l_2**2 + pressure - maxwell) / mu, (mu * l_3**2 + pressure + maxwell) / mu

    l_2, l_3 = fsolve(forces, (lambda_1**-0.5, lambda_1**-0.5), xtol=1e-13)
    return l_2, l_3, D * l_3 / (eps * lambda_1 * l_2)
