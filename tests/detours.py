"""Worlds and judgements for the tests of the coarse search."""

import math

import numpy as np

from vfguide.airspace.footprint import Band
from vfguide.airspace.keep_out import NO_FENCE
from vfguide.field.obstacle import Obstacle, obstacle_distance, obstacle_rows
from vfguide.geometry.angles import wrap
from vfguide.geometry.se2 import Pose
from vfguide.geometry.shapes import shape
from vfguide.paths.edge import edge_in, pose_along, segments_of
from vfguide.planning.collision_check import Air, Task, ground_speed
from vfguide.planning.route_search import find_route

RADIUS = 80.0
CALM = Air(25.0, 0.0, 0.0)
LEVEL = Band(-100.0, -100.0)
NOTHING = obstacle_rows([])


def task_of(start, goal, air=CALM, t=0.0):
    return Task(Pose(*map(float, start)), Pose(*map(float, goal)), RADIUS, air, t)


def ball(x, y, radius, **options):
    return Obstacle(shape.sphere(radius), (float(x), float(y), -100.0), **options)


def wall(begin, end, thick=10.0):
    (x, y), (dx, dy) = begin, np.subtract(end, begin)
    centre = (x + 0.5 * dx, y + 0.5 * dy, -100.0)
    return Obstacle(shape.box((math.hypot(dx, dy), thick, 400.0)), centre, math.atan2(dy, dx))


def find(obstacles, start, goal, fence=NO_FENCE, band=LEVEL, **options):
    """The task and its route."""
    task = task_of(start, goal, **options)
    rows = obstacles if isinstance(obstacles, np.ndarray) else obstacle_rows(obstacles)
    return task, find_route(rows, fence, band, task)


def flown(task, following, step=1.0):
    """Poses and times every `step` metres along a route."""
    t, poses = task.t, []
    for i in range(len(following.route_edges)):
        for segment in segments_of(edge_in(following.route_edges, i), task.radius):
            count = max(1, math.ceil(segment.length / step))
            for k in range(count):
                at = pose_along(segment, segment.length * (k + 0.5) / count, task.radius)
                poses.append(
                    (at, t + 0.5 * segment.length / count / ground_speed(task.air, at.course))
                )
                t += segment.length / count / ground_speed(task.air, at.course)
    return poses


def least_clearance(obstacles, task, following, height=-100.0):
    """From the obstacles, beyond a radius from the ends [m]."""
    rows = obstacles if isinstance(obstacles, np.ndarray) else obstacle_rows(obstacles)
    least = math.inf
    for at, t in flown(task, following, 2.0):
        for i in range(len(rows)):
            least = min(least, obstacle_distance(rows, i, (at.x, at.y, height), t))
    return least


def assert_joined(task, following):
    """Each hop ends where the next begins, the first and the last at the ends of the task."""
    ends = [edge_in(following.route_edges, i).begin for i in range(len(following.route_edges))] + [
        task.goal
    ]
    assert ends[0] == task.start
    for i, end in enumerate(ends[1:]):
        third = segments_of(edge_in(following.route_edges, i), task.radius)[2]
        there = pose_along(third, third.length, task.radius)
        assert math.hypot(there.x - end.x, there.y - end.y) < 1e-7
        assert abs(wrap(there.course - end.course)) < 1e-9
