"""The coarse search finds flyable ways round obstacles, through gates and out of dead ends."""

import math
from itertools import pairwise

import numpy as np
import pytest
from detours import (
    LEVEL,
    NOTHING,
    RADIUS,
    assert_joined,
    ball,
    find,
    flown,
    least_clearance,
    task_of,
    wall,
)
from dubins import dubins_length
from search_worlds import draw

from vfguide.airspace.footprint import Band
from vfguide.airspace.keep_out import KEEP_IN, NO_FENCE, circle, joined, obstacle_zones, polygon
from vfguide.field.obstacle import Obstacle, obstacle_rows
from vfguide.geometry.angles import wrap
from vfguide.geometry.shapes.shape import cone
from vfguide.paths.edge import edge_in, next_path
from vfguide.planning.collision_check import Air, route_is_clear
from vfguide.planning.roadmap import MAX_ROUTE_EDGES
from vfguide.planning.route_search import CLEARANCES, EFFORTS

HARD = (16, 53, 65)
"""Fields that need many hops or little clearance."""
U_SHAPE = [
    wall((400.0, -200.0), (400.0, 200.0)),
    wall((100.0, -200.0), (400.0, -200.0)),
    wall((100.0, 200.0), (400.0, 200.0)),
]


def gate(wide, offset=0.0):
    half = 0.5 * wide
    return [
        wall((500.0, offset + half), (500.0, 700.0)),
        wall((500.0, offset - half), (500.0, -700.0)),
    ]


def search_world(world):
    task, following = find(world.obstacles, world.start, world.goal)
    return task, following


@pytest.mark.parametrize("number", range(20))
def test_a_free_world_is_crossed_by_the_shortest_word(number):
    rng = np.random.default_rng(number)
    start = (*rng.uniform(-500.0, 500.0, 2), rng.uniform(-3.0, 3.0))
    goal = (*rng.uniform(-500.0, 500.0, 2), rng.uniform(-3.0, 3.0))
    task, following = find([], start, goal)
    assert_joined(task, following)
    path = next_path(task.start, task.goal, RADIUS, -1.0)
    assert edge_in(following.route_edges, 0).path == path
    assert len(following.route_edges) == 1
    assert following.length == pytest.approx(dubins_length(task.start, task.goal, RADIUS), abs=1e-6)


@pytest.mark.parametrize("number", [*range(12), *HARD])
def test_ways_through_fields_join_and_are_clear(number):
    world = draw("field", 1, number)
    task, following = search_world(world)
    assert 0 < len(following.route_edges) <= MAX_ROUTE_EDGES
    assert_joined(task, following)
    assert least_clearance(world.obstacles, task, following) >= following.clearance
    hazards = obstacle_zones(world.obstacles, LEVEL, following.clearance)
    assert route_is_clear(hazards, task, following.clearance, following.route_edges, 0, 0, 0.0)


@pytest.mark.parametrize("number", range(24))
def test_dead_ends_are_left_and_gates_are_found(number):
    world = draw("dead end", 1, number)
    task, following = search_world(world)
    assert len(following.route_edges) > 0
    assert_joined(task, following)
    assert (
        least_clearance(world.obstacles, task, following) >= min(following.clearance, 25.0) - 1e-6
    )


def test_no_turn_is_tighter_than_the_radius():
    task, following = search_world(draw("field", 1, 1))
    poses = [at for at, _ in flown(task, following, 1.0)]
    for a, b in pairwise(poses):
        gone = math.hypot(b.x - a.x, b.y - a.y)
        assert abs(wrap(b.course - a.course)) <= gone / RADIUS * 1.001 + 1e-9


def turned(obstacle, angle, mirror):
    x, y, z = obstacle.p_n
    c, s = math.cos(angle), math.sin(angle)
    heading = angle + mirror * obstacle.heading
    return obstacle._replace(
        p_n=(c * x - s * mirror * y, s * x + c * mirror * y, z), heading=heading
    )


@pytest.mark.parametrize(("angle", "mirror"), [(1.1, 1.0), (0.0, -1.0), (-2.5, -1.0)])
@pytest.mark.parametrize("obstacles", [gate(110.0, 60.0), U_SHAPE], ids=["gate", "u shape"])
def test_the_turned_or_mirrored_world_has_the_same_way(obstacles, angle, mirror):
    c, s = math.cos(angle), math.sin(angle)
    goal = (1000.0 * c - mirror * 50.0 * s, 1000.0 * s + mirror * 50.0 * c, angle + mirror * 0.5)
    _, following = find(obstacles, (0.0, 0.0, 0.0), (1000.0, 50.0, 0.5))
    others = [turned(obstacle, angle, mirror) for obstacle in obstacles]
    _, other = find(others, (0.0, 0.0, angle), goal)
    assert other.length == pytest.approx(following.length, rel=5e-3)


def test_a_wide_gate_is_flown_through_and_a_narrow_one_is_not():
    task, following = find(gate(100.0), (0.0, 0.0, 0.0), (1000.0, 0.0, 0.0))
    assert following.length == pytest.approx(1000.0)
    task, following = find(gate(14.0), (0.0, 0.0, 0.0), (1000.0, 0.0, 0.0))
    crossing = [at.y for at, _ in flown(task, following) if abs(at.x - 500.0) < 5.0]
    assert min(map(abs, crossing)) > 700.0


def test_less_clearance_is_taken_where_there_is_no_more():
    walls = [wall((500.0, y0), (500.0, y1)) for y0, y1 in ((15.0, 9000.0), (-15.0, -9000.0))]
    _, following = find(walls, (0.0, 0.0, 0.0), (1000.0, 0.0, 0.0))
    assert following.clearance == 12.0
    assert following.length == pytest.approx(1000.0)


@pytest.mark.parametrize("x", [-200.0, 0.0, 150.0, 200.0])
def test_a_u_shape_is_left(x):
    task, following = find(U_SHAPE, (x, 0.0, 0.0), (900.0, 0.0, 0.0))
    assert_joined(task, following)
    assert least_clearance(U_SHAPE, task, following) >= following.clearance > 0.0


@pytest.mark.parametrize("speed", [6.0, 12.0, 20.0])
@pytest.mark.parametrize("wind", [0.0, 8.0])
def test_a_crossing_obstacle_is_passed_when_it_is_there(speed, wind):
    air = Air(25.0, 0.0, wind)
    meeting = 600.0 / 25.0
    crossing = [ball(600.0, -speed * meeting, 50.0, v_n=(0.0, speed, 0.0))]
    task, following = find(crossing, (0.0, 0.0, 0.0), (1200.0, 0.0, 0.0), air=air)
    assert following.length > 1200.0
    assert least_clearance(crossing, task, following) >= following.clearance - 0.5


def test_what_has_passed_before_is_ignored():
    crossing = [ball(600.0, 300.0, 50.0, v_n=(0.0, 20.0, 0.0))]
    _, following = find(crossing, (0.0, 0.0, 0.0), (1200.0, 0.0, 0.0))
    assert len(following.route_edges) == 1
    _, later = find(crossing, (0.0, 0.0, 0.0), (1200.0, 0.0, 0.0), t=-40.0)
    assert later.length > 1200.0


def test_an_obstacle_that_climbs_through_the_height_is_met_when_it_is_there():
    rising = [ball(600.0, 0.0, 50.0)._replace(p_n=(600.0, 0.0, 0.0), v_n=(0.0, 0.0, -4.0))]
    _, met = find(rising, (0.0, 0.0, 0.0), (1200.0, 0.0, 0.0))
    _, missed = find(rising, (0.0, 0.0, 0.0), (1200.0, 0.0, 0.0), t=60.0)
    assert met.length > 1200.0
    assert missed.length == pytest.approx(1200.0)


def test_a_cone_is_passed_at_the_lower_height_of_the_band():
    base = [Obstacle(cone(150.0, 200.0), (600.0, 0.0, -100.0))]
    _, high = find(base, (0.0, 0.0, 0.0), (1200.0, 0.0, 0.0), band=Band(-160.0, -150.0))
    _, both = find(base, (0.0, 0.0, 0.0), (1200.0, 0.0, 0.0), band=Band(-160.0, -50.0))
    assert 1200.0 < high.length < both.length


def test_a_fence_to_keep_in_is_kept():
    corner = [(-300.0, -300.0), (-300.0, 300.0), (900.0, 300.0), (900.0, -900.0), (600.0, -900.0)]
    fence = polygon([*corner, (600.0, -300.0)], KEEP_IN)
    task, following = find([], (0.0, -200.0, 0.0), (750.0, -700.0, -1.57), fence)
    assert len(following.route_edges) > 1
    assert_joined(task, following)
    corner = np.array([600.0, -300.0])
    near = min(np.hypot(*(np.array(at[:2]) - corner)) for at, _ in flown(task, following))
    assert near >= following.clearance
    assert all(at.x > 600.0 or at.y > -300.0 for at, _ in flown(task, following))


def test_fences_to_keep_out_of_are_kept():
    fence = joined(
        circle(400.0, 0.0, 100.0), polygon([(700.0, 100.0), (800.0, 100.0), (750.0, -200.0)])
    )
    task, following = find([], (0.0, 0.0, 0.0), (1200.0, 0.0, 0.0), fence)
    outbound = [math.hypot(at.x - 400.0, at.y) for at, _ in flown(task, following)]
    assert min(outbound) >= 100.0 + following.clearance
    assert_joined(task, following)


def test_a_circle_to_keep_in_leaves_no_way_out():
    _, following = find([], (0.0, 0.0, 0.0), (1000.0, 0.0, 0.0), circle(0.0, 0.0, 400.0, KEEP_IN))
    assert len(following.route_edges) == 0
    _, following = find([], (0.0, 0.0, 0.0), (200.0, 0.0, 3.0), circle(0.0, 0.0, 400.0, KEEP_IN))
    assert len(following.route_edges) > 0


def test_near_a_hazard_one_may_begin_with_less_clearance():
    beside = [ball(0.0, 60.0, 50.0)]
    task, following = find(beside, (0.0, 0.0, 0.0), (1000.0, 0.0, 0.0))
    assert following.clearance == CLEARANCES[0]
    assert least_clearance(beside, task, following) >= 2.0


def test_the_search_gives_up_and_says_so():
    closed = [
        wall((x0, y0), (x1, y1))
        for (x0, y0), (x1, y1) in (
            ((700.0, -310.0), (700.0, 310.0)),
            ((1300.0, -310.0), (1300.0, 310.0)),
            ((690.0, 300.0), (1310.0, 300.0)),
            ((690.0, -300.0), (1310.0, -300.0)),
        )
    ]
    _, following = find(closed, (0.0, 0.0, 0.0), (1000.0, 0.0, 0.0))
    assert len(following.route_edges) == 0
    assert following.clearance == following.length == 0.0
    assert following.effort <= sum(EFFORTS) + 10 * len(EFFORTS)


def test_the_same_task_has_the_same_way():
    world = draw("field", 1, 12)
    _, one = search_world(world)
    _, other = search_world(world)
    assert np.array_equal(one.route_edges, other.route_edges)
    assert one.effort == other.effort


def test_a_way_is_not_clear_any_more_where_something_new_stands_ahead():
    task, following = find([], (0.0, 0.0, 0.0), (1000.0, 0.0, 0.0))
    hazards = obstacle_zones(obstacle_rows([ball(500.0, 30.0, 40.0)]), LEVEL, 12.0)
    assert not route_is_clear(hazards, task, 12.0, following.route_edges, 0, 0, 0.0)
    beyond = task_of((600.0, 0.0, 0.0), (1000.0, 0.0, 0.0))
    assert route_is_clear(hazards, beyond, 12.0, following.route_edges, 0, 1, 600.0)
    nothing = joined(obstacle_zones(NOTHING, LEVEL, 12.0), NO_FENCE)
    assert route_is_clear(nothing, task, 12.0, following.route_edges, 0, 0, 0.0)
