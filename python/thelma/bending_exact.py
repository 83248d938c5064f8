"""The exact circle of the two-layer bending actuator in plane strain.

A bilayer held at its sides bends into a circle, F = diag(x'(X_1), 1, t_0 + kappa x(X_1)) with
x(0) = 0 (doc/theory.md, "Bending"). Lengths are counted in thicknesses of a layer: the active layer
is 0 < X_1 < 1, the passive one 1 < X_1 < 2. With lambda_r = x', lambda_t = t_0 + kappa x and
stresses in units of mu(theta), the state is the stationary point of

    Pi = int_0^2 W dX_1 - e^2 / (2 S),   S = int_0^1 lambda_r/lambda_t dX_1,
    W = f [(s^2 (lambda_r^2 + lambda_t^2 + 1) - 3 - 2 j)/2 + (K/mu) j^2/2],
    f = theta/theta_0,  s = exp(-alpha (theta - theta_0)),  j = ln(s^3 lambda_r lambda_t)

over x, t_0 and kappa: the potential across the active layer is eliminated, because its displacement
D = e^2/S^2 does not depend on X_1. x is one polynomial a layer and Newton's method does the rest.
"""

from dataclasses import dataclass

import numpy as np
from numpy.polynomial import legendre

DEGREE = 10  # of x in a layer; the answer no longer changes beyond 8
LARGEST_STEP = 0.02  # in e, from one state to the next


@dataclass(frozen=True)
class Circle:
    """A state of the actuator; lengths in thicknesses of a layer."""

    e: float  # dimensionless field
    curvature: float  # -kappa, radians per layer thickness; positive with the active layer outside
    stretch: float  # lambda_t of the interface
    inner: float  # lambda_t of the free face of the passive layer

    def rotation(self, length):
        """Degrees between two sections a length apart."""
        return float(np.degrees(self.curvature * length))

    def tip(self, length):
        """Deflection u_1 of the interface a length from the plane of symmetry."""
        if abs(self.curvature) < 1e-12:
            return 0.0
        return self.stretch / self.curvature * (1 - np.cos(self.curvature * length))


class Bilayer:
    """Residual and tangent of Pi for (x at the nodes, t_0, kappa)."""

    def __init__(self, material, theta):
        self.f, self.s = material.factor(theta), material.split(theta)
        self.ratio = material.K / material.mu(theta)
        points, weights = legendre.leggauss(DEGREE + 4)
        nodes = -np.cos(np.pi * np.arange(DEGREE + 1) / DEGREE)
        inverse = np.linalg.inv(legendre.legvander(nodes, DEGREE))
        value = legendre.legvander(points, DEGREE) @ inverse
        slope = 2 * legendre.legvander(points, DEGREE - 1) @ legendre.legder(inverse)
        self.x = np.zeros((2 * len(points), 2 * DEGREE + 1))  # x at the points
        self.dx = np.zeros_like(self.x)  # and its slope
        for layer in range(2):
            rows = slice(layer * len(points), (layer + 1) * len(points))
            columns = slice(layer * DEGREE, (layer + 1) * DEGREE + 1)
            self.x[rows, columns], self.dx[rows, columns] = value, slope
        self.x, self.dx = self.x[:, 1:], self.dx[:, 1:]  # x(0) = 0
        self.weights = np.tile(weights / 2, 2)
        self.active = np.repeat([1.0, 0.0], len(points))
        self.nodes = np.concatenate([(nodes + 1) / 2, (nodes[1:] + 3) / 2])[1:]

    def start(self):
        """The state without a field: free expansion in the plane."""
        stretch = self.s**-1.5
        return np.concatenate([stretch * self.nodes, [stretch, 0.0]])

    def elastic(self, r, t):
        """Slopes (W_r, W_t) and second derivatives (W_rr, W_rt, W_tt)."""
        f, s2, k = self.f, self.s**2, self.ratio
        pressure = k * np.log(self.s**3 * r * t) - 1
        return ((f * (s2 * r + pressure / r), f * (s2 * t + pressure / t)),
                (f * (s2 + (k - pressure) / r**2), f * k / (r * t),
                 f * (s2 + (k - pressure) / t**2)))

    def system(self, y, e):
        """Gradient and Hessian of Pi."""
        n = len(y) - 2
        t_0, kappa, x = y[n], y[n + 1], self.x @ y[:n]
        r, t = self.dx @ y[:n], t_0 + kappa * x
        to_r = np.column_stack([self.dx, np.zeros_like(x), np.zeros_like(x)])
        to_t = np.column_stack([kappa * self.x, np.ones_like(x), x])
        gap = self.weights * self.active
        total = gap @ (r / t)
        pull = e**2 / (2 * total**2) * self.active
        (w_r, w_t), (w_rr, w_rt, w_tt) = self.elastic(r, t)
        w_r, w_t = w_r + pull / t, w_t - pull * r / t**2
        w_rt, w_tt = w_rt - pull / t**2, w_tt + 2 * pull * r / t**3
        w = self.weights
        gradient = to_r.T @ (w * w_r) + to_t.T @ (w * w_t)
        mixed = to_r.T @ ((w * w_rt)[:, None] * to_t)
        hessian = to_r.T @ ((w * w_rr)[:, None] * to_r) + mixed + mixed.T
        hessian += to_t.T @ ((w * w_tt)[:, None] * to_t)
        hessian[:n, n + 1] += self.x.T @ (w * w_t)
        hessian[n + 1, :n] += self.x.T @ (w * w_t)
        d_total = to_r.T @ (gap / t) - to_t.T @ (gap * r / t**2)
        return gradient, hessian - e**2 / total**3 * np.outer(d_total, d_total)

    def solve(self, y, e):
        """Newton's method from a state near by."""
        for _ in range(30):
            gradient, hessian = self.system(y, e)
            step = np.linalg.solve(hessian, gradient)
            y = y - step
            if np.max(np.abs(step)) < 1e-11:
                return y
        raise ValueError(f"no circle found at e = {e:g}")

    def circle(self, y, e):
        """What is worth knowing of a state."""
        n = len(y) - 2
        interface, face = (float(y[n] + y[n + 1] * y[at]) for at in (DEGREE - 1, n - 1))
        return Circle(float(e), -float(y[n + 1]), interface, face)


def circles(material, theta, fields):
    """The Circle at each of the dimensionless fields, which must not decrease."""
    bilayer = Bilayer(material, theta)
    y, reached, result = bilayer.solve(bilayer.start(), 0.0), 0.0, []
    for field in fields:
        steps = int(np.ceil((field - reached) / LARGEST_STEP))
        for e in np.linspace(reached, field, steps + 1)[1:]:
            y = bilayer.solve(y, e)
        reached = field
        result.append(bilayer.circle(y, field))
    return result
