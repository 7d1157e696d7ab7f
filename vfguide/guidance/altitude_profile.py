"""The vertical half of the flight law: the height profile, and the path angle to fly."""

import math

from vfguide.aircraft.path_limits import steepest_descent
from vfguide.aircraft.performance import Performance, turn_length
from vfguide.aircraft.state import FlightState
from vfguide.geometry.compiled import compiled
from vfguide.paths.distance_for_altitude import LINE_UP, SLOPE_RATE, profile_height
from vfguide.planning.objective import GuidanceTarget

STANDOFF = 0.35
"""The distance to the goal is not taken below this in the profile, in turn lengths."""
LOITER_HORIZON = 2.35
"""Distance over which a loitering vehicle takes away an error of height, in turn lengths."""
SMALL_ERROR_DISTANCE = 0.45
"""A small error of height falls over this distance, wherever the goal is, in turn lengths, ..."""
GENTLE = 0.06
"""... a larger one with this slope."""
WAIT = 8.0
"""Height above the profile is kept until that slope takes it away so long before the goal, in turn
lengths and half of LINE_UP: it is what air that sinks can take."""


@compiled
def plan_slope(
    state: FlightState,
    target: GuidanceTarget,
    aircraft: Performance,
    airspeed: float,
    remaining: float,
    groundspeed: float,
    radius_factor: float,
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
        radius_factor: by which turns are wider than in level flight, see `steepest_descent`.
        before: the slope of the step before.
        dt: time since then [s].
    """
    height = target.p_n[2] - state.p_n[2]
    if target.circle != 0.0:
        wanted = -2.0 * height / (LOITER_HORIZON * turn_length(airspeed))
    else:
        wanted = goal_slope(height, remaining, target.slope, turn_length(airspeed))
    up = airspeed_over_ground(state.airspeed, groundspeed)
    steepest = steepest_path(wanted, radius_factor, target.slope, aircraft)
    wanted = max(-up * steepest, min(up * steepest, wanted))
    change = SLOPE_RATE / airspeed * dt
    return max(before - change, min(before + change, wanted))


@compiled
def steepest_path(
    slope: float, radius_factor: float, goal_slope: float, aircraft: Performance
) -> float:
    """Largest sine of the path angle up or down, as the sign of `slope` says."""
    if slope > 0.0:
        return math.sin(aircraft.climb_max)
    return math.sin(steepest_descent(aircraft, radius_factor, goal_slope))


@compiled
def airspeed_over_ground(airspeed: float, groundspeed: float) -> float:
    """Ratio of the speeds, bounded where the wind stops the vehicle."""
    return airspeed / max(groundspeed, 0.2 * airspeed, 1e-3)


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
    reach = max(SMALL_ERROR_DISTANCE * unit, abs(error) / GENTLE)
    return own - error / max(min(over, reach), 0.5 * STANDOFF * unit)
