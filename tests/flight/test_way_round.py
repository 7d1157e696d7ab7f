"""The point mass among obstacles: ways round them are planned, flown and planned anew."""

import math
from dataclasses import replace

import numpy as np
import pytest
from closed_loop import STILL, blowing, goal, plan_of
from point_mass import fly, level

from vfguide.companion.route_memory import DETOUR, GUARD, packed_memory
from vfguide.field import shape
from vfguide.field.obstacle import VISIBLE_FROM, Obstacle, obstacle_distance, obstacle_rows
from vfguide.flight.detour_leg import COUNT
from vfguide.safety.assurance import Reason
from vfguide.safety.fence import Zone, fence_distance, fences
from vfguide.safety.guard import REASON
from vfguide.safety.hazards import Hazards, traffic_rows
from vfguide.scenario.fence import ZoneEntry
from vfguide.scenario.hazards import Fence, outlines_of

HEIGHT = -150.0
FREE = (-math.inf, math.inf)


def ball(x, y, radius, v_n=STILL):
    return Obstacle(shape.sphere(radius), (float(x), float(y), HEIGHT), v_n=v_n)


def wall(begin, end, thick=12.0):
    (x, y), (u, v) = begin, (end[0] - begin[0], end[1] - begin[1])
    middle = (x + 0.5 * u, y + 0.5 * v, HEIGHT)
    return Obstacle(shape.box((math.hypot(u, v), thick, 400.0)), middle, math.atan2(v, u))


def among(plan, obstacles, seen=2000.0, entries=(), heights=FREE):
    """The plan with obstacles that are known from `seen` metres on, and a fence."""
    rows = obstacle_rows(list(obstacles))
    rows[:, VISIBLE_FROM] = seen
    fence = Fence(zone=[ZoneEntry(**entry) for entry in entries])
    zones = fences([zone_of(entry) for entry in entries])
    hazards = Hazards(rows, traffic_rows(()), zones, *heights)
    return replace(plan, hazards=hazards, fence=outlines_of(fence))


def zone_of(entry):
    inside = entry["kind"] == "include"
    if "polygon_m" in entry:
        return Zone(inside, tuple(entry["polygon_m"]))
    return Zone(inside, (entry["centre_m"],), entry["radius_m"])


def least_distance(flown, obstacles):
    rows = obstacle_rows(list(obstacles))
    return min(
        obstacle_distance(rows, i, at.state.p_n, at.state.time)
        for at in flown
        for i in range(len(rows))
    )


def arrived(at):
    return at.route.goal == 1


def start():
    return level((-700.0, 0.0, HEIGHT), 0.0, 25.0, plan_of([goal(0, 0)]).aircraft)


def flown_among(obstacles, wind=STILL, to=None, **known):
    plan = among(plan_of([to or goal(500.0, 0.0)]), obstacles, **known)
    flown = fly(start(), plan, wind, 200.0, arrived)
    assert arrived(flown[-1]), "the goal was not reached"
    return flown


def acted(flown):
    return [at for at in flown if packed_memory(at.route)[GUARD + REASON] != Reason.CLEAR]


@pytest.mark.parametrize("wind", [STILL, blowing(8.0, 60.0), blowing(8.0, 240.0)])
@pytest.mark.parametrize("aside", [0.0, 20.0, -55.0])
def test_a_tower_in_the_way_is_passed_with_room(aside, wind):
    tower = Obstacle(shape.cylinder(50.0, 400.0), (-100.0, aside, HEIGHT))
    flown = flown_among([tower], wind)
    assert least_distance(flown, [tower]) > 12.0
    assert not acted(flown)


def test_a_detour_ends_in_a_way_of_the_leg_itself():
    flown = flown_among([ball(-100.0, 0.0, 60.0)])
    counts = [packed_memory(at.route)[DETOUR + COUNT] for at in flown]
    assert max(counts) >= 2
    assert counts[-1] == 0.0


@pytest.mark.parametrize("gate", [70.0, 110.0])
def test_a_wall_is_passed_through_its_gate(gate):
    at = 120.0
    walls = [
        wall((-100.0, -600.0), (-100.0, at - 0.5 * gate)),
        wall((-100.0, at + 0.5 * gate), (-100.0, 600.0)),
    ]
    flown = flown_among(walls)
    assert least_distance(flown, walls) > 8.0
    crossing = min(flown, key=lambda moment: abs(moment.state.p_n[0] + 100.0))
    assert abs(crossing.state.p_n[1] - at) < 0.5 * gate


def test_out_of_a_dead_end():
    walls = [
        wall((0.0, -200.0), (0.0, 200.0)),
        wall((-300.0, -200.0), (0.0, -200.0)),
        wall((-300.0, 200.0), (0.0, 200.0)),
    ]
    flown = flown_among(walls)
    assert least_distance(flown, walls) > 8.0


@pytest.mark.parametrize("seen", [150.0, 200.0, 300.0])
def test_what_comes_into_sight_late_is_passed_all_the_same(seen):
    obstacle = ball(-100.0, 10.0, 60.0)
    flown = flown_among([obstacle], seen=seen)
    assert least_distance(flown, [obstacle]) > 5.0


@pytest.mark.parametrize("speed", [8.0, 15.0, 20.0])
@pytest.mark.parametrize("side", [-1.0, 1.0])
def test_one_that_crosses_is_passed(side, speed):
    """It would be where the straight way leads, when the aircraft is there."""
    meeting = 20.0
    mover = ball(-200.0, -side * speed * meeting, 40.0, (0.0, side * speed, 0.0))
    flown = flown_among([mover], seen=400.0)
    assert least_distance(flown, [mover]) > 5.0


def test_a_fence_is_kept_and_its_gap_found():
    corners = [(-900.0, -150.0), (700.0, -150.0), (700.0, 400.0), (-900.0, 400.0)]
    entries = [
        {"kind": "include", "polygon_m": corners},
        {"kind": "exclude", "centre_m": (-100.0, -20.0), "radius_m": 70.0},
    ]
    flown = flown_among([], entries=entries)
    zones = fences([zone_of(entry) for entry in entries])
    assert min(fence_distance(zones, i, at.state.p_n) for at in flown for i in range(2)) > 0.0


def test_between_floor_and_ceiling_the_height_is_kept():
    low = goal(500.0, 0.0, z=-150.0)
    flown = flown_among([], to=low, heights=(130.0, 170.0))
    heights = np.array([-at.state.p_n[2] for at in flown])
    assert heights.min() > 130.0
    assert heights.max() < 170.0


def test_hazards_that_are_far_away_change_nothing():
    plan = plan_of([goal(500.0, 150.0, course=40.0)])
    far = among(plan, [ball(-5000.0, 8000.0, 60.0)])
    alone = fly(start(), plan, STILL, 60.0, arrived)
    among_them = fly(start(), far, STILL, 60.0, arrived)
    assert [at.state for at in alone] == [at.state for at in among_them]
