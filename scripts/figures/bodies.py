"""Bodies from the program's fields: read, mirrored, given a width."""

from dataclasses import dataclass

import numpy as np

from thelma import plotting
from thelma.fields import read_fields, vtk  # first: says what is missing
from vtkmodules.util.numpy_support import numpy_to_vtk


@dataclass
class Body:
    """Hexahedra with displacement and other fields at their corners."""

    points: np.ndarray  # undeformed, (n, 3) in mm
    cells: np.ndarray  # (m, 8)
    fields: dict  # name -> (n,), of vectors the magnitude, but of the displacement u (n, 3)

    @property
    def u(self):
        """Displacement in mm."""
        return self.fields["u"]

    def mirrored(self, normal, offset=0.0):
        """Mirror image at the plane x_normal = offset, as a body of its own."""
        sign = np.ones(3)
        sign[normal] = -1
        points, fields = self.points * sign, {**self.fields, "u": self.u * sign}
        points[:, normal] += 2 * offset
        return Body(points, np.roll(self.cells, 4, axis=1), fields)  # bottom and top swapped

    def grid(self, deformed=True):
        """The vtkUnstructuredGrid of the body, with its fields and u1, u2, u3."""
        points = vtk.vtkPoints()
        place = self.points + self.u if deformed else self.points
        points.SetData(numpy_to_vtk(np.ascontiguousarray(place, dtype=float), deep=True))
        cells = vtk.vtkCellArray()
        for corners in self.cells:
            cells.InsertNextCell(8, [int(corner) for corner in corners])
        grid = vtk.vtkUnstructuredGrid()
        grid.SetPoints(points)
        grid.SetCells(vtk.VTK_HEXAHEDRON, cells)
        components = {f"u{i + 1}": self.u[:, i] for i in range(3)}
        for name, values in {**self.fields, **components}.items():
            array = numpy_to_vtk(np.ascontiguousarray(values, dtype=float), deep=True)
            array.SetName(name)
            grid.GetPointData().AddArray(array)
        return grid

    @staticmethod
    def span(bodies, name):
        """Range of a scalar field over several bodies, for colours: VTK ends the process at none."""
        values = np.concatenate([body.values(name) for body in bodies])
        low, high = float(values.min()), float(values.max())
        return low, high if high > low else low + 1.0

    def values(self, name):
        """A scalar field by name; u1, u2, u3 are components of u."""
        return self.u[:, int(name[1]) - 1] if name in ("u1", "u2", "u3") else self.fields[name]


def together(first, second):
    """Two bodies as one; common points are shared, so that no seam shows."""
    cells = np.concatenate([first.cells, second.cells + len(first.points)])
    fields = {name: np.concatenate([values, second.fields[name]])
              for name, values in first.fields.items()}
    return joined(np.concatenate([first.points, second.points]), cells, fields)


def load(folder, width=None, at=None):
    """A state of a run (thelma.fields). A plane one, of x1 and x3, becomes a body of the given width."""
    state = read_fields(folder, at)
    if "u" not in state.values:
        raise plotting.PlotError(f"the fields of {folder} have no displacement 'u'.")
    values = {name: np.linalg.norm(one, axis=1) if name != "u" and one.ndim == 2 else one
              for name, one in state.values.items()}
    body = joined(state.points, state.cells, values)
    return extruded(body, width or 1.0) if state.is_plane else body


def joined(points, cells, fields):
    """The program writes the corners of every cell; neighbours shall share them."""
    _, first, place = np.unique(points.round(5), axis=0, return_index=True, return_inverse=True)
    return Body(points[first], place.ravel()[cells],
                {name: values[first].astype(float) for name, values in fields.items()})


def extruded(plane, width):
    """A body of the plane's x1, x3 (its first and second coordinate) and a width along x2."""
    def sides(values, offset=0.0):
        side = values[:, [0, 2, 1]]
        return np.concatenate([side, side + [0.0, offset, 0.0]])

    cells = np.concatenate([plane.cells, plane.cells + len(plane.points)], axis=1)
    fields = {name: np.concatenate([values, values]) for name, values in plane.fields.items()
              if name != "u"}
    return Body(sides(plane.points, width), cells, {**fields, "u": sides(plane.u)})
