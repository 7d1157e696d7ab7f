"""Path stretching: longer paths, where the shortest is too short for the change of height.

The length of the shortest path jumps by up to a circle where another Dubins path becomes the
shortest. Therefore several longer paths are tried, and the shortest of those that suffice is taken.
"""

import math

from vfguide.geometry.se2 import Pose, after_turn, straight_on
from vfguide.kernels.compiled import compiled
from vfguide.paths.course_laws import PlanarState, course_of, pose_at
from vfguide.paths.dubins import length_of, shortest_path

OUTBOUND_TURNS = 4
"""Number of turns to either side that are tried before an outbound straight; chosen."""
OUTBOUND_TURN = 0.55
"""Difference between two turns that are tried before an outbound straight [rad]; chosen, so that
the largest is 126 degrees."""
STRIDE = 0.1
"""Step of the lengths of straights that are tried [turn radii]; chosen."""
STRIDES = 100
"""Number of lengths of straights that are tried; chosen: they reach 10 turn radii."""
LEAST_GAIN = 0.01
"""Least difference by which a later path must be shorter to be taken [turn radii]; chosen above
rounding."""
LENGTH_SLACK = 0.3
"""Additional length for which an outbound course must suffice too [turn radii]; chosen, so that a
path that is a little too short later does not become longer by a circle."""


@compiled
def best_end(at: PlanarState, radius: float, distance_for_altitude: float) -> tuple[float, float]:
    """Additional length of the final approach, and the length of the path with it [m].

    The path is infinitely long where no length suffices, as straight behind the goal.

    Args:
        at: the vehicle, relative to the start of the final approach.
        radius: radius of the turns [m].
        distance_for_altitude: least length of the path to the origin [m].
    """
    course = course_of(at)
    for k in range(STRIDES):
        farther = STRIDE * radius * k
        path = shortest_path(at.x + farther, at.y, course, radius)
        length = farther + radius * length_of(path)
        if length >= distance_for_altitude:
            return farther, length
    return 0.0, math.inf


@compiled
def best_outbound(
    at: PlanarState, radius: float, distance_for_altitude: float
) -> tuple[float, float]:
    """The outbound course before the path [rad], and the length of both [m].

    The arguments are those of `best_end`.
    """
    begin = pose_at(at)
    best, shortest, least = begin.course, math.inf, math.inf
    for k in range(2 * OUTBOUND_TURNS + 1):
        turn = OUTBOUND_TURN * ((k + 1) // 2)
        pose = after_turn(begin, 1.0 if k % 2 == 1 else -1.0, turn, radius)
        arc = radius * turn
        with_slack = arc + outbound_length(
            pose, radius, distance_for_altitude + LENGTH_SLACK * radius - arc
        )
        if with_slack < least - LEAST_GAIN * radius:
            best, least = pose.course, with_slack
            shortest = arc + outbound_length(pose, radius, distance_for_altitude - arc)
    return best, shortest


@compiled
def outbound_length(begin: Pose, radius: float, distance_for_altitude: float) -> float:
    """Length of the shortest outbound straight, with the path after it, that suffices [m].

    It starts at `begin`; the path is that to the origin, with turns of `radius` [m]. Both together
    must be as long as `distance_for_altitude` [m]. It is infinite where none of STRIDES lengths is
    enough, as far from the origin with the course towards it.
    """
    for k in range(STRIDES):
        straight = STRIDE * radius * k
        there = straight_on(begin, straight)
        path = shortest_path(there.x, there.y, there.course, radius)
        length = straight + radius * length_of(path)
        if length >= distance_for_altitude:
            return length
    return math.inf
