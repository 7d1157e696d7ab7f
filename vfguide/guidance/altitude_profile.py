"""The vertical half of the flight law: the altitude profile and its slope."""

import math

from vfguide.aircraft.path_limits import steepest_descent
from vfguide.aircraft.performance import Performance, turn_length
from vfguide.aircraft.state import FlightState
from vfguide.kernels.compiled import compiled
from vfguide.paths.distance_for_altitude import LINE_UP, SLOPE_RATE, profile_height
from vfguide.planning.objective import GuidanceTarget

STANDOFF = 0.35
"""Least distance to the goal with which the slope is computed [turn lengths]; chosen, so that the
slope stays finite at the goal."""
LOITER_HORIZON = 2.35
"""Length of path on which a loitering vehicle reduces a height error to zero [turn lengths];
chosen."""
SMALL_ERROR_DISTANCE = 0.45
"""Length of path on which a small height error is reduced to zero, wherever the goal is [turn
lengths]; tuned with `tools/measure_poses.py` in turbulence."""
GENTLE_SLOPE = 0.06
"""Slope dh/ds with which a larger height error is reduced far from the goal, dimensionless;
chosen."""
WAIT_DISTANCE = 8.0
"""Length of path, before the last half of LINE_UP, on which GENTLE_SLOPE takes off height above the
profile [turn lengths]; farther away that height is kept, because sinking air may take it. Tuned
with `tools/measure_avoidance.py`."""
LEAST_GROUNDSPEED_SHARE = 0.2
"""Share of the airspeed below which the groundspeed counts as that share; chosen, so that slopes
stay finite where the wind stops the vehicle."""


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
        state: state of the vehicle.
        target: the goal or the circle.
        aircraft: its limits.
        airspeed: true airspeed to fly [m/s]; distances and rates scale with it.
        remaining: path over ground to the target [m].
        groundspeed: speed over ground along the course [m/s].
        radius_factor: factor by which turns are wider than in level flight, see `steepest_descent`.
        before: slope of the step before.
        dt: time since the step before [s].
    """
    height = target.p_n[2] - state.p_n[2]
    if target.circle != 0.0:
        wanted = -2.0 * height / (LOITER_HORIZON * turn_length(airspeed))
    else:
        wanted = goal_slope(height, remaining, target.slope, turn_length(airspeed))
    up = airspeed_to_groundspeed(state.airspeed, groundspeed)
    steepest = steepest_path(wanted, radius_factor, target.slope, aircraft)
    wanted = max(-up * steepest, min(up * steepest, wanted))
    return limited_slope(wanted, before, airspeed, dt)


@compiled
def limited_slope(wanted: float, before: float, airspeed: float, dt: float) -> float:
    """The wanted slope dh/ds, its rate limited.

    Args:
        wanted: slope that is wanted.
        before: slope of the step before.
        airspeed: true airspeed to fly [m/s].
        dt: time since the step before [s].
    """
    change = SLOPE_RATE / airspeed * dt
    return max(before - change, min(before + change, wanted))


@compiled
def steepest_path(
    slope: float, radius_factor: float, goal_slope: float, aircraft: Performance
) -> float:
    """Largest sine of the path angle, of a climb if `slope` is positive, else of a descent."""
    if slope > 0.0:
        return math.sin(aircraft.climb_max)
    return math.sin(steepest_descent(aircraft, radius_factor, goal_slope))


@compiled
def airspeed_to_groundspeed(airspeed: float, groundspeed: float) -> float:
    """Ratio of the airspeed to the groundspeed, bounded where the wind stops the vehicle.

    It turns the sine of a path angle through the air into a slope over ground.
    """
    return airspeed / max(groundspeed, LEAST_GROUNDSPEED_SHARE * airspeed, 1e-3)


@compiled
def goal_slope(height: float, remaining: float, goal_slope: float, unit: float) -> float:
    """Slope dh/ds of a path that ends at the goal's height with the goal's slope.

    The height error over the goal's profile decreases linearly until LINE_UP before the goal, and
    from there as a parabola, with the slope -2 error / remaining. Small errors are reduced sooner;
    far from the goal, height above the profile is kept for a while.

    Args:
        height: height above the goal [m].
        remaining: path over ground to the goal [m].
        goal_slope: slope dh/ds at the goal.
        unit: turn length [m].
    """
    error = height - profile_height(remaining, goal_slope, unit)
    line_up = LINE_UP * unit
    own = goal_slope * max(0.0, 1.0 - remaining / line_up)
    over = 0.5 * remaining if remaining < line_up else remaining - 0.5 * line_up
    if 0.0 < error < GENTLE_SLOPE * over:
        error = max(0.0, error - GENTLE_SLOPE * max(0.0, over - WAIT_DISTANCE * unit))
    reach = max(SMALL_ERROR_DISTANCE * unit, abs(error) / GENTLE_SLOPE)
    return own - error / max(min(over, reach), 0.5 * STANDOFF * unit)
