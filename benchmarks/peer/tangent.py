"""The tangent as PETSc's matrix, assembled in two ways."""

import itertools
from collections import deque

import numpy as np
from cffi import FFI
from dolfinx.fem import petsc as assembler
from mpi4py import MPI
from petsc4py import PETSc


class DolfinxMatrix:
    """By DOLFINx's own assembler; held unknowns keep their rows."""

    def __init__(self, actuator):
        self.actuator = actuator
        self.matrix = assembler.create_matrix(actuator.tangent_form)
        self.matrix.setOption(PETSc.Mat.Option.SYMMETRIC, True)
        self.rows = slice(None)

    def assemble(self):
        """At the actuator's state."""
        self.matrix.zeroEntries()
        assembler.assemble_matrix(self.matrix, self.actuator.tangent_form,
                                  [self.actuator.condition])
        self.matrix.assemble()


class GatheredMatrix:
    """By calling FFCx's kernels cell by cell and summing to the upper triangle of the free rows.

    The positions are found once, where DOLFINx's assembler searches for them again and again.
    """

    def __init__(self, actuator):
        self.actuator = actuator
        size, n_local = len(actuator.state.x.array), actuator.cell_dofs.shape[1]
        self.rows = np.setdiff1d(np.arange(size), actuator.held)
        self.find_positions(size)
        self.values = np.zeros((actuator.n_cells, n_local, n_local))
        self.states = np.zeros((actuator.n_cells, n_local))
        self.calls = self.kernel_calls()

    def find_positions(self, size):
        """Which values of the cells make up which entry."""
        n = len(self.rows)
        number = np.full(size, -1)
        number[self.rows] = np.arange(n)
        numbers = number[self.actuator.cell_dofs]
        i, j = np.broadcast_arrays(numbers[:, :, None], numbers[:, None, :])
        place = np.where((i >= 0) & (j >= i), i * n + j, -1).ravel()
        self.order = np.argsort(place, kind="stable")[np.count_nonzero(place < 0):]
        places, self.starts = np.unique(place[self.order], return_index=True)
        row_starts = np.searchsorted(places, n * np.arange(n + 1))
        self.entries = np.zeros(len(places))
        self.matrix = PETSc.Mat().createAIJWithArrays(
            (n, n), (row_starts.astype(PETSc.IntType), (places % n).astype(PETSc.IntType),
                     self.entries), comm=MPI.COMM_SELF)

    def kernel_calls(self):
        """Pairs of a kernel and the arguments for its cells."""
        actuator, ffi = self.actuator, FFI()
        geometry = actuator.domain.geometry
        self.corners = np.array([geometry.x[geometry.dofmap.links(c)]
                                 for c in range(actuator.n_cells)])

        def pointers(array):
            return [ffi.cast("double *", array.ctypes.data + c * array.strides[0])
                    for c in range(actuator.n_cells)]

        nothing = itertools.repeat(ffi.NULL)
        arguments = list(zip(pointers(self.values), pointers(self.states), nothing,
                             pointers(self.corners), nothing, nothing))
        form, over_cells = actuator.tangent_form.ufcx_form, 0
        integrals, layers = form.integrals(over_cells), form.integral_ids(over_cells)
        return [(integrals[k].tabulate_tensor_float64,
                 [arguments[c] for c in np.flatnonzero(actuator.layers == layers[k])])
                for k in range(form.num_integrals(over_cells))]

    def assemble(self):
        """At the actuator's state."""
        self.values[:] = 0
        np.take(self.actuator.state.x.array, self.actuator.cell_dofs, out=self.states)
        for kernel, arguments in self.calls:
            deque(itertools.starmap(kernel, arguments), maxlen=0)  # a loop without Python in it
        np.add.reduceat(self.values.ravel()[self.order], self.starts, out=self.entries)
        self.matrix.assemble()


ASSEMBLIES = {"dolfinx": DolfinxMatrix, "gathered": GatheredMatrix}
