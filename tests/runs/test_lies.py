"""A liar on the link: one thing that the autopilot tells is wrong, and the flight is judged.

The limits are those of the issue: bank 55 degrees, load factor 0 to 2.6, 1.1 times the stall,
50 m of height.
"""

import math

import pytest
from altered import fly_altered, turned_about_vertical

from vfguide.earth.atmosphere import DENSITY_0, isa_density
from vfguide.geometry.units import DEG
from vfguide.link.messages import AttitudeQuaternion, LocalPositionNed, VfrHud, WindCov

pytestmark = pytest.mark.slow

STALL = 17.5
LONG = 999.0
STRAIGHT = (
    "vehicle.0.position_m=[-1200.0, 0.0, -120.0]",
    "vehicle.0.heading_deg=0.0",
    "vehicle.0.goal.0.position_m=[600.0, 0.0, -120.0]",
    "duration_s=100.0",
)


def lie(kind, change, begin, end):
    """The messages of one kind changed for a time [s]."""

    def alter(t, message):
        return [change(message) if isinstance(message, kind) and begin <= t < end else message]

    return alter


def turned(product):
    """An attitude message with another quaternion."""

    def change(m):
        q1, q2, q3, q4 = (float(each) for each in product((m.q1, m.q2, m.q3, m.q4)))
        return m._replace(q1=q1, q2=q2, q3=q3, q4=q4)

    return change


def yaw(degrees, begin, end=LONG):
    change = turned(lambda q: turned_about_vertical(q, degrees * DEG))
    return lie(AttitudeQuaternion, change, begin, end)


def about_body_axis(axis, degrees, begin):
    half = 0.5 * degrees * DEG
    x, y = (math.sin(half), 0.0) if axis == "roll" else (0.0, math.sin(half))

    def product(q):
        a, b, c, d = q
        w = math.cos(half)
        return (
            a * w - b * x - c * y,
            a * x + b * w - d * y,
            a * y + c * w + d * x,
            b * y - c * x + d * w,
        )

    return lie(AttitudeQuaternion, turned(product), begin, LONG)


def wind(north, east, begin, end=LONG):
    return lie(
        WindCov,
        lambda m: m._replace(wind_x=m.wind_x + north, wind_y=m.wind_y + east),
        begin,
        end,
    )


def velocity(north, east, down, begin, end=LONG):
    return lie(
        LocalPositionNed,
        lambda m: m._replace(vx=m.vx + north, vy=m.vy + east, vz=m.vz + down),
        begin,
        end,
    )


def airspeed(scale, begin):
    return lie(VfrHud, lambda m: m._replace(airspeed=scale * m.airspeed), begin, LONG)


def stays_inside(flight, stall=STALL):
    assert flight.bank <= 55.0
    assert flight.load[0] >= 0.0
    assert flight.load[1] <= 2.6
    assert flight.record.airspeed.min() >= 1.1 * stall
    assert flight.lost <= 50.0


@pytest.mark.parametrize(
    ("what", "alter"),
    [
        ("yaw", yaw(60.0, -1.0, 12.0)),
        ("yaw", yaw(-60.0, 6.0, 14.0)),
        ("yaw", yaw(45.0, 6.0)),
        ("yaw", yaw(180.0, 6.0)),
        ("wind", wind(7.2, -9.6, 6.0, 21.0)),
        ("wind", wind(-18.0, 24.0, 6.0, 21.0)),
        ("wind", wind(9.6, -12.8, -1.0)),
        ("wind", wind(-16.0, 0.0, -1.0)),
        ("ground velocity", velocity(10.0, 0.0, 0.0, 6.0)),
        ("ground velocity", velocity(-12.0, 16.0, 0.0, 6.0)),
        ("ground velocity", velocity(0.0, 10.0, 0.0, -1.0)),
        ("ground velocity", velocity(0.0, 0.0, -5.0, 6.0)),
        ("airspeed sensor", airspeed(1.25, 8.0)),
        ("airspeed sensor", airspeed(0.8, 8.0)),
        ("airspeed sensor", airspeed(1.5, -1.0)),
    ],
)
def test_what_contradicts_the_rest_is_told_once_and_the_goal_is_reached(tmp_path, what, alter):
    flight = fly_altered(tmp_path, alter, "duration_s=60.0")
    stays_inside(flight)
    assert flight.result.verdict == "good"
    doubts = flight.notes("contradicts the rest") + flight.notes("is not believed")
    assert len(doubts) == 1
    assert f"the {what} " in doubts[0]


HIGH = ("origin.altitude_m=4500.0", "vehicle.0.airspeed_mps=28.0", "duration_s=90.0")
"""A field in air of 0.63 of the density at sea level."""


@pytest.mark.parametrize("turbulence", ["none", "light"])
@pytest.mark.parametrize(
    ("what", "alter"),
    [
        ("yaw", yaw(-60.0, 6.0, 14.0)),
        ("wind", wind(7.2, -9.6, 6.0, 21.0)),
        ("ground velocity", velocity(0.0, 10.0, 0.0, -1.0)),
        ("airspeed sensor", airspeed(1.25, 8.0)),
        ("airspeed sensor", airspeed(0.7, 10.0)),
    ],
)
def test_lies_are_found_in_thin_air_too(tmp_path, what, alter, turbulence):
    """Thresholds are in m/s, and true airspeeds larger than at sea level."""
    flight = fly_altered(tmp_path, alter, *HIGH, f"wind.turbulence='{turbulence}'")
    stall = STALL / math.sqrt(isa_density(4650.0) / DENSITY_0)
    stays_inside(flight, stall)
    assert flight.result.verdict == "good"
    doubts = flight.notes("contradicts the rest") + flight.notes("is not believed")
    assert len(doubts) == 1
    assert f"the {what} " in doubts[0]


@pytest.mark.parametrize("degrees", [-90.0, 90.0, 120.0])
def test_straight_flight_with_a_wrong_yaw(tmp_path, degrees):
    flight = fly_altered(tmp_path, yaw(degrees, 6.0, 14.0), *STRAIGHT)
    stays_inside(flight)
    assert flight.result.verdict == "good"


def test_a_yaw_that_stays_wrong_ends_in_hold(tmp_path):
    flight = fly_altered(tmp_path, yaw(90.0, 6.0), *STRAIGHT)
    stays_inside(flight)
    (time,) = [t for t, note in flight.told if "has contradicted the rest for 30 s" in note]
    assert time == pytest.approx(36.0, abs=0.2)
    assert flight.notes("no more setpoints for now")
    assert not flight.notes("goal 1 reached")


@pytest.mark.parametrize("axis", ["roll", "pitch"])
@pytest.mark.parametrize(("degrees", "begin"), [(20.0, 6.0), (-40.0, 6.0), (40.0, -1.0)])
def test_a_wrong_roll_or_pitch_ends_in_hold_within_a_second(tmp_path, axis, degrees, begin):
    flight = fly_altered(tmp_path, about_body_axis(axis, degrees, begin), "duration_s=40.0")
    found = next(t for t, note in flight.told if "roll or pitch" in note)
    assert found <= max(begin, 0.26) + 1.0
    assert flight.lost <= 50.0


def test_an_honest_flight_is_not_doubted(tmp_path):
    flight = fly_altered(tmp_path, lambda _, message: [message], "wind.turbulence='moderate'")
    assert not flight.notes("contradict")
    assert flight.result.verdict == "good"
