"""Random worlds for the assurance: what stands, moves and appears between a start and a goal."""

import math
from typing import NamedTuple

import numpy as np

from vfguide.aircraft.point_mass import PointMass
from vfguide.airspace.fence import Fences, Zone, fences
from vfguide.field.obstacle import Obstacle, Rows, obstacle_rows
from vfguide.geometry.shapes import shape
from vfguide.geometry.shapes.shape import Shape
from vfguide.geometry.vector import Vec3, Vectors
from vfguide.kernels.rows import table_of

HEIGHT = 150.0
"""Height of start and goal above the origin [m]; chosen."""
AIRSPEED = 25.0
"""True airspeed of the aircraft [m/s]: the cruise of the Aerosonde."""
GUST_LAG = 2.0
"""Correlation time of gusts [s]; chosen."""
TICK = 0.05
"""Time between two decisions [s]; chosen."""
Tracks = Vectors
NO_TRACKS: Tracks = np.zeros((0, 2, 3))


class Turning(NamedTuple):
    """How the velocity of an obstacle changes while it is flown."""

    rate: float = 0.0
    """Turn rate [rad/s]; zero: it never turns."""
    sinking: float = 0.0
    """Downward velocity while it turns [m/s]."""
    begin: float = 0.0
    """Time from which it turns [s]."""


class World(NamedTuple):
    """One world, as compiled code takes it."""

    start: PointMass
    goal: Vec3
    rows: Rows
    """Obstacles as `obstacle_rows` has them; those that turn are turned while it is flown."""
    turning: Rows
    """A `Turning` a row for each of the obstacles."""
    fences: Fences
    floor: float
    ceiling: float
    wind_n: Vec3
    gust: float
    gusts_n: Vectors
    """(ticks, 3) gusts, NED [m/s]."""
    tracks: Tracks = NO_TRACKS
    """(K, n, 3) positions of K upright cylinders at n ticks, at least 2, NED [m]."""
    volume: tuple[float, float] = (0.0, 0.0)
    """Radius and half height of these cylinders [m]."""


def any_shape(rng: np.random.Generator, low: float, high: float) -> Shape:
    """A shape of any kind, with semi-axes from `low` to `high` [m]."""
    a, b, c = (float(x) for x in rng.uniform(low, high, 3))
    p, q, r = (float(x) for x in rng.uniform(1.0, 5.0, 3))
    return (
        shape.sphere(a),
        shape.ellipsoid((a, b, c)),
        shape.superquadric((a, b, c), (p, q, r)),
        shape.box((2.0 * a, 2.0 * b, 2.0 * c)),
        shape.cylinder(a, 2.0 * c),
        shape.cone(a, 2.0 * c),
    )[rng.integers(6)]


def standing(rng: np.random.Generator) -> list[Obstacle]:
    """5 to 15 obstacles 20 to 80 m high and wide, overlapping or not."""
    return [
        Obstacle(
            any_shape(rng, 10.0, 40.0),
            (rng.uniform(80.0, 920.0), rng.uniform(-180.0, 180.0), -HEIGHT + rng.uniform(-30, 30)),
            rng.uniform(0.0, math.pi),
        )
        for _ in range(rng.integers(5, 16))
    ]


def crossing(
    rng: np.random.Generator, course: float, speed: float, seen: float, radius: float
) -> Obstacle:
    """A moving obstacle that comes near the vehicle on its straight path to the goal.

    Args:
        rng: random numbers.
        course: its course [rad].
        speed: its speed over ground [m/s].
        seen: distance from which it is detected [m].
        radius: its radius [m].
    """
    meeting = rng.uniform(8.0, 30.0)
    v_n = (speed * math.cos(course), speed * math.sin(course), 0.0)
    at = (AIRSPEED * meeting, rng.uniform(-20.0, 20.0), -HEIGHT + rng.uniform(-15.0, 15.0))
    p_n = (at[0] - meeting * v_n[0], at[1] - meeting * v_n[1], at[2])
    body = shape.sphere(radius) if rng.random() < 0.5 else shape.cylinder(radius, 2.0 * radius)
    return Obstacle(body, p_n, 0.0, v_n, visible_from=seen)


def movers(rng: np.random.Generator) -> list[Obstacle]:
    """1 to 4 moving obstacles that cross from any side, detected at 400 m."""
    return [
        crossing(
            rng, rng.uniform(-math.pi, math.pi), rng.uniform(5, 20), 400.0, rng.uniform(20, 50)
        )
        for _ in range(rng.integers(1, 5))
    ]


def cluster(rng: np.random.Generator) -> list[Obstacle]:
    """4 to 8 moving obstacles that come as a group, detected at 250 m."""
    course, speed = rng.uniform(-math.pi, math.pi), rng.uniform(5.0, 18.0)
    leader = crossing(rng, course, speed, 250.0, 15.0)
    found = list[Obstacle]()
    for _ in range(rng.integers(4, 9)):
        x, y, z = rng.normal(size=3) * (60.0, 60.0, 20.0)
        u, v = rng.normal(size=2)
        p_n = (leader.p_n[0] + x, leader.p_n[1] + y, leader.p_n[2] + z)
        v_n = (leader.v_n[0] + u, leader.v_n[1] + v, 0.0)
        body = shape.sphere(rng.uniform(10.0, 30.0))
        found.append(Obstacle(body, p_n, 0.0, v_n, visible_from=250.0))
    return found


def overtaking(rng: np.random.Generator) -> list[Obstacle]:
    """1 to 3 obstacles that move along the course: slower ones ahead, or faster from behind."""
    found = list[Obstacle]()
    for _ in range(rng.integers(1, 4)):
        speed = rng.uniform(5.0, 20.0) if rng.random() < 0.5 else rng.uniform(28.0, 35.0)
        course = rng.normal(0.0, 0.15)
        found.append(crossing(rng, course, speed, 400.0, rng.uniform(20.0, 50.0)))
    return found


def popup(rng: np.random.Generator) -> list[Obstacle]:
    """An obstacle on the path, detected only at 60 to 150 m, and up to three beside it."""
    radius = rng.uniform(40.0, 100.0)
    at = (rng.uniform(350.0, 600.0), rng.uniform(-0.6, 0.6) * radius, -HEIGHT)
    found = [Obstacle(shape.sphere(radius), at, visible_from=rng.uniform(60.0, 150.0))]
    for _ in range(rng.integers(0, 4)):
        place = (rng.uniform(200.0, 800.0), rng.uniform(-400.0, 400.0), -HEIGHT)
        found.append(Obstacle(any_shape(rng, 20.0, 40.0), place, rng.uniform(0.0, math.pi)))
    return found


DRAWN = {
    "static": standing,
    "movers": movers,
    "cluster": cluster,
    "overtaking": overtaking,
    "turning": movers,
    "popup": popup,
    "fence": lambda rng: standing(rng)[:5],
}


def draw_world(kind: str, seed: int, number: int, duration: float) -> World:
    """World `number` of a kind, drawn from (seed, number) alone, with gusts for `duration` [s]."""
    rng = np.random.default_rng([seed, number, list(DRAWN).index(kind)])
    rows = obstacle_rows(DRAWN[kind](rng))
    turning = [Turning()] * len(rows)
    if kind == "turning":
        ranges = ((-0.15, 0.15), (-3.0, 3.0), (0.0, 25.0))
        turning = list(map(Turning, *(rng.uniform(*each, len(rows)) for each in ranges)))
    zones, floor, ceiling = list[Zone](), -math.inf, math.inf
    if kind == "fence":
        zones, floor, ceiling = narrow_fence(rng), 100.0, 200.0
    speed, toward = rng.uniform(0.0, 8.0), rng.uniform(-math.pi, math.pi)
    wind_n = (speed * math.cos(toward), speed * math.sin(toward), 0.0)
    gust = 1.5 * float(number % 2)
    gusts: Vectors = np.zeros((round(duration / TICK) + 1, 3))
    keep = math.exp(-TICK / GUST_LAG)
    for k in range(1, len(gusts)):
        push = rng.normal(size=3) * (gust, gust, 0.5 * gust)
        gusts[k] = keep * gusts[k - 1] + math.sqrt(1.0 - keep * keep) * push
    start = PointMass((0.0, 0.0, -HEIGHT), rng.normal(0.0, 0.3), 0.0, 0.0, AIRSPEED)
    goal = (1000.0, 0.0, -HEIGHT)
    turns, fence = table_of(Turning, turning), fences(zones)
    return World(start, goal, rows, turns, fence, floor, ceiling, wind_n, gust, gusts)


def narrow_fence(rng: np.random.Generator) -> list[Zone]:
    """A polygon of four to seven corners round start and goal, and two zones to stay out of."""
    wide = rng.uniform(150.0, 300.0)
    count = rng.integers(4, 8)
    angles = (np.arange(count) + rng.uniform(-0.3, 0.3, count)) * 2.0 * math.pi / count
    reach = 900.0 / math.cos(math.pi / count)
    corners = tuple((500.0 + reach * math.cos(a), wide * 2.0 * math.sin(a)) for a in angles)
    out = Zone(False, ((rng.uniform(300.0, 700.0), rng.uniform(-wide, wide)),), 40.0, highest=170.0)
    x, y = rng.uniform(300.0, 700.0), rng.uniform(-wide, wide)
    triangle = Zone(False, ((x, y), (x + 60.0, y + 20.0), (x + 20.0, y + 70.0)))
    return [Zone(True, corners), out, triangle]
