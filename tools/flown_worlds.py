"""Random worlds as scenarios: fields, movers, turning traffic, late obstacles, walls, fences."""

import math
from collections.abc import Callable
from typing import Any

import numpy as np
from numpy.random import Generator

from vfguide.sim.traffic import Turn, flight_of, motion_at

HEIGHT = 150.0
"""Height of start and goal above the ground [m]; chosen."""
ROOM = 60.0
"""Distance that obstacles leave free around start and goal [m]; chosen."""
SPEED = 25.0
HEARD_FROM = 400.0
"""Distance from the surface of its volume from which traffic is heard [m]; chosen."""
CHANGE_TIME = 1.5
"""Duration of each change of velocity of which a turn is made [s]; chosen."""
MANOEUVRES = 60.0
"""Time until which traffic turns and climbs [s]; chosen."""
BESIDE = 700.0
"""Distance of the wide fence from start and goal [m]; chosen."""
Table = dict[str, Any]
SHAPES = ("sphere", "ellipsoid", "superquadric", "box", "cylinder", "cone")


def sizes_of(rng: Generator, shape: str, low: float, high: float) -> Table:
    """Keys of the sizes of a shape, whose widths and height are from `low` to `high` [m]."""
    a, b, c = (round(float(x), 2) for x in rng.uniform(low, high, 3))
    if shape == "sphere":
        return {"radius_m": a / 2}
    if shape == "box":
        return {"size_m": [a, b, c]}
    if shape in ("cylinder", "cone"):
        return {"radius_m": a / 2, "height_m": c}
    table: Table = {"semi_axes_m": [a / 2, b / 2, c / 2]}
    if shape == "superquadric":
        table["exponents"] = [round(float(x), 2) for x in rng.uniform(1.0, 5.0, 3)]
    return table


def body(rng: Generator, place: tuple[float, float, float], low: float, high: float) -> Table:
    """An obstacle of any shape."""
    shape = str(rng.choice(SHAPES))
    return {
        "shape": shape,
        "position_m": [round(x, 2) for x in place],
        "heading_deg": round(float(rng.uniform(0.0, 180.0)), 2),
        **sizes_of(rng, shape, low, high),
    }


def frame(rng: Generator, number: int, apart: float, aligned: float) -> Table:
    """Start at the origin, goal `apart` [m] to the north, headings within `aligned` [deg]."""
    return {
        "name": f"world {number}",
        "duration_s": 240.0,
        "seed": number + 1,
        "wind": {
            "speed_mps": round(float(rng.uniform(0.0, 8.0)), 2),
            "from_deg": round(float(rng.uniform(0.0, 360.0)), 1),
            "turbulence": "moderate" if number % 2 else "none",
        },
        "vehicle": [
            {
                "id": 1,
                "position_m": [0.0, 0.0, -HEIGHT],
                "heading_deg": round(float(rng.uniform(-aligned, aligned)), 1),
                "goal": [
                    {
                        "position_m": [apart, 0.0, -HEIGHT + float(rng.uniform(-20.0, 20.0))],
                        "heading_deg": round(float(rng.uniform(-aligned, aligned)), 1),
                        "tolerance_deg": 5.0,
                    }
                ],
            }
        ],
    }


def field(rng: Generator, number: int) -> Table:
    """5 to 15 obstacles of 20 to 80 m, overlapping or not."""
    apart = float(rng.uniform(800.0, 1500.0))
    world = frame(rng, number, apart, 180.0)
    obstacles: list[Table] = []
    for _ in range(int(rng.integers(5, 16))):
        while True:
            x, y = float(rng.uniform(-0.1, 1.1) * apart), float(rng.uniform(-0.3, 0.3) * apart)
            if min(math.hypot(x, y), math.hypot(x - apart, y)) > ROOM + 60.0:
                break
        obstacles.append(body(rng, (x, y, -HEIGHT + float(rng.uniform(-30.0, 30.0))), 20.0, 80.0))
    world["obstacle"] = obstacles
    return world


def mover(rng: Generator, course: float, speed: float, seen: float, radius: float) -> Table:
    """A moving obstacle that comes near the vehicle on its straight path to the goal."""
    meeting = float(rng.uniform(10.0, 35.0))
    v = (speed * math.cos(course), speed * math.sin(course))
    x, y = SPEED * meeting - meeting * v[0], float(rng.uniform(-20.0, 20.0)) - meeting * v[1]
    z = -HEIGHT + float(rng.uniform(-15.0, 15.0))
    shape = "sphere" if rng.random() < 0.5 else "cylinder"
    sizes: Table = {"radius_m": radius}
    if shape == "cylinder":
        sizes["height_m"] = 2.0 * radius
    return {
        "shape": shape,
        "position_m": [round(x, 2), round(y, 2), round(z, 2)],
        "velocity_mps": [round(v[0], 3), round(v[1], 3), 0.0],
        "visible_from_m": seen,
        **sizes,
    }


def from_start(table: Table) -> float:
    """Horizontal distance of an obstacle or of traffic from the start [m]."""
    north, east, _ = table["position_m"]
    return math.hypot(north, east)


def apart_from_start(obstacles: list[Table]) -> list[Table]:
    """The obstacles that leave room at the start."""
    return [each for each in obstacles if from_start(each) > 150.0 + each.get("radius_m", 40.0)]


def movers(rng: Generator, number: int) -> Table:
    """1 to 4 moving obstacles that cross, detected at 400 m."""
    world = frame(rng, number, 1100.0, 20.0)
    found = [
        mover(
            rng,
            float(rng.uniform(-math.pi, math.pi)),
            float(rng.uniform(5.0, 20.0)),
            400.0,
            float(rng.uniform(20.0, 50.0)),
        )
        for _ in range(int(rng.integers(1, 5)))
    ]
    world["obstacle"] = apart_from_start(found)
    return world


def cluster(rng: Generator, number: int) -> Table:
    """4 to 8 moving obstacles that come as a group, detected at 250 m."""
    world = frame(rng, number, 1100.0, 20.0)
    course, speed = float(rng.uniform(-math.pi, math.pi)), float(rng.uniform(5.0, 18.0))
    leader = mover(rng, course, speed, 250.0, 15.0)
    found: list[Table] = []
    for _ in range(int(rng.integers(4, 9))):
        shift, drift = rng.normal(size=3) * (60.0, 60.0, 20.0), rng.normal(size=2)
        position = [
            round(float(a + b), 2) for a, b in zip(leader["position_m"], shift, strict=True)
        ]
        velocity = [
            round(float(a + b), 3)
            for a, b in zip(leader["velocity_mps"], (*drift, 0.0), strict=True)
        ]
        found.append(
            {
                "shape": "sphere",
                "radius_m": round(float(rng.uniform(10.0, 30.0)), 2),
                "position_m": position,
                "velocity_mps": velocity,
                "visible_from_m": 250.0,
            }
        )
    world["obstacle"] = apart_from_start(found)
    return world


def overtaking(rng: Generator, number: int) -> Table:
    """1 to 3 obstacles that move along the course: slower ones ahead, or faster from behind."""
    world = frame(rng, number, 1100.0, 20.0)
    found: list[Table] = []
    for _ in range(int(rng.integers(1, 4))):
        slow = rng.random() < 0.5
        speed = float(rng.uniform(5.0, 20.0) if slow else rng.uniform(28.0, 35.0))
        found.append(
            mover(rng, float(rng.normal(0.0, 0.15)), speed, 400.0, float(rng.uniform(20.0, 50.0)))
        )
    world["obstacle"] = apart_from_start(found)
    return world


def unforeseen(rng: Generator, course: float, speed: float) -> list[Turn]:
    """Changes of velocity: turns up to 0.15 rad/s with climbs up to 3 m/s, one after another.

    The first begins at a random time; each turn, and straight flight between them, lasts 3 to 12 s.
    """
    turns: list[Turn] = []
    time = int(rng.integers(0, 100)) / 4.0
    while time < MANOEUVRES:
        rate = float(rng.uniform(-0.15, 0.15)) if rng.random() < 0.75 else 0.0
        down, changes = float(rng.uniform(-3.0, 3.0)), int(rng.integers(2, 9))
        for _ in range(changes):
            course += rate * CHANGE_TIME
            v_n = (speed * math.cos(course), speed * math.sin(course), down)
            turns.append(Turn(time, CHANGE_TIME, v_n))
            time += CHANGE_TIME
    return turns


def turner(rng: Generator, number: int) -> Table:
    """Traffic that turns and climbs, and yet comes near the straight path to the goal."""
    course, speed = float(rng.uniform(-math.pi, math.pi)), float(rng.uniform(5.0, 20.0))
    meeting = float(rng.uniform(10.0, 35.0))
    begin = (speed * math.cos(course), speed * math.sin(course), 0.0)
    turns = unforeseen(rng, course, speed)
    moved = motion_at(flight_of((0.0, 0.0, 0.0), begin, turns), np.array([meeting]))[0][0]
    at = (SPEED * meeting, float(rng.uniform(-20.0, 20.0)), -HEIGHT + float(rng.uniform(-15, 15)))
    return {
        "name": f"MOVER{number}",
        "position_m": [round(a - float(b), 2) for a, b in zip(at, moved, strict=True)],
        "velocity_mps": [round(x, 3) for x in begin],
        "change": [
            {
                "time_s": each.time,
                "velocity_mps": [round(x, 3) for x in each.v_n],
                "within_s": each.within,
            }
            for each in turns
        ],
    }


def turning(rng: Generator, number: int) -> Table:
    """1 to 4 aircraft that turn and climb unforeseen, heard from 400 m, a report each second."""
    world = frame(rng, number, 1100.0, 20.0)
    radius = round(float(rng.uniform(20.0, 50.0)), 1)
    found = [turner(rng, k + 1) for k in range(int(rng.integers(1, 5)))]
    world["avoidance"] = {"traffic_radius_m": radius, "traffic_half_height_m": radius}
    world["traffic"] = [each for each in found if from_start(each) > 150.0 + radius]
    world["traffic_receiver"] = {"range_m": HEARD_FROM + radius}
    return world


def popup(rng: Generator, number: int) -> Table:
    """An obstacle on the path that is detected at 60, 80, 100 or 150 m, and up to three beside."""
    world = frame(rng, number, 1100.0, 10.0)
    radius = round(float(rng.uniform(40.0, 100.0)), 1)
    place = [float(rng.uniform(350.0, 600.0)), float(rng.uniform(-0.6, 0.6) * radius), -HEIGHT]
    seen = float(rng.choice((60.0, 80.0, 100.0, 150.0)))
    found: list[Table] = [
        {"shape": "sphere", "radius_m": radius, "position_m": place, "visible_from_m": seen}
    ]
    for _ in range(int(rng.integers(0, 4))):
        x, y = float(rng.uniform(200.0, 800.0)), float(rng.uniform(-400.0, 400.0))
        found.append(body(rng, (x, y, -HEIGHT), 40.0, 80.0))
    world["obstacle"] = apart_from_start(found)
    return world


def wall(begin: tuple[float, float], end: tuple[float, float], thick: float) -> Table:
    """A wall from one place to another."""
    dx, dy = end[0] - begin[0], end[1] - begin[1]
    return {
        "shape": "box",
        "position_m": [0.5 * (begin[0] + end[0]), 0.5 * (begin[1] + end[1]), -HEIGHT],
        "size_m": [math.hypot(dx, dy), thick, 290.0],
        "heading_deg": math.degrees(math.atan2(dy, dx)),
    }


def dead_end(rng: Generator, number: int) -> Table:
    """A wall with a gate, a U that opens towards the start, or a ring with a gap round the goal."""
    apart = float(rng.uniform(900.0, 1300.0))
    world = frame(rng, number, apart, 40.0)
    middle, thick = 0.5 * apart + float(rng.uniform(-80.0, 80.0)), float(rng.uniform(8.0, 25.0))
    kind = int(rng.integers(3))
    if kind == 0:
        gate, at = float(rng.uniform(60.0, 150.0)), float(rng.uniform(-250.0, 250.0))
        walls = [
            wall((middle, -450.0), (middle, at - 0.5 * gate), thick),
            wall((middle, at + 0.5 * gate), (middle, 450.0), thick),
        ]
    elif kind == 1:
        wide, deep = float(rng.uniform(120.0, 260.0)), float(rng.uniform(150.0, 350.0))
        walls = [
            wall((middle, -wide), (middle, wide), thick),
            wall((middle - deep, -wide), (middle, -wide), thick),
            wall((middle - deep, wide), (middle, wide), thick),
        ]
    else:
        shift = float(rng.uniform(100.0, 250.0))
        walls = [
            wall((middle - shift, -500.0), (middle - shift, 150.0), thick),
            wall((middle + shift, -150.0), (middle + shift, 500.0), thick),
        ]
    world["obstacle"] = [{**each, "visible_from_m": 1000.0} for each in walls]
    return world


def fence(rng: Generator, number: int) -> Table:
    """A narrow fence round start and goal, with two places to stay out of, floor and ceiling."""
    world = frame(rng, number, 1000.0, 20.0)
    wide, count = float(rng.uniform(200.0, 350.0)), int(rng.integers(4, 8))
    angles = (np.arange(count) + rng.uniform(-0.3, 0.3, count)) * 2.0 * math.pi / count
    reach = 900.0 / math.cos(math.pi / count)
    corners = [
        [round(500.0 + reach * math.cos(a), 1), round(2.0 * wide * math.sin(a), 1)] for a in angles
    ]
    zones: list[Table] = [{"kind": "include", "polygon_m": corners}]
    x, y = float(rng.uniform(300.0, 700.0)), float(rng.uniform(-wide, wide))
    zones.append({"kind": "exclude", "centre_m": [x, y], "radius_m": 40.0})
    x, y = float(rng.uniform(300.0, 700.0)), float(rng.uniform(-wide, wide))
    triangle = [[x, y], [x + 60.0, y + 20.0], [x + 20.0, y + 70.0]]
    zones.append({"kind": "exclude", "polygon_m": triangle})
    world["fence"] = {"floor_m": 90.0, "ceiling_m": 210.0, "zone": zones}
    return world


def fenced(world: Table) -> Table:
    """A world with floor, ceiling and a wide fence, if it has none of its own."""
    if "fence" in world:
        return world
    (vehicle,) = world["vehicle"]
    (goal,) = vehicle["goal"]
    goal_north, _, _ = goal["position_m"]
    south, north = -BESIDE, goal_north + BESIDE
    corners = [[south, -BESIDE], [north, -BESIDE], [north, BESIDE], [south, BESIDE]]
    zone = {"kind": "include", "polygon_m": corners}
    return {**world, "fence": {"floor_m": 90.0, "ceiling_m": 210.0, "zone": [zone]}}


def hills(rng: Generator, number: int) -> Table:
    """1 to 6 ridges and hills from the ground up, lower and higher than the path; no ceiling."""
    apart = float(rng.uniform(1800.0, 3000.0))
    world = frame(rng, number, apart, 60.0)
    obstacles: list[Table] = []
    while len(obstacles) < 1 + number % 6:
        x, y = float(rng.uniform(0.3, 0.5) * apart), float(rng.uniform(-200.0, 200.0))
        high, wide = float(rng.uniform(100.0, 190.0)), float(rng.uniform(300.0, 1500.0))
        sizes = {"shape": "cone", "radius_m": 0.1 * wide + 50.0, "height_m": high}
        if rng.random() < 0.6:
            sizes = {"shape": "box", "size_m": [float(rng.uniform(20.0, 80.0)), wide, high]}
        turned = float(rng.uniform(-25.0, 25.0))
        place = {"position_m": [x, y, -0.5 * high], "heading_deg": turned}
        obstacles.append({**sizes, **place, "visible_from_m": 2000.0})
    world["obstacle"] = obstacles
    world["fence"] = {"floor_m": 60.0}
    return world


DRAWN: dict[str, Callable[[Generator, int], Table]] = {
    "field": field,
    "movers": movers,
    "cluster": cluster,
    "overtaking": overtaking,
    "popup": popup,
    "dead-end": dead_end,
    "fence": fence,
    "turning": turning,
    "hills": hills,
}


def scenario_of(kind: str, seed: int, number: int) -> Table:
    """World `number` of a kind, from (seed, number) alone."""
    return DRAWN[kind](np.random.default_rng([seed, number, list(DRAWN).index(kind)]), number)
