"""scripts/plot-pull-in on studies written from the exact solution."""

import csv
import json
import subprocess
import sys
import tempfile
import unittest
from pathlib import Path

import numpy as np

from scene import SCRIPTS
from thelma import planar_exact as exact
from thelma import study

TEMPERATURES = (273.0, 293.0, 313.0, 333.0, 353.0)  # K

USED_PRM = """subsection Materials
  subsection elastomer
    set Elastic law = neo-Hookean
    set Shear modulus = 0.506, -0.35933333333333334, 0.0667
    set Permittivity          = 3.98e-5
    set Bulk modulus          = 56.552
    set Thermal expansion     = {alpha} # default: 0
    set Reference temperature = 293
  end
end
"""


def write_csv(path, header, rows):
    """A CSV file."""
    with open(path, "w", newline="") as file:
        writer = csv.writer(file)
        writer.writerow(header)
        writer.writerows(rows)


def write_case(directory, theta, alpha, error):
    """A case as the program writes it; `error` is added to lambda_3 in mid-curve."""
    directory.mkdir()
    m = exact.Material(alpha=alpha)
    limit = exact.limit_point(m, theta)
    below, above = limit.e - 4e-5, limit.e + 5e-5
    rows = []
    for step, e in enumerate(below * np.linspace(0, 1, 41) ** 0.7):
        field = float(m.field(e, theta))
        l3 = exact.stable_state(m, theta, field)[1] + (error if step == 20 else 0)
        rows.append([step, e / below, field, e, theta, l3, "pull-in" if step == 40 else ""])
    write_csv(directory / "curve.csv",
              ("step", "load", "voltage_kV", "e", "theta_K", "lambda_3", "event"), rows)
    (directory / "run.json").write_text(json.dumps({"pull_in": {"e_below": below,
                                                                "e_above": above}}))
    (directory / "used.prm").write_text(USED_PRM.format(alpha=alpha))


def write_study(directory, alpha=0.0, error=0.0, temperatures=(273.0, 353.0)):
    """A study of the temperatures, in K."""
    rows = []
    for number, theta in enumerate(temperatures):
        write_case(directory / f"case_{number}", theta, alpha, error)
        rows.append([f"{theta:g}", f"case_{number}", 0, "pull-in", "", 0.7])
    write_csv(directory / "study.csv",
              (study.TEMPERATURE, "directory", "exit_code", "outcome", "reason", "e"), rows)


def plot(directory):
    """Runs the script."""
    return subprocess.run([sys.executable, str(SCRIPTS / "plot-pull-in"), str(directory)],
                          capture_output=True, text=True, check=False)


class PlotPullIn(unittest.TestCase):
    def setUp(self):
        self.temporary = tempfile.TemporaryDirectory()
        self.addCleanup(self.temporary.cleanup)
        self.directory = Path(self.temporary.name)

    def assert_one_sentence(self, result, *words):
        self.assertEqual(result.returncode, 1)
        self.assertEqual(len(result.stderr.splitlines()), 1)
        for word in words:
            self.assertIn(word, result.stderr)

    def test_picture_and_table(self):
        write_study(self.directory, alpha=1.8e-4, error=3e-5, temperatures=TEMPERATURES)
        result = plot(self.directory)
        self.assertEqual(result.returncode, 0, result.stderr)
        self.assertEqual((self.directory / "pull_in.png").read_bytes()[:4], b"\x89PNG")
        lines = result.stdout.splitlines()[1:6]
        for line, theta in zip(lines, TEMPERATURES):
            limit = exact.limit_point(exact.Material(alpha=1.8e-4), theta)
            cells = line.split()
            self.assertEqual(float(cells[0]), theta)
            self.assertEqual(cells[1], "41")
            self.assertEqual(cells[3], f"{limit.e:.6f}")
            self.assertAlmostEqual(float(cells[4]), 5e-6, delta=1e-7)
            self.assertAlmostEqual(float(cells[6]), 3e-5, delta=1e-6)

    def test_material(self):
        write_study(self.directory, alpha=1.8e-4)
        material = study.read_study(self.directory)[0].material()
        default = exact.Material(alpha=1.8e-4)
        self.assertEqual((material.alpha, material.K, material.theta_0, material.eps_law),
                         (default.alpha, default.K, default.theta_0, default.eps_law))
        np.testing.assert_allclose(material.mu_law, default.mu_law, rtol=1e-15)

    def test_failed_case_is_a_line(self):
        write_study(self.directory)
        with open(self.directory / "study.csv", "a") as file:
            file.write('373,case_2,3,stopped,"no convergence, at all",\n')
        result = plot(self.directory)
        self.assertEqual(result.returncode, 0, result.stderr)
        self.assertIn("exit code 3, stopped: no convergence, at all", result.stdout)

    def test_missing_study(self):
        self.assert_one_sentence(plot(self.directory / "nowhere"), "study.csv")

    def test_missing_column(self):
        write_study(self.directory)
        write_csv(self.directory / "case_1" / "curve.csv", ("step", "e", "voltage_kV", "event"),
                  [])
        self.assert_one_sentence(plot(self.directory), "lambda_3", "case_1")


if __name__ == "__main__":
    unittest.main()
