"""Length of path over ground that a change of height takes."""

import math

from vfguide.geometry.units import G0
from vfguide.kernels.compiled import compiled

LINE_UP = 1.57
"""Length of path before the goal on which the slope of the goal is taken up [turn lengths]; 100 m
at 25 m/s, tuned with `tools/measure_poses.py`: with 70 m misses grew."""
SLOPE_RATE = 2.5
"""Largest rate of change of the slope dh/ds, times the airspeed to fly [m/s^2]; chosen: 0.1 1/s at
25 m/s."""
RAMP = 0.8
"""Share of SLOPE_RATE with which lengths of paths are planned; chosen below 1 as a reserve."""


@compiled
def profile_height(remaining: float, goal_slope: float, unit: float) -> float:
    """Height over the goal of the path that is level until LINE_UP before it [m].

    Args:
        remaining: path over ground to the goal [m].
        goal_slope: slope dh/ds at the goal.
        unit: turn length [m].
    """
    r = min(remaining, LINE_UP * unit)
    return -goal_slope * r * (1.0 - 0.5 * r / (LINE_UP * unit))


@compiled
def distance_for_altitude(
    height: float,
    remaining: float,
    goal_slope: float,
    slope_max: float,
    unit: float,
    before: float,
) -> float:
    """Shortest path over ground on which a height over the goal's profile is reduced to zero [m].

    The slope changes from `before` to `slope_max`, and at the end to that of the goal, at RAMP
    times SLOPE_RATE.

    Args:
        height: height over the goal [m].
        remaining: path over ground to the goal, for its profile [m].
        goal_slope: slope dh/ds at the goal.
        slope_max: steepest slope dh/ds, positive.
        unit: turn length [m].
        before: slope dh/ds now.
    """
    error = height - profile_height(remaining, goal_slope, unit)
    ramp = RAMP * SLOPE_RATE / (G0 * unit)  # change of slope [1/m]
    start = max(-slope_max, min(slope_max, -before if error > 0.0 else before))
    too_steep = 0.5 * start * abs(start) / ramp - abs(error)
    if too_steep > 0.0:
        return start / ramp + 2.0 * math.sqrt(too_steep / ramp)
    peak = math.sqrt(ramp * abs(error) + 0.5 * start * start)
    if peak <= slope_max:
        return (2.0 * peak - start) / ramp
    ramps = (slope_max - start) ** 2 + slope_max * slope_max
    return abs(error) / slope_max + ramps / (2.0 * ramp * slope_max)
