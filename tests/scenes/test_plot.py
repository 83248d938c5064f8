"""scripts/plot on small results written here: every figure, from curves and fields."""

import itertools
import subprocess
import sys
import tempfile
import unittest
from pathlib import Path

import numpy as np
from test_plot_pull_in import SCRIPTS, USED_PRM, write_csv

from thelma import bending_exact
from thelma import planar_exact
from figures import bodies

EXPANSIONS, TEMPERATURES = (0.0, 1.8e-4), (273.0, 353.0)
SWEPT = ("Materials/elastomer/Thermal expansion", "Temperature/Value")
SIZES = {"planar": (5, 5, 1), "bending": (1, 4, 20), "heated": (1, 4, 20),
         "buckling": (1, 4, 20), "balloon": (10, 10, 10), "stack": (10, 3, 2), "gripper": (1, 4, 20),
         "membrane": (15, 15, 0.25)}  # mm


def deformation(points):
    """Some displacement."""
    return 0.1 * np.sin(points / 3.0)


def write_vtu(path, size, cells=2):
    """A row of hexahedra along x3, or of squares in the x1-x3 plane, as the program writes them:
    the corners of every cell anew."""
    corners = np.array(list(itertools.product((0, 1), repeat=len(size))))[:, ::-1]
    order = [0, 1, 3, 2, 4, 5, 7, 6][:len(corners)]
    along = np.eye(len(size), dtype=int)[-1]
    step = np.array(size, float) / (1 + (cells - 1) * along)
    points = np.concatenate([(corners[order] + cell * along) * step for cell in range(cells)])
    points = np.pad(points, ((0, 0), (0, 3 - len(size))))

    def array(name, values, kind="Float64"):
        text = " ".join(f"{value:g}" for value in np.ravel(values))
        columns = values.shape[1] if values.ndim == 2 else 1
        return (f'<DataArray type="{kind}" Name="{name}" NumberOfComponents="{columns}" '
                f'format="ascii">{text}</DataArray>')

    number = np.arange(len(points))
    path.write_text(
        '<VTKFile type="UnstructuredGrid" version="0.1"><UnstructuredGrid>'
        f'<Piece NumberOfPoints="{len(points)}" NumberOfCells="{cells}">'
        f'<Points>{array("points", points)}</Points><Cells>'
        + array("connectivity", number, "Int32")
        + array("offsets", (np.arange(cells) + 1) * len(order), "Int32")
        + array("types", np.full(cells, 12 if len(order) == 8 else 9), "UInt8")
        + f'</Cells><PointData>{array("u", deformation(points))}{array("phi", points[:, 0])}'
        f'{array("theta", 273 + 4 * points[:, 1])}</PointData></Piece></UnstructuredGrid></VTKFile>')


def write_case(directory, theta, alpha, fields=None):
    """A case with all columns that the figures draw, and a field file of a body of that size."""
    directory.mkdir(parents=True)
    m = planar_exact.Material(alpha=alpha)
    rows = []
    for e, tip in ((c.e, c.tip(40)) for c in bending_exact.circles(m, theta, [0, 0.3, 0.6])):
        field = float(m.field(e, theta))
        stretch = planar_exact.stable_state(m, theta, field)[1]
        pulled = 1 + min(e, 0.3) if alpha else 1.3 - abs(e - 0.3)  # and held, or back
        rows.append([field, e, theta, stretch, tip / 2, 80 * e, 5 * e, 10 * e, 40 * e, theta - 10,
                     theta + 10, pulled, 0.01 * e, ""])
    write_csv(directory / "curve.csv",
              ("voltage_kV", "e", "theta_K", "lambda_3", "tip_u1_mm", "end_rotation_deg",
               "centre_u1_mm", "time_s", "mid_rotation_deg", "theta_min_K", "theta_max_K",
               "lambda_1", "reaction_f1_N", "event"), rows)
    (directory / "used.prm").write_text(USED_PRM.format(alpha=alpha))
    if fields:
        write_vtu(directory / "fields_0002.vtu", fields)
        (directory / "fields.pvd").write_text('<DataSet timestep="0" file="none.vtu"/>\n'
                                              '<DataSet timestep="1" file="fields_0002.vtu"/>\n')


def write_study(directory, temperatures, expansions, fields=None):
    """A case for every temperature and expansion."""
    rows = []
    for theta, alpha in itertools.product(temperatures, expansions):
        name = f"{theta:g}_{alpha:g}"
        write_case(directory / name, theta, alpha, fields)
        rows.append([f"{alpha:g}", f"{theta:g}", name, 0, "target reached"])
    write_csv(directory / "study.csv", (*SWEPT, "directory", "exit_code", "outcome"), rows)


def write_results(folder):
    """All that scripts/plot draws."""
    for name in ("planar_actuator", "bending_actuator", "bending_actuator_plane", "buckling_pump",
                 "buckling_pump_quarter"):
        write_study(folder / "studies" / name, TEMPERATURES, EXPANSIONS)
    for name in ("planar_actuator", "bending_actuator", "bending_actuator_plane",
                 "bending_hot_face", "bending_hot_end", "heated_bending", "buckling_pump",
                 "buckling_pump_quarter", "balloon", "stack", "gripper", "membrane"):
        size = SIZES[name.split("_")[0]]
        plane = name in ("bending_actuator_plane", "bending_hot_face", "bending_hot_end",
                         "heated_bending", "gripper")
        write_study(folder / "figures" / name, (353.0,),
                    EXPANSIONS if "quarter" in name or "heated" in name else (0.0,), size[::2] if plane else size)
    for name in ("relaxation", "pull_in_rate", "delayed_pull_in", "creeping_bending_actuator"):
        write_study(folder / "figures" / name, (293.0,), EXPANSIONS)


def plot(folder, *figures):
    """Runs the script; the pictures go to folder/pictures."""
    command = [sys.executable, str(SCRIPTS / "plot"), "--draw", "--results", str(folder),
               "--output", str(folder / "pictures"), *figures]
    return subprocess.run(command, capture_output=True, text=True, check=False)


class Plot(unittest.TestCase):
    def setUp(self):
        self.temporary = tempfile.TemporaryDirectory()
        self.addCleanup(self.temporary.cleanup)
        self.folder = Path(self.temporary.name)

    def test_all_figures(self):
        write_results(self.folder)
        result = plot(self.folder)
        self.assertEqual(result.returncode, 0, result.stderr)
        pictures = list((self.folder / "pictures").glob("*.png"))
        self.assertEqual(len(pictures), 18)
        for picture in pictures:
            self.assertEqual(picture.read_bytes()[:4], b"\x89PNG")
            self.assertLess(picture.stat().st_size, 200e3)

    def test_missing_study_is_one_sentence(self):
        result = plot(self.folder, "7")
        self.assertEqual(result.returncode, 1)
        self.assertEqual(len(result.stderr.splitlines()), 1)
        self.assertIn("study.csv", result.stderr)

    def test_unknown_figure(self):
        result = plot(self.folder, "3")
        self.assertEqual(result.returncode, 2)
        self.assertIn("figure 3", result.stderr)


class Bodies(unittest.TestCase):
    def setUp(self):
        self.temporary = tempfile.TemporaryDirectory()
        self.addCleanup(self.temporary.cleanup)
        self.folder = Path(self.temporary.name)

    def load(self, size, width=None):
        write_case(self.folder / "case", 293.0, 0.0, size)
        return bodies.load(self.folder / "case", width)

    def test_neighbours_share_their_corners(self):
        body = self.load((1, 4, 20))
        self.assertEqual(len(body.points), 12)
        np.testing.assert_allclose(body.u, deformation(body.points), atol=1e-6)

    def test_plane_body_gets_a_width(self):
        body = self.load((1, 20), 4.0)
        self.assertEqual(body.cells.shape, (2, 8))
        np.testing.assert_allclose(body.points.max(axis=0), (1, 4, 20))
        np.testing.assert_allclose(body.u[:, 1], 0)
        np.testing.assert_allclose(body.u[:, 2], deformation(body.points)[:, 2], atol=1e-6)

    def test_mirrored_halves_have_no_seam(self):
        body = self.load((1, 4, 20))
        both = bodies.together(body, body.mirrored(2, 20.0))
        self.assertEqual(len(both.points), 20)
        np.testing.assert_allclose(both.points.max(axis=0), (1, 4, 40))


if __name__ == "__main__":
    unittest.main()
