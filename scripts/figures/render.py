"""Pictures of bodies by VTK, off-screen."""

import contextlib
import os
import shutil
import subprocess

import numpy as np
from thelma import plotting
import vtk
from vtkmodules.util.numpy_support import vtk_to_numpy

OVERSAMPLING = 3  # pixels rendered per pixel kept, each way
NO_EDGES, EDGES = 0.0, 0.35  # opacity of the mesh


def start_server():
    """A virtual X server and its number. MPI asks the servers 0 to 9 for graphics cards when programs
    start, which end with the server."""
    for number in range(99, 199):
        read, write = os.pipe()
        command = ["Xvfb", f":{number}", "-displayfd", str(write), "-screen", "0", "64x64x24", "-nolisten",
                   "tcp", "-noreset"]
        server = subprocess.Popen(command, pass_fds=[write], stdout=subprocess.DEVNULL,
                                  stderr=subprocess.DEVNULL)
        os.close(write)
        with os.fdopen(read) as pipe:
            if pipe.readline().strip():
                return server, number
        server.wait()  # the number is another's
    raise plotting.PlotError("Xvfb did not start.")


@contextlib.contextmanager
def display():
    """VTK of Debian draws on an X display only: a virtual one if that is installed."""
    if not shutil.which("Xvfb"):
        if os.environ.get("DISPLAY"):
            yield
            return
        raise plotting.PlotError("shapes need an X display or Xvfb; on Debian install xvfb.")
    server, number = start_server()
    before = os.environ.get("DISPLAY")
    try:
        os.environ["DISPLAY"] = f":{number}"
        yield
    finally:
        server.terminate()
        server.wait()
        os.environ.pop("DISPLAY")
        if before is not None:
            os.environ["DISPLAY"] = before


def lookup_table(colormap, low, high):
    """A matplotlib colour map for VTK."""
    table = vtk.vtkLookupTable()
    table.SetNumberOfTableValues(256)
    table.SetRange(low, high)
    for i, color in enumerate(colormap(np.linspace(0, 1, 256))):
        table.SetTableValue(i, *color)
    return table


class Scene:
    """Bodies and lines, seen in parallel projection."""

    def __init__(self, direction, up):
        self.direction, self.up = np.array(direction, float), up
        self.renderer = vtk.vtkRenderer()
        self.renderer.SetBackground(1, 1, 1)

    def add_body(self, body, name, colormap, limits, edges=EDGES):
        """The deformed body, coloured by one of its fields."""
        surface = vtk.vtkDataSetSurfaceFilter()
        surface.SetInputData(body.grid())
        normals = vtk.vtkPolyDataNormals()
        normals.SetInputConnection(surface.GetOutputPort())
        normals.SetFeatureAngle(50)
        mapper = vtk.vtkPolyDataMapper()
        mapper.SetInputConnection(normals.GetOutputPort())
        mapper.SetScalarModeToUsePointFieldData()
        mapper.SelectColorArray(name)
        mapper.SetLookupTable(lookup_table(colormap, *limits))
        mapper.SetScalarRange(*limits)
        mapper.InterpolateScalarsBeforeMappingOn()
        actor = vtk.vtkActor()
        actor.SetMapper(mapper)
        actor.GetProperty().SetAmbient(0.6)
        actor.GetProperty().SetDiffuse(0.45)
        self.renderer.AddActor(actor)
        if edges:
            self.add_edges(body.grid(), edges)

    def add_edges(self, grid, opacity=1.0, width=1.0, feature_angle=None,
                  color=(0.1, 0.1, 0.1)):
        """The mesh on the surface of a grid, or only its sharp edges."""
        surface = vtk.vtkDataSetSurfaceFilter()
        surface.SetInputData(grid)
        if feature_angle:
            edges = vtk.vtkFeatureEdges()
            edges.SetFeatureAngle(feature_angle)
            edges.ColoringOff()
        else:
            edges = vtk.vtkExtractEdges()
        edges.SetInputConnection(surface.GetOutputPort())
        self.add_lines(edges.GetOutputPort(), color, opacity, width)

    def add_polyline(self, points, color=(0, 0, 0), width=2.0):
        """A line through points in mm."""
        line, coordinates = vtk.vtkPolyLineSource(), np.asarray(points, float)
        line.SetNumberOfPoints(len(coordinates))
        for i, point in enumerate(coordinates):
            line.SetPoint(i, *point)
        self.add_lines(line.GetOutputPort(), color, 1.0, width)

    def add_lines(self, port, color, opacity, width):
        """Lines in front of the surfaces they lie on."""
        mapper = vtk.vtkPolyDataMapper()
        mapper.SetInputConnection(port)
        mapper.ScalarVisibilityOff()
        mapper.SetResolveCoincidentTopologyToPolygonOffset()
        mapper.SetRelativeCoincidentTopologyLineOffsetParameters(-2, -2)
        actor = vtk.vtkActor()
        actor.SetMapper(mapper)
        actor.GetProperty().SetLighting(False)
        actor.GetProperty().SetColor(*color)
        actor.GetProperty().SetOpacity(opacity)
        actor.GetProperty().SetLineWidth(width * OVERSAMPLING)
        self.renderer.AddActor(actor)

    def picture(self, pixels_per_mm):
        """The scene at this scale, cut to what is in it: an array of RGB."""
        camera = self.renderer.GetActiveCamera()
        low, high = np.array(self.renderer.ComputeVisiblePropBounds()).reshape(3, 2).T
        size = np.linalg.norm(high - low) * 1.05
        camera.ParallelProjectionOn()
        camera.SetFocalPoint(*(low + high) / 2)
        camera.SetPosition(*((low + high) / 2 + self.direction * 3 * size))
        camera.SetViewUp(*self.up)
        camera.SetParallelScale(size / 2)
        self.renderer.ResetCameraClippingRange()
        window = vtk.vtkRenderWindow()
        window.SetOffScreenRendering(1)
        window.SetMultiSamples(0)
        side = OVERSAMPLING * int(np.ceil(size * pixels_per_mm))
        window.SetSize(side, side)
        window.AddRenderer(self.renderer)
        window.Render()
        pixels = grabbed(window)
        window.RemoveRenderer(self.renderer)
        window.Finalize()
        return cut(pixels)


def grabbed(window):
    """What the window shows, averaged over the oversampling."""
    grab = vtk.vtkWindowToImageFilter()
    grab.SetInput(window)
    grab.ReadFrontBufferOff()
    grab.Update()
    image = grab.GetOutput()
    width, height, _ = image.GetDimensions()
    pixels = vtk_to_numpy(image.GetPointData().GetScalars()).reshape(height, width, 3)[::-1]
    n = OVERSAMPLING
    blocks = pixels[:height // n * n, :width // n * n].reshape(height // n, n, width // n, n, 3)
    return blocks.mean(axis=(1, 3)).round().astype(np.uint8)


def cut(pixels, margin=4):
    """Without the white around."""
    rows, columns = (np.flatnonzero((pixels < 255).any(axis=(axis, 2))) for axis in (1, 0))
    if len(rows) == 0:
        raise plotting.PlotError("VTK drew an empty picture.")
    padded = pixels[rows[0]:rows[-1] + 1, columns[0]:columns[-1] + 1]
    return np.pad(padded, ((margin, margin), (margin, margin), (0, 0)), constant_values=255)
