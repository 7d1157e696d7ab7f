"""The shortest path over ground that takes away a difference of height."""

import math

from vfguide.geometry.compiled import compiled
from vfguide.geometry.units import G0

LINE_UP = 1.57
"""The slope of the goal is taken up over this distance before it, in turn lengths."""
SLOPE_RATE = 2.5
"""The wanted slope changes no faster than this over the airspeed to fly [m/s^2]."""
RAMP = 0.8
"""Part of SLOPE_RATE that paths are planned with."""


@compiled
def profile_height(remaining: float, goal_slope: float, unit: float) -> float:
    """Height over the goal of the path that is level until LINE_UP before it [m]."""
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
    """Shortest path over ground that takes away `height` over the goal's profile [m].

    From the slope `before` the path takes up `slope_max`, and at its end the goal's own slope, no
    faster than `plan_slope` lets it.
    """
    error = height - profile_height(remaining, goal_slope, unit)
    ramp = RAMP * SLOPE_RATE / (G0 * unit)  # change of slope for each metre
    start = max(-slope_max, min(slope_max, -before if error > 0.0 else before))
    too_steep = 0.5 * start * abs(start) / ramp - abs(error)
    if too_steep > 0.0:
        return start / ramp + 2.0 * math.sqrt(too_steep / ramp)
    peak = math.sqrt(ramp * abs(error) + 0.5 * start * start)
    if peak <= slope_max:
        return (2.0 * peak - start) / ramp
    ramps = (slope_max - start) ** 2 + slope_max * slope_max
    return abs(error) / slope_max + ramps / (2.0 * ramp * slope_max)
