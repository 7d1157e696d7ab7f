#!/usr/bin/env python3
"""What the paper's field holds to and how fast it is: worst cases over random points, and times.

    python tools/measure_field.py --points 10000 --seed 1

All is drawn from the seed. Times are the least of many repeats on one core.
"""

import argparse
import math
import time
from collections.abc import Callable, Iterator
from typing import NamedTuple

import numpy as np

from vfguide.field.composite_arrays import CompositeArrays, composite_fields
from vfguide.field.goal_frame import GoalFrame, goal_frame
from vfguide.field.neighbours import robots_in_range
from vfguide.field.obstacle import Obstacle, Rows, obstacle_rows, obstacle_surface
from vfguide.field.robots import Robot, Spacing
from vfguide.field.swarm import fields_of_robots, goal_rows
from vfguide.geometry.dual import Dual3
from vfguide.geometry.shapes import shape
from vfguide.geometry.shapes.distance import onto_surface
from vfguide.geometry.vector import Matrices, Series, Vectors
from vfguide.kernels.rows import columns

SPACING = Spacing(10.0, 100.0)
NOBODY = np.zeros((0, 6))
NOTHING = obstacle_rows([])
STILL = (0.0, 0.0, 0.0)
SHAPES = {
    "sphere": shape.sphere(40.0),
    "ellipsoid": shape.ellipsoid((60.0, 25.0, 10.0)),
    "superquadric": shape.superquadric((30.0, 50.0, 20.0), (1.5, 2.0, 5.0)),
    "box": shape.box((20.0, 60.0, 100.0)),
    "cylinder": shape.cylinder(15.0, 120.0),
    "cone": shape.cone(50.0, 80.0),
}
HALF_STEPS = (5e-4, 5e-5, 5e-6, 5e-8)
"""Half steps of the differences [s], of which the best counts; chosen, since G' may flip within a
long one, and a short one suffers from rounding."""
IN_A_SCENE = 50
NEIGHBOURS = 6.0
"""Average number of robots within range of each, whatever their number; chosen."""


class Scene(NamedTuple):
    """Points that move among obstacles and robots."""

    goal: GoalFrame
    p: Vectors
    v: Vectors
    obstacles: Rows
    others: Rows

    def at(self, s: float) -> CompositeArrays:
        """The field a time `s` later [s], when all points, obstacles and robots have moved on."""
        robots = columns(Robot, self.others)
        others = np.hstack([robots.p_n + s * robots.v_n, robots.v_n])
        return composite_fields(
            self.goal, self.p + s * self.v, self.v, s, self.obstacles, others, SPACING
        )


def floats(a: np.ndarray) -> tuple[float, ...]:
    """An array as the tuple that compiled code takes."""
    return tuple(map(float, a))


def lengths(a: Vectors) -> Series:
    """Lengths of the vectors along the last axis."""
    return np.linalg.norm(a, axis=-1)


def directions(rng: np.random.Generator, count: int) -> Vectors:
    """Random unit vectors, (count, 3)."""
    a = rng.normal(size=(count, 3))
    return a / lengths(a)[:, None]


def random_goal(rng: np.random.Generator, size: float) -> GoalFrame:
    """A goal somewhere in a cube, of any heading, climbing or sinking."""
    position = floats(rng.uniform(-size, size, 3))
    return goal_frame(position, rng.uniform(-math.pi, math.pi), rng.uniform(-1.0, 1.0))


def on_level(body: shape.Shape, level: float, towards: Vectors) -> Vectors:
    """Points in directions `towards` at which U has the value `level`."""
    rows = obstacle_rows([Obstacle(body, STILL)])
    points = []
    for direction in towards:
        y = onto_surface(body, floats(direction))
        low, high = 1.0, 100.0
        while level > 1.0 and high - low > 1e-9:
            middle = 0.5 * (low + high)
            here = obstacle_surface(rows, 0, Dual3(floats(middle * np.array(y)), STILL), 0.0)
            low, high = (low, middle) if here.U.value > level else (middle, high)
        points.append(low * np.array(y))
    return np.array(points)


def random_scene(rng: np.random.Generator, moving: bool, robots: bool) -> Scene:
    """One to three obstacles, up to two robots, and points in and around their areas."""
    bodies = list(SHAPES.values())
    obstacles = [
        Obstacle(
            bodies[rng.integers(len(bodies))],
            floats(rng.uniform(-40.0, 40.0, 3)),
            rng.uniform(-math.pi, math.pi),
            floats(8.0 * moving * rng.normal(size=3)),
            10.0 ** rng.uniform(0.3, 2.0),
        )
        for _ in range(rng.integers(1, 4))
    ]
    p, v = rng.uniform(-60.0, 60.0, (IN_A_SCENE, 3)), 20.0 * rng.normal(size=(IN_A_SCENE, 3))
    for i, direction in enumerate(directions(rng, 4 * IN_A_SCENE // 5)):
        near = obstacles[i % len(obstacles)]
        p[i] = near.p_n + rng.uniform(0.8, 1.3) * direction * near.shape.semi_axes
    others: Rows = np.hstack([rng.uniform(-60.0, 60.0, (2, 3)), 20.0 * rng.normal(size=(2, 3))])
    return Scene(random_goal(rng, 300.0), p, v, obstacle_rows(obstacles), others[: 2 * robots])


def penetration(rng: np.random.Generator, body: shape.Shape, count: int) -> float:
    """Worst |F_OA . n| / (|F_OA| |n|) on the surface."""
    rows, worst = obstacle_rows([Obstacle(body, STILL)]), 0.0
    p = on_level(body, 1.0, directions(rng, count))
    n = np.array([obstacle_surface(rows, 0, Dual3(floats(q), STILL), 0.0).n.value for q in p])
    for _ in range(10):
        F = composite_fields(random_goal(rng, 1e3), p, STILL, 0.0, rows, NOBODY, SPACING).F
        across = np.abs(np.sum(F * n, axis=1)) / lengths(F) / lengths(n)
        worst = max(worst, float(across.max()))
    return worst


def least_field(rng: np.random.Generator, body: shape.Shape, count: int) -> float:
    """Least |F_OA| / |F| in the reactive area, also straight ahead on the goal's axis."""
    rows, least = obstacle_rows([Obstacle(body, STILL)]), math.inf
    towards = np.vstack([directions(rng, count), [(-1.0, 0.0, 0.0), (1.0, 0.0, 0.0)]])
    for level in (1.0, 1.01, 1.5, 3.9):
        p = on_level(body, level, towards)
        for goal in (random_goal(rng, 1e3), goal_frame((1e3, 0.0, 0.0), 0.0, 0.0)):
            here = composite_fields(goal, p, STILL, 0.0, rows, NOBODY, SPACING)
            free = composite_fields(goal, p, STILL, 0.0, NOTHING, NOBODY, SPACING)
            least = min(least, float((lengths(here.F) / lengths(free.F)).min()))
    return least


def turn_rates(scene: Scene, half: float) -> Vectors:
    """Body rates of R_a from fourth-order differences over two and four half steps."""
    wide = scene.at(2.0 * half).R_na - scene.at(-2.0 * half).R_na
    narrow = scene.at(half).R_na - scene.at(-half).R_na
    S = np.swapaxes(scene.at(0.0).R_na, 1, 2) @ ((8.0 * narrow - wide) / (12.0 * half))
    skew: Matrices = 0.5 * (S - np.swapaxes(S, 1, 2))
    return np.stack([skew[:, 2, 1], skew[:, 0, 2], skew[:, 1, 0]], axis=1)


def errors_of(scene: Scene) -> tuple[float, float]:
    """Worst of R_a^T R_a - I and of Omega_a against differences, over 1 + |Omega_a|."""
    here = scene.at(0.0)
    gram = np.swapaxes(here.R_na, 1, 2) @ here.R_na - np.eye(3)
    volume = np.abs(np.linalg.det(here.R_na) - 1.0)
    size = 1.0 + lengths(here.Omega_a)
    rates = [lengths(turn_rates(scene, h) - here.Omega_a) / size for h in HALF_STEPS]
    return float(max(np.abs(gram).max(), volume.max())), float(np.min(rates, axis=0).max())


def least_time(call: Callable[[], object], repeats: int) -> float:
    """Time of the fastest of some calls [s]."""
    times = []
    for _ in range(repeats):
        start = time.perf_counter()
        call()
        times.append(time.perf_counter() - start)
    return min(times)


def point_time(rng: np.random.Generator) -> float:
    """Field, frame and Omega_a of one point within reach of ten obstacles [s]."""
    obstacles = obstacle_rows(
        [
            Obstacle(body, floats(rng.uniform(-25.0, 25.0, 3)), 0.3, (1.0, 2.0, 3.0), 1e8)
            for body in [*SHAPES.values(), *list(SHAPES.values())[:4]]
        ]
    )
    goal, p = goal_frame((300.0, 40.0, 0.0), 0.3, 0.1), rng.uniform(-5.0, 5.0, (2000, 3))

    def call() -> CompositeArrays:
        return composite_fields(goal, p, (20.0, 1.0, 2.0), 0.0, obstacles, NOBODY, SPACING)

    if not (call().chi < 1.0).all():
        raise SystemExit("an obstacle is out of reach")
    return least_time(call, 50) / len(p)


def robots_time(rng: np.random.Generator, count: int) -> tuple[float, float]:
    """Time of a step of `count` robots [s], and the average number of their neighbours."""
    size = (count * 4.0 / 3.0 * math.pi * SPACING.detection_range**3 / NEIGHBOURS) ** (1 / 3)
    robots = np.hstack([rng.uniform(0.0, size, (count, 3)), 20.0 * rng.normal(size=(count, 3))])
    goals = goal_rows([random_goal(rng, size) for _ in range(count)])
    near = len(robots_in_range(columns(Robot, robots).p_n, SPACING.detection_range).others) / count

    def call() -> CompositeArrays:
        return fields_of_robots(goals, robots, 0.0, NOTHING, SPACING)

    return least_time(call, 300_000 // count), near


def exactness(seed: int, points: int) -> Iterator[tuple[str, str, str]]:
    """Rows of the table: name, number of points, worst value."""
    for kind, (name, body) in enumerate(SHAPES.items()):
        worst = penetration(np.random.default_rng([seed, 0, kind]), body, points // 10)
        yield f"|F_OA.n| / |F_OA||n| on the {name}", f"{points // 10 * 10}", f"{worst:.1e}"
    for kind, (name, body) in enumerate(SHAPES.items()):
        count = points // 8
        least = least_field(np.random.default_rng([seed, 1, kind]), body, count)
        yield f"least |F_OA| / |F| around the {name}", f"{8 * (count + 2)}", f"{least:.1e}"
    groups = {"static": (False, False), "moving": (True, False), "moving, robots": (True, True)}
    for kind, (name, (moving, robots)) in enumerate(groups.items()):
        rng = np.random.default_rng([seed, 2, kind])
        scenes = (random_scene(rng, moving, robots) for _ in range(points // IN_A_SCENE))
        R_error, rate_error = map(max, zip(*map(errors_of, scenes), strict=True))
        yield f"R_a^T R_a - I, {name}", f"{points}", f"{R_error:.1e}"
        yield f"Omega_a - differences, {name}", f"{points}", f"{rate_error:.1e}"


def speed(seed: int) -> Iterator[tuple[str, str, str]]:
    """Rows of the table: name, number, time."""
    rng = np.random.default_rng([seed, 3])
    yield "F, R_a, Omega_a among 10 obstacles", "1", f"{1e6 * point_time(rng):.2f} us"
    few, _ = robots_time(rng, 1000)
    many, near = robots_time(rng, 10_000)
    yield f"robots with {near:.1f} neighbours, a step", "10000", f"{1e3 * many:.1f} ms"
    yield "time of one over that among 1000", "10000", f"{many / few / 10.0:.2f}"


def main() -> None:
    """Print the table."""
    parser = argparse.ArgumentParser(description=__doc__)
    parser.add_argument("--points", type=int, default=10_000)
    parser.add_argument("--seed", type=int, default=1)
    args = parser.parse_args()
    print(f"seed {args.seed}")
    for rows in (exactness(args.seed, args.points), speed(args.seed)):
        for what, count, value in rows:
            print(f"{what:45} {count:>6}  {value}", flush=True)


if __name__ == "__main__":
    main()
