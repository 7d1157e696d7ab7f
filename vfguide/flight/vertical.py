"""The height profile: which path angle to fly."""

from vfguide.geometry.compiled import compiled

STANDOFF = 30.0
"""The distance to the goal is not taken below this in the profile [m]."""
SLOPE_RATE = 0.1
"""Fastest change of the wanted slope [1/s]: 2.5 m/s^2 at 25 m/s."""


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
