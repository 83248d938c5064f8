#!/usr/bin/env python3
"""Exact histories of a homogeneous viscoelastic film: stretched along one axis, or under a voltage.

  python/thelma/viscoelastic_exact.py    compares with known numbers; exit code 1 if one is missed

Axisymmetric states F = diag(l_x, l_z, l_z): l_x is the stretch along the pulled axis, or across the
thickness of the film; the faces around the axis are free. With x = ln l_x, z = ln l_z and a branch's
C_v = diag(exp(a), exp(-a/2), exp(-a/2)) the free energy of the material (doc/theory.md) is

    psi = f [ W(I_1) - mu_0 ln J + K/2 ln^2 J + sum G_i/2 (exp(2 w_i) + 2 exp(-w_i) - 3) ]
          - eps e^2/2 exp(2 z - x),
    f = theta/theta_0,  s = exp(-alpha (theta - theta_0)),  J = s^3 l_x l_z^2,
    I_1 = s^2 (l_x^2 + 2 l_z^2),  mu_0 = 2 W'(3),  w_i = 2/3 (x - z) - a_i/2,

with the nominal field e, and the flow C_v' = (C_iso - (C_iso : C_v^-1)/3 C_v)/tau becomes

    a_i' = 2/3 (exp(2 w_i) - exp(-w_i))/tau_i.

K = inf is incompressible: J = 1. A film under voltage is followed along its path by a parameter p in
which pull-in is an ordinary point: with the balance R(y, a, e) = dpsi/dy = 0 of the free log stretches y,

    dt/dp = det R_y,   dy/dp = -adj(R_y) (R_a a' + R_e e'),   da/dp = a' dt/dp,

and pull-in is where det R_y = 0: nothing but inertia can balance the film then, since C_v is continuous.

Any consistent units: moduli, stress, eps e^2 and work per volume in one of them; K for theta.
"""

import math
import sys
from dataclasses import dataclass, replace
from functools import cached_property
from typing import Callable, Union

import numpy as np
from scipy.integrate import solve_ivp
from scipy.optimize import brentq

TOLERANCE = {"rtol": 1e-12, "atol": 1e-13}
GAS_CONSTANT = 8.314462618  # J/(mol K)


def langevin(x):
    """coth x - 1/x, below 1 by its continued fraction."""
    if x > 1:
        return 1 / math.tanh(x) - 1 / x
    fraction = 19.0
    for odd in range(17, 1, -2):
        fraction = odd + x * x / fraction
    return x / fraction


def langevin_slope(x):
    """1/x^2 - 1/sinh^2 x."""
    if x > 2:
        return 1 / x**2 - 4 * math.exp(-2 * x) / math.expm1(-2 * x)**2
    value = langevin(x)
    return 1 - value**2 - 2 * value / x


def inverse_langevin(r):
    """x with langevin(x) = r, 0 < r < 1, by Newton's method from Cohen's approximation."""
    x = r * (3 - r * r) / (1 - r * r)
    for _ in range(50):
        step = (langevin(x) - r) / langevin_slope(x)
        x -= step
        if abs(step) < 4e-16 * x:
            break
    return x


@dataclass(frozen=True)
class NeoHookean:
    """W = mu/2 (I_1 - 3)."""

    mu: float

    def modulus(self, _):
        """2 dW/dI_1 and its slope at an I_1."""
        return self.mu, 0.0


@dataclass(frozen=True)
class Gent:
    """W = -mu J_m/2 ln(1 - (I_1 - 3)/J_m)."""

    mu: float
    J_m: float

    def modulus(self, I_1):
        """2 dW/dI_1 and its slope."""
        left = self.J_m - I_1 + 3
        return self.mu * self.J_m / left, self.mu * self.J_m / left**2


@dataclass(frozen=True)
class ArrudaBoyce:
    """2 dW/dI_1 = G/(3 r) L^-1(r), r = sqrt(I_1/3)/locking."""

    G: float
    locking: float

    def modulus(self, I_1):
        """2 dW/dI_1 and its slope."""
        r = math.sqrt(I_1 / 3) / self.locking
        x = inverse_langevin(r)
        return self.G * x / (3 * r), self.G * (1 / langevin_slope(x) - x / r) / (6 * I_1)


OfTheta = Union[float, Callable[[float], float]]


@dataclass(frozen=True)
class Branch:
    """A Maxwell element; G and tau are numbers or functions of theta."""

    G: OfTheta
    tau: OfTheta


def arrhenius(tau_0, activation, theta_r):
    """tau(theta) with an activation energy in J/mol."""
    return lambda theta: tau_0 * math.exp(activation / GAS_CONSTANT * (1 / theta - 1 / theta_r))


def wlf(tau_0, C_1, C_2, theta_r):
    """tau(theta) of Williams, Landel and Ferry."""
    return lambda theta: tau_0 * 10**(-C_1 * (theta - theta_r) / (C_2 + theta - theta_r))


@dataclass(frozen=True)
class Film:
    """A film at a constant temperature; the law is that at theta."""

    law: object
    branches: tuple = ()
    K: float = math.inf
    eps: float = 1.0
    theta: float = 293.0
    theta_0: float = 293.0
    alpha: float = 0.0

    @property
    def incompressible(self):
        """Without volumetric energy."""
        return math.isinf(self.K)

    def of_branches(self, name):
        """Their G or tau at theta."""
        values = (getattr(branch, name) for branch in self.branches)
        return np.array([v(self.theta) if callable(v) else v for v in values], dtype=float)

    @cached_property
    def G(self):
        """Moduli of the branches."""
        return self.of_branches("G")

    @cached_property
    def tau(self):
        """Relaxation times."""
        return self.of_branches("tau")

    @property
    def rest(self):
        """Log stretch without any load."""
        return self.alpha * (self.theta - self.theta_0)

    @cached_property
    def basis(self):
        """(x, z) - rest = basis @ y of the free log stretches y of a film under voltage."""
        return np.array([[1.0], [-0.5]]) if self.incompressible else np.eye(2)

    def elastic_strain(self, x, z, a):
        """w of the branches."""
        return 2 / 3 * (x - z) - a / 2

    def flow(self, x, z, a):
        """da/dt."""
        w = self.elastic_strain(x, z, a)
        return 2 / 3 * (np.exp(2 * w) - np.exp(-w)) / self.tau

    def gradient(self, x, z, a, q=0.0):
        """dpsi/d(x, z), without K if incompressible; q = eps e^2."""
        f, (c_x, c_z) = self.theta / self.theta_0, np.exp(2 * (np.array([x, z]) - self.rest))
        w = self.elastic_strain(x, z, a)
        m, m_0 = self.law.modulus(c_x + 2 * c_z)[0], self.law.modulus(3.0)[0]
        pressure = (0 if self.incompressible else self.K) * (x + 2 * z - 3 * self.rest) - m_0
        viscous = 2 / 3 * np.sum(self.G * (np.exp(2 * w) - np.exp(-w)))
        maxwell = q / 2 * math.exp(2 * z - x)
        return np.array([f * (m * c_x + pressure + viscous) + maxwell,
                         f * (2 * (m * c_z + pressure) - viscous) - 2 * maxwell])

    def tangents(self, x, z, a, q=0.0):
        """Derivatives of the gradient to (x, z) and to a."""
        f, (c_x, c_z) = self.theta / self.theta_0, np.exp(2 * (np.array([x, z]) - self.rest))
        w = self.elastic_strain(x, z, a)
        m, slope = self.law.modulus(c_x + 2 * c_z)
        K = 0 if self.incompressible else self.K
        stiffness = self.G * (2 * np.exp(2 * w) + np.exp(-w))
        maxwell = q / 2 * math.exp(2 * z - x)
        across, way = np.array([c_x, 2 * c_z]), np.array([1.0, -1.0])
        volume, field = np.array([1.0, 2.0]), np.array([1.0, -2.0])
        H = f * (2 * m * np.diag(across) + 2 * slope * np.outer(across, across)
                 + K * np.outer(volume, volume) + 4 / 9 * np.sum(stiffness) * np.outer(way, way))
        return H - maxwell * np.outer(field, field), -f / 3 * np.outer(way, stiffness)

    def stretches(self, y):
        """x and z of the free log stretches of a film under voltage."""
        return self.rest + self.basis @ y

    def lateral(self, x, a):
        """z without lateral force."""
        z = 1.5 * self.rest - x / 2
        if self.incompressible:
            return z
        for _ in range(50):
            step = self.gradient(x, z, a)[1] / self.tangents(x, z, a)[0][1, 1]
            z -= step
            if abs(step) < 1e-15:
                break
        return z

    def stress(self, x, a):
        """Nominal stress along the axis, no lateral force."""
        g_x, g_z = self.gradient(x, self.lateral(x, a), a)
        return (g_x - g_z / 2) / math.exp(x)


@dataclass(frozen=True)
class Stretching:
    """The answer to a stretch that is given over time."""

    film: Film
    times: np.ndarray  # knots
    stretches: np.ndarray
    pieces: tuple  # solutions between knots: a of the branches, work

    def stretch(self, t):
        """l_x at time t."""
        return float(np.interp(t, self.times, self.stretches))

    def values(self, t):
        """(a, work) at time t."""
        piece = np.clip(np.searchsorted(self.times, t, side="left") - 1, 0, len(self.pieces) - 1)
        values = self.pieces[piece](t)
        return values[:-1], float(values[-1])

    def stress(self, t):
        """Nominal."""
        return float(self.film.stress(math.log(self.stretch(t)), self.values(t)[0]))

    def lateral(self, t):
        """l_z."""
        return float(math.exp(self.film.lateral(math.log(self.stretch(t)), self.values(t)[0])))

    def work(self, t):
        """Done since the first knot, per reference volume."""
        return self.values(t)[1]


def stretched(film, times, stretches, method="DOP853"):
    """Stretch linear between knots, from a film at rest; the first knot may be a jump.

    Time constants far below the length of the test want the method "Radau".
    """
    n, pieces, values = len(film.branches), [], np.zeros(len(film.branches) + 1)
    for t_0, t_1, l_0, l_1 in zip(times, times[1:], stretches, stretches[1:]):
        rate = (l_1 - l_0) / (t_1 - t_0)

        def slopes(t, values, t_0=t_0, l_0=l_0, rate=rate):
            x, a = math.log(l_0 + rate * (t - t_0)), values[:n]
            z = film.lateral(x, a)
            return np.append(film.flow(x, z, a), rate * film.stress(x, a) if rate else 0.0)

        piece = solve_ivp(slopes, (t_0, t_1), values, method, dense_output=True, **TOLERANCE)
        pieces.append(piece.sol)
        values = piece.y[:, -1]
    return Stretching(film, np.array(times, float), np.array(stretches, float), tuple(pieces))


def uniaxial(film, rate, peak, method="DOP853"):
    """Triangle 1, peak, 1 of the stretch at a nominal rate."""
    time = (peak - 1) / rate
    return stretched(film, (0, time, 2 * time), (1, peak, 1), method)


def work_lost(test):
    """Work of a closed cycle per reference volume."""
    return test.work(test.times[-1])


def relaxation(film, stretch, times, method="DOP853"):
    """Nominal stresses at these times after a jump to a stretch that is kept."""
    test = stretched(film, (0, max(times)), (stretch, stretch), method)
    return [test.stress(t) for t in times]


@dataclass(frozen=True)
class Charging:
    """A film under a voltage, to pull-in or to the end of the time."""

    film: Film
    pulled_in: bool
    t: float
    field: float  # e
    thickness: float  # stretches at the end
    lateral: float
    load: Callable  # t -> (eps e^2, its rate)
    path: Callable  # parameter -> (t, y, a)
    end: float  # of the parameter

    def state(self, t):
        """(thickness stretch, lateral stretch, a) at a time on the path."""
        p = self.end
        if t < self.t:
            p = brentq(lambda p: self.path(p)[0] - t, 0, self.end, xtol=1e-14, rtol=1e-14)
        values, n = self.path(p), 1 + self.film.basis.shape[1]
        x, z = self.film.stretches(values[1:n])
        return float(math.exp(x)), float(math.exp(z)), values[n:]

    def imbalance(self, t):
        """Largest residual at a time, over the modulus at rest: how far the path has drifted."""
        thickness, lateral, a = self.state(t)
        g = self.film.gradient(math.log(thickness), math.log(lateral), a, self.load(t)[0])
        return float(np.max(np.abs(self.film.basis.T @ g)) / self.film.law.modulus(3.0)[0])


def follow(film, load, flows, t_end, y, a=None, method="DOP853"):
    """Path of a film from y and a (0) under load(t) = (eps e^2, its rate); C_v rests unless it flows."""
    n = 1 + len(y)

    def parts(values):
        (x, z), a, (q, rate) = film.stretches(values[1:n]), values[n:], load(values[0])
        H, H_a = film.tangents(x, z, a, q)
        a_rate = film.flow(x, z, a) if flows else np.zeros_like(a)
        push = H_a @ a_rate + rate / 2 * math.exp(2 * z - x) * np.array([1.0, -2.0])
        return film.basis.T @ H @ film.basis, film.basis.T @ push, a_rate

    start = np.concatenate([[0.0], y, np.zeros(len(film.branches)) if a is None else a])
    scale = np.linalg.det(parts(start)[0])

    def slopes(_, values):
        R_y, push, a_rate = parts(values)
        adjugate = np.trace(R_y) * np.eye(n - 1) - R_y if n == 3 else np.eye(1)
        t_rate = np.linalg.det(R_y) / scale
        return np.concatenate([[t_rate], -adjugate @ push / scale, t_rate * a_rate])

    def pull_in(_, values):
        return np.linalg.det(parts(values)[0]) / scale

    def over(_, values):
        return values[0] - t_end

    pull_in.terminal = over.terminal = True
    found = solve_ivp(slopes, (0, 1e12), start, method, events=(pull_in, over), dense_output=True,
                      **TOLERANCE)
    if found.status != 1:
        raise ValueError(found.message)
    values, pulled_in = found.y[:, -1], bool(len(found.t_events[0]))
    x, z = film.stretches(values[1:n])
    field = math.sqrt(load(values[0])[0] / film.eps)
    return Charging(film, pulled_in, float(values[0]), field, float(math.exp(x)), float(math.exp(z)),
                    load, found.sol, float(found.t[-1]))


def at_once(film, field):
    """The state that a sudden field makes; at the largest if there is none."""
    q_end = film.eps * field**2
    return follow(film, lambda q: (q, 1.0), False, q_end, np.zeros(film.basis.shape[1]))


def instantaneous_limit(film):
    """Pull-in of a voltage that is raised too fast for any flow."""
    return at_once(film, math.inf)


def equilibrium_limit(film):
    """Pull-in of a voltage that is raised infinitely slowly."""
    return instantaneous_limit(replace(film, branches=()))


def ramped(film, rate, t_end=math.inf, method="DOP853"):
    """A nominal field that rises from 0 at a rate."""
    def load(t):
        return film.eps * (rate * t)**2, 2 * film.eps * rate**2 * t

    return follow(film, load, True, t_end, np.zeros(film.basis.shape[1]), method=method)


def held(film, field, t_end, method="DOP853"):
    """A nominal field that is there from t = 0 on."""
    sudden = at_once(film, field)
    if sudden.pulled_in:
        return replace(sudden, t=0.0, load=lambda _: (film.eps * sudden.field**2, 0.0))
    y = balanced(film, sudden.path(sudden.end)[1:1 + film.basis.shape[1]], field)
    return follow(film, lambda t: (film.eps * field**2, 0.0), True, t_end, y, method=method)


def raised(charged, t, field=math.inf):
    """A voltage that jumps at a time on a path, to pull-in if the field is not reached before."""
    film, (thickness, lateral, a) = charged.film, charged.state(t)
    y = np.linalg.lstsq(film.basis, np.log([thickness, lateral]) - film.rest, rcond=None)[0]
    q = charged.load(t)[0]
    return follow(film, lambda more: (q + more, 1.0), False, film.eps * field**2 - q, y, a)


def held_after(jump, t_end):
    """What follows a jump to a field that the film bears, in times after it."""
    film, n = jump.film, 1 + jump.film.basis.shape[1]
    values = jump.path(jump.end)
    y = balanced(film, values[1:n], jump.field, values[n:])
    return follow(film, lambda t: (film.eps * jump.field**2, 0.0), True, t_end, y, values[n:])


def balanced(film, y, field, a=None):
    """Newton's method for a sudden state from one nearby, from a (0)."""
    a, q = np.zeros(len(film.branches)) if a is None else a, film.eps * field**2
    for _ in range(20):
        x, z = film.stretches(y)
        R = film.basis.T @ film.gradient(x, z, a, q)
        y = y - np.linalg.solve(film.basis.T @ film.tangents(x, z, a, q)[0] @ film.basis, R)
    return y


# Wang, Decker, Henann and Chester (J. Mech. Phys. Solids 95 (2016) 213), kPa and s.
G_VHB = 15.36
BRANCHES_VHB = (Branch(26.06, 0.6074), Branch(26.53, 6.56), Branch(10.83, 61.25))
STIFF = 1e3 * G_VHB


def vhb(locking=5.99, **more):
    """Their VHB 4910; its tests in tension have the locking stretch 5.85."""
    return Film(ArrudaBoyce(G_VHB, locking), BRANCHES_VHB, **more)


def unit_film(**more):
    """Spring and branch of the same modulus; its pull-in in equilibrium is at UNIT_FIELD."""
    return Film(NeoHookean(1.0), (Branch(1.0, 1.0),), **more)


UNIT_FIELD = math.sqrt(3) * 2**(-4 / 3)  # of an incompressible neo-Hookean film


def tension_rows(K):
    """Peak stress and lost work of VHB at three rates; in equilibrium."""
    film = vhb(5.85, K=K)
    for rate, stress, lost in ((0.01, 42.199, 18.34), (0.03, 49.892, 30.16), (0.05, 55.406, 36.45)):
        test = uniaxial(film, rate, 2.5)
        yield f"stress at 2.5, {rate} /s, kPa", test.stress(test.times[1]), stress, 3
        yield f"work lost, {rate} /s, kJ/m^3", work_lost(test), lost, 2
    relaxed = replace(film, branches=()).stress(math.log(2.5), np.zeros(0))
    yield "stress at 2.5, equilibrium, kPa", relaxed, 37.527, 3


def ramp_rows(K):
    """Pull-in of VHB under a rising voltage."""
    film, unit = vhb(K=K), math.sqrt(G_VHB)
    slow, fast = ramped(film, 0.1 * unit), ramped(film, unit)
    yield "pull-in, phi*' = 0.1 /s", slow.field / unit, 1.30740, 5
    yield "lambda_3, phi*' = 0.1 /s", slow.thickness, 0.520, 3
    yield "pull-in, phi*' = 1 /s", fast.field / unit, 1.4857, 4
    yield "lambda_3, phi*' = 1 /s", fast.thickness, 0.60, 2
    yield "pull-in, equilibrium", equilibrium_limit(film).field / unit, 0.69440, 5
    yield "pull-in, instantaneous", instantaneous_limit(film).field / unit, 1.55980, 5


def delay_rows(K):
    """Delayed pull-in under a voltage that is held."""
    film = unit_film(K=K)
    for field, time in ((1.02, 20.634), (1.1, 5.441), (1.3, 0.728), (1.4, 0.059)):
        yield f"pull-in time, e = {field}", held(film, field * UNIT_FIELD, 100).t, time, 3
    yield "never, e = 0.999", float(held(film, 0.999 * UNIT_FIELD, 1e3).pulled_in), 0, 3
    yield "pull-in at once", instantaneous_limit(film).field / UNIT_FIELD, math.sqrt(2), 9
    charged = held(film, 0.9 * UNIT_FIELD, 1e3)
    crept, rested = raised(charged, 0.5).field, raised(charged, 999.0).field
    yield "the same once it has crept: less", float(rested < crept < math.sqrt(2) * UNIT_FIELD), 1, 3
    whole = held(film, 1.1 * UNIT_FIELD, 100)
    again = held_after(raised(whole, 1.0, 1.1 * UNIT_FIELD), 100)
    yield "pull-in time, e = 1.1, seen at t = 1", 1 + again.t, whole.t, 8


def known_rows():
    """Limits and identities that the models have."""
    hot = dict(arrhenius=arrhenius(2.0, 4e4, 300.0), WLF=wlf(2.0, 17.44, 51.6, 300.0))
    for name, tau in hot.items():
        film = Film(NeoHookean(1.0), (Branch(0.7, tau),), theta=330.0, theta_0=300.0)
        cold = replace(film, theta=300.0)
        shift = tau(330.0) / 2.0
        fast, slow = relaxation(film, 3.0, [1.5 * shift], "Radau"), relaxation(cold, 3.0, [1.5])
        yield f"{name}: time shifted by temperature", fast[0], 1.1 * slow[0], 9
    small = relaxation(unit_film(), 1 + 1e-7, [2.0])[0] / 1e-7
    yield "small relaxation, 3 (mu_a + mu_b exp(-t))", small, 3 * (1 + math.exp(-2)), 5
    planar = equilibrium_limit(Film(NeoHookean(1.0), K=1e3))
    yield "e_c, K = 1000 mu", planar.field, 0.68737, 5
    yield "lambda_3, K = 1000 mu", planar.thickness, 0.6299, 4
    gent = equilibrium_limit(Film(Gent(1.0, 97.2)))
    yield "e of Gent's film, J_m = 97.2", gent.field, 0.68942, 5
    yield "lambda of Gent's film", gent.lateral, 1.2639, 4


def compare(title, rows):
    """Prints number, reference and difference; whether all agree to a unit of the last digit given."""
    print(f"{title}\n{'':44} {'here':>14} {'reference':>12} {'difference':>11}")
    good = True
    for name, value, reference, digits in rows:
        is_met = abs(value - reference) < 10**-digits
        good = good and is_met
        mark = "" if is_met else "  beyond the last digit"
        print(f"{name:44} {value:14.9f} {reference:12.9g} {value - reference:11.1e}{mark}")
    return good


def check_known():
    """Whether all numbers of incompressible films, and what the model must do, are reached."""
    rows = [*tension_rows(math.inf), *ramp_rows(math.inf), *delay_rows(math.inf)]
    good = compare("Incompressible", rows)
    return compare("\nLimits and identities", known_rows()) and good


def main():
    """The table, and how far K = 1000 G is from K = inf."""
    good = check_known()
    compare("\nK = 1000 G beside the incompressible numbers: the difference is the effect of K",
            [*tension_rows(STIFF), *ramp_rows(STIFF), *delay_rows(1e3)])
    print("\nall numbers of incompressible films reached" if good else "\nsome numbers missed")
    sys.exit(not good)


if __name__ == "__main__":
    main()
