"""The slope that is flown: the goal's at the goal, the aircraft's limits everywhere."""

import math

import numpy as np
import pytest
from aeroplanes import AEROSONDE
from flight_states import state
from guidance_targets import GOAL
from hypothesis import example, given
from hypothesis import strategies as st

from vfguide.aircraft.path_limits import (
    AIRSPEED_BAND,
    AT_FLOOR,
    CLIMB_BAND,
    DESCENT_RATIO,
    FLOOR_CLIMB_BAND,
    FLOOR_LEVEL_RATIO,
    FLOOR_ZOOM_RATIO,
    LEVEL_RATIO,
    MAX_RADIUS_FACTOR,
    NEAR_FLOOR,
    ZOOM_RATIO,
    allowed_path,
    descent_at_airspeed,
    highest_path,
    largest_radius_factor,
    path_angle,
    path_limits,
    steepest_descent,
)
from vfguide.aircraft.performance import turn_length
from vfguide.geometry.units import DEG
from vfguide.guidance.altitude_profile import (
    LOITER_HORIZON,
    STANDOFF,
    airspeed_to_groundspeed,
    goal_slope,
    plan_slope,
    steepest_path,
)
from vfguide.paths.distance_for_altitude import LINE_UP, SLOPE_RATE, profile_height

SLOPES = st.floats(-0.18, 0.18)
REMAINING = st.floats(0.0, 2000.0)
STEP = 0.05
SPEED = 25.0
UNIT = turn_length(SPEED)
BAND = AIRSPEED_BAND * SPEED
HEIGHTS = (-1.0, AT_FLOOR, 0.5 * (AT_FLOOR + NEAR_FLOOR), NEAR_FLOOR, 10.0)
"""Above the floor, in turn lengths."""


def flown(height, slope, whole=400.0):
    """Distances to the goal and heights over it along the profile, to its end."""
    path = [(whole, height)]
    while path[-1][0] > STEP:
        remaining, height = path[-1]
        path.append((remaining - STEP, height + STEP * goal_slope(height, remaining, slope, UNIT)))
    return path


@pytest.mark.parametrize("slope", [0.0, 0.1, -0.12, 0.176])
def test_the_last_metres_lead_to_the_goal_with_its_slope_too(slope):
    """Within the standoff as well: a profile that turns round there costs the climb angle."""
    path = flown(30.0, slope)
    steady = (30.0 - profile_height(400.0, slope, UNIT)) / (400.0 - 0.5 * LINE_UP * UNIT)
    assert path[-1][1] == pytest.approx(0.0, abs=0.15)
    for remaining, height in path[-round(STANDOFF * UNIT / STEP) :: 50]:
        share = remaining / (LINE_UP * UNIT)
        own = slope * (1.0 - share) - min(steady, 0.06) * share
        assert goal_slope(height, remaining, slope, UNIT) == pytest.approx(own, abs=0.02)


@given(REMAINING, SLOPES)
def test_on_the_profile_its_own_slope_is_wanted(remaining, slope):
    step = 1e-4
    height = profile_height(remaining, slope, UNIT)
    rise = (height - profile_height(remaining + step, slope, UNIT)) / step
    assert goal_slope(height, remaining, slope, UNIT) == pytest.approx(rise, abs=1e-5)


@given(st.floats(0.0, 200.0), REMAINING, SLOPES)
def test_too_high_it_is_never_steeper_up(height, remaining, slope):
    on_it = profile_height(remaining, slope, UNIT)
    higher = goal_slope(on_it + height, remaining, slope, UNIT)
    assert higher <= goal_slope(on_it, remaining, slope, UNIT)


@pytest.mark.parametrize("below", [100.0, -100.0])
@pytest.mark.parametrize("dt", [0.02, 0.1])
def test_the_slope_changes_no_faster_than_its_rate(below, dt):
    here = state((-100.0, 0.0, GOAL.p_n[2] + below), 0.0)
    after = plan_slope(here, GOAL, AEROSONDE, SPEED, 100.0, 25.0, 1.0, 0.0, dt)
    assert after == pytest.approx(math.copysign(SLOPE_RATE / SPEED * dt, below))


@example(7.0, 0.0, -7.0, 24.0, 1.0)
@given(
    st.floats(-300.0, 300.0),
    REMAINING,
    st.floats(-10.0, 45.0),
    st.floats(18.0, 32.0),
    st.floats(1.0, 3.0),
)
def test_the_path_is_never_steeper_than_the_aircraft_flies(
    height, remaining, groundspeed, speed, radius_factor
):
    here = state((0.0, 0.0, GOAL.p_n[2] - height), 0.0)._replace(airspeed=speed)
    slope = plan_slope(
        here, GOAL, AEROSONDE, SPEED, remaining, groundspeed, radius_factor, 0.0, 100.0
    )
    rise = slope * max(groundspeed, 0.2 * speed) / speed
    assert abs(rise) <= math.sin(10.0 * DEG) + 1e-12
    limits = path_limits(speed, SPEED, math.inf, AEROSONDE)
    gamma, _ = allowed_path(path_angle(slope, groundspeed, 0.0, speed), limits)
    assert -AEROSONDE.descent_max - 1e-12 <= gamma <= AEROSONDE.climb_max + 1e-12


@given(st.floats(-30.0, 30.0))
def test_on_a_loiter_height_comes_back_over_its_horizon(height):
    circle = GOAL._replace(circle=1.0, radius=100.0, slope=0.0)
    here = state((0.0, 0.0, GOAL.p_n[2] - height), 0.0)
    slope = plan_slope(here, circle, AEROSONDE, SPEED, math.inf, 25.0, 1.0, 0.0, 100.0)
    up, down = math.sin(10.0 * DEG), math.sin(descent_at_airspeed(AEROSONDE, 0.0))
    wanted = max(-down, min(up, -2.0 * height / (LOITER_HORIZON * UNIT)))
    assert slope == pytest.approx(wanted)


def test_no_dive_past_the_fastest_and_no_climb_near_the_slowest_airspeed():
    """With the engine at rest an Aerosonde gains speed in a dive of 10 degrees: 35.5 m/s; where
    the air sinks it would climb into the stall."""
    fastest = DESCENT_RATIO * AEROSONDE.airspeed_max
    safe, room = LEVEL_RATIO * AEROSONDE.airspeed_min, CLIMB_BAND * SPEED
    full = (-AEROSONDE.descent_max, AEROSONDE.climb_max)
    assert path_limits(safe + room, SPEED, math.inf, AEROSONDE) == pytest.approx(full)
    zoom = math.asin(ZOOM_RATIO * math.sin(AEROSONDE.climb_max))
    for airspeed in (safe + ZOOM_RATIO * room, fastest - BAND):
        assert path_limits(airspeed, SPEED, math.inf, AEROSONDE) == pytest.approx((full[0], zoom))
    assert path_limits(fastest + BAND, SPEED, math.inf, AEROSONDE) == pytest.approx((0.0, zoom))
    assert path_limits(safe, SPEED, math.inf, AEROSONDE) == pytest.approx((full[0], 0.0))
    assert path_limits(safe - room, SPEED, math.inf, AEROSONDE)[1] < 0.0


@given(st.floats(-1.5, 1.5))
def test_thrust_is_set_for_all_of_a_climb_and_for_no_more_of_a_descent(asked):
    gamma, climb = allowed_path(asked, (-0.17, 0.24))
    assert gamma == np.clip(asked, -0.17, 0.24)
    assert climb == max(asked, -0.17)


def test_at_the_slowest_airspeed_the_path_is_level_in_air_that_sinks():
    level = allowed_path(path_angle(0.0, 25.0, 4.0, 25.0), (-AEROSONDE.descent_max, 0.0))[0]
    assert level == 0.0


def test_the_height_is_held_also_where_the_air_sinks():
    assert math.sin(path_angle(0.1, 30.0, 4.0, 25.0)) == pytest.approx(7.0 / 25.0)
    assert path_angle(0.0, 30.0, 40.0, 25.0) == pytest.approx(math.pi / 2)


def test_a_descent_is_no_steeper_than_the_glide_in_a_turn_unless_the_goal_asks_for_it():
    """On a descent of 10 degrees it reached 31 m/s and left the turns that were planned for 25."""
    glide = math.asin(1.2 * AEROSONDE.thrust_trim / AEROSONDE.thrust_per_climb)
    assert 6.0 * DEG < glide < 7.5 * DEG
    assert descent_at_airspeed(AEROSONDE, 0.0) == pytest.approx(glide)
    assert descent_at_airspeed(AEROSONDE, 0.15) == pytest.approx(glide)
    assert descent_at_airspeed(AEROSONDE, -math.tan(9.0 * DEG)) == pytest.approx(9.0 * DEG)
    assert descent_at_airspeed(AEROSONDE, -1.0) == AEROSONDE.descent_max
    assert steepest_path(-0.1, 1.0, 0.0, AEROSONDE) == pytest.approx(math.sin(glide))


def test_in_wider_turns_a_descent_is_steeper_as_far_as_the_aircraft_flies():
    glide = math.sin(descent_at_airspeed(AEROSONDE, 0.0))
    assert steepest_descent(AEROSONDE, 1.0, 0.0) == pytest.approx(math.asin(glide))
    assert steepest_descent(AEROSONDE, 1.15, 0.0) == pytest.approx(math.asin(1.15 * glide))
    assert steepest_descent(AEROSONDE, 9.0, 0.0) == AEROSONDE.descent_max
    goal = -math.tan(9.0 * DEG)
    assert steepest_descent(AEROSONDE, 1.15, goal) == pytest.approx(9.0 * DEG)
    assert largest_radius_factor(AEROSONDE) == MAX_RADIUS_FACTOR
    gentle = AEROSONDE._replace(descent_max=math.asin(1.05 * glide))
    assert largest_radius_factor(gentle) == pytest.approx(1.05)
    assert largest_radius_factor(AEROSONDE._replace(descent_max=0.5 * math.asin(glide))) == 1.0
    assert (
        largest_radius_factor(AEROSONDE._replace(airspeed_max=1.02 * AEROSONDE.airspeed_cruise))
        == 1.0
    )


@pytest.mark.parametrize("groundspeed", [-5.0, 0.0, 1e-9, 25.0])
@pytest.mark.parametrize("airspeed", [0.0, 1e-9, 25.0])
def test_the_ratio_of_the_speeds_is_bounded(airspeed, groundspeed):
    assert 0.0 <= airspeed_to_groundspeed(airspeed, groundspeed) <= 5.0 + 1e-9


@pytest.mark.parametrize("airspeed", [11.0, 25.0, 45.0])
def test_a_change_of_slope_takes_the_same_acceleration_at_every_airspeed(airspeed):
    here = state((-100.0, 0.0, GOAL.p_n[2] + 50.0), 0.0)
    after = plan_slope(here, GOAL, AEROSONDE, airspeed, 100.0, airspeed, 1.0, 0.0, 0.02)
    assert after * airspeed / 0.02 == pytest.approx(2.5)


def test_speed_goes_before_height():
    safe, room = LEVEL_RATIO * AEROSONDE.airspeed_min, CLIMB_BAND * SPEED
    climb, glide = math.sin(AEROSONDE.climb_max), math.sin(descent_at_airspeed(AEROSONDE, 0.0))
    for airspeed, sine in (
        (40.0, ZOOM_RATIO * climb),
        (safe + ZOOM_RATIO * room, ZOOM_RATIO * climb),
        (safe + room, climb),
        (safe + 0.5 * room, 0.5 * climb),
        (safe, 0.0),
        (safe - 0.5 * room, -0.5 * glide),
        (safe - room, -glide),
        (0.0, -glide),
    ):
        assert highest_path(airspeed, SPEED, math.inf, AEROSONDE) == pytest.approx(sine, abs=1e-12)


@pytest.mark.parametrize("airspeed", [21.0, 22.0, 22.6])
def test_near_the_floor_the_same_airspeed_lets_the_path_be_steeper(airspeed):
    """An Aerosonde climbs at 6.6 m/s at 22.4 m/s, at 5.7 m/s at 25 m/s."""
    steep = [highest_path(airspeed, SPEED, UNIT * above, AEROSONDE) for above in HEIGHTS]
    assert steep == sorted(steep, reverse=True)
    assert steep[0] == steep[1] > steep[-2] == steep[-1]
    assert steep[-1] == highest_path(airspeed, SPEED, math.inf, AEROSONDE)


def test_at_the_floor_the_airspeed_is_spent_down_to_a_slower_one():
    at, climb = 0.0, math.sin(AEROSONDE.climb_max)
    safe, room = FLOOR_LEVEL_RATIO * AEROSONDE.airspeed_min, FLOOR_CLIMB_BAND * SPEED
    assert safe > 1.1 * 17.6, "the stall"
    for airspeed, sine in (
        (safe + 3.0 * room, FLOOR_ZOOM_RATIO * climb),
        (safe + FLOOR_ZOOM_RATIO * room, FLOOR_ZOOM_RATIO * climb),
        (safe + room, climb),
        (safe, 0.0),
    ):
        assert highest_path(airspeed, SPEED, at, AEROSONDE) == pytest.approx(sine, abs=1e-12)


@pytest.mark.parametrize("flown", [18.0, 19.0, 20.0, 21.0, 22.0, 25.0, 30.0])
@pytest.mark.parametrize("part", [0.88, 0.9, 0.95, 1.0, 1.1])
def test_at_no_airspeed_to_fly_is_less_height_kept_near_the_floor(flown, part):
    """Told to fly 18 m/s it once gave up height at 0.9 of that there, and climbed elsewhere."""
    steep = [
        highest_path(part * flown, flown, above * turn_length(flown), AEROSONDE)
        for above in HEIGHTS
    ]
    assert steep == sorted(steep, reverse=True)


@pytest.mark.parametrize("flown", [18.0, 25.0])
@pytest.mark.parametrize("airspeed", [17.0, 20.0, 22.0, 24.0, 27.0])
def test_the_path_changes_steadily_on_the_way_to_the_floor(airspeed, flown):
    heights = np.linspace(-20.0, 120.0, 1401).tolist()
    steep = [highest_path(airspeed, flown, above, AEROSONDE) for above in heights]
    assert np.abs(np.diff(steep)).max() < 4e-3


def test_an_airspeed_near_the_slowest_may_be_flown():
    slowest = AEROSONDE.airspeed_min
    assert highest_path(slowest, slowest, math.inf, AEROSONDE) == math.sin(AEROSONDE.climb_max)
    assert highest_path(0.88 * slowest, slowest, math.inf, AEROSONDE) == pytest.approx(
        0.0, abs=1e-12
    )
