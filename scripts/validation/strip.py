"""Buckling of a strip in plane strain between two smooth walls: incremental analysis.

The strip [0, H] x [0, L] in x1, x3 has electrodes on x1 = 0 and H and slides along walls at x3 = 0 and L, of
which one may be pushed. Its straight state is homogeneous, lambda_2 = 1 and lambda_3 given. Increments

    u_1 = f(x1) cos(k x3),  u_3 = g(x1) sin(k x3),  phi = h(x1) cos(k x3),  k = m pi/L,  h(0) = h(H) = 0

satisfy the conditions at the walls exactly. With one polynomial each for f, g and h the second variation is
a small matrix, and the strip buckles where it loses its definiteness.
"""

from dataclasses import dataclass

import numpy as np
from numpy.polynomial import legendre

from validation.material import Material, newton

DEGREE = 10  # of f, g and h


@dataclass(frozen=True)
class Strip:
    """A strip of one material."""

    material: Material
    length: float
    thickness: float

    def across(self, l_3, E):
        """lambda_1 of the straight state."""
        def residual(z):
            slope = self.material.slopes([z[0], 1 + 0 * z[0], l_3 + 0 * z[0]])[0]
            # The field is along x1, so that lambda_1 takes the part of a film's lambda_3.
            return np.array([slope + self.material.eps / 2 * E**2 * l_3 / z[0]**2]) / self.material.mu

        found = newton(residual, [1 / l_3])
        return None if found is None else float(found[0])

    def unstable(self, l_3, E, waves):
        """Number of unstable directions with m = waves half waves along the strip."""
        l_1 = self.across(l_3, E)
        A = self.material.tangent(np.diag([l_1, 1.0, l_3]), np.array([E, 0, 0]))
        points, weights = legendre.leggauss(DEGREE + 2)
        H, k = self.thickness, waves * np.pi / self.length
        value = legendre.legvander(points, DEGREE)
        slope = legendre.legvander(points, DEGREE - 1) @ legendre.legder(np.eye(DEGREE + 1)) * 2 / H
        n = DEGREE + 1
        bubble = np.eye(n)[:, 2:] - np.eye(n)[:, [0, 1] * n][:, :n - 2]  # P_j - P_0 or P_1
        h, dh = value @ bubble, slope @ bubble
        # Gradients with cos(k x3): u_1,1, u_3,3, phi,1; with sin(k x3): u_1,3, u_3,1, phi,3.
        even = {0: (0, slope), 8: (1, k * value), 9: (2, dh)}
        odd = {2: (0, -k * value), 6: (1, slope), 11: (2, -k * h)}
        offsets, size = (0, n, 2 * n), 2 * n + bubble.shape[1]
        matrix = np.zeros((size, size))
        for gradients in (even, odd):
            for row, (a, left) in gradients.items():
                for column, (b, right) in gradients.items():
                    block = A[row, column] * left.T @ ((weights * H / 2)[:, None] * right)
                    matrix[offsets[a]:offsets[a] + block.shape[0],
                           offsets[b]:offsets[b] + block.shape[1]] += block
        K, C, electric = matrix[:2 * n, :2 * n], matrix[:2 * n, 2 * n:], matrix[2 * n:, 2 * n:]
        return int(np.sum(np.linalg.eigvalsh(K - C @ np.linalg.solve(electric, C.T)) < 0))

    def first_bifurcation(self, state, largest, modes=6):
        """The smallest parameter p, state(p) = (lambda_3, E), with an unstable direction, and its m."""
        def unstable(p):
            return next((m for m in range(1, modes + 1) if self.unstable(*state(p), m)), 0)

        grid = np.linspace(0, largest, 41)
        above = next((i for i, p in enumerate(grid) if unstable(p)), None)
        if not above:
            return None if above is None else (0.0, unstable(0.0))
        low, high = grid[above - 1], grid[above]
        while high - low > 1e-9 * largest:
            middle = (low + high) / 2
            low, high = (low, middle) if unstable(middle) else (middle, high)
        return high, unstable(high)
