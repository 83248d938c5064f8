"""Scenes are run and read: against the exact states of the planar actuator."""

import numpy as np
import pytest

import thelma
from thelma import planar_exact
from thelma.scene import text_of


def test_run(film, tmp_path):
    """Every state of the curve, the bracket of pull-in, and the outcome."""
    hot = film.with_entries({"Temperature/Value": 353})
    case = hot.run(tmp_path / "hot")
    assert (case.outcome, case.exit_code) == ("pull-in", 0)
    curve, material = case.curve(), case.material()
    _, field = planar_exact.curve(material, 353.0, curve["lambda_3"])
    assert np.max(np.abs(material.e(field, 353.0) - curve["e"])) < 1e-6
    below, above = case.pull_in()
    assert below < planar_exact.limit_point(material, 353.0).e < above


def test_sweep(film, tmp_path):
    """A case per temperature, in their order; what is swept is not kept at one value."""
    temperatures = [273.0, 353.0]
    cases = film.with_entries({"Temperature/Value": 300}).sweep({"Temperature/Value": temperatures}, tmp_path)
    assert [float(case.swept["Temperature/Value"]) for case in cases] == temperatures
    for case, theta in zip(cases, temperatures):
        below, above = case.pull_in()
        assert below < planar_exact.limit_point(case.material(), theta).e < above


def test_fields(film, tmp_path):
    """A homogeneous film: u, phi and J where they are known."""
    pytest.importorskip("vtk")
    case = film.run(tmp_path / "run")
    state, last = case.fields(), {name: values[-1] for name, values in case.curve().items()}
    assert np.ptp(state.deformed[:, 2]) / np.ptp(state.points[:, 2]) == pytest.approx(last["lambda_3"], rel=1e-6)
    assert np.ptp(state["phi"]) == pytest.approx(last["voltage_kV"], rel=1e-6)
    assert np.ptp(state["J"]) < 1e-6
    assert np.max(np.abs(case.fields(at=0)["u"])) < np.max(np.abs(state["u"]))
    with pytest.raises(thelma.ThelmaError, match="no field 'v'; known: "):
        state["v"]


def test_frames(film, tmp_path):
    """Curves, studies and fields for pandas."""
    pandas = pytest.importorskip("pandas")
    from thelma.study import study_frame
    case, = film.sweep({"Temperature/Value": [293]}, tmp_path)
    frame = case.frame()
    assert isinstance(frame, pandas.DataFrame) and list(frame["event"])[-1] == "pull-in"
    assert study_frame(tmp_path)["theta_K"][0] == 293
    pytest.importorskip("vtk")
    assert {"X1", "u3", "phi"} <= set(case.fields().frame().columns)


def test_write(film, tmp_path):
    """A scene of its own elsewhere, with the same geometry."""
    written = film.with_entries({"Temperature/Value": 353}).write(tmp_path / "hot.prm")
    assert written.text().entries["Temperature", "Value"].value == "353"
    assert written.check()


def test_bad_input(film, tmp_path):
    """The program's sentence."""
    with pytest.raises(thelma.ThelmaError, match="did you mean 'Value'"):
        film.with_entries({"Temperature/Valeu": 353}).run(tmp_path / "bad")
    with pytest.raises(thelma.ThelmaError, match="there is no parameter file"):
        thelma.Scene(tmp_path / "none.prm")


def test_texts():
    """Values as parameter files have them."""
    assert [text_of(value) for value in (True, 2, np.int64(2), 0.1, np.float64(0.1), "4 kV", (1, 0.5), {"top": 1})] == [
        "true", "2", "2", "0.1", "0.1", "4 kV", "1, 0.5", "top: 1"]


def test_material_point(film):
    """Neo-Hookean and, with this bulk modulus, incompressible within 1e-6: mu (l - l^-2)."""
    pull = {"name": "pull", "mode": "uniaxial", "stress unit": "MPa", "columns": {"stretch": {"values": [1, 2, 3]}}}
    scene = film.with_entries({"Materials/elastomer/Shear modulus": 0.02, "Materials/elastomer/Bulk modulus": 1e5})
    with scene.material_point() as point:
        (stresses,), (doubled,) = point.stresses([pull], [(), ["Materials/elastomer/Shear modulus=0.04"]])
    stretch = np.array([1, 2, 3])
    assert stresses == pytest.approx(0.02 * (stretch - stretch**-2.0), abs=1e-7)
    assert doubled == pytest.approx(2 * np.array(stresses), abs=1e-7)
