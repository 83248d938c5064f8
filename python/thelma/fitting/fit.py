"""Least squares of a material's free parameters (SciPy), with the program as the model.

Residuals are (model - measured)/(largest stress of the test): every point of every test counts the same.
"""

from dataclasses import dataclass

import numpy as np
from scipy.optimize import least_squares
from scipy.stats import t as student

from thelma.errors import ThelmaError
from thelma.fitting.free import free, material_of
from thelma.material_point import MaterialPoint
from thelma.prm import ParameterText

STEP = 1e-5  # of differences: the root of the 1e-10 to which the program's stresses are exact
CONFIDENCE = 0.95
UNKNOWN = 2e4  # condition beyond which a direction of the parameters is lost in the error of the differences


@dataclass
class Fit:
    """The best values, their intervals of confidence and the stresses they give."""

    scene: ParameterText
    material: str
    parameters: list
    entries: list
    tests: list
    values: np.ndarray
    low: np.ndarray
    high: np.ndarray
    stresses: list

    @property
    def residuals(self):
        """Of all measured points."""
        return np.concatenate(residuals(self.tests, self.stresses))

    @property
    def rms(self):
        """Of the residuals."""
        return float(np.sqrt(np.mean(self.residuals**2)))

    def rms_of(self, i):
        """Of one test."""
        return float(np.sqrt(np.mean(residuals(self.tests, self.stresses)[i]**2)))

    @property
    def undetermined(self):
        """Names of parameters about which the tests say nothing alone."""
        return [one.name for one, high in zip(self.parameters, self.high) if np.isinf(high)]

    def fitted_scene(self):
        """The parameter file with the fitted values; nothing in it is free any more."""
        text = ParameterText(str(self.scene), self.scene.name)
        for entry in self.entries:
            found = text.entries[tuple(entry.name.split("/"))]
            text.replace(found, rounded(entry, self.values), comment="")
            text.parse()
        return text

    def section(self):
        """The material's section of it."""
        return self.fitted_scene().section(("Materials", self.material))


def rounded(entry, values):
    """Eight digits say more than any test."""
    return entry.text([float(f"{value:.8g}") for value in values])


def residuals(tests, stresses):
    """Of every test."""
    return [(np.array(values)[test.measured] - test.stress[test.measured]) / test.scale
            for test, values in zip(tests, stresses)]


class Problem:
    """The residuals and their derivatives at coordinates of the parameters."""

    def __init__(self, point, material, parameters, entries, tests):
        self.point, self.material, self.parameters, self.entries = point, material, parameters, entries
        self.tests, self.requests = tests, [test.request() for test in tests]

    def values(self, x):
        """The parameters."""
        return np.array([one.value(coordinate) for one, coordinate in zip(self.parameters, x)])

    def stresses(self, *points):
        """At several coordinates, or a ThelmaError each."""
        sets = [[f"{entry.name}={entry.text(self.values(x))}" for entry in self.entries] for x in points]
        return self.point.stresses(self.requests, sets, self.material)

    def residuals(self, x):
        """Not finite where the program knows no stress, from which the search turns back."""
        found, = self.stresses(x)
        if isinstance(found, ThelmaError):
            return np.full(sum(test.measured.sum() for test in self.tests), np.inf)
        return np.concatenate(residuals(self.tests, found))

    def jacobian(self, x):
        """By differences, away from an upper bound."""
        high = np.array([one.bounds[1] for one in self.parameters])
        steps = np.where(x + STEP > high, -STEP, STEP)
        found = self.stresses(x, *(x + np.diag(steps)))
        for one, parameter, value in zip(found[1:], self.parameters, self.values(x)):
            if isinstance(one, ThelmaError):
                raise ThelmaError(f"{one}; this is near {parameter.name} = {value:.4g}: give it bounds, "
                                  "`# free from A to B`")
        here, *beside = (np.concatenate(residuals(self.tests, stresses)) for stresses in found)
        return np.array([(one - here) / step for one, step in zip(beside, steps)]).T


def intervals(problem, found):
    """Ends of the intervals of confidence."""
    freedom = len(found.fun) - len(found.x)
    _, s, V = np.linalg.svd(found.jac, full_matrices=False)
    known = s > s[0] / UNKNOWN
    deviation = np.linalg.norm(V[known] / s[known, None], axis=0)
    width = np.full(len(found.x), np.inf)
    if freedom > 0:
        width = student.ppf((1 + CONFIDENCE) / 2, freedom) * np.sqrt(2 * found.cost / freedom) * deviation
    width[np.abs(V[~known]).max(axis=0, initial=0.0) > 1e-3] = np.inf
    ends = [[one.value(x - w) if np.isfinite(w) else (0.0 if one.is_positive else -np.inf),
             one.value(min(x + w, 700.0)) if np.isfinite(w) else np.inf]
            for one, x, w in zip(problem.parameters, found.x, width)]
    return np.array(ends).T


def fit(program, scene, tests):
    """The fit of a parameter file with free entries to tests."""
    text = ParameterText.read(scene)
    parameters, entries = free(text)
    material = material_of(entries, text.name)
    points = sum(int(test.measured.sum()) for test in tests)
    if points < len(parameters):
        raise ThelmaError(f"{len(parameters)} parameters cannot be found from {points} stresses; free fewer")
    with MaterialPoint(program, scene) as point:
        problem = Problem(point, material, parameters, entries, tests)
        start = np.array([one.coordinate(one.start) for one in parameters])
        first, = problem.stresses(start)
        if isinstance(first, ThelmaError):
            raise first
        bounds = np.array([one.bounds for one in parameters]).T
        found = least_squares(problem.residuals, start, problem.jacobian, bounds, x_scale="jac",
                              xtol=1e-10, ftol=1e-12, gtol=1e-15, max_nfev=300)
        if found.status == 0:
            raise ThelmaError("the least squares do not converge in 300 steps; give other starting values, or free "
                              "fewer parameters")
        low, high = intervals(problem, found)
        stresses, = problem.stresses(found.x)
    return Fit(text, material, parameters, entries, tests, problem.values(found.x), low, high, stresses)
