"""Pressure altitude against the table of the standard atmosphere."""

import pytest
from hypothesis import given
from hypothesis import strategies as st

from vfguide.earth.pressure_altitude import isa_pressure, pressure_altitude


@pytest.mark.parametrize(
    ("altitude", "pressure"),
    [
        (-500.0, 107_477.0),
        (0.0, 101_325.0),
        (1000.0, 89_874.6),
        (3000.0, 70_108.5),
        (5000.0, 54_019.9),
        (11_000.0, 22_632.1),
    ],
)
def test_the_table_of_iso_2533(altitude, pressure):
    assert pressure_altitude(pressure) == pytest.approx(altitude, abs=0.3)
    assert isa_pressure(altitude) == pytest.approx(pressure, rel=2e-5)


@given(st.floats(-1000.0, 11_000.0))
def test_one_is_the_inverse_of_the_other(altitude):
    assert pressure_altitude(isa_pressure(altitude)) == pytest.approx(altitude, abs=1e-6)
