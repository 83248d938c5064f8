"""scripts/accuracy: what it computes from rows, and that the documents are those of its CSV."""

import math
import subprocess
import sys
import tempfile
import unittest
from pathlib import Path
from unittest import mock

SOURCE = Path(__file__).resolve().parents[2]
from scene import SCRIPTS  # noqa: F401  (first: finds the scripts)
import accuracy_cases as cases
import accuracy_peer as peer
import accuracy_report as report
import accuracy_table as table
from accuracy_run import AccuracyError


def row(cells="2 x 8", unknowns=100, seconds=0.1, error=1e-2, **more):
    """A bending run in the plane to e = 0.475."""
    values = {"scene": "bending", "model": "plane", "formulation": "mean dilatation", "degree": 2,
              "ranks": 1, "e": 0.475, "observable": "tip u_1/L", **more}
    return table.Row(cells=cells, unknowns=unknowns, solve_seconds=seconds, relative_error=error,
                     newton_iterations=24, factorisations=16, peak_memory_MB=100.0, **values)


class Table(unittest.TestCase):
    def test_orders(self):
        errors = [3.0 * h**4 for h in (1, 0.5, 0.25)]
        for order in table.observed_orders(errors):
            self.assertAlmostEqual(order, 4)
        self.assertAlmostEqual(table.observed_orders([-1e-2, 1e-4], ratio=10)[0], 2)

    def test_fastest_of_the_good(self):
        rows = [row("2 x 4", 50, 0.05, -0.03), row("2 x 8", 100, 0.1, -0.004),
                row("4 x 20", 80, 0.02, 0.3, degree=1), row("4 x 80", 900, 0.3, 0.003, degree=1)]
        self.assertEqual(table.choose(rows, 0.05).cells, "2 x 4")
        self.assertEqual(table.choose(rows, 0.01).cells, "2 x 8")
        self.assertIsNone(table.choose(rows, 0.001))

    def test_chance_is_no_recommendation(self):
        lucky = [row("2 x 4", 50, 0.05, 1e-6), row("2 x 8", 100, 0.1, 2e-3),
                 row("2 x 16", 200, 0.2, 5e-4)]
        self.assertEqual(table.choose(lucky, 1e-3).cells, "2 x 16")

    def test_failed_run(self):
        failed = row("2 x 16", 200, None, None, outcome="no convergence")
        self.assertIsNone(table.choose([row(), failed], 0.05))
        self.assertEqual(report.outcome(failed), "no convergence")

    def test_file(self):
        rows = [row(), row("2 x 16", None, None, None, outcome="exit code 1: a, \"b\"")]
        with tempfile.TemporaryDirectory() as folder:
            path = Path(folder) / "rows.csv"
            table.write(path, rows, {"machine": "two: processors"})
            self.assertEqual(table.read(path), (rows, {"machine": "two: processors"}))


class References(unittest.TestCase):
    def test_exact_rotation(self):
        # A tabulated field, and values between two of an independent program.
        self.assertAlmostEqual(cases.exact_mid_rotation(0.5), math.degrees(0.0441896467 * 20),
                               places=9)
        self.assertAlmostEqual(2 * cases.exact_mid_rotation(0.87), 442.588, places=3)
        self.assertAlmostEqual(2 * cases.exact_mid_rotation(0.87, 293, 0), 633.367, places=3)

    def test_interpolation(self):
        xs = [0.1 * i for i in range(12)]
        self.assertAlmostEqual(cases.interpolated(0.537, xs, [x**9 for x in xs]), 0.537**9)


class Documents(unittest.TestCase):
    def test_bars(self):
        rows = [row(cells, n, s, e) for cells, n, s, e in (("2 x 6", 50, 0.04, 8e-3),
                                                          ("2 x 14", 90, 0.2, 2e-4))]
        first, second, third = report.bar_lines(rows)
        self.assertEqual(first[-1], "holds")
        self.assertEqual(second[-1], "**fails**: 2 times")
        self.assertEqual(third[2:], ["none measured", "**fails**"])

    def test_published_peer(self):
        row_3d = row("2 x 1 x 8", 500, 0.046, -2.6e-3, model="3-D")
        (line,) = report.peer_lines([row_3d])
        self.assertEqual(len(line), len(report.PEER_HEADER))
        self.assertEqual(line[-4:], ["5.0", "", "4", "holds"])

    def test_measured_peer(self):
        row_3d = row("2 x 1 x 8", 500, 0.1, -2.6e-3, model="3-D", reference=cases.TIP)
        record = {"assembly": "dolfinx", "unknowns": "1084", "newton_iterations": "18",
                  "seconds": "0.3", "tip": f"{cases.TIP * 0.999:.12g}"}
        packaged = peer.converted(record, row_3d)
        gathered = peer.converted({**record, "assembly": "gathered", "seconds": "0.15"}, row_3d)
        self.assertAlmostEqual(packaged.error, 1e-3)
        (line,) = report.peer_lines([row_3d, packaged, gathered])
        self.assertEqual(line[-4:], ["3.0", "1.5", "4", "**fails**: 1.3 times"])
        # The peer is no setting of ours.
        self.assertEqual(report.solved([row_3d, packaged, gathered], "bending", 0.475), [row_3d])

    def test_no_peer(self):
        with mock.patch.object(peer.interpreter, "SYSTEM", "/bin/false"):
            with self.assertRaisesRegex(AccuracyError, "needs FEniCSx"):
                peer.require()

    def test_plan(self):
        plan = cases.plan([(cases.MEAN, 1), (cases.MEAN, 2), ("standard", 2)], quick=False)
        self.assertLessEqual(set(cases.PEERS), set(plan))
        whole, order = plan[cases.halved(2)[0]], plan[cases.halved(2)[-1]]
        self.assertEqual((whole, order), ([0.475, 0.87, 0.5], [0.5]))

    def test_lines_between_markers(self):
        text = f"a\n{report.BEGIN}\nold\n{report.END}\nb\n"
        self.assertEqual(report.insert(text, "new\n"), text.replace("old", "new"))
        with self.assertRaises(ValueError):
            report.insert("no markers", "new\n")

    def test_up_to_date(self):
        result = subprocess.run([sys.executable, str(SOURCE / "scripts/accuracy"), "--check"],
                                capture_output=True, text=True, check=False)
        self.assertEqual(result.returncode, 0, result.stderr)


if __name__ == "__main__":
    unittest.main()
