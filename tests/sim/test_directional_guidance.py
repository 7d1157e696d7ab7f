"""The lateral acceleration that leads to a circle, flown by a point in the plane."""

import math

import pytest
from hypothesis import given
from hypothesis import strategies as st

from vfguide.geometry.angles import wrap
from vfguide.geometry.units import DEG, G0
from vfguide.sim.autopilot.directional_guidance import (
    air_velocity,
    lateral_acceleration,
    look_ahead,
)

CALM = (0.0, 0.0)
SPEEDS = st.sampled_from([11.0, 25.0, 45.0])
ANGLES = st.floats(-math.pi, math.pi)
DT = 0.02


def polar(size: float, angle: float) -> tuple[float, float]:
    return (size * math.cos(angle), size * math.sin(angle))


def wide_enough(airspeed: float, wind: float) -> float:
    """Radius at which 35 degrees of bank are enough downwind [m]."""
    return (airspeed + wind) ** 2 / (G0 * math.tan(35.0 * DEG))


class Point:
    """What a lateral acceleration up to that of 42 degrees of bank turns, without any lag."""

    def __init__(self, place, heading, airspeed, wind, radius):
        self.place, self.heading = place, heading
        self.airspeed, self.wind, self.radius = airspeed, wind, radius

    @property
    def ground(self):
        north, east = polar(self.airspeed, self.heading)
        return (north + self.wind[0], east + self.wind[1])

    def fly(self, seconds: float) -> list[float]:
        """Distances from the circle [m]."""
        most, errors = G0 * math.tan(42.0 * DEG), []
        for _ in range(round(seconds / DT)):
            wanted = lateral_acceleration(
                self.place, self.ground, self.wind, self.airspeed, self.radius
            )
            self.heading += max(-most, min(most, wanted)) / self.airspeed * DT
            north, east = self.ground
            self.place = (self.place[0] + north * DT, self.place[1] + east * DT)
            errors.append(math.hypot(*self.place) - self.radius)
        return errors


@pytest.mark.parametrize("where", [0.0, 1.0, 3.0, -2.0])
def test_on_the_circle_it_turns_with_it(where):
    place, ground = polar(100.0, where), polar(25.0, where + 0.5 * math.pi)
    assert lateral_acceleration(place, ground, CALM, 25.0, 100.0) == pytest.approx(25.0**2 / 100.0)


@given(where=ANGLES, airspeed=SPEEDS, part=st.floats(0.0, 0.6), direction=ANGLES)
def test_on_the_circle_it_turns_as_the_wind_triangle_asks(where, airspeed, part, direction):
    """The rate of the heading from two wind triangles, a little apart on the circle."""
    radius, wind = 300.0, polar(part * airspeed, direction)

    def heading_at(angle: float) -> float:
        course = angle + 0.5 * math.pi
        return course - math.asin(part * math.sin(direction - course))

    def ground_speed(angle: float) -> float:
        north, east = polar(airspeed, heading_at(angle))
        return math.hypot(north + wind[0], east + wind[1])

    rate = (heading_at(where + 1e-5) - heading_at(where - 1e-5)) / 2e-5
    expected = airspeed * rate * ground_speed(where) / radius
    ground = polar(ground_speed(where), where + 0.5 * math.pi)
    found = lateral_acceleration(polar(radius, where), ground, wind, airspeed, radius)
    assert found == pytest.approx(expected, rel=1e-4, abs=1e-6)


@given(
    start=st.floats(0.0, 12.0),
    where=ANGLES,
    heading=ANGLES,
    airspeed=SPEEDS,
    part=st.floats(0.0, 0.6),
    direction=ANGLES,
)
def test_from_anywhere_and_in_any_wind_it_comes_to_the_circle(
    start, where, heading, airspeed, part, direction
):
    radius = wide_enough(airspeed, part * airspeed)
    point = Point(
        polar(start * radius, where), heading, airspeed, polar(part * airspeed, direction), radius
    )
    point.fly(start * radius / (airspeed * (1.0 - part)) + 20.0 * airspeed / G0)
    around = 2.0 * math.pi * radius / (airspeed * (1.0 - part))
    assert max(map(abs, point.fly(around))) < 0.01 * radius


def test_it_goes_round_clockwise():
    point = Point((100.0, 0.0), -0.5 * math.pi, 25.0, CALM, 100.0)
    point.fly(60.0)
    north, east = point.place
    before = math.atan2(east, north)
    point.fly(1.0)
    north, east = point.place
    assert wrap(math.atan2(east, north) - before) == pytest.approx(0.25, rel=0.01)


@given(turn=ANGLES, where=ANGLES, course=ANGLES, direction=ANGLES)
def test_it_turns_with_the_world(turn, where, course, direction):
    def asked(by: float) -> float:
        place, ground = polar(180.0, where + by), polar(22.0, course + by)
        return lateral_acceleration(place, ground, polar(9.0, direction + by), 25.0, 100.0)

    assert asked(turn) == pytest.approx(asked(0.0), rel=1e-6, abs=1e-6)


def test_the_bearing_turns_from_straight_at_the_circle_to_along_it():
    angles = [look_ahead(error, (25.0, 0.0), 25.0) for error in (1e5, 60.0, 20.0, 0.0, -20.0)]
    assert angles[0] == 0.0
    assert angles[0] < angles[1] < angles[2] < angles[3]
    assert angles[3] == pytest.approx(0.5 * math.pi)
    assert angles[4] == angles[2]


@given(bearing=ANGLES, wind=st.floats(0.0, 0.99), direction=ANGLES)
def test_in_a_wind_slower_than_the_aircraft_it_flies_along_the_bearing(bearing, wind, direction):
    along, blows = polar(1.0, bearing), polar(25.0 * wind, direction)
    air = air_velocity(along, blows, 25.0)
    ground = (air[0] + blows[0], air[1] + blows[1])
    assert math.hypot(*air) == pytest.approx(25.0)
    assert ground[0] * along[1] - ground[1] * along[0] == pytest.approx(0.0, abs=1e-6)
    assert ground[0] * along[0] + ground[1] * along[1] > 0.0


@pytest.mark.parametrize("wind", [1.05, 1.3, 2.0])
def test_in_a_wind_faster_than_the_aircraft_its_nose_turns_against_it(wind):
    """No course can be held away from the wind; with the nose against it it drifts least."""
    point = Point((0.0, 500.0), 1.0, 25.0, (0.0, 25.0 * wind), 200.0)
    point.fly(120.0)
    north, east = point.ground
    assert math.hypot(north, east) < 25.0 * math.sqrt(wind * wind - 1.0) + 1.0
    assert math.cos(point.heading + 0.5 * math.pi) > 0.6


BOUNDED = st.floats(-1e5, 1e5)


@given(
    place=st.tuples(BOUNDED, BOUNDED),
    ground=st.tuples(BOUNDED, BOUNDED),
    wind=st.tuples(BOUNDED, BOUNDED),
    airspeed=st.floats(3.0, 100.0),
    radius=st.floats(5.0, 5000.0),
)
def test_it_is_always_a_number(place, ground, wind, airspeed, radius):
    assert math.isfinite(lateral_acceleration(place, ground, wind, airspeed, radius))


@pytest.mark.parametrize("wind", [(0.0, 0.0), (0.0, 25.0), (25.0, 0.0), (-25.0, 0.0)])
def test_the_centre_and_standing_still_are_no_exception(wind):
    for ground in ((0.0, 0.0), (25.0, 0.0), wind):
        assert math.isfinite(lateral_acceleration((0.0, 0.0), ground, wind, 25.0, 100.0))
