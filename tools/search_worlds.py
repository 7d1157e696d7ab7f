"""Random worlds for the coarse search: fields of obstacles of all shapes, and dead ends."""

import math
from collections.abc import Callable
from dataclasses import dataclass

import numpy as np

from vfguide.field.obstacle import Obstacle, Rows, obstacle_distance, obstacle_rows
from vfguide.geometry.se2 import Pose
from vfguide.geometry.shapes import shape
from vfguide.geometry.shapes.shape import Shape
from vfguide.geometry.vector import Vec3

HEIGHT = 100.0
"""Height at which everything is flown [m]; chosen."""
TALL = 400.0
"""Height of walls, which begin far below HEIGHT [m]; chosen."""
ROOM = 60.0
"""Distance that obstacles of fields leave free around start and goal [m]; chosen."""
THICK = (8.0, 25.0)
"""Least and greatest thickness of walls [m]; chosen."""


@dataclass(frozen=True)
class World:
    """A random world, and the task of the search in it."""

    kind: str
    start: Pose
    goal: Pose
    obstacles: Rows


def random_shape(rng: np.random.Generator) -> Shape:
    """Any kind of shape, the semi-axes of its plan between 20 and 80 m."""
    a, b = map(float, rng.uniform(20.0, 80.0, 2))
    tall = float(rng.uniform(60.0, 300.0))
    p, q, r = map(float, rng.uniform(1.0, 5.0, 3))
    return (
        shape.sphere(a),
        shape.ellipsoid((a, b, 0.5 * tall)),
        shape.superquadric((a, b, 0.5 * tall), (p, q, r)),
        shape.box((2.0 * a, 2.0 * b, tall)),
        shape.cylinder(a, tall),
        shape.cone(a, tall),
    )[rng.integers(6)]


def is_free(rows: Rows, at: Pose, apart: float) -> bool:
    """Whether a pose at HEIGHT is farther than `apart` [m] from all obstacles."""
    p_n = (at.x, at.y, -HEIGHT)
    return all(obstacle_distance(rows, i, p_n, 0.0) > apart for i in range(len(rows)))


def field(rng: np.random.Generator) -> World:
    """5 to 15 obstacles between start and goal, 800 to 1500 m apart."""
    apart, bearing = rng.uniform(800.0, 1500.0), rng.uniform(-math.pi, math.pi)
    c, s = math.cos(bearing), math.sin(bearing)
    start = Pose(0.0, 0.0, rng.uniform(-math.pi, math.pi))
    goal = Pose(apart * c, apart * s, rng.uniform(-math.pi, math.pi))
    obstacles: list[Obstacle] = []
    count = rng.integers(5, 16)
    while len(obstacles) < count:
        along, across = rng.uniform(-0.1, 1.1) * apart, rng.uniform(-0.35, 0.35) * apart
        body = random_shape(rng)
        down = -HEIGHT + rng.uniform(-0.6, 0.6) * body.semi_axes[2]
        place = (along * c - across * s, along * s + across * c, float(down))
        new = Obstacle(body, place, rng.uniform(-math.pi, math.pi))
        alone = obstacle_rows([new])
        if is_free(alone, start, ROOM) and is_free(alone, goal, ROOM):
            obstacles.append(new)
    return World("field", start, goal, obstacle_rows(obstacles))


def wall(begin: tuple[float, float], end: tuple[float, float], thick: float) -> Obstacle:
    """A wall from one place to another, with a thickness [m]."""
    dx, dy = end[0] - begin[0], end[1] - begin[1]
    centre: Vec3 = (0.5 * (begin[0] + end[0]), 0.5 * (begin[1] + end[1]), -HEIGHT)
    return Obstacle(shape.box((math.hypot(dx, dy), thick, TALL)), centre, math.atan2(dy, dx))


def courses(rng: np.random.Generator) -> tuple[float, float]:
    """Random courses at the start and at the goal [rad]."""
    a, b = rng.uniform(-math.pi, math.pi, 2)
    return float(a), float(b)


def gate(rng: np.random.Generator) -> World:
    """A wall of 1200 m with a gate of 60 to 150 m anywhere in its middle half."""
    thick, wide = rng.uniform(*THICK), rng.uniform(60.0, 150.0)
    x, y = rng.uniform(400.0, 700.0), rng.uniform(-300.0, 300.0)
    walls = [
        wall((x, y - 0.5 * wide), (x + rng.uniform(-150, 150), -600.0), thick),
        wall((x, y + 0.5 * wide), (x + rng.uniform(-150, 150), 600.0), thick),
    ]
    start, goal = courses(rng)
    return World("gate", Pose(0.0, 0.0, start), Pose(1100.0, 0.0, goal), obstacle_rows(walls))


def u_shape(rng: np.random.Generator) -> World:
    """A U that opens towards the start, which may lie within it; the goal lies behind."""
    thick, wide, deep = rng.uniform(*THICK), rng.uniform(320.0, 600.0), rng.uniform(200.0, 500.0)
    x = rng.uniform(250.0, 600.0)
    half = 0.5 * wide
    walls = [
        wall((x, -half), (x, half), thick),
        wall((x, -half), (x - deep, -half), thick),
        wall((x, half), (x - deep, half), thick),
    ]
    start, goal = Pose(0.0, 0.0, rng.uniform(-0.5, 0.5)), Pose(1000.0, 0.0, courses(rng)[1])
    return World("u shape", start, goal, obstacle_rows(walls))


def maze(rng: np.random.Generator) -> World:
    """Two walls that are open at opposite ends, closed off at the sides."""
    thick, x = rng.uniform(*THICK), rng.uniform(300.0, 450.0)
    apart, wide = rng.uniform(250.0, 400.0), rng.uniform(90.0, 150.0)
    side = rng.choice([-1.0, 1.0])
    walls = [
        wall((x, -500.0 * side), (x, (400.0 - wide) * side), thick),
        wall((x + apart, 500.0 * side), (x + apart, -(400.0 - wide) * side), thick),
        wall((x - 50.0, 400.0), (x + apart + 50.0, 400.0), thick),
        wall((x - 50.0, -400.0), (x + apart + 50.0, -400.0), thick),
    ]
    start, goal = courses(rng)
    return World("maze", Pose(0.0, 0.0, start), Pose(1100.0, 0.0, goal), obstacle_rows(walls))


def ring(rng: np.random.Generator) -> World:
    """Walls all round the goal but for a gap, anywhere."""
    thick, wide, radius = rng.uniform(*THICK), rng.uniform(80.0, 150.0), rng.uniform(260.0, 350.0)
    gap, begin = wide / radius, rng.uniform(-math.pi, math.pi)
    sides, x = 8, 900.0
    corner = [begin + gap + k * (2.0 * math.pi - gap) / sides for k in range(sides + 1)]
    at = [(x + radius * math.cos(a), radius * math.sin(a)) for a in corner]
    walls = [wall(at[k], at[k + 1], thick) for k in range(sides)]
    start, goal = courses(rng)
    return World("ring", Pose(0.0, 0.0, start), Pose(x, 0.0, goal), obstacle_rows(walls))


DEAD_ENDS: tuple[Callable[[np.random.Generator], World], ...] = (gate, u_shape, maze, ring)


def draw(kind: str, seed: int, number: int) -> World:
    """World `number` of a kind, "field" or "dead end"."""
    rng = np.random.default_rng([seed, number])
    return field(rng) if kind == "field" else DEAD_ENDS[number % len(DEAD_ENDS)](rng)
