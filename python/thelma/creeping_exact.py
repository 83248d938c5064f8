"""The exact circle of the two-layer bending actuator as it creeps under a voltage.

With Maxwell branches (doc/theory.md, "Memory") the actuator of bending_exact.py stays a circle: at every X_1
the branches have their own C_v = diag(exp(a_r), exp(-a_r - a_t), exp(a_t)), and with the elastic strain
b = (lambda_r^2, 1, lambda_t^2) J^(-2/3) / C_v they add to W, in units of mu(theta),

    f G/(2 mu) (tr b - 3),   and flow by   a' = (b - tr b/3)/tau.

The circle that balances e for given a is found by Newton's method; the flow is integrated as an ordinary
differential equation of a at the points of the quadrature.
"""

import numpy as np
from thelma.bending_exact import LARGEST_STEP, Bilayer
from scipy.integrate import solve_ivp
from thelma.viscoelastic_exact import BRANCHES_VHB, Branch, Film, arrhenius

TOLERANCE = {"rtol": 1e-6, "atol": 1e-8}  # of a; then rotations are within 1e-7
# MPa and s, of prm/creeping_bending_actuator.prm.
BRANCHES = tuple(Branch(1e-3 * branch.G, arrhenius(branch.tau, 50e3, 293.0)) for branch in BRANCHES_VHB)


class CreepingBilayer(Bilayer):
    """A bilayer of a material with branches, at one temperature."""

    def __init__(self, material, theta, branches):
        super().__init__(material, theta)
        film = Film(None, tuple(branches), theta=theta)
        self.stiffness, self.tau = self.f * film.G[:, None] / material.mu(theta), film.tau[:, None]
        self.a = np.zeros((2, len(branches), len(self.weights)))  # a_r and a_t

    def strain(self, r, t):
        """b_r, b_t and a third of the trace."""
        mean = np.log(r * t) / 3
        b_r, b_t = (np.exp(2 * (np.log(stretch) - mean) - a) for stretch, a in zip((r, t), self.a))
        return b_r, b_t, (b_r + b_t + np.exp(-2 * mean + self.a[0] + self.a[1])) / 3

    def elastic(self, r, t):
        """Slopes and second derivatives, with those of the branches."""
        (w_r, w_t), (w_rr, w_rt, w_tt) = super().elastic(r, t)
        b_r, b_t, mean = self.strain(r, t)

        def over(values):
            return np.sum(self.stiffness * values, axis=0)

        p_r, p_t = over(b_r - mean), over(b_t - mean)  # slopes by the logarithms
        return ((w_r + p_r / r, w_t + p_t / t),
                (w_rr + (over(2 / 3 * (b_r + mean)) - p_r) / r**2,
                 w_rt + over(2 / 3 * (mean - b_r - b_t)) / (r * t),
                 w_tt + (over(2 / 3 * (b_t + mean)) - p_t) / t**2))

    def flow(self, y):
        """a'."""
        n = len(y) - 2
        b_r, b_t, mean = self.strain(self.dx @ y[:n], y[n] + y[n + 1] * (self.x @ y[:n]))
        return np.array([b_r - mean, b_t - mean]) / self.tau

    def sudden(self, e):
        """The state that a field makes without time to flow."""
        y = self.solve(self.start(), 0.0)
        for field in np.linspace(0, e, 1 + int(np.ceil(e / LARGEST_STEP)))[1:]:
            y = self.solve(y, field)
        return y


def creep(material, theta, branches, e, times):
    """The Circle at each of the times, which increase, under a field e that is there from t = 0 on."""
    bilayer = CreepingBilayer(material, theta, branches)
    shape, y = bilayer.a.shape, bilayer.sudden(e)

    def balanced(a):
        nonlocal y
        bilayer.a = a.reshape(shape)
        y = bilayer.solve(y, e)
        return y

    found = solve_ivp(lambda _, a: bilayer.flow(balanced(a)).ravel(), (0, times[-1]), bilayer.a.ravel(),
                      "Radau", t_eval=times, first_step=1e-3 * bilayer.tau.min(), **TOLERANCE)
    return [bilayer.circle(balanced(a), e) for a in found.y.T]
