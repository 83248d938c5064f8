"""Fields of a run, its `fields.pvd` and .vtu or .pvtu files, as arrays. VTK reads them."""

import re
from dataclasses import dataclass
from pathlib import Path

import numpy as np

from thelma.errors import ThelmaError
from thelma.study import StudyError, existing

try:
    import vtk
    from vtkmodules.util.numpy_support import vtk_to_numpy
except ImportError:
    raise ThelmaError("fields need VTK for Python; on Debian install python3-vtk9 and use /usr/bin/python3.") from None

vtk.vtkLogger.SetStderrVerbosity(vtk.vtkLogger.VERBOSITY_WARNING)  # 9.3 tells of every edge

CORNERS = {vtk.VTK_QUAD: 4, vtk.VTK_HEXAHEDRON: 8}


@dataclass
class Fields:
    """A state of a body. Neighbouring cells have corners of their own, where P, D, E and J may differ."""

    points: np.ndarray  # undeformed, (n, 3) in mm; of a plane one x1, x3, 0
    cells: np.ndarray  # corners, (m, 4) or (m, 8)
    values: dict  # name -> (n,) or (n, 3), ...

    def __getitem__(self, name):
        if name not in self.values:
            raise ThelmaError(f"there is no field '{name}'; known: {', '.join(self.values)}")
        return self.values[name]

    @property
    def deformed(self):
        """Points where they are now."""
        return self.points + self["u"]

    @property
    def is_plane(self):
        """Whether the cells are quadrilaterals."""
        return self.cells.shape[1] == 4

    def frame(self):
        """A pandas.DataFrame with a row per corner, vectors by component."""
        import pandas  # pylint: disable=import-outside-toplevel  # optional
        columns = {}
        for name, values in {"X": self.points, **self.values}.items():
            parts = values.reshape(len(values), -1)
            for i, part in enumerate(parts.T, 1):
                columns[name if parts.shape[1] == 1 else f"{name}{i}"] = part
        return pandas.DataFrame(columns)


def state_file(folder, at=None):
    """The field file of a run that is nearest to a load or, in time, second; without one the last."""
    text = existing(folder / "fields.pvd").read_text()
    files = re.findall(r'timestep="([^"]+)".*?file="([^"]+)"', text)
    if not files:
        raise StudyError(f"{folder / 'fields.pvd'} names no file.")
    _, name = files[-1] if at is None else min(files, key=lambda file: abs(float(file[0]) - at))
    return existing(folder / name)


def read_fields(folder, at=None):
    """A state of a run (state_file)."""
    return read_file(state_file(Path(folder), at))


def read_file(path):
    """A .vtu or .pvtu file."""
    reader = (vtk.vtkXMLPUnstructuredGridReader if path.suffix == ".pvtu"
              else vtk.vtkXMLUnstructuredGridReader)()
    reader.SetFileName(str(path))
    reader.Update()
    grid = reader.GetOutput()
    kind = grid.GetCellType(0) if grid.GetNumberOfCells() else None
    if kind not in CORNERS:
        raise ThelmaError(f"{path} has no quadrilaterals or hexahedra.")
    cells = vtk_to_numpy(grid.GetCells().GetConnectivityArray()).reshape(-1, CORNERS[kind])
    data = grid.GetPointData()
    values = {data.GetArrayName(i): vtk_to_numpy(data.GetArray(i)) for i in range(data.GetNumberOfArrays())}
    return Fields(vtk_to_numpy(grid.GetPoints().GetData()).astype(float), cells, values)
