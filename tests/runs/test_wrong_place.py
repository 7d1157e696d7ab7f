"""Flights whose autopilot tells a place where the plan is not."""

import pytest
from altered import fly_altered

from vfguide.link.messages import GpsGlobalOrigin, LocalPositionNed, VfrHud

SHIFTS = [0.5, 1.0, 5.0, 10.0, 20.0, 40.0, 100.0, -100.0, 179.0]


def shifted(degrees, begin=0.0, end=1e9):
    """The origin is some degrees of longitude to the east of where it is."""

    def alter(time, message):
        if isinstance(message, GpsGlobalOrigin) and begin <= time < end:
            return [message._replace(longitude=message.longitude + round(degrees * 1e7))]
        return [message]

    return alter


def null(time, message):
    """The origin before a fix."""
    if isinstance(message, GpsGlobalOrigin):
        return [message._replace(latitude=0, longitude=0, altitude=0)]
    return [message]


@pytest.mark.parametrize("degrees", SHIFTS)
def test_a_vehicle_far_from_its_plan_is_not_flown(tmp_path, degrees):
    flight = fly_altered(tmp_path, shifted(degrees), "duration_s=20")
    assert flight.notes("km from the nearest goal") or flight.notes("GLOBAL_POSITION_INT")
    assert flight.result.vehicles[0].setpoints == 0
    assert flight.lost < 10.0


def test_an_origin_before_a_fix_is_not_flown_on(tmp_path):
    flight = fly_altered(tmp_path, null, "duration_s=20")
    assert flight.notes("from the nearest goal")
    assert flight.result.vehicles[0].setpoints == 0
    assert flight.lost < 10.0


def glitch(north, begin, lasts):
    """The position leaps to the north for a while."""

    def alter(time, message):
        if isinstance(message, LocalPositionNed) and begin <= time < begin + lasts:
            return [message._replace(x=message.x + north)]
        return [message]

    return alter


@pytest.mark.parametrize("lasts", [1.0, 3.0])
@pytest.mark.parametrize("north", [30.0, 2000.0, 90_000.0, 900_000.0])
def test_a_glitch_of_the_position_is_flown_through(tmp_path, north, lasts):
    flight = fly_altered(tmp_path, glitch(north, 8.0, lasts))
    assert flight.result.vehicles[0].goals[0].reached
    assert flight.bank < 55.0
    assert flight.lost < 50.0


@pytest.mark.parametrize("north", [2000.0, 90_000.0, 900_000.0])
def test_a_place_that_stays_wrong_ends_in_hold(tmp_path, north):
    flight = fly_altered(tmp_path, glitch(north, 8.0, 1e9), "duration_s=60")
    assert flight.notes("no more setpoints for now")
    assert flight.bank < 55.0
    assert flight.lost < 50.0
    assert flight.load[0] > 0.0
    assert flight.load[1] < 2.6


def altitude_error(error):
    """VFR_HUD tells another altitude than the local frame."""

    def alter(_, message):
        if isinstance(message, VfrHud):
            return [message._replace(alt=message.alt + error)]
        return [message]

    return alter


@pytest.mark.parametrize("error", [-488.0, 488.0])
def test_two_altitudes_are_not_flown_on(tmp_path, error):
    flight = fly_altered(tmp_path, altitude_error(error), "duration_s=20")
    assert flight.notes("VFR_HUD")
    assert flight.result.vehicles[0].setpoints <= 5  # the first VFR_HUD is not altered
