"""The aircraft in the air of the moment: dynamic pressure and density decide, not the height."""

import math

import pytest
from aeroplanes import AEROSONDE, CESSNA, EASYSTAR
from hypothesis import given, settings
from hypothesis import strategies as st

from vfguide.aircraft.air_density import (
    NO_CLIMB,
    excess_thrust,
    in_air,
    steepest_climb,
    vehicle_in_air,
)
from vfguide.aircraft.envelope import usable_bank
from vfguide.aircraft.flight_model import modelled_flight
from vfguide.aircraft.performance import Gains
from vfguide.aircraft.vehicle import Vehicle
from vfguide.earth.atmosphere import DENSITY_0, isa_density
from vfguide.geometry.so3 import from_euler

AIRCRAFT = pytest.mark.parametrize("aircraft", [AEROSONDE, EASYSTAR, CESSNA])
DENSITIES = st.floats(0.4, 1.4)
RATIOS = st.floats(1.01, 1.25)


def dynamic_pressure(airspeed: float, density: float) -> float:
    return 0.5 * density * airspeed**2


@AIRCRAFT
def test_at_sea_level_it_is_the_aircraft_of_the_file(aircraft):
    for airspeed in (aircraft.airspeed_min, aircraft.airspeed_cruise, aircraft.airspeed_max):
        assert in_air(aircraft, DENSITY_0, airspeed) == aircraft


@AIRCRAFT
@given(density=DENSITIES)
@settings(max_examples=50, deadline=None)
def test_its_airspeeds_have_the_dynamic_pressures_of_the_file(aircraft, density):
    here = in_air(aircraft, density, aircraft.airspeed_cruise)
    for name in ("airspeed_min", "airspeed_cruise", "airspeed_max"):
        assert dynamic_pressure(getattr(here, name), density) == pytest.approx(
            dynamic_pressure(getattr(aircraft, name), DENSITY_0)
        )


@AIRCRAFT
@given(density=DENSITIES, ratio=RATIOS, load=st.floats(0.5, 2.0))
@settings(max_examples=50, deadline=None)
def test_lift_and_bank_at_a_dynamic_pressure_are_the_same_in_any_air(
    aircraft, density, ratio, load
):
    low = ratio * aircraft.airspeed_min
    high = low * math.sqrt(DENSITY_0 / density)
    here, gains = in_air(aircraft, density, high), Gains(low, bank_max=aircraft.bank_max)
    assert here.alpha_load * load / high**2 == pytest.approx(aircraft.alpha_load * load / low**2)
    assert usable_bank(here, gains, high) == pytest.approx(usable_bank(aircraft, gains, low))


@AIRCRAFT
@given(density=DENSITIES, ratio=RATIOS, thrust=st.floats(0.0, 1.0))
@settings(max_examples=50, deadline=None)
def test_a_thrust_in_newtons_accelerates_the_same_in_any_air(aircraft, density, ratio, thrust):
    # A setpoint is a share of the full thrust, which falls with the density.
    low = ratio * aircraft.airspeed_min
    high, share = low * math.sqrt(DENSITY_0 / density), thrust * DENSITY_0 / density
    R_nb = from_euler(0.3, 0.1, 0.0)
    here = modelled_flight(R_nb, high, share, 0.0, in_air(aircraft, density, high))
    there = modelled_flight(R_nb, low, thrust, 0.0, aircraft)
    assert here.acceleration == pytest.approx(there.acceleration, abs=1e-9)
    assert here.d_n == pytest.approx(there.d_n)


@AIRCRAFT
def test_the_steepest_climb_falls_with_height_and_is_no_more_than_the_thrust_gives(aircraft):
    heights = range(0, 10_000, 250)
    climbs = []
    for height in heights:
        density = isa_density(height)
        airspeed = aircraft.airspeed_cruise * math.sqrt(DENSITY_0 / density)
        climb = steepest_climb(aircraft, density, airspeed)
        left = excess_thrust(aircraft, density, airspeed, 1.0)
        assert climb == NO_CLIMB or math.sin(climb) <= 0.8 * left
        climbs.append(climb)
    assert climbs[0] == aircraft.climb_max
    assert climbs == sorted(climbs, reverse=True)
    assert climbs[-1] < 0.5 * climbs[0]


@given(density=DENSITIES, airspeed=st.floats(5.0, 60.0))
@settings(max_examples=50, deadline=None)
def test_the_airspeed_to_fly_is_within_the_limits_in_any_air(density, airspeed):
    flown = vehicle_in_air(Vehicle(AEROSONDE, Gains(airspeed)), density)
    aircraft, gains, _ = flown
    assert aircraft.airspeed_min <= gains.airspeed <= aircraft.airspeed_max
    if aircraft.airspeed_min <= airspeed <= aircraft.airspeed_max:
        assert gains.airspeed == airspeed


def test_the_rigid_body_of_the_paper_knows_no_air():
    body = Vehicle(AEROSONDE, Gains(60.0), is_rigid_body=True)
    assert vehicle_in_air(body, 0.6) == body
