"""scripts/experiments: the stored fit has the residuals of doc/experiments.md, and its film under voltage
is that of python/thelma/viscoelastic_exact.py where they meet."""

import unittest
from pathlib import Path

SOURCE = Path(__file__).resolve().parents[2]
from scene import SCRIPTS  # noqa: F401  (first: finds the scripts)
import experiments_data as data
import experiments_model as model
import experiments_program as program
import experiments_report as report
from thelma import viscoelastic_exact as exact

FITS, PROGRAM = model.read(SOURCE / "doc/experiments.json")
FIT = FITS[0]
DOCUMENT = (SOURCE / "doc/experiments.md").read_text(encoding="utf8")


def rows(first, columns):
    """The lines of a table by what their first cell begins with and by their number of cells."""
    cells = [[cell.strip() for cell in line.strip("|").split("|")] for line in DOCUMENT.splitlines()
             if line.startswith(f"| {first}")]
    return [line for line in cells if len(line) == columns and line[1] != "---"]


class Fit(unittest.TestCase):
    def test_parameters(self):
        for fit in FITS:
            material = fit.material
            for value in (material.G, *material.moduli, *material.times, *material.constants, fit.factor):
                self.assertGreater(value, 0)
            if material.shift == "WLF":  # holds at the coldest test
                self.assertGreater(model.CELSIUS + model.LOW, model.THETA_R - material.constants[1])

    def test_residuals_of_the_document(self):
        lines = rows("VHB", 8)
        points = model.fitted_points()
        self.assertEqual(len(lines), len(points))
        residuals = []
        for line, point in zip(lines, points):
            value = FIT.model(point)
            residuals.append(value / point.stress - 1)
            self.assertEqual((line[0], float(line[1]), float(line[4])), (point.set, point.celsius, point.stress))
            self.assertAlmostEqual(float(line[5]), value, delta=0.051)
            self.assertAlmostEqual(float(line[6].split()[0]), 100 * residuals[-1], delta=0.051)
        self.assertIn(f"**{report.size(model.rms(residuals))}**", DOCUMENT)
        self.assertLess(model.rms(residuals), 0.055)

    def test_rates_of_the_document(self):
        lines = {float(line[0]): line for line in rows("0.0", 7)}
        peaks = report.rate_peaks(exact.vhb(model.LOCKING))
        for rate, measured in data.HOSSAIN_PEAKS.items():
            self.assertEqual(float(lines[rate][1]), measured)
            self.assertAlmostEqual(float(lines[rate][2]), peaks[rate], delta=0.0051)

    def test_material_of_the_document(self):
        self.assertIn(program.material_section(FIT.material), DOCUMENT)

    def test_program(self):
        for own, point in zip(PROGRAM["points"], model.fitted_points(), strict=True):
            self.assertAlmostEqual(own / FIT.model(point), 1, delta=5e-3)


class Histories(unittest.TestCase):
    def test_table(self):
        test, tables = model.Test(2.0, 0.1), model.Tables()
        for celsius in (0, 40):
            self.assertAlmostEqual(tables.stress(FIT.material, test, celsius) / test.stress(
                FIT.material.film(celsius)), 1, delta=1e-4)

    def test_no_voltage(self):
        for celsius in data.MEHNERT_STRESSES:
            film = FIT.material.film(celsius)
            own = model.under_voltage(FIT.material, celsius, 0)[1][-1]
            self.assertAlmostEqual(own / model.FIELD_TEST.stress(film), 1, delta=1e-6)

    def test_voltage(self):
        # An elastic film has a closed form where its width is held: P = m (l - l^-3) - q l.
        film = exact.Film(exact.NeoHookean(10.0), theta=300.0, theta_0=300.0)
        stress = model.charged(film, model.FIELD_TEST, 2.0, width_held=True)[1][-1]
        l = model.FIELD_TEST.stretch
        self.assertAlmostEqual(stress, 10 * (l - l**-3) - 2 * l, places=8)


if __name__ == "__main__":
    unittest.main()
