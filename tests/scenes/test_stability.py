"""Which parts of a curve are drawn dashed."""

import unittest
from pathlib import Path

from thelma import plotting
from thelma import stability
from thelma.plotting import plt


class Stability(unittest.TestCase):
    def test_stable_without_word_of_the_contrary(self):
        self.assertEqual(stability.unstable_pieces([0, 0, 0]), [False, False])
        self.assertEqual(stability.unstable_pieces([]), [])

    def test_a_piece_with_an_unstable_end_is_unstable(self):
        self.assertEqual(stability.unstable_pieces([0, 0, 1, 2, 0]), [False, True, True, True])

    def test_at_a_limit_point_the_other_end_decides(self):
        events = ["", "", "limit point", "", "double bifurcation", ""]
        for at_events in ((0, 0), (1, 1), (1, 2)):
            numbers = [0, 0, at_events[0], 1, at_events[1], 0]
            self.assertEqual(stability.unstable_pieces(numbers, events),
                             [False, False, True, True, False])

    def test_parts_share_their_ends(self):
        self.assertEqual(stability.parts([False, False, True, False]),
                         [(0, 2, False), (2, 3, True), (3, 4, False)])

    def test_unstable_parts_are_dashed(self):
        figure, axes = plt.subplots()
        self.addCleanup(plt.close, figure)
        plotting.by_stability(axes, [0, 1, 2, 3], [0, 1, 0, 1], [False, True, True])
        solid, dashed = axes.get_lines()
        self.assertEqual((solid.get_linestyle(), list(solid.get_xdata())), ("-", [0, 1]))
        self.assertEqual((dashed.get_linestyle(), list(dashed.get_xdata())), ("--", [1, 2, 3]))

    def test_marks_stand_at_every_point(self):
        figure, axes = plt.subplots()
        self.addCleanup(plt.close, figure)
        plotting.by_stability(axes, [0, 1], [0, 1], [False], linestyle="", marker="o")
        marks, = axes.get_lines()
        self.assertEqual(marks.get_marker(), "o")


if __name__ == "__main__":
    unittest.main()
