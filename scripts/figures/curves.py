"""Curves of a temperature study: an observable against the field, a curve per case."""

from dataclasses import dataclass

import numpy as np
from thelma import planar_exact
from thelma import study


@dataclass
class Curve:
    """A computed case; `value` is the observable drawn."""

    case: study.Case
    theta: float  # K
    material: planar_exact.Material
    e: np.ndarray
    voltage: np.ndarray  # kV
    value: np.ndarray
    pulled_in: bool
    unstable: list  # for each piece between two points, whether it is

    @property
    def thickness(self):
        """Voltage over nominal field, in mm."""
        last = np.argmax(self.e)
        field = self.material.field(self.e[last], self.theta)
        return self.voltage[last] / field if field > 0 else 1.0

    @property
    def stopped(self):
        """Whether the curve ends before its target."""
        return self.pulled_in or self.case.exit_code == 3

    def abscissas(self):
        """The two horizontal axes: (values, factor from e to the values)."""
        kilovolts = self.material.field(1.0, self.theta) * self.thickness
        return (self.e, 1.0), (self.voltage, kilovolts)


def load_curve(case, observable):
    """The Curve of a case that left at least one accepted step."""
    table = case.curve("e", "voltage_kV", observable, "event")
    if len(table["e"]) == 0:
        raise study.StudyError(f"{case.directory / 'curve.csv'} has no rows.")
    theta = table["theta_K"][0] if "theta_K" in table else float(case.swept[study.TEMPERATURE])
    return Curve(case, float(theta), case.material(), table["e"], table["voltage_kV"],
                 table[observable], "pull-in" in list(table["event"]),
                 case.unstable_pieces(table))


def load_study(directory, observable):
    """Curves by temperature, and the cases that left nothing to draw."""
    curves, failed = [], []
    for case in study.read_study(directory):
        if case.exit_code != 0 and not (case.directory / "curve.csv").is_file():
            failed.append(case)
        else:
            curves.append(load_curve(case, observable))
    if not curves:
        raise study.StudyError(f"no case of {directory}/study.csv has a curve.")
    return sorted(curves, key=lambda curve: curve.theta), failed


def by_expansion(curves):
    """Thermal expansion -> its curves, smallest first."""
    values = sorted({curve.material.alpha for curve in curves})
    return {alpha: [c for c in curves if c.material.alpha == alpha] for alpha in values}
