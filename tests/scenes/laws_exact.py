"""Exact homogeneous films of Yeoh's and Ogden's rubber, and with fibres.

With w_i = lambda_i dpsi/dlambda_i of the material without a field (doc/theory.md, eqs. 13, 9, 10, 11) and the Maxwell
stress M = e^2 mu lambda_1 lambda_2/lambda_3, a film without forces has w_1 = w_2 = -w_3 = M/2.
"""

from dataclasses import dataclass, replace
from functools import partial

import numpy as np
from scene import require
from validation.material import newton

THETA_0 = 293.0
TERMS = {1.3: 0.63, 5.0: 0.0012, -2.0: -0.01}  # alpha: mu in MPa, the default of `Ogden terms`
CHAINS = 4.0  # links of a chain, Arruda and Boyce's series to five terms
SERIES = [1 / 2, 1 / 20, 11 / 1050, 19 / 7000, 519 / 673750]


@dataclass(frozen=True)
class Rubber:
    """A law: w_i of three stretches without the volumetric energy, and the entries of the program."""

    name: str
    mu: float  # MPa
    w: object
    entries: dict
    ratio: float = 1000.0  # K/mu
    theta: float = THETA_0
    alpha: float = 0.0  # 1/K
    scene: str = "planar_actuator"  # a free film

    def balance(self, stretches):
        """w_1, w_2, w_3."""
        scaled = [np.exp(-self.alpha * (self.theta - THETA_0)) * stretch for stretch in stretches]
        pressure = self.ratio * self.mu * np.log(scaled[0] * scaled[1] * scaled[2])
        return self.theta / THETA_0 * (np.array(self.w(scaled)) + pressure)

    def options(self):
        """The entries, with those of every law."""
        here = {"Elastic law": self.name, "Bulk modulus": f"{self.ratio * self.mu!r}",
                "Thermal expansion": f"{self.alpha!r}", **self.entries}
        return {**{f"Materials/elastomer/{name}": value for name, value in here.items()},
                "Temperature/Value": f"{self.theta}", "Output/Fields": "none",
                "Expectations/Final values": ""}


def w_of_yeoh(mu, ratios, stretches):
    """C_{n + 1}/C_1 = ratios[n - 1]."""
    x = sum(stretch**2 for stretch in stretches) - 3
    slope = sum((n + 1) * c * x**n for n, c in enumerate([1.0, *ratios]))
    return [mu * (slope * stretch**2 - 1) for stretch in stretches]


def yeoh(mu, ratios):
    """By the shear modulus and C_2/C_1, C_3/C_1, ..."""
    return Rubber("Yeoh", mu, partial(w_of_yeoh, mu, ratios),
                  {"Shear modulus": f"{mu!r}", "Yeoh ratios": ", ".join(map(repr, ratios))})


def as_expression(mu, ratios):
    """The same law as an energy of the parameter file."""
    energy = " + ".join(f"({c!r})*x*(I1 - 3)^{n + 2}" for n, c in enumerate(ratios))
    return replace(yeoh(mu, ratios), name="expression", scene="verification/own_energy", entries={
        "Energy": f"x*(I1 - 3 - 2*log(J)) + {energy}, x: {mu / 2!r}"})


def series_of_chains():
    """Arruda and Boyce's five terms, a polynomial in I_1, as one in I_1 - 3."""
    in_I_1 = np.polynomial.Polynomial([0.0, *(c / CHAINS**n for n, c in enumerate(SERIES))])
    shifted = in_I_1(np.polynomial.Polynomial([3.0, 1.0])).coef
    return yeoh(2 * float(shifted[1]), [float(c / shifted[1]) for c in shifted[2:]])


def w_of_ogden(scale, terms, stretches):
    """alpha: mu, times the scale."""
    return [scale * sum(mu * (stretch**alpha - 1) for alpha, mu in terms.items()) for stretch in stretches]


def ogden(terms, coefficients=(), theta=THETA_0):
    """alpha: mu, and the coefficients of the shear modulus to which they are scaled, or none."""
    of_terms = sum(alpha * mu for alpha, mu in terms.items()) / 2
    modulus = sum(c * (1000 / theta)**n for n, c in enumerate(coefficients)) or of_terms
    return Rubber("Ogden", modulus, partial(w_of_ogden, modulus / of_terms, terms), {
        "Ogden terms": ", ".join(f"{alpha!r}: {mu!r} MPa" for alpha, mu in terms.items()),
        "Shear modulus": ", ".join(map(repr, coefficients))}, theta=theta)


def w_with_fibres(mu, k_1, k_2, directions, stretches):
    """Squares of the components of each direction; fibres that are pressed carry nothing."""
    result = [mu * (stretch**2 - 1) for stretch in stretches]
    for direction in directions:
        x = sum(share * stretch**2 for share, stretch in zip(direction, stretches)) - 1
        force = 2 * k_1 * x * np.exp(k_2 * x**2) if np.real(x) > 0 else 0
        result = [w + force * share * stretch**2 for w, share, stretch in zip(result, direction, stretches)]
    return result


def with_fibres(mu, k_1, k_2, angles, plane="x1-x2"):
    """Families in a plane of the axes, at angles in degrees."""
    directions = np.zeros((len(angles), 3))
    for axis, turned in zip(plane.split("-"), (np.cos, np.sin)):
        directions[:, int(axis[1]) - 1] = turned(np.radians(angles))**2
    return Rubber("fibres", mu, partial(w_with_fibres, mu, k_1, k_2, directions), {
        "Shear modulus": f"{mu!r}", "Fibre stiffness": f"{k_1!r}", "Fibre exponent": f"{k_2!r}",
        "Fibre angles": ", ".join(map(str, angles)), "Fibre plane": plane})


def state(rubber, thickness, start, normal=2, held=None):
    """(stretches, e) of a film without forces, that much thick along an axis; e of a held axis is free."""
    free = [axis for axis in range(3) if axis not in (normal, held)]

    def stretches(y):
        values = [1.0] * 3
        values[normal] = thickness
        for axis, stretch in zip(free, y):
            values[axis] = stretch
        return values

    def residual(y):
        w = rubber.balance(stretches(y))
        return np.array([(w[axis] + w[normal]) / rubber.mu for axis in free])

    found = newton(residual, start)
    require(found is not None, f"no state of {rubber.name} at {thickness}")
    all_three = stretches(found)
    M = -2 * rubber.balance(all_three)[normal]
    return all_three, float(np.sqrt(max(M / rubber.mu * thickness**2 / np.prod(all_three), 0)))


def along(rubber, thicknesses, normal=2, held=None):
    """The states of a film that gets thinner."""
    y = [1.0] * (2 if held is None else 1)
    for thickness in thicknesses:
        stretches, e = state(rubber, thickness, y, normal, held)
        y = [stretches[axis] for axis in range(3) if axis not in (normal, held)]
        yield stretches, e


def limit_point(rubber):
    """(e, stretches) of a free film at its largest e, by ever smaller steps."""
    low, high = 0.35, 1.0
    for _ in range(3):  # further on e differs by no more than rounding
        thicknesses = np.linspace(high, low, 60)
        states = list(along(rubber, [*np.linspace(1.0, high, 30), *thicknesses]))[30:]
        best = int(np.argmax([e for _, e in states]))
        require(0 < best < 59, "the limit point is elsewhere")
        low, high = thicknesses[best + 1], thicknesses[best - 1]
    return states[best][1], states[best][0]
