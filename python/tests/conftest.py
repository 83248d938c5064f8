"""What the tests share. The program is that of the environment variable THELMA or of the checkout."""

import pytest

import thelma
from thelma import program


@pytest.fixture
def film():
    """The planar actuator."""
    return thelma.Scene(program.CHECKOUT / "prm/planar_actuator.prm")
