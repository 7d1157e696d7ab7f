"""How steep a path the aircraft flies: airspeed comes before height."""

import math

from vfguide.aircraft.performance import Performance, turn_length
from vfguide.geometry.compiled import compiled

SAFE = 1.165
"""Below this times the slowest airspeed height is given up for airspeed; measured on the shipped
aircraft in turbulence."""
ROOM = 0.12
"""The steepest climb is flown from so much above SAFE on, as a share of the airspeed to fly."""
ZOOM = 1.4
"""Through air that sinks a climb may be steeper than the steepest by this factor, while the
airspeed lasts."""
LAST_SAFE = 1.12
"""What SAFE becomes at the floor, where airspeed is spent for height."""
LAST_ROOM = 0.056
"""What ROOM becomes at the floor."""
LAST_ZOOM = 1.8
"""What ZOOM becomes at the floor."""
NEAR_FLOOR = 1.2
"""From this height above the floor on, in turn lengths, the three change towards their values at
the floor."""
AT_FLOOR = 0.6
"""At this height above the floor, in turn lengths, the three have their values at the floor."""
FASTEST_DESCENT = 0.98
"""At this times the fastest airspeed half of the steepest descent is given up."""
AIRSPEED_BAND = 0.12
"""All of the descent is given up so much above that airspeed, as a share of the cruise airspeed."""
IDLE = 1.2
"""A descent in a turn is steeper than the straight glide without thrust by this factor: a turn
takes more drag, and the descent is flown a little faster."""
MAX_RADIUS_FACTOR = 1.15
"""Turns are made wider by no more than this, for a faster and steeper descent."""


@compiled
def descent_at_airspeed(aircraft: Performance, goal_slope: float) -> float:
    """Steepest angle of a descent that hardly gains airspeed, or the goal's own [rad].

    Without thrust the aeroplane glides at the angle whose sine is trim / per_climb; in a turn,
    which takes more drag, and a little faster it sinks IDLE times as steeply.
    """
    glide = IDLE * aircraft.thrust_trim / aircraft.thrust_per_climb
    angle = max(math.asin(min(glide, 1.0)), math.atan(-goal_slope))
    return min(aircraft.descent_max, angle)


@compiled
def steepest_descent(aircraft: Performance, radius_factor: float, goal_slope: float) -> float:
    """The same where turns are wider by a factor [rad].

    They are flown at a larger airspeed then. Its square is in proportion to both the radius, at the
    same bank, and the drag.
    """
    faster = math.asin(min(radius_factor * math.sin(descent_at_airspeed(aircraft, 0.0)), 1.0))
    return min(aircraft.descent_max, max(faster, descent_at_airspeed(aircraft, goal_slope)))


@compiled
def largest_radius_factor(aircraft: Performance) -> float:
    """By which turns are widened for a steeper descent: not for more than the aircraft flies."""
    angle = max(descent_at_airspeed(aircraft, 0.0), 1e-3)
    fastest = FASTEST_DESCENT * aircraft.airspeed_max / max(aircraft.airspeed_cruise, 1e-3)
    most = min(math.sin(aircraft.descent_max) / math.sin(angle), fastest * fastest / IDLE)
    return max(1.0, min(MAX_RADIUS_FACTOR, most))


@compiled
def highest_path(airspeed: float, flown: float, above: float, aircraft: Performance) -> float:
    """Largest sine of the path angle that the airspeed allows: speed goes before height.

    It falls with the airspeed from more than the steepest climb, which `plan_slope` asks for only
    where the air sinks, to the glide without thrust: the climb is the steepest ROOM above SAFE
    times the slowest airspeed, the glide ROOM below, and there the path is level; near the floor,
    `above` it [m], LAST_ROOM and LAST_SAFE. An airspeed to fly, `flown` [m/s], that leaves no such
    room puts it lower.
    """
    last = floor_share(above, turn_length(flown))
    room = blended(ROOM, LAST_ROOM, last) * flown
    safe = min(blended(SAFE, LAST_SAFE, last) * aircraft.airspeed_min, (1.0 - ROOM) * flown)
    part = max(-1.0, min(blended(ZOOM, LAST_ZOOM, last), (airspeed - safe) / room))
    steepest = aircraft.climb_max if part > 0.0 else descent_at_airspeed(aircraft, 0.0)
    return part * math.sin(steepest)


@compiled
def floor_share(above: float, unit: float) -> float:
    """How near the floor is: 0 NEAR_FLOOR above it and higher, 1 AT_FLOOR and lower."""
    return max(0.0, min(1.0, (NEAR_FLOOR - above / unit) / (NEAR_FLOOR - AT_FLOOR)))


@compiled
def blended(first: float, second: float, part: float) -> float:
    """The first at part 0, the second at part 1."""
    return first + part * (second - first)


@compiled
def share(margin: float, band: float) -> float:
    """Part of the path angle that is flown with the airspeed `margin` inside its limit [m/s]."""
    return max(0.0, min(1.0, 0.5 + 0.5 * margin / band))


@compiled
def path_limits(
    airspeed: float, flown: float, above: float, aircraft: Performance
) -> tuple[float, float]:
    """Steepest path angles through the air, down and up [rad], at an airspeed without its gusts.

    The airspeed comes before the height, also where it is the air that sinks or rises.

    Args:
        airspeed: [m/s].
        flown: the one to fly [m/s].
        above: height above the floor, infinite where there is none [m].
        aircraft: its limits.
    """
    band = AIRSPEED_BAND * aircraft.airspeed_cruise
    down = share(FASTEST_DESCENT * aircraft.airspeed_max - airspeed, band)
    return -down * aircraft.descent_max, math.asin(highest_path(airspeed, flown, above, aircraft))


@compiled
def path_angle(
    slope: float,
    groundspeed: float,
    wind_down: float,
    airspeed: float,
) -> float:
    """Path angle through the air that makes good the slope over ground [rad], not limited.

    Level over ground where the wind blows the vehicle back: no slope is made good there.
    """
    climb = slope * max(groundspeed, 0.0) + wind_down
    return math.asin(max(-1.0, min(1.0, climb / airspeed)))


@compiled
def allowed_path(asked: float, limits: tuple[float, float]) -> tuple[float, float]:
    """The part of a path angle that is within the limits, and what thrust is set for [rad].

    That is no less: the airspeed that a climb lacks comes from the thrust for it.
    """
    gamma = max(limits[0], min(limits[1], asked))
    return gamma, max(gamma, asked)
