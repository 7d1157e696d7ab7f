"""The point mass among obstacles: ways round them are planned, flown and planned anew."""

import math
from dataclasses import replace

import numpy as np
import pytest
from closed_loop import STILL, blowing, goal, plan_of
from point_mass import fly
from rate_body import level

from vfguide.airspace.fence import Zone, fence_distance, fences
from vfguide.airspace.hazards import Hazards, Intruder, traffic_rows
from vfguide.airspace.keep_out import KEEP_IN, KEEP_OUT, NO_FENCE, circle, joined, polygon
from vfguide.assurance.decision import Reason
from vfguide.field.obstacle import Obstacle, PlacedObstacle, obstacle_distance, obstacle_rows
from vfguide.geometry.shapes import shape
from vfguide.kernels.rows import columns
from vfguide.loop.loop_report import decision_of_row, route_of_row
from vfguide.loop.state import take_over

pytestmark = pytest.mark.slow

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
    columns(PlacedObstacle, rows).visible_from[:] = seen
    zones = fences([zone_of(entry) for entry in entries])
    hazards = Hazards(rows, traffic_rows(()), zones, *heights)
    return replace(plan, hazards=hazards, fence=outlines_of(entries))


def zone_of(entry):
    inside = entry["kind"] == "include"
    if "polygon_m" in entry:
        return Zone(inside, tuple(entry["polygon_m"]))
    return Zone(inside, (entry["centre_m"],), entry["radius_m"])


def outlines_of(entries):
    """The same zones in the plane."""
    outlines = NO_FENCE
    for entry in entries:
        sign = KEEP_IN if entry["kind"] == "include" else KEEP_OUT
        if "polygon_m" in entry:
            outline = polygon(entry["polygon_m"], sign)
        else:
            outline = circle(*entry["centre_m"], entry["radius_m"], sign)
        outlines = joined(outlines, outline)
    return outlines


def least_distance(flown, obstacles):
    rows = obstacle_rows(list(obstacles))
    return min(
        obstacle_distance(rows, i, at.state.p_n, at.state.time)
        for at in flown
        for i in range(len(rows))
    )


def arrived(at):
    return at.goal == 1


def start():
    return level((-700.0, 0.0, HEIGHT), 0.0, 25.0, plan_of([goal(0, 0)]).aircraft)


def flown_among(obstacles, wind=STILL, to=None, seconds=200.0, **known):
    plan = among(plan_of([to or goal(500.0, 0.0)]), obstacles, **known)
    flown = fly(start(), plan, wind, seconds, arrived)
    assert arrived(flown[-1]), "the goal was not reached"
    return flown


def acted(flown):
    return [at for at in flown if decision_of_row(at.row).reason != Reason.NOMINAL]


@pytest.mark.parametrize("wind", [STILL, blowing(8.0, 60.0), blowing(8.0, 240.0)])
@pytest.mark.parametrize("aside", [0.0, 20.0, -55.0])
def test_a_tower_in_the_way_is_passed_with_room(aside, wind):
    tower = Obstacle(shape.cylinder(50.0, 400.0), (-100.0, aside, HEIGHT))
    flown = flown_among([tower], wind)
    assert least_distance(flown, [tower]) > 12.0
    assert not acted(flown)


def test_a_detour_ends_in_a_way_of_the_leg_itself():
    flown = flown_among([ball(-100.0, 0.0, 60.0)])
    counts = [route_of_row(at.row).length for at in flown]
    assert max(counts) >= 2
    assert counts[-1] == 0


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


def ridge(high=180.0, wide=1600.0, low=0.0):
    """A ridge across the way, which is 150 m high."""
    return Obstacle(shape.box((80.0, wide, high - low)), (200.0, 0.0, -0.5 * (high + low)))


def flown_far(obstacles, wind=STILL, **known):
    """The same 2,600 m to the goal."""
    return flown_among(obstacles, wind, goal(1900.0, 0.0), 300.0, **known)


def heights(flown):
    return np.array([-at.state.p_n[2] for at in flown])


def beside(flown):
    return max(abs(at.state.p_n[1]) for at in flown)


@pytest.mark.parametrize("wind", [STILL, blowing(8.0, 0.0), blowing(8.0, 120.0)])
def test_a_long_ridge_is_passed_over(wind):
    flown = flown_far([ridge()], wind)
    assert beside(flown) < 30.0
    assert least_distance(flown, [ridge()]) > 20.0
    assert heights(flown).max() == pytest.approx(205.0, abs=3.0)
    assert not acted(flown)


def test_a_short_one_is_passed_round():
    flown = flown_far([ridge(wide=100.0)])
    assert beside(flown) > 50.0
    assert heights(flown).max() < 155.0


@pytest.mark.parametrize("ceiling", [200.0, 225.0])
def test_under_a_ceiling_that_leaves_no_room_over_it_the_way_leads_round(ceiling):
    flown = flown_far([ridge()], heights=(20.0, ceiling))
    assert beside(flown) > 700.0
    assert heights(flown).max() < 155.0


def test_too_near_to_climb_over_it_is_passed_round():
    near = Obstacle(shape.box((40.0, 700.0, 180.0)), (-400.0, 0.0, -90.0))
    flown = flown_far([near])
    assert beside(flown) > 300.0
    assert least_distance(flown, [near]) > 10.0


def plateau():
    """600 m long, so that the vehicle is over it for a while."""
    return Obstacle(shape.box((600.0, 1600.0, 180.0)), (460.0, 0.0, -90.0))


def with_sight(plan, *distances):
    columns(PlacedObstacle, plan.hazards.obstacles).visible_from[:] = distances
    return plan


@pytest.mark.parametrize("north", [600.0, 900.0, 1100.0, 1300.0])
@pytest.mark.parametrize("seen", [150.0, 300.0])
def test_the_level_is_kept_over_a_plateau_when_a_tower_comes_into_sight(north, seen):
    """The way round the tower leads over the plateau, no lower."""
    tower = Obstacle(shape.cylinder(30.0, 600.0), (north, 10.0, HEIGHT))
    both = [plateau(), tower]
    plan = with_sight(among(plan_of([goal(2300.0, 0.0)]), both), 2000.0, seen)
    flown = fly(start(), plan, STILL, 300.0, arrived)
    assert arrived(flown[-1])
    assert beside(flown) < 400.0
    assert least_distance(flown, [tower]) > 5.0
    over = [at for at in flown if 160.0 < at.state.p_n[0] < 760.0]
    assert len(over) > 100
    assert min(-at.state.p_n[2] for at in over) > 200.0
    assert not [at for at in over if decision_of_row(at.row).reason != Reason.NOMINAL]


@pytest.mark.parametrize("sunk", [6.0, 11.0, 18.0])
@pytest.mark.parametrize("north", [600.0, 1100.0])
def test_sunk_over_a_plateau_it_climbs_again(sunk, north):
    """Whatever comes into sight, and whether a way round it is found from there."""
    tower = Obstacle(shape.cylinder(30.0, 600.0), (north, 10.0, HEIGHT))
    plan = among(plan_of([goal(2300.0, 0.0)]), [plateau(), tower])
    plan = with_sight(plan, 2000.0, north - 330.0)
    flown = fly(start(), plan, STILL, 300.0, lambda at: at.state.p_n[0] > 300.0)
    at = flown[-1]
    x, y, z = at.state.p_n
    body = level((x, y, z + sunk), 0.0, 25.0, plan.aircraft)._replace(time=at.state.time)
    after = fly(body, plan, STILL, at.state.time + 10.0, arrived, at.loop)
    heights_after = heights(after)
    assert heights_after.min() > -z - sunk - 3.0
    assert heights_after[-1] > 200.0


def test_behind_what_was_passed_the_level_is_dropped():
    flown = flown_far([ridge()])
    kept = [route_of_row(at.row).level for at in flown]
    there = [at.state.p_n[0] for at, z in zip(flown, kept, strict=True) if z == -205.0]
    assert there[0] < -600.0
    assert 200.0 < there[-1] < 500.0
    assert kept[-1] == math.inf


def test_what_comes_into_sight_behind_a_ridge_is_passed_too():
    tower = Obstacle(shape.cylinder(30.0, 400.0), (700.0, 0.0, HEIGHT))
    flown = flown_far([ridge(), tower], seen=900.0)
    assert least_distance(flown, [ridge(), tower]) > 12.0


def mast(x, y, top, radius=8.0):
    return Obstacle(shape.cylinder(radius, top), (x, y, -0.5 * top))


@pytest.mark.parametrize("at_goal", [mast(500.0, 0.0, 137.0), mast(500.0, -23.0, 300.0)])
@pytest.mark.parametrize("in_way", [mast(-100.0, 0.0, 300.0), mast(-100.0, 62.0, 300.0, 50.0)])
def test_what_is_near_the_goal_does_not_make_the_look_along_the_way_blind(at_goal, in_way):
    """The clearance at the goal was enough along a straight way as a whole: 12 to 15 m."""
    flown = flown_among([in_way, at_goal])
    assert least_distance(flown, [in_way]) > 25.0
    assert not acted(flown)


def test_the_level_is_kept_where_the_goal_lies_over_something():
    """It was dropped before the ridge, and the assurance flew over it by 12 m."""
    hall = Obstacle(shape.box((120.0, 120.0, 138.0)), (1400.0, 0.0, -69.0))
    plan = among(plan_of([goal(1400.0, 0.0)]), [ridge(), hall])
    flown = fly(start(), plan, STILL, 300.0, arrived)
    assert arrived(flown[-1])
    assert least_distance(flown, [ridge()]) > 20.0
    assert not acted(flown)


def long_plateau():
    """So long that a leg begins and ends over it."""
    return Obstacle(shape.box((1200.0, 1600.0, 180.0)), (760.0, 0.0, -90.0))


def over_the_plateau(flown):
    return min(-at.state.p_n[2] - 180.0 for at in flown if 160.0 < at.state.p_n[0] < 1360.0)


@pytest.mark.parametrize("sunk", [0.0, 0.5, 2.0])
def test_a_level_is_found_again_when_the_autopilot_follows_again(sunk):
    """A level is come to from below: it was 1 cm short of it, and no level began there."""
    plan = among(plan_of([goal(2300.0, 0.0)]), [long_plateau()])
    flown = fly(start(), plan, STILL, 300.0, lambda at: at.state.p_n[0] > 300.0)
    at = flown[-1]
    x, y, z = at.state.p_n
    body = level((x, y, z + sunk), 0.0, 25.0, plan.aircraft)._replace(time=at.state.time)
    after = fly(body, plan, STILL, 300.0, arrived, take_over(at.loop))
    assert arrived(after[-1])
    assert over_the_plateau(after) > 24.5 - sunk
    assert not acted(after)


TRAFFIC = (Intruder((0.0, 9000.0, -150.0), (0.0, 0.1, 0.0), 0.0, 50.0, 30.0, 0.0, 0.0),)


@pytest.mark.parametrize(
    ("up", "ceiling", "traffic"),
    [
        (30.0, math.inf, ()),
        (30.0, math.inf, TRAFFIC),
        (30.0, 228.0, ()),
        (24.0, math.inf, ()),
        (20.0, math.inf, ()),
    ],
)
def test_over_a_plateau_the_next_goal_is_not_descended_to_at_once(up, ceiling, traffic):
    """Whoever is there keeps the height, also where no climb would begin: 5 and 11 m were left."""
    goals = [goal(400.0, 0.0, z=-180.0 - up), goal(2300.0, 0.0)]
    plan = among(plan_of(goals), [long_plateau()], heights=(20.0, ceiling))
    plan = replace(plan, hazards=plan.hazards._replace(traffic=traffic_rows(traffic)))
    body = level((-700.0, 0.0, -180.0 - up), 0.0, 25.0, plan.aircraft)
    flown = fly(body, plan, STILL, 300.0, lambda at: at.goal == 2)
    assert flown[-1].goal == 2
    assert over_the_plateau(flown) > min(up, 25.0) - 3.0
    assert not acted(flown)


@pytest.mark.parametrize("masts", [9, 14])
def test_many_obstacles_beside_the_way_leave_a_level_over_the_one_in_it(masts):
    """Ten of one height took all places: it flew 800 m round."""
    beside_way = [mast(1000.0 + 40.0 * i, 600.0, 140.0, 5.0) for i in range(masts)]
    flown = flown_far([ridge(), *beside_way], seen=5000.0)
    assert beside(flown) < 50.0
    assert least_distance(flown, [ridge()]) > 20.0


def test_a_detour_is_looked_along_after_the_wind_has_changed():
    """The leg under it wanted another radius and counted as new: nobody looked for 30 s."""
    tower = Obstacle(shape.cylinder(50.0, 400.0), (-100.0, 0.0, HEIGHT))
    late = Obstacle(shape.cylinder(40.0, 400.0), (-180.0, -185.0, HEIGHT))
    blocks = [tower, wall((200.0, -300.0), (200.0, 500.0)), late]
    plan = with_sight(among(plan_of([goal(1500.0, 0.0)]), blocks), 2000.0, 2000.0, 250.0)
    body = level((-700.0, 0.0, HEIGHT), math.radians(120.0), 25.0, plan.aircraft)
    at = fly(body, plan, STILL, 3.0, arrived)[-1]
    heading = math.atan2(at.state.v_n[1], at.state.v_n[0])
    body = level(at.state.p_n, heading, 25.0, plan.aircraft)._replace(time=at.state.time)
    flown = fly(body, plan, (9.0, 0.0, 0.0), 200.0, arrived, at.loop)
    assert arrived(flown[-1])
    assert least_distance(flown, blocks) > 25.0
    looked = [route_of_row(at.row).looked for at in flown[:-1]]
    assert max(at.state.time - t for at, t in zip(flown[:-1], looked, strict=True)) < 1.0
