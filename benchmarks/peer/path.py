"""Newton's method along the load steps, with MUMPS' LDL^T; seconds by phase."""

import math
import time
from contextlib import contextmanager

import numpy as np
from actuator import TARGET, voltage
from dolfinx.fem import petsc as assembler
from mpi4py import MPI
from petsc4py import PETSc
from tangent import ASSEMBLIES

TOLERANCE = 1e-10  # of the scaled residual
MAX_ITERATIONS = 30
PREDICTED_FROM = 4  # states: a cubic in e^2, quadratic where only three steps are taken
# PORD, no ScaLAPACK, workspace for pivoting; scaling changes no pivot here.
MUMPS = {"icntl_7": 4, "icntl_13": 1, "icntl_14": 50, "icntl_8": 0}


class PathError(Exception):
    """One sentence."""


class Path:
    """From e = 0 to the target."""

    def __init__(self, actuator, assembly):
        self.actuator = actuator
        self.tangent = ASSEMBLIES[assembly](actuator)
        self.residual_vector = assembler.create_vector(actuator.residual_form)
        self.right, self.correction = self.tangent.matrix.createVecs()
        self.scales = actuator.residual_scales()
        options = PETSc.Options()
        for name, value in MUMPS.items():
            options[f"mat_mumps_{name}"] = value

    def start(self):
        """A solver that has not analysed the matrix yet, and the state at e = 0."""
        self.linear = PETSc.KSP().create(MPI.COMM_SELF)
        self.linear.setOperators(self.tangent.matrix)
        self.linear.setType("preonly")
        self.linear.getPC().setType("cholesky")
        self.linear.getPC().setFactorSolverType("mumps")
        self.linear.setFromOptions()
        self.actuator.expand()
        self.seconds, self.iterations = {}, 0

    @contextmanager
    def measure(self, phase):
        """Adds the seconds of a block."""
        begin = time.perf_counter()
        yield
        self.seconds[phase] = self.seconds.get(phase, 0.0) + time.perf_counter() - begin

    def residual(self):
        """Assembles it; the largest of the scaled norms."""
        with self.measure("residual"):
            vector = self.residual_vector.array_w
            vector[:] = 0
            assembler.assemble_vector(self.residual_vector, self.actuator.residual_form)
            vector[self.actuator.held] = 0
            return max(np.linalg.norm(vector[dofs]) / scale for dofs, scale in self.scales)

    def correct(self):
        """An iteration of Newton's method."""
        with self.measure("assembly"):
            self.tangent.assemble()
        with self.measure("factorisation"):
            self.linear.getPC().setUp()
        with self.measure("solve"):
            self.right.array_w[:] = self.residual_vector.array_r[self.tangent.rows]
            self.linear.solve(self.right, self.correction)
            self.actuator.state.x.array[self.tangent.rows] -= self.correction.array_r
        self.iterations += 1

    def newton(self, e):
        """To equilibrium, from the predicted state."""
        norm = self.residual()
        for _ in range(MAX_ITERATIONS):
            self.correct()
            norm = self.residual()
            if norm <= TOLERANCE:
                return
            if not math.isfinite(norm):
                break
        raise PathError(f"no convergence at e = {e:g}, residual {norm:.1e}.")

    def run(self):
        """Seconds of the whole path; the potential is extrapolated per kV, and all of it in e^2,
        of which the state is a smooth function."""
        self.start()
        x, phi = self.actuator.state.x.array, self.actuator.dofs[3]
        begin = time.perf_counter()
        known = [(0.0, x.copy())]
        for step in range(1, self.actuator.element.steps + 1):
            e = TARGET * step / self.actuator.element.steps
            with self.measure("prediction"):
                x[:] = extrapolated(known[-PREDICTED_FROM:], e * e)
                x[phi] *= voltage(e)
            self.newton(e)
            known.append((e * e, x.copy()))
            known[-1][1][phi] /= voltage(e)
        return time.perf_counter() - begin


def extrapolated(known, t):
    """The polynomial through the pairs (t_i, x_i) at t."""
    return sum(math.prod((t - t_j) / (t_i - t_j) for t_j, _ in known if t_j != t_i) * x_i
               for t_i, x_i in known)
