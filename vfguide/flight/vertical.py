"""The vertical half of the flight law: the height profile, and the path angle to fly."""

import math

from vfguide.flight.memory import Target
from vfguide.flight.performance import Performance
from vfguide.flight.state import FlightState
from vfguide.geometry.compiled import compiled

STANDOFF = 30.0
"""The distance to the goal is not taken below this in the profile [m]."""
LOITER_HORIZON = 150.0
"""Distance over which a loitering vehicle takes away an error of height [m]."""
SLOPE_RATE = 0.1
"""Fastest change of the wanted slope [1/s]: 2.5 m/s^2 at 25 m/s."""


@compiled
def plan_slope(
    state: FlightState,
    target: Target,
    aircraft: Performance,
    remaining: float,
    groundspeed: float,
    before: float,
    dt: float,
) -> float:
    """Slope dh/ds over ground, within the aircraft's path angles, its rate limited.

    Args:
        state: of the vehicle.
        target: what it flies to.
        aircraft: its limits.
        remaining: path over ground to the target [m].
        groundspeed: along the course [m/s].
        before: the slope of the step before.
        dt: time since then [s].
    """
    height = target.p_n[2] - state.p_n[2]
    if target.circle != 0.0:
        wanted = -2.0 * height / LOITER_HORIZON
    else:
        wanted = goal_slope(height, remaining, target.slope)
    up = airspeed_over_ground(state.airspeed, groundspeed)
    highest, lowest = up * math.sin(aircraft.climb_max), -up * math.sin(aircraft.descent_max)
    wanted = max(lowest, min(highest, wanted))
    return max(before - SLOPE_RATE * dt, min(before + SLOPE_RATE * dt, wanted))


@compiled
def airspeed_over_ground(airspeed: float, groundspeed: float) -> float:
    """Ratio of the speeds, bounded where the wind stops the vehicle."""
    return airspeed / max(groundspeed, 0.2 * airspeed)


@compiled
def path_angle(
    slope: float, groundspeed: float, wind_down: float, airspeed: float, aircraft: Performance
) -> float:
    """Path angle through the air that makes good the slope over ground [rad]."""
    sine = (slope * groundspeed + wind_down) / airspeed
    return max(-aircraft.descent_max, min(aircraft.climb_max, math.asin(max(-1.0, min(1.0, sine)))))


@compiled
def goal_slope(height: float, remaining: float, goal_slope: float) -> float:
    """Slope dh/ds of the parabola that ends at the goal's height with the goal's slope.

    `height` above the goal [m], `remaining` path over ground [m]. Every solution of
    dh/ds = -2 h / remaining - goal_slope is h = -goal_slope * remaining + c * remaining^2.
    """
    return -2.0 * height / max(remaining, STANDOFF) - goal_slope


@compiled
def path_needed(height: float, remaining: float, goal_slope: float, slope_max: float) -> float:
    """Shortest path over ground that takes away `height` above the goal's line [m]."""
    return abs(height + goal_slope * min(remaining, STANDOFF)) / slope_max
