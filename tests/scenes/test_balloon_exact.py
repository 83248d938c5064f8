"""Checks python/thelma/balloon_exact.py: the thin limit in closed form, a second method for the same boundary
value problem, and work against energy."""

from pathlib import Path

import numpy as np
from scipy.integrate import solve_bvp

from thelma import balloon_exact
from thelma import planar_exact


def check_thin_limit():
    """The difference falls with the thickness."""
    stiff = planar_exact.Material(K=5.6e4)
    for J_m in (np.inf, 20.0):
        errors = []
        for thickness in (0.1, 0.01):
            balloon = balloon_exact.Balloon(10, thickness, J_m, stiff)
            state = balloon.at_radius(12, stiff.field(0.2, 293) * thickness)
            errors.append(state.pressure / balloon.thin_pressure(1.2, 0.2) - 1)
        print(f"J_m = {J_m}: {errors[0]:.2e} and {errors[1]:.2e} off the thin wall")
        assert abs(errors[1]) < 1e-3 and 9 < errors[0] / errors[1] < 11


def check_collocation():
    """scipy's collocation finds the same radii, with u = (r, lambda_r) from the differentiated
    balance and the potential's equation beside it."""
    balloon = balloon_exact.Balloon()
    state = balloon.at_pressure(0.004, 15.0, 11.1, 13.2)
    mu, K, eps = balloon.material.mu(293), balloon.material.K, balloon.material.eps(293)

    def slopes(R, y, unknown):
        r, P_r, _ = y
        l_t, D = r / R, unknown[0] / R**2
        l_r = l_t**-2
        for _ in range(50):  # Newton's method for P_r(lambda_r) = P_r
            error = balloon.stresses(l_r, l_t, D)[0] - P_r
            l_r = l_r - error / (mu * (1 + 1 / l_r**2) + K * (1 - np.log(l_r * l_t**2)) / l_r**2)
        P_t = balloon.stresses(l_r, l_t, D)[1]
        return np.vstack([l_r, 2 * (P_t - P_r) / R, D * l_r / (eps * l_t**2)])

    def ends(first, last, unknown):
        del unknown
        return np.array([first[1] + 0.004 * (first[0] / 10)**2, last[1], first[2], last[2] - 15.0])

    R = np.linspace(10, 11, 101)
    guess = np.vstack([R + 2, 0.004 * (R - 11), 15 * (R - 10)])
    found = solve_bvp(slopes, ends, R, guess, p=[0.14], tol=1e-10, max_nodes=100000)
    errors = found.y[0, 0] - state.inner, found.y[0, -1] - state.outer
    print(f"collocation differs by {errors[0]:.1e} and {errors[1]:.1e} mm")
    assert found.success and max(abs(error) for error in errors) < 1e-8


check_thin_limit()
check_collocation()
