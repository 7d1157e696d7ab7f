"""Random starts, worlds of superquadrics and swarms for the kinematic plant, each from its seed."""

import math
from dataclasses import dataclass

import numpy as np
from scipy.spatial.transform import Rotation

from vfguide.field.goal_frame import goal_frame
from vfguide.field.obstacle import Obstacle, PlacedObstacle, Rows, obstacle_rows, placed
from vfguide.field.obstacle_arrays import levels
from vfguide.field.swarm import goal_rows
from vfguide.geometry.shapes import shape
from vfguide.kernels.rows import columns
from vfguide.sim.kinematic import Bodies

WORLD = 100.0
"""Half the edge of the cube from which starts, goals and obstacles are drawn [m]; chosen."""
ROOM = 1.0
"""Least distance between two reactive areas, and from them to starts and goals [m]; chosen."""


@dataclass(frozen=True)
class World:
    """One robot among obstacles."""

    goals: Rows
    """The goal, one row of `goal_rows`."""
    start: Bodies
    obstacles: Rows


def random_bodies(rng: np.random.Generator, p_n: Rows) -> Bodies:
    """Bodies at places (N, 3), NED [m], with random attitudes."""
    return Bodies(
        p_n, np.ascontiguousarray(Rotation.random(len(p_n), random_state=rng).as_matrix())
    )


def random_goals(rng: np.random.Generator, p_n: Rows) -> Rows:
    """Goals at places (N, 3), NED [m], with random headings and climbs up to 60 degrees."""
    headings, climbs = rng.uniform(-math.pi, math.pi, len(p_n)), rng.uniform(-1.05, 1.05, len(p_n))
    places = [(float(x), float(y), float(z)) for x, y, z in p_n]
    return goal_rows([goal_frame(*each) for each in zip(places, headings, climbs, strict=True)])


def starts_in_free_space(seed: tuple[int, int], count: int) -> tuple[Rows, Bodies]:
    """`count` goals and starts, each drawn independently."""
    rng = np.random.default_rng(seed)
    goals = random_goals(rng, rng.uniform(-WORLD, WORLD, (count, 3)))
    return goals, random_bodies(rng, rng.uniform(-WORLD, WORLD, (count, 3)))


def random_obstacle(rng: np.random.Generator) -> Obstacle:
    """A superquadric of 5 to 20 m, with a reactive area that is 1.5 to 2 times as large."""
    exponents = rng.uniform(1.0, 4.0, 3)
    level = rng.uniform(1.5, 2.0) ** (2.0 * float(exponents.min()))
    return Obstacle(
        shape.superquadric(tuple(rng.uniform(5.0, 20.0, 3)), tuple(exponents)),
        tuple(map(float, rng.uniform(-0.8 * WORLD, 0.8 * WORLD, 3))),
        rng.uniform(-math.pi, math.pi),
        reactive_level=level,
    )


def random_world(seed: int, number: int) -> World:
    """A world that respects the paper's assumptions.

    3 to 8 obstacles whose reactive areas are apart (assum_dist_ob, by the balls that hold them),
    start and goal outside of them (assum_p_d).
    """
    rng = np.random.default_rng((seed, number))
    wanted = rng.integers(3, 9)
    obstacles: list[Obstacle] = []
    while len(obstacles) < wanted:
        new = random_obstacle(rng)
        others = columns(PlacedObstacle, obstacle_rows(obstacles))
        gaps = np.linalg.norm(others.p_n - new.p_n, axis=1) - others.reach
        if (gaps > placed(new).reach + ROOM).all():
            obstacles.append(new)
    rows = obstacle_rows(obstacles)
    goals = random_goals(rng, free_place(rng, rows)[None])
    return World(goals, random_bodies(rng, free_place(rng, rows)[None]), rows)


def free_place(rng: np.random.Generator, obstacles: Rows) -> Rows:
    """A place outside the balls around all reactive areas, (3,), NED [m]."""
    found = columns(PlacedObstacle, obstacles)
    while True:
        p_n = rng.uniform(-WORLD, WORLD, 3)
        away = np.linalg.norm(found.p_n - p_n, axis=1)
        if (away > found.reach + ROOM).all():
            return p_n


def random_swarm(seed: int, count: int, apart: float) -> tuple[Rows, Bodies]:
    """Goals and starts of a swarm: in cubes of one density, no two nearer than `apart` [m].

    The cube of the goals stands beside that of the starts, all goals point the same way.
    """
    rng = np.random.default_rng((seed, count))
    size = 2.0 * apart * count ** (1.0 / 3.0)
    starts, ends = spread(rng, count, size, apart), spread(rng, count, size, apart)
    heading = rng.uniform(-math.pi, math.pi)
    ends += 2.0 * size * np.array([math.cos(heading), math.sin(heading), 0.0])
    goals = goal_rows([goal_frame(tuple(map(float, p)), heading, 0.0) for p in ends])
    attitude = Rotation.from_euler("z", heading).as_matrix()
    return goals, Bodies(starts, np.tile(attitude, (count, 1, 1)))


def spread(rng: np.random.Generator, count: int, size: float, apart: float) -> Rows:
    """Places (count, 3) in a cube with the edge `size`, each two farther apart than `apart` [m]."""
    places = np.empty((0, 3))
    while len(places) < count:
        p_n = rng.uniform(0.0, size, 3)
        if not len(places) or np.linalg.norm(places - p_n, axis=1).min() > apart:
            places = np.vstack((places, p_n))
    return places


def level_at(p_n: Rows, obstacles: Rows) -> Rows:
    """Level U of every obstacle at time zero at places (..., 3), (..., M)."""
    return levels(p_n, 0.0, obstacles)
