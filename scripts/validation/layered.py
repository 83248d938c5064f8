"""Bodies with one curved coordinate: bilayers in plane strain, tubes, spherical balloons.

All have the principal stretches lambda_r = x'(X) and lambda_t, in which the displaced coordinate x shows:

    bilayer  lambda_t = t_0 + kappa x, lambda_2 = 1 (a circle; x(0) = 0)
    tube     lambda_t = x/X,           lambda_2 = 1
    balloon  lambda_t = lambda_2 = x/X

with the weight w = 1, X, X^2 of the volume. The displacement D w does not depend on X, so that

    c = V / int lambda_r/(eps lambda_t lambda_2 w) dX over the active layers, E = c lambda_r/(eps lambda_t lambda_2 w)

and Galerkin's method with one polynomial a layer gives x. A steady temperature is harmonic in the deformed
tube: theta = theta_i + (theta_o - theta_i) ln(x/x_i)/ln(x_o/x_i).
"""

from dataclasses import dataclass

import numpy as np
from numpy.polynomial import legendre

from validation.material import Material, linearised, newton

DEGREE = 9  # of x in a layer


@dataclass(frozen=True)
class Layered:
    """Layers from X = first on; `shape` is bilayer, tube or balloon."""

    shape: str
    layers: tuple  # (thickness in mm, Material, whether it carries the field)
    first: float = 0.0  # inner radius in mm
    pressure: float = 0.0  # on the inner face, MPa
    walls: tuple = ()  # temperatures of the faces, if conduction is steady

    def grid(self):
        """Points, weights, x and x' at the points by the nodal values, nodes, layer of the points."""
        points, weights = legendre.leggauss(DEGREE + 4)
        nodes = -np.cos(np.pi * np.arange(DEGREE + 1) / DEGREE)
        inverse = np.linalg.inv(legendre.legvander(nodes, DEGREE))
        value = legendre.legvander(points, DEGREE) @ inverse
        slope = legendre.legvander(points, DEGREE - 1) @ legendre.legder(inverse)
        n, count = len(points), len(self.layers)
        x, dx = np.zeros((n * count, DEGREE * count + 1)), np.zeros((n * count, DEGREE * count + 1))
        X, w, at, begin = [], [], [self.first], self.first
        for layer, (thickness, _, _) in enumerate(self.layers):
            rows, columns = slice(layer * n, (layer + 1) * n), slice(layer * DEGREE, (layer + 1) * DEGREE + 1)
            x[rows, columns], dx[rows, columns] = value, slope * 2 / thickness
            X.extend(begin + (points + 1) / 2 * thickness)
            w.extend(weights / 2 * thickness)
            at.extend(begin + (nodes[1:] + 1) / 2 * thickness)
            begin += thickness
        return np.array(X), np.array(w), x, dx, np.array(at), np.repeat(np.arange(count), n)


class Solver:
    """Residual and states of one body."""

    def __init__(self, body):
        self.body = body
        self.X, self.weights, self.x, self.dx, self.nodes, self.layer = body.grid()
        self.bent = body.shape == "bilayer"
        power = {"bilayer": 0, "tube": 1, "balloon": 2}[body.shape]
        self.w = self.X**power
        self.copies = 2 if body.shape == "balloon" else 1  # directions with lambda_t
        self.mu = float(np.mean(body.layers[0][1].mu))

    def start(self):
        """Free expansion in the free directions."""
        material, power = self.body.layers[0][1], 1.5 if self.copies == 1 else 1.0
        theta = np.mean(self.body.walls) if self.body.walls else material.theta
        stretch = float(material.at(theta).split) ** -power
        if self.bent:
            return np.concatenate([stretch * self.nodes[1:], [stretch, 0.0]])
        return stretch * self.nodes

    def split(self, y):
        """x at the nodes, lambda_r and lambda_t at the points, d lambda_t by the unknowns."""
        if not self.bent:
            return y, self.dx @ y, self.x @ y / self.X
        nodal = np.concatenate([[0.0], y[:-2]])
        return nodal, self.dx @ nodal, y[-2] + y[-1] * (self.x @ nodal)

    def temperature(self, nodal):
        """At the points; None without conduction."""
        if not self.body.walls:
            return None
        inner, outer = self.body.walls
        return inner + (outer - inner) * np.log(self.x @ nodal / nodal[0]) / np.log(nodal[-1] / nodal[0])

    def materials(self, nodal):
        """(rows, material, whether it is charged) for every layer."""
        theta = self.temperature(nodal)
        for i, (_, material, active) in enumerate(self.body.layers):
            rows = self.layer == i
            yield rows, material if theta is None else material.at(theta[rows]), active

    def charge(self, y, voltage):
        """c = D w, which gives the field to the voltage."""
        nodal, r, t = self.split(y)
        area = t**self.copies * self.w
        total = sum(np.sum((self.weights * r / area)[rows] / material.eps)
                    for rows, material, active in self.materials(nodal) if active)
        return voltage / total

    def residual(self, y, voltage):
        """Balance of the unknowns, in units of mu."""
        nodal, r, t = self.split(y)
        c = self.charge(y, voltage)
        P_r, P_t = 0 * r, 0 * r
        for rows, material, active in self.materials(nodal):
            l_r, l_t = r[rows], t[rows]
            slopes = material.slopes([l_r, l_t, l_t if self.copies == 2 else 1 + 0 * l_t])
            P_r[rows], P_t[rows] = slopes[0], slopes[1]
            if active:
                D2 = c**2 / self.w[rows] ** 2 / (2 * material.eps)
                P_r[rows] += D2 / l_t**self.copies
                P_t[rows] -= D2 * l_r / l_t ** (self.copies + 1)
        a, b = self.weights * self.w * P_r, self.weights * self.w * P_t * self.copies
        if self.bent:
            nodes = self.dx.T @ a + y[-1] * (self.x.T @ b)
            return np.concatenate([nodes[1:], [np.sum(b), b @ (self.x @ nodal)]]) / self.mu
        forces = self.dx.T @ a + self.x.T @ (b / self.X)
        forces[0] -= self.body.pressure * nodal[0] ** self.copies
        return forces / self.mu

    def stable(self, y, voltage):
        """Whether the tangent has no unstable direction among these states."""
        tangent = linearised(lambda z: self.residual(z, voltage), y)[1]
        return bool(np.all(np.linalg.eigvals(tangent).real > 0))

    def path(self, voltage, steps=20):
        """The state at a voltage, from rest over `steps`, or None past an instability."""
        y = self.start()
        pressure = self.body.pressure
        for part in np.linspace(0, 1, 6 if pressure else 2)[1:]:
            body = Layered(self.body.shape, self.body.layers, self.body.first, part * pressure,
                           self.body.walls)
            y = newton(lambda z, solver=Solver(body): solver.residual(z, 0.0), y)
            if y is None:
                return None
        for V in np.linspace(0, voltage, steps + 1)[1:]:
            y = newton(lambda z, V=V: self.residual(z, V), y)
            if y is None:
                return None
        return y if self.stable(y, voltage) else None

    def limit(self, largest):
        """The voltage of the first limit point (bisected to 1e-7 of the largest), or None."""
        low, y, step = 0.0, self.path(0.0, 1), largest / 40
        while low < largest:
            trial = newton(lambda z, V=low + step: self.residual(z, V), y, iterations=12)
            if trial is not None and self.stable(trial, low + step):
                low, y = low + step, trial
            elif step < 1e-7 * largest:
                return low
            else:
                step /= 2
        return None

    def potential(self, y, voltage, X):
        """Potential at X, from the voltage at the inner face to 0 outside."""
        nodal, r, t = self.split(y)
        c = self.charge(y, voltage)
        field = np.zeros(len(r))
        for rows, material, active in self.materials(nodal):
            if active:
                field[rows] = (c * r / (t**self.copies * self.w))[rows] / material.eps
        # The polynomial through the points of the one layer, integrated from its inner face.
        thickness = self.body.layers[0][0]
        at = 2 * (self.X - self.body.first) / thickness - 1
        series = legendre.legint(legendre.legfit(at, field, len(at) - 1), lbnd=-1) * thickness / 2
        return float(voltage - legendre.legval(2 * (X - self.body.first) / thickness - 1, series))

    def at(self, y, X):
        """x at X of a body of one layer."""
        nodal, thickness = self.split(y)[0], self.body.layers[0][0]
        at = 2 * (self.nodes - self.body.first) / thickness - 1
        return float(legendre.legval(2 * (X - self.body.first) / thickness - 1,
                                     legendre.legfit(at, nodal, DEGREE)))
