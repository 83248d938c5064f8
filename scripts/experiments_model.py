"""The model of scripts/experiments: one thermo-viscoelastic material, its histories and its fit.

Incompressible; the stress is theta/theta_0 times that of the elastic law and of the branches. In a stretch
that is given the branches do not see each other, so the stress of each is G_i h(tau_i): a fit takes h from
a table over tau, which viscoelastic_exact.py integrates once per test.
"""

import json
import math
from dataclasses import asdict, dataclass, replace

import numpy as np
from scipy.integrate import solve_ivp
from scipy.interpolate import PchipInterpolator
from scipy.optimize import least_squares

import experiments_data as data
from thelma import viscoelastic_exact as exact

CELSIUS = 273.15
THETA_R = CELSIUS + 20  # reference temperature of the material and of the shift
LOCKING = 5.85  # of the tests in tension, Wang et al. 2016
VACUUM = 8.8541878128  # pF/m
METHOD = "LSODA"  # changes to implicit formulas where the time constants are short


@dataclass(frozen=True)
class Material:
    """Elastic law and branches in kPa and s at THETA_R."""

    G: float
    moduli: tuple
    times: tuple
    shift: str  # Arrhenius or WLF
    constants: tuple  # Ea in kJ/mol, or C1 and C2 in K
    locking: float = LOCKING

    def shift_factor(self, theta):
        """a_T."""
        if self.shift == "Arrhenius":
            return exact.arrhenius(1.0, 1e3 * self.constants[0], THETA_R)(theta)
        return exact.wlf(1.0, *self.constants, THETA_R)(theta)

    def film(self, celsius):
        """Film of viscoelastic_exact.py."""
        theta = CELSIUS + celsius
        branches = tuple(exact.Branch(G, tau * self.shift_factor(theta))
                         for G, tau in zip(self.moduli, self.times))
        return exact.Film(exact.ArrudaBoyce(self.G, self.locking), branches, theta=theta, theta_0=THETA_R)


@dataclass(frozen=True)
class Test:
    """A stretch at a rate, which may be held afterwards."""

    stretch: float
    rate: float
    hold: float = 0.0

    @property
    def knots(self):
        """Times and stretches."""
        rise = (self.stretch - 1) / self.rate
        if self.hold:
            return (0, rise, rise + self.hold), (1, self.stretch, self.stretch)
        return (0, rise), (1, self.stretch)

    def history(self, film):
        """By viscoelastic_exact.py."""
        return exact.stretched(film, *self.knots, METHOD)

    def stress(self, film):
        """At the end."""
        history = self.history(film)
        return history.stress(history.times[-1])


@dataclass(frozen=True)
class Point:
    """A measured stress."""

    set: str
    source: data.Source
    test: Test
    celsius: float
    stress: float


LIAO, PEAK, RELAXED = "VHB 4905, peak", "VHB 4910, peak", "VHB 4910, after an hour"
SETS = (LIAO, PEAK, RELAXED)
LOW = -20  # the coldest test
RELAXED_TEST = Test(data.RELAXED_STRETCH, data.ALKHOURY_RATE, data.RELAXED_AFTER)


def fitted_points():
    """What the fit sees."""
    peaks = [Point(LIAO, data.LIAO, Test(data.LIAO_STRETCH, rate), *pair)
             for rate, stresses in data.LIAO_PEAKS.items() for pair in zip(data.LIAO_CELSIUS, stresses)]
    others = [Point(name, data.ALKHOURY, test, *pair) for name, test, stresses in (
        (PEAK, Test(data.ALKHOURY_STRETCH, data.ALKHOURY_RATE), data.ALKHOURY_PEAKS),
        (RELAXED, RELAXED_TEST, data.ALKHOURY_RELAXED)) for pair in stresses.items()]
    return peaks + others


TAUS = np.geomspace(1e-7, 1e9, 321)


class Tables:
    """Stress h(tau) of a branch of modulus 1 at the end of a test."""

    def __init__(self):
        self.known = {}

    def of(self, test):
        """A function of an array of relaxation times."""
        if test not in self.known:
            film = exact.Film(exact.NeoHookean(1.0), tuple(exact.Branch(1.0, tau) for tau in TAUS))
            history = test.history(film)
            x = math.log(test.stretch)
            w = film.elastic_strain(x, -x / 2, history.values(history.times[-1])[0])
            stresses = (np.exp(2 * w) - np.exp(-w)) / test.stretch
            self.known[test] = PchipInterpolator(np.log(TAUS), stresses)
        table = self.known[test]
        return lambda tau: table(np.clip(np.log(tau), math.log(TAUS[0]), math.log(TAUS[-1])))

    def stress(self, material, test, celsius):
        """Nominal stress at the end of a test."""
        film = material.film(celsius)
        relaxed = replace(film, branches=()).stress(math.log(test.stretch), np.zeros(0))
        return relaxed + film.theta / film.theta_0 * float(film.G @ self.of(test)(film.tau))


@dataclass(frozen=True)
class Fit:
    """A material, the factor of a laboratory's stresses, and how well each parameter is determined."""

    name: str
    material: Material
    factor: float  # of the stresses of Alkhoury et al.
    uncertain: tuple = ()  # exp(standard error of ln) of G, moduli, times, constants, factor

    def scale(self, source):
        """What the model is multiplied by to compare with a source."""
        return self.factor if source == data.ALKHOURY else 1.0

    def model(self, point, tables=None):
        """Stress to compare with a point; by an own history without tables."""
        stress = (tables.stress(self.material, point.test, point.celsius) if tables
                  else point.test.stress(self.material.film(point.celsius)))
        return self.scale(point.source) * stress


@dataclass(frozen=True)
class Plan:
    """What is fitted to what."""

    name: str
    shift: str = "WLF"
    branches: int = 3
    has_factor: bool = True
    sees: object = staticmethod(lambda point: True)

    def unpack(self, logs):
        """The fit of a vector of logarithms."""
        values, n = [float(value) for value in np.exp(logs)], self.branches
        constants = values[1 + 2 * n:]
        factor = constants.pop() if self.has_factor else 1.0
        if self.shift == "WLF":
            constants[1] += 40  # WLF's equation must hold at the coldest test
        pairs = sorted(zip(values[1 + n:1 + 2 * n], values[1:1 + n]))
        times, moduli = zip(*pairs)
        return Fit(self.name, Material(values[0], moduli, times, self.shift, tuple(constants)), factor)

    def bounds(self):
        """Of the logarithms."""
        n = self.branches
        constants = [(1, 1e3)] if self.shift == "Arrhenius" else [(1, 40), (1, 400)]
        pairs = [(0.1, 100), *[(0.01, 3e4)] * n, *[(1e-4, 1e5)] * n, *constants,
                 *[(0.5, 3)] * self.has_factor]
        return np.log(np.array(pairs, float)).T

    def start(self, random):
        """A guess."""
        n = self.branches
        constants = ([random.uniform(50, 120)] if self.shift == "Arrhenius"
                     else [random.uniform(2, 15), random.uniform(20, 100)])
        guess = [12.0, *np.exp(random.normal(math.log(40), 1, n)),
                 *np.geomspace(0.3, 300, n) * np.exp(random.normal(0, 1, n)), *constants]
        return np.log(guess + [1.3] * self.has_factor)

    def fit(self, tables, starts=6):
        """Least squares of ln(model/measured), the best of some starts."""
        points = [point for point in fitted_points() if self.sees(point)]
        low, high = self.bounds()

        def residuals(logs):
            fit = self.unpack(logs)
            return [math.log(fit.model(point, tables) / point.stress) for point in points]

        random = np.random.default_rng(1)
        tried = [least_squares(residuals, np.clip(self.start(random), low + 1e-6, high - 1e-6),
                               bounds=(low, high), max_nfev=300) for _ in range(starts)]
        best = min(tried, key=lambda one: one.cost)
        return replace(self.unpack(best.x), uncertain=self.uncertainty(best))

    def uncertainty(self, best):
        """exp(standard error) of every parameter, in the order of Fit.uncertain; of C2 that of C2 - 40."""
        freedom = len(best.fun) - len(best.x)
        if freedom < 1:
            return ()
        covariance = 2 * best.cost / freedom * np.linalg.pinv(best.jac.T @ best.jac)
        errors, n = np.exp(np.sqrt(np.diag(covariance))), self.branches
        order = np.argsort(best.x[1 + n:1 + 2 * n])
        return tuple(float(error) for error in (
            errors[0], *errors[1:1 + n][order], *errors[1 + n:1 + 2 * n][order], *errors[1 + 2 * n:]))


PLANS = (
    Plan("WLF, 3 branches, factor"),
    Plan("WLF, 2 branches, factor", branches=2),
    Plan("WLF, 4 branches, factor", branches=4),
    Plan("Arrhenius, 3 branches, factor", shift="Arrhenius"),
    Plan("WLF, 3 branches, no factor", has_factor=False),
    Plan("WLF, 3 branches, VHB 4905 alone", has_factor=False, sees=lambda point: point.set == LIAO),
    Plan("WLF, 3 branches, factor, without -20 C", sees=lambda point: point.celsius > LOW),
)


def rms(values):
    """Root mean square."""
    return math.sqrt(sum(value**2 for value in values) / len(values))


def write(path, fits, program):
    """Fits, the first of which is the one that is used, and stresses that the program computed."""
    record = {"units": "moduli kPa, times s at 293.15 K, Ea kJ/mol, C2 K, program: stretch, kPa",
              "fits": [asdict(fit) for fit in fits], "program": program}
    path.write_text(json.dumps(record, indent=1) + "\n", encoding="utf8")


def read(path):
    """(fits, program)."""
    record = json.loads(path.read_text(encoding="utf8"))
    fits = []
    for one in record["fits"]:
        lists = {name: tuple(value) if isinstance(value, list) else value
                 for name, value in one.pop("material").items()}
        fits.append(Fit(**{**one, "uncertain": tuple(one["uncertain"])}, material=Material(**lists)))
    return fits, record["program"]


def permittivity_law():
    """(c_0, c_1) of eps_r = c_0 + c_1 (1000 K/theta), by least squares."""
    x = [1e3 / (CELSIUS + celsius) for celsius in data.PERMITTIVITIES]
    c_1, c_0 = np.polyfit(x, list(data.PERMITTIVITIES.values()), 1)
    return float(c_0), float(c_1)


def permittivity(celsius):
    """Relative."""
    c_0, c_1 = permittivity_law()
    return c_0 + c_1 * 1e3 / (CELSIUS + celsius)


def charged(film, test, q, width_held=False, points=2):
    """Stretches and nominal stresses of a film that is stretched under a voltage across its thickness,
    q = eps e^2 in kPa with the nominal field e; the width is free or held. The voltage is switched on when
    the stretching begins."""
    n = len(film.tau)
    rise = test.knots[0][1]

    def log_stretch(t):
        return math.log(1 + test.rate * t)

    def parts(x, y, a, b):
        c = np.exp(2 * np.array([x, y, -x - y]))
        strain = c[:, None] * np.exp(-np.array([a, b, -a - b]))
        m, slope = film.law.modulus(c.sum())
        f, maxwell = film.theta / film.theta_0, q * math.exp(2 * (x + y))
        return c, strain, m, slope, f, maxwell

    def width(x, a, b):
        """ln of the stretch of the width, by Newton's method."""
        y = 0.0 if width_held else -x / 2
        for _ in range(0 if width_held else 100):
            c, strain, m, slope, f, maxwell = parts(x, y, a, b)
            force = f * (m * (c[1] - c[2]) + film.G @ (strain[1] - strain[2])) - maxwell
            stiffness = f * (2 * m * (c[1] + c[2]) + 2 * slope * (c[1] - c[2])**2
                             + 2 * film.G @ (strain[1] + strain[2])) - 2 * maxwell
            y -= force / stiffness
            if abs(force / stiffness) < 1e-13:
                break
        return y

    def slopes(t, values):
        x, a, b = log_stretch(t), values[:n], values[n:]
        strain = parts(x, width(x, a, b), a, b)[1]
        mean = strain.sum(axis=0) / 3
        return np.concatenate([(strain[0] - mean) / film.tau, (strain[1] - mean) / film.tau])

    times = np.linspace(0, rise, points)
    found = solve_ivp(slopes, (0, rise), np.zeros(2 * n), METHOD, t_eval=times, rtol=1e-8, atol=1e-10)
    stresses = []
    for t, values in zip(times, found.y.T):
        x, a, b = log_stretch(t), values[:n], values[n:]
        c, strain, m, _, f, maxwell = parts(x, width(x, a, b), a, b)
        stresses.append((f * (m * (c[0] - c[2]) + film.G @ (strain[0] - strain[2])) - maxwell) / math.exp(x))
    return 1 + test.rate * times, np.array(stresses)


FIELD_TEST = Test(data.MEHNERT_STRETCH, data.MEHNERT_RATE)
THICKNESS = 0.5  # mm, assumed


def under_voltage(material, celsius, kilovolts, thickness=THICKNESS, **more):
    """Stretches and stresses in kPa of the blind test."""
    q = 1e-3 * VACUUM * permittivity(celsius) * (kilovolts / thickness)**2  # 1e-12 (1e6)^2 F/m (V/m)^2 in kPa
    return charged(material.film(celsius), FIELD_TEST, q, **more)


def slow_pull_in(material, celsius):
    """Nominal field in kV/mm of the film that is free of forces, raised infinitely slowly."""
    film = replace(material.film(celsius), eps=1e-3 * VACUUM * permittivity(celsius))
    return exact.equilibrium_limit(film).field
