"""The circuit of an identification flight: its legs, and their distance from hazards.

It is a closed circuit of straight legs and two turns, with a climb, a descent, a fast and a slow
leg.
"""

import math
from collections.abc import Sequence
from typing import NamedTuple

from vfguide.aircraft.envelope import FASTEST_SHARE, flyable_radius, usable_bank
from vfguide.aircraft.state import FlightState
from vfguide.aircraft.vehicle import Vehicle
from vfguide.airspace.hazards import Hazards, hazard_count, hazard_distance
from vfguide.geometry.se2 import rotated
from vfguide.geometry.units import DEG
from vfguide.geometry.vector import Vec3
from vfguide.geometry.velocity import azimuth_of
from vfguide.loop.legs import Goal

TEST_CLIMB = 4.0 * DEG
"""Mean path angle of the climb and the descent [rad]; chosen, they are steeper between their level
ends."""
TEST_CLIMB_SHARE = 0.4
"""Largest share of the aircraft's steepest path angle that the mean of a climb or descent has;
chosen, as they are steeper between their level ends."""
AIRSPEED_CHANGE = 0.15
"""Share by which the airspeed is raised and lowered; chosen, so that its effect is seen."""
SLOW_LEG_RATIO = 1.1
"""Least ratio of the airspeed of the slow leg to the slowest airspeed; chosen, gusts take the
rest."""
STRAIGHT_TIME = 8.0
"""Duration of a straight leg [s]; chosen."""
FIRST_LEG_TIME = 3.0
"""Duration of the first leg, level flight straight on [s]; chosen."""
TURN_END = 0.7
"""Length of the straight after a turn [turn radii]; chosen."""
MET_DISTANCE = 10.0
"""Miss of its last pose up to which a leg counts as flown [m]; chosen: one that misses by more is
left all the same."""
MET_ANGLE = 30.0 * DEG
"""Error of course and climb within which a leg counts as flown [rad]; chosen."""
ROOM_SPACING = 25.0
"""Largest distance between two checked positions on the circuit [m]; chosen."""
LEG_TIME_FACTOR = 3.0
"""Ratio of the longest time of a leg, after which it is left, to that in still air; chosen."""
SPARE_TIME = 10.0
"""Time that is added to the longest time of a leg [s]; chosen."""


class CircuitLeg(NamedTuple):
    """One leg of the test flight."""

    name: str
    """What is flown, for the operator."""
    goal: Goal
    """Pose at its end."""
    airspeed: float
    """True airspeed to fly [m/s]."""
    longest: float
    """Time after which the leg is left [s]."""
    places: tuple[Vec3, ...]
    """Positions along it, no farther than ROOM_SPACING apart, NED [m]."""


def circuit(state: FlightState, vehicle: Vehicle, side: float) -> tuple[CircuitLeg, ...]:
    """The legs of a test flight of a vehicle in the present air that begins and ends at `state`.

    Its turns are to the right with `side` +1, to the left with -1.
    """
    aircraft, gains, _ = vehicle
    speed = gains.airspeed
    fast = max(speed, min((1.0 + AIRSPEED_CHANGE) * speed, FASTEST_SHARE * aircraft.airspeed_max))
    slow = min(speed, max((1.0 - AIRSPEED_CHANGE) * speed, SLOW_LEG_RATIO * aircraft.airspeed_min))
    still = state._replace(wind_n=tuple(0.0 if math.isnan(w) else w for w in state.wind_n))
    radius = flyable_radius(still, usable_bank(aircraft, gains, speed), gains)
    course = azimuth_of(state.v_n)
    up = min(TEST_CLIMB, TEST_CLIMB_SHARE * aircraft.climb_max)
    down = min(up, TEST_CLIMB_SHARE * aircraft.descent_max)
    long, turn, end = STRAIGHT_TIME * speed, side * math.pi, TURN_END * radius
    legs = (  # name, airspeed, turn, length after it and height on it [m]
        ("level flight", speed, 0.0, FIRST_LEG_TIME * speed, 0.0),
        ("a climb", speed, 0.0, long, long * math.tan(up)),
        ("a descent", speed, 0.0, long, -long * math.tan(down)),
        ("a turn", speed, turn, end, 0.0),
        ("fast flight", fast, 0.0, STRAIGHT_TIME * fast, 0.0),
        ("slow flight", slow, 0.0, STRAIGHT_TIME * fast, 0.0),
        ("a turn back", speed, turn, end, 0.0),
    )
    at, manoeuvres = state.p_n, list[CircuitLeg]()
    for name, airspeed, turned, length, height in legs:
        places = places_along(at, course, radius, turned, length, height)
        at, course = places[-1], course + turned
        longest = LEG_TIME_FACTOR * (radius * abs(turned) + length) / airspeed + SPARE_TIME
        goal = Goal(at, course, 0.0, MET_DISTANCE, MET_ANGLE, attempts=1)
        manoeuvres.append(CircuitLeg(name, goal, airspeed, longest, places))
    return tuple(manoeuvres)


def places_along(
    p_n: Vec3, course: float, radius: float, turned: float, length: float, height: float
) -> tuple[Vec3, ...]:
    """Positions on an arc and the straight after it, at most ROOM_SPACING apart, NED [m].

    Args:
        p_n: where the arc begins, NED [m].
        course: course there [rad].
        radius: radius of the arc [m].
        turned: angle by which it turns, right positive [rad].
        length: length of the straight over ground [m].
        height: height that it gains [m].
    """
    places: list[Vec3] = []
    steps = math.ceil(radius * abs(turned) / ROOM_SPACING)
    side = math.copysign(radius, turned)
    for k in range(1, steps + 1):
        angle = abs(turned) * k / steps
        across = side * (1.0 - math.cos(angle))
        places.append(moved(p_n, course, radius * math.sin(angle), across, 0.0))
    at = places[-1] if places else p_n
    steps = math.ceil(math.hypot(length, height) / ROOM_SPACING)
    for k in range(1, steps + 1):
        share = k / steps
        places.append(moved(at, course + turned, share * length, 0.0, share * height))
    return tuple(places)


def least_room(legs: Sequence[CircuitLeg], hazards: Hazards | None, t: float) -> float:
    """Least distance of the legs from a hazard [m] at the time `t` [s]; infinite without any."""
    return min(room(place, hazards, t) for leg in legs for place in leg.places)


def room(p_n: Vec3, hazards: Hazards | None, t: float) -> float:
    """Distance of a position, NED [m], from the nearest hazard [m] at the time `t` [s].

    It is infinite where there is none.
    """
    if hazards is None:
        return math.inf
    return min(hazard_distance(hazards, i, p_n, t) for i in range(hazard_count(hazards)))


def moved(p_n: Vec3, course: float, ahead: float, right: float, up: float) -> Vec3:
    """The position `ahead`, `right` and `up` [m] of another along a course [rad], NED [m]."""
    north, east = rotated(ahead, right, math.cos(course), math.sin(course))
    return p_n[0] + north, p_n[1] + east, p_n[2] - up
