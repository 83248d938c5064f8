"""Homogeneous states of a film and when they lose their stability.

The film [0, L1] x [0, L2] x [0, L3] has a nominal field E along x3 and principal stretches that make

    psi(lambda_1, lambda_2, lambda_3, E) - P_1 lambda_1 - P_2 lambda_2

stationary in those that are free; P_1 and P_2 are dead loads. In plane strain lambda_2 = 1; sides that are
held after a prestretch keep lambda_1 and lambda_2. Where the second derivatives by the free stretches lose
their definiteness is a limit point, or a bifurcation (of Treloar's and Kearsley's kind) if the state goes on.

Waves are counted by quadratic elements with full integration. In a homogeneous state their tangent is
a sum of Kronecker products of one-dimensional matrices, exact without any quadrature.
"""

from dataclasses import dataclass

import numpy as np

from validation.material import Material, linearised, newton

SCAN = 400  # steps of the field towards an instability


@dataclass(frozen=True)
class Film:
    """What holds and loads a film."""

    material: Material
    size: tuple = (5.0, 5.0, 1.0)  # mm
    load: tuple = (0.0, 0.0)  # dead loads P_1, P_2 in MPa
    held: tuple = (None, None)  # given lambda_1, lambda_2, or None

    @property
    def free(self):
        """Indices of the free stretches."""
        return [i for i in range(3) if i == 2 or self.held[i] is None]

    def stretches(self, y):
        """All three of the free ones."""
        values = [*self.held, None]
        for i, value in zip(self.free, y):
            values[i] = value
        return values

    def residual(self, y, E):
        """Slopes of the energy by the free stretches in units of mu; E may be complex."""
        l = self.stretches(y)
        slopes, field = self.material.slopes(l), self.material.field_slopes(l, E)
        forces = [slopes[i] - field[i] - (*self.load, 0.0)[i] for i in range(3)]
        return np.array([forces[i] for i in self.free]) / self.material.mu

    def hessian(self, y, E):
        """Second derivatives by the free stretches."""
        return linearised(lambda z: self.residual(z, E), y)[1]

    def rest(self):
        """The free stretches without a field, the loads put on bit by bit."""
        start = [1 / float(self.material.split)] * 3
        y = [start[i] for i in self.free]
        if None not in self.held:
            return newton(lambda z: self.residual(z, 0.0), [1 / (self.held[0] * self.held[1])])
        for part in np.linspace(0.1, 1, 10):
            film = Film(self.material, self.size, tuple(part * p for p in self.load), self.held)
            y = newton(lambda z, film=film: film.residual(z, 0.0), y)
            if y is None:
                return None
        return y

    def at_field(self, E, steps=40):
        """The free stretches at a field below the first limit point."""
        y = self.rest()
        for part in np.linspace(0, E, steps + 1)[1:]:
            y = y if y is None else newton(lambda z, E=part: self.residual(z, E), y)
        return y

    def at_thickness(self, l_3, y, E):
        """(free stretches, E) of the state with this lambda_3, from one near by, on any branch."""
        if None not in self.held:
            return None
        start = np.append(y[:-1], E**2)
        found = newton(lambda z: self.residual(np.append(z[:-1], l_3), np.sqrt(z[-1])), start)
        return None if found is None else (np.append(found[:-1], l_3), float(np.sqrt(max(found[-1], 0))))


def one_dimensional(length, cells):
    """{(i, j): matrix} of the integrals of the i-th times the j-th derivatives of quadratic shapes."""
    points, weights = np.polynomial.legendre.leggauss(3)
    x = (points + 1) / 2
    values = np.array([(1 - x) * (1 - 2 * x), 4 * x * (1 - x), x * (2 * x - 1)])
    slopes = np.array([4 * x - 3, 4 - 8 * x, 4 * x - 1])
    h = length / cells
    shapes, result = (values, slopes / h), {}
    for i in range(2):
        for j in range(2):
            matrix = np.zeros((2 * cells + 1, 2 * cells + 1))
            for cell in range(cells):
                rows = slice(2 * cell, 2 * cell + 3)
                matrix[rows, rows] += (shapes[i] * weights * h / 2) @ shapes[j].T
            result[i, j] = matrix
    return result


class Waves:
    """Unstable directions of a homogeneous film on a mesh of quadratic elements."""

    def __init__(self, film, cells):
        self.film, self.plane = film, film.held[1] == 1 and film.held[0] is None
        axes = (0, 2) if self.plane else (0, 1, 2)
        lines = {axis: one_dimensional(film.size[axis], cells[axis]) for axis in axes}
        self.gradients = {}
        for I in axes:
            for J in axes:
                product = np.ones((1, 1))
                for axis in axes:
                    product = np.kron(product, lines[axis][int(axis == I), int(axis == J)])
                self.gradients[I, J] = product
        grid = np.meshgrid(*[np.arange(2 * cells[axis] + 1) for axis in axes], indexing="ij")
        at = {axis: index.ravel() for axis, index in zip(axes, grid)}
        last = {axis: 2 * cells[axis] for axis in axes}
        self.unknowns = []  # (component, its free nodes); the potential is component 3
        for axis in axes:
            fixed = at[axis] == 0
            if axis < 2 and film.held[axis] is not None:
                fixed |= at[axis] == last[axis]
            self.unknowns.append((axis, np.flatnonzero(~fixed)))
        self.potential = np.flatnonzero((at[2] > 0) & (at[2] < last[2]))

    def block(self, tangent, row, column):
        """Tangent between two (component, nodes)."""
        (i, a), (j, b) = row, column
        return sum(tangent[3 * i + I, 3 * j + J] * matrix[np.ix_(a, b)]
                   for (I, J), matrix in self.gradients.items()
                   if abs(tangent[3 * i + I, 3 * j + J]) > 0)

    def stiffness(self, y, E):
        """The tangent of the displacements with the potential in balance."""
        tangent = self.film.material.tangent(np.diag(self.film.stretches(y)), np.array([0, 0, E]))
        phi = (3, self.potential)

        def full(row, column):
            return np.zeros((len(row[1]), len(column[1]))) + self.block(tangent, row, column)

        K = np.block([[full(row, column) for column in self.unknowns] for row in self.unknowns])
        coupling = np.vstack([full(row, phi) for row in self.unknowns])
        K = K - coupling @ np.linalg.solve(full(phi, phi), coupling.T)
        return (K + K.T) / 2

    def count(self, y, E):
        """Number of unstable directions."""
        return int(np.sum(np.linalg.eigvalsh(self.stiffness(y, E)) < 0))

    def stable(self, y, E):
        """Whether there is none."""
        try:
            np.linalg.cholesky(self.stiffness(y, E))
        except np.linalg.LinAlgError:
            return False
        return True


@dataclass(frozen=True)
class Instability:
    """Where a path from rest stops being stable."""

    field: float  # kV/mm
    kind: str  # "limit point" or "bifurcation"
    stretches: tuple


def first_fold(film, largest):
    """The first singular point in homogeneous directions below the largest field, or None."""
    y, E, step = film.rest(), 0.0, largest / SCAN
    while y is not None and E < largest:
        trial = newton(lambda z, E=E + step: film.residual(z, E), y, iterations=12)
        known = trial is not None and np.max(np.abs(trial - y)) < 0.1
        if known and np.all(np.linalg.eigvalsh(film.hessian(trial, E + step)) > 0):
            y, E = trial, E + step
            continue
        if step < 1e-10 * largest:
            if np.min(np.linalg.eigvalsh(film.hessian(y, E))) > 1e-3:
                return None  # Newton's method has lost the state where chains are stretched out
            return Instability(E, fold_kind(film, y, E), tuple(film.stretches(y)))
        step /= 2
    return None


def fold_kind(film, y, E):
    """At a limit point the load has a component along the direction that has lost its stiffness."""
    vector = np.linalg.eigh(film.hessian(y, E))[1][:, 0]
    load = film.residual(np.array(y, dtype=complex), E * (1 + 1e-30j)).imag / 1e-30
    along = abs(vector @ load) / np.linalg.norm(load)
    return "limit point" if along > 1e-6 else "bifurcation"


def first_wave(film, cells, largest, precision=1e-6):
    """The largest field up to which the mesh of quadratic elements is stable; largest if it is there."""
    waves, rest = Waves(film, cells), film.rest()
    if not waves.stable(rest, 0.0):
        return 0.0
    low, y = 0.0, rest
    step = largest / 16
    while low < largest * (1 - 1e-12) and step > precision * largest:
        E = min(low + step, largest)
        trial = newton(lambda z, E=E: film.residual(z, E), y, iterations=25)
        if trial is not None and np.max(np.abs(trial - y)) < 0.5 and waves.stable(trial, E):
            low, y = E, trial
        else:
            step /= 2
    return low
