"""Checks python/thelma/viscoelastic_exact.py: the numbers of other programs; the free energy and
the flow in tensors; a delay by quadrature instead of integration in time."""

import math
from pathlib import Path

import numpy as np
from scipy.integrate import quad, solve_ivp
from scipy.optimize import brentq

from thelma import viscoelastic_exact as exact

BRANCHES = (exact.Branch(0.8, 0.5), exact.Branch(0.4, exact.wlf(3.0, 8, 90, 300)))
FILM = exact.Film(exact.Gent(1.0, 30.0), BRANCHES, K=40.0, eps=0.7, theta=320.0, theta_0=300.0,
                  alpha=1e-3)


def energy(F, E, C_vs):
    """psi of FILM at any F, E, complex ones too (doc/theory.md)."""
    film, f = FILM, FILM.theta / FILM.theta_0
    law, C, J = film.law, F.T @ F, np.linalg.det(F)
    J_theta = np.exp(3 * film.alpha * (film.theta - film.theta_0))
    C_EM, ln_J_EM = J_theta**(-2 / 3) * C, np.log(J / J_theta)
    C_iso = np.exp(-2 / 3 * ln_J_EM) * C_EM
    elastic = -law.mu / 2 * (law.J_m * np.log(1 - (np.trace(C_EM) - 3) / law.J_m) + 2 * ln_J_EM)
    viscous = sum(G / 2 * (np.trace(C_iso @ np.linalg.inv(C_v)) - 3) for G, C_v in zip(film.G, C_vs))
    return (f * (elastic + film.K / 2 * ln_J_EM**2 + viscous)
            - film.eps / 2 * J * E @ np.linalg.inv(C) @ E)


def stress(F, E, C_vs):
    """P = dpsi/dF by complex steps."""
    P = np.zeros((3, 3))
    for i in range(3):
        for J in range(3):
            step = np.zeros((3, 3), complex)
            step[i, J] = 1e-30j
            P[i, J] = energy(F + step, E, C_vs).imag / 1e-30
    return P


def flowed(deformation, t_end):
    """C_v of FILM's branches after F(t), by their equation in tensors."""
    def slopes(t, values):
        C_vs, F = values.reshape(-1, 3, 3), deformation(t)
        C_iso = np.linalg.det(F)**(-2 / 3) * F.T @ F
        return np.ravel([(C_iso - np.trace(C_iso @ np.linalg.inv(C_v)) / 3 * C_v) / tau
                         for C_v, tau in zip(C_vs, FILM.tau)])

    start = np.ravel([np.eye(3)] * len(FILM.tau))
    return solve_ivp(slopes, (0, t_end), start, rtol=1e-9, atol=1e-11).y[:, -1].reshape(-1, 3, 3)


def check_tension():
    """The sides are free and the stress is that of the tensors."""
    test = exact.stretched(FILM, (0, 1, 2), (1.5, 2.5, 1.2))

    def deformation(t):
        return np.diag([test.stretch(t), test.lateral(t), test.lateral(t)])

    for t in (0.7, 1.0, 1.6):
        P = stress(deformation(t), np.zeros(3), flowed(deformation, t))
        error = max(abs(P[0, 0] - test.stress(t)), abs(P[1, 1]), abs(P[2, 2]))
        print(f"tension, t = {t}: tensors differ by {error:.1e}")
        assert error < 1e-6


def check_voltage():
    """A film under a rising voltage, and under one that is held, is free of forces."""
    rising, kept = exact.ramped(FILM, 0.5), exact.held(FILM, 0.95, 50.0)
    assert rising.pulled_in and kept.pulled_in
    for name, film, field in (("rising", rising, lambda t: 0.5 * t), ("held", kept, lambda t: 0.95)):
        def deformation(t, film=film):
            thickness, lateral, _ = film.state(t)
            return np.diag([thickness, lateral, lateral])
        for t in (0.5 * film.t, 0.98 * film.t):
            P = stress(deformation(t), np.array([field(t), 0, 0]), flowed(deformation, t))
            print(f"voltage {name}, t = {t:.3f} of {film.t:.3f}: forces of {np.abs(P).max():.1e}")
            assert np.abs(P).max() < 1e-6 and film.imbalance(t) < 1e-10


def check_delay():
    """Spring and branch of modulus 1 under a field held: the elastic strain w of the branch and so its C_v
    are known at every lambda, and t = int (da/dlambda)/a' dlambda."""
    film, field = exact.unit_film(), 1.02 * exact.UNIT_FIELD

    def w(l):
        needed = field**2 * l**4 - (l**2 - l**-4)
        return brentq(lambda w: math.exp(-w) - math.exp(2 * w) - needed, -5, 5, xtol=1e-15)

    def time_per_stretch(l):
        force, stiffness = math.exp(-w(l)) - math.exp(2 * w(l)), math.exp(-w(l)) + 2 * math.exp(2 * w(l))
        w_slope = -(4 * field**2 * l**3 - 2 * l - 4 * l**-5) / stiffness
        return (-4 / l - 2 * w_slope) / (-2 / 3 * force)

    start = brentq(lambda l: 2 * (l**2 - l**-4) - field**2 * l**4, 1.01, 1.2, xtol=1e-15)
    found = exact.held(film, field, 100.0)
    exact_time = quad(time_per_stretch, start, found.lateral, epsabs=1e-12, epsrel=1e-12, limit=200)[0]
    print(f"delay {found.t:.10f}, by quadrature {exact_time:.10f}")
    assert abs(found.t - exact_time) < 1e-8


def check_laws():
    """Slopes of the moduli by differences, and the first terms of Arruda and Boyce's series."""
    for law in (exact.Gent(1.3, 40.0), exact.ArrudaBoyce(1.3, 3.0)):
        for I_1 in (3.0, 5.0, 20.0):
            slope = (law.modulus(I_1 + 1e-4)[0] - law.modulus(I_1 - 1e-4)[0]) / 2e-4
            assert abs(slope / law.modulus(I_1)[1] - 1) < 1e-6
    n = 1e4
    terms = (1 / 2, 1 / 20, 11 / 1050, 19 / 7000, 519 / 673750)
    series = sum(2 * (i + 1) * c * (20 / n)**i for i, c in enumerate(terms))
    assert abs(exact.ArrudaBoyce(1.0, 100.0).modulus(20.0)[0] - series) < 1e-13
    for r in (1e-4, 0.2, 0.7, 0.999):
        assert abs(exact.langevin(exact.inverse_langevin(r)) / r - 1) < 3e-15


assert exact.check_known()
check_laws()
check_delay()
check_tension()
check_voltage()
