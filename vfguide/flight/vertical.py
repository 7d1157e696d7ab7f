"""The vertical half of the flight law: the height profile, and the path angle to fly."""

import math

from vfguide.flight.memory import Target
from vfguide.flight.performance import Performance, turn_length
from vfguide.flight.state import FlightState
from vfguide.geometry.compiled import compiled
from vfguide.geometry.units import G0

STANDOFF = 0.35
"""The distance to the goal is not taken below this in the profile, in turn lengths."""
LINE_UP = 1.57
"""The slope of the goal is taken up over this distance before it, in turn lengths."""
LOITER_HORIZON = 2.35
"""Distance over which a loitering vehicle takes away an error of height, in turn lengths."""
SOON = 0.45
"""A small error of height falls over this distance, wherever the goal is, in turn lengths, ..."""
GENTLE = 0.06
"""... a larger one with this slope."""
WAIT = 8.0
"""Height above the profile is kept until that slope takes it away so long before the goal, in turn
lengths and half of LINE_UP: it is what air that sinks can take."""
SAFE = 1.165
"""Below this times the slowest airspeed height is given up for airspeed."""
ROOM = 0.12
"""This much above it the steepest climb is flown, as a share of the airspeed to fly."""
ZOOM = 1.4
"""Through air that sinks it may be this much steeper, while the airspeed lasts."""
LAST_SAFE, LAST_ROOM, LAST_ZOOM = 1.12, 0.056, 1.8
"""The same three at the floor: airspeed is spent there, and at less of it the climb is faster."""
NEAR_FLOOR, AT_FLOOR = 1.2, 0.6
"""From the first height above the floor, in turn lengths, to the second the first three become
the last."""
FASTEST_DESCENT = 0.98
"""At this times the fastest airspeed half the descent is given up, ..."""
AIRSPEED_BAND = 0.12
"""... all of it so much of the cruise airspeed above."""
IDLE = 1.2
"""A descent in a turn is steeper than the straight glide without thrust by this factor."""
WIDER = 1.15
"""Turns that are wider by this allow a faster and steeper descent."""
SLOPE_RATE = 2.5
"""Fastest change of the wanted slope times the airspeed to fly [m/s^2], ..."""
RAMP = 0.8
"""... and the part of it that paths are planned with."""


@compiled
def plan_slope(
    state: FlightState,
    target: Target,
    aircraft: Performance,
    airspeed: float,
    remaining: float,
    groundspeed: float,
    wider: float,
    before: float,
    dt: float,
) -> float:
    """Slope dh/ds over ground, within the aircraft's path angles, its rate limited.

    Args:
        state: of the vehicle.
        target: what it flies to.
        aircraft: its limits.
        airspeed: true airspeed to fly [m/s]; distances and rates scale with it.
        remaining: path over ground to the target [m].
        groundspeed: along the course [m/s].
        wider: by which turns are wider than in level flight, see `steepest_descent`.
        before: the slope of the step before.
        dt: time since then [s].
    """
    height = target.p_n[2] - state.p_n[2]
    if target.circle != 0.0:
        wanted = -2.0 * height / (LOITER_HORIZON * turn_length(airspeed))
    else:
        wanted = goal_slope(height, remaining, target.slope, turn_length(airspeed))
    up = airspeed_over_ground(state.airspeed, groundspeed)
    steepest = steepest_path(wanted, wider, target.slope, aircraft)
    wanted = max(-up * steepest, min(up * steepest, wanted))
    change = SLOPE_RATE / airspeed * dt
    return max(before - change, min(before + change, wanted))


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
def steepest_descent(aircraft: Performance, wider: float, goal_slope: float) -> float:
    """The same where turns are wider by a factor [rad].

    They are flown at a larger airspeed then. Its square is in proportion to both the radius, at the
    same bank, and the drag.
    """
    faster = math.asin(min(wider * math.sin(descent_at_airspeed(aircraft, 0.0)), 1.0))
    return min(aircraft.descent_max, max(faster, descent_at_airspeed(aircraft, goal_slope)))


@compiled
def widest(aircraft: Performance) -> float:
    """By which turns are widened for a steeper descent: not for more than the aircraft flies."""
    angle = max(descent_at_airspeed(aircraft, 0.0), 1e-3)
    fastest = FASTEST_DESCENT * aircraft.airspeed_max / max(aircraft.airspeed_cruise, 1e-3)
    most = min(math.sin(aircraft.descent_max) / math.sin(angle), fastest * fastest / IDLE)
    return max(1.0, min(WIDER, most))


@compiled
def steepest_path(slope: float, wider: float, goal_slope: float, aircraft: Performance) -> float:
    """Largest sine of the path angle up or down, as the sign of `slope` says."""
    if slope > 0.0:
        return math.sin(aircraft.climb_max)
    return math.sin(steepest_descent(aircraft, wider, goal_slope))


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
def airspeed_over_ground(airspeed: float, groundspeed: float) -> float:
    """Ratio of the speeds, bounded where the wind stops the vehicle."""
    return airspeed / max(groundspeed, 0.2 * airspeed, 1e-3)


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


@compiled
def goal_slope(height: float, remaining: float, goal_slope: float, unit: float) -> float:
    """Slope dh/ds of a path that ends at the goal's height with the goal's slope.

    `height` above the goal [m], `remaining` path over ground [m], `unit` turn length [m]. The
    error of height over the goal's own profile falls in a straight line until LINE_UP before the
    goal, from there as a parabola: its slope is -2 error / remaining. Small errors fall sooner,
    but far from the goal those above the profile wait.
    """
    error = height - profile_height(remaining, goal_slope, unit)
    line_up = LINE_UP * unit
    own = goal_slope * max(0.0, 1.0 - remaining / line_up)
    over = 0.5 * remaining if remaining < line_up else remaining - 0.5 * line_up
    if 0.0 < error < GENTLE * over:
        error = max(0.0, error - GENTLE * max(0.0, over - WAIT * unit))
    soon = max(SOON * unit, abs(error) / GENTLE)
    return own - error / max(min(over, soon), 0.5 * STANDOFF * unit)


@compiled
def profile_height(remaining: float, goal_slope: float, unit: float) -> float:
    """Height over the goal of the path that is level until LINE_UP before it [m]."""
    r = min(remaining, LINE_UP * unit)
    return -goal_slope * r * (1.0 - 0.5 * r / (LINE_UP * unit))


@compiled
def path_needed(
    height: float,
    remaining: float,
    goal_slope: float,
    slope_max: float,
    unit: float,
    before: float,
) -> float:
    """Shortest path over ground that takes away `height` over the goal's profile [m].

    From the slope `before` the path takes up `slope_max`, and at its end the goal's own slope, no
    faster than `plan_slope` lets it.
    """
    error = height - profile_height(remaining, goal_slope, unit)
    ramp = RAMP * SLOPE_RATE / (G0 * unit)  # change of slope for each metre
    begun = max(-slope_max, min(slope_max, -before if error > 0.0 else before))
    too_steep = 0.5 * begun * abs(begun) / ramp - abs(error)
    if too_steep > 0.0:
        return begun / ramp + 2.0 * math.sqrt(too_steep / ramp)
    peak = math.sqrt(ramp * abs(error) + 0.5 * begun * begun)
    if peak <= slope_max:
        return (2.0 * peak - begun) / ramp
    ramps = (slope_max - begun) ** 2 + slope_max * slope_max
    return abs(error) / slope_max + ramps / (2.0 * ramp * slope_max)
