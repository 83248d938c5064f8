"""The bending actuator in UFL: elements, supports, energy."""

import math
from dataclasses import dataclass

import basix
import numpy as np
import ufl
from dolfinx import fem, mesh
from mpi4py import MPI

# mm, N, MPa, kV, K: prm/bending_actuator.prm at 353 K.
THICKNESS, WIDTH, LENGTH = 1.0, 4.0, 20.0
INTERFACE = THICKNESS / 2
THETA, THETA_0, ALPHA, EPS = 353.0, 293.0, 1.8e-4, 3.98e-5
TARGET = 0.475  # of e = (2 V/H) sqrt(eps/mu)
TIP = 0.664257  # u_1/L of the interface's tip there, converged

COMPILER = {"cffi_extra_compile_args": ["-Ofast", "-march=native"], "cffi_libraries": ["m"]}
ACTIVE, PASSIVE = 1, 2


def shear_modulus(theta):
    """MPa (doc/theory.md)."""
    return (0.2001 * (1000 / theta) ** 2 - 1.078 * (1000 / theta) + 1.5180) / 3


MU = THETA / THETA_0 * shear_modulus(THETA)
BULK = THETA / THETA_0 * 1000 * shear_modulus(THETA_0)
J_THETA = math.exp(3 * ALPHA * (THETA - THETA_0))


def voltage(e):
    """kV."""
    return e * INTERFACE * math.sqrt(shear_modulus(THETA) / EPS)


@dataclass(frozen=True)
class Element:
    """Degree of u and phi, element of the pressure, degree of the quadrature, load steps."""

    degree: int
    pressure: tuple
    quadrature: int
    steps: int  # those with the fewest iterations among 2 to 12


ELEMENTS = {"Q1 selective reduced": Element(1, (), 3, 8),
            "Q1/P0": Element(1, ("DG", 0), 3, 3),
            "Q2/P1": Element(2, ("DPC", 1), 5, 3)}


class Actuator:
    """The state is x = (u_1, u_2, u_3, phi, p), p where the element has a pressure.

    Scalar components, since FFCx's loops over those of a vector element have a stride.
    """

    def __init__(self, element, cells):
        self.element = element
        self.domain = mesh.create_box(
            MPI.COMM_SELF, [[0, 0, 0], [THICKNESS, WIDTH, LENGTH]], list(cells),
            mesh.CellType.hexahedron)
        self.n_cells = math.prod(cells)
        self.cell_size = np.array([THICKNESS, WIDTH, LENGTH]) / cells
        shape = self.domain.ufl_cell()
        parts = 4 * [ufl.FiniteElement("Q", shape, element.degree)]
        if element.pressure:
            family, degree = element.pressure
            parts.append(ufl.FiniteElement(family, shape, degree))
        self.space = fem.FunctionSpace(self.domain, ufl.MixedElement(parts))
        self.state = fem.Function(self.space)
        collapsed = [self.space.sub(i).collapse() for i in range(len(parts))]
        self.dofs = [np.array(dofs) for _, dofs in collapsed]
        self.cell_dofs = np.array([self.space.dofmap.cell_dofs(c) for c in range(self.n_cells)])
        self.nodes = collapsed[0][0].tabulate_dof_coordinates()  # the same for u_i and phi
        self.hold()
        variation = ufl.derivative(self.energy(), self.state, ufl.TestFunction(self.space))
        tangent = ufl.derivative(variation, self.state, ufl.TrialFunction(self.space))
        self.residual_form = fem.form(variation, jit_params=COMPILER)
        self.tangent_form = fem.form(tangent, jit_params=COMPILER)

    def at(self, direction, value):
        """Which nodes."""
        return np.isclose(self.nodes[:, direction], value)

    def hold(self):
        """Supports, electrodes, and no potential in the passive layer."""
        u_1, u_2, u_3, phi = self.dofs[:4]
        interface = self.at(0, INTERFACE)
        passive = interface | (self.nodes[:, 0] > INTERFACE)
        self.held = np.concatenate([
            u_1[interface & self.at(2, 0)], u_2[self.at(1, 0) | self.at(1, WIDTH)],
            u_3[self.at(2, 0)], phi[self.at(0, 0) | passive]]).astype(np.int32)
        self.condition = fem.dirichletbc(fem.Function(self.space), self.held)
        self.tip_dofs = u_1[interface & self.at(2, LENGTH)]

    def energy(self):
        """Stationary at the solution; a pressure is one of the unknowns."""
        dim = self.domain.topology.dim
        cells = np.arange(self.n_cells, dtype=np.int32)
        centres = mesh.compute_midpoints(self.domain, dim, cells)
        self.layers = np.where(centres[:, 0] < INTERFACE, ACTIVE, PASSIVE).astype(np.int32)
        layers = mesh.meshtags(self.domain, dim, cells, self.layers)

        def over(layer, degree):
            return ufl.Measure("dx", self.domain, subdomain_data=layers,
                               metadata={"quadrature_degree": degree})(layer)

        split = ufl.split(self.state)
        F = ufl.Identity(3) + ufl.grad(ufl.as_vector(split[:3]))
        J = ufl.det(F)
        log_J = ufl.ln(J / J_THETA)
        elastic = MU / 2 * (J_THETA ** (-2 / 3) * ufl.inner(F, F) - 3 - 2 * log_J)
        E = ufl.inv(F).T * ufl.grad(split[3])
        electric = -EPS / 2 * J * ufl.inner(E, E)
        full, once = self.element.quadrature, 0
        if self.element.pressure:
            pressure = split[4]
            elastic += pressure * log_J - pressure ** 2 / (2 * BULK)
            return (elastic + electric) * over(ACTIVE, full) + elastic * over(PASSIVE, full)
        volumetric = BULK / 2 * log_J ** 2
        return ((elastic + electric) * over(ACTIVE, full) + elastic * over(PASSIVE, full)
                + volumetric * over(ACTIVE, once) + volumetric * over(PASSIVE, once))

    def expand(self):
        """The exact state at e = 0: expands freely but for the sides; phi as for 1 kV."""
        mu, square = MU * J_THETA ** (-2 / 3), J_THETA
        for _ in range(20):
            stress = mu * square - MU + BULK * math.log(square / J_THETA)
            square -= stress / (mu + BULK / square)
        stretch, x = math.sqrt(square), self.state.x.array
        x[:] = 0
        x[self.dofs[0]] = (stretch - 1) * (self.nodes[:, 0] - INTERFACE)
        x[self.dofs[2]] = (stretch - 1) * self.nodes[:, 2]
        x[self.dofs[3]] = np.maximum(0, 1 - self.nodes[:, 0] / INTERFACE)
        if self.element.pressure:
            x[self.dofs[4]] = BULK * math.log(square / J_THETA)

    def residual_scales(self):
        """Pairs of the dofs of a field and its unit of the residual's norm, as in Thelma: nodal
        forces of a stress mu, charges of a displacement sqrt(mu eps), an error 1 of ln J."""
        hexahedron, degree = basix.CellType.hexahedron, self.element.degree
        points, weights = basix.make_quadrature(hexahedron, self.element.quadrature)
        shapes = basix.create_element(basix.ElementFamily.P, hexahedron, degree,
                                      basix.LagrangeVariant.gll_warped).tabulate(1, points)
        gradients = np.linalg.norm(shapes[1:, :, :, 0] / self.cell_size[:, None, None], axis=0)
        share = np.prod(self.cell_size) * weights @ gradients  # of a node in any of the equal boxes
        forces = np.zeros(len(self.state.x.array))
        parts = np.split(self.cell_dofs[:, :4 * len(share)], 4, axis=1)
        for part in parts[:3]:
            np.add.at(forces, part, MU * share)
        np.add.at(forces, parts[3][self.layers == ACTIVE], math.sqrt(MU * EPS) * share)
        forces[self.held] = 0
        fields = [np.concatenate(self.dofs[:3]), self.dofs[3]]
        scales = [(dofs, np.linalg.norm(forces[dofs])) for dofs in fields]
        if self.element.pressure:
            volume = THICKNESS * WIDTH * LENGTH
            scales.append((self.dofs[4], volume / math.sqrt(len(self.dofs[4]))))
        return scales

    def tip(self):
        """u_1/L."""
        return self.state.x.array[self.tip_dofs].mean() / LENGTH
