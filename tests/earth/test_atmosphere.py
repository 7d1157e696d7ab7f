import pytest
from hypothesis import given
from hypothesis import strategies as st

from vfguide.earth.atmosphere import calibrated_airspeed, isa_density, true_airspeed


@pytest.mark.parametrize(
    ("altitude", "density"),  # ISO 2533, geopotential altitude
    [
        (-1000.0, 1.3470),
        (0.0, 1.2250),
        (1000.0, 1.11164),
        (2000.0, 1.00649),
        (5000.0, 0.736116),
        (11000.0, 0.363918),
        (15000.0, 0.193674),
        (20000.0, 0.0880349),
    ],
)
def test_density_of_the_standard(altitude, density):
    assert isa_density(altitude) == pytest.approx(density, rel=1e-5)


@given(st.floats(-5000.0, 80000.0), st.floats(1.0, 1000.0))
def test_density_falls_with_height_and_stays_positive(altitude, more):
    assert 0.0 < isa_density(altitude + more) < isa_density(altitude)


@pytest.mark.parametrize(("altitude", "percent"), [(0.0, 0.0), (650.0, 3.0), (2000.0, 10.0)])
def test_true_airspeed_is_the_greater_the_higher(altitude, percent):
    true = true_airspeed(25.0, isa_density(altitude))
    assert 100.0 * (true / 25.0 - 1.0) == pytest.approx(percent, abs=0.4)


@given(st.floats(0.0, 100.0), st.floats(-500.0, 15000.0))
def test_airspeeds_come_back(airspeed, altitude):
    density = isa_density(altitude)
    assert calibrated_airspeed(true_airspeed(airspeed, density), density) == pytest.approx(
        airspeed, rel=1e-14
    )
