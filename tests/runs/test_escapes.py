"""What the tools say of flights among obstacles: turning traffic, and whether it left an escape."""

import math

import numpy as np
import pytest
from flown_escapes import best_possible, known_from, true_distances, world_of
from flown_worlds import fenced, scenario_of
from outcomes import flight
from world_tables import loaded_from, northward

from vfguide.results.record import FlightRecord
from vfguide.scenario.traffic import path_of
from vfguide.sim.traffic import motion_at

SPEED = 25.0


def straight_on(loaded, seconds):
    """The record of a flight to the north through whatever is there, in still air."""
    vehicle = loaded.scenario.vehicles[0]
    time = np.arange(round(50 * seconds) + 1) / 50.0
    zeros = np.zeros((len(time), 3))
    v_n = np.tile((SPEED, 0.0, 0.0), (len(time), 1))
    p_n = np.array(vehicle.position_m) + time[:, None] * v_n
    ones = np.ones(len(time))
    up = -p_n[:, 2]
    return FlightRecord(
        vehicle,
        time,
        p_n,
        v_n,
        zeros,
        zeros,
        zeros,
        ones,
        SPEED * ones,
        ones,
        zeros,
        up,
        up,
        len(time),
    )


def sphere_ahead(folder, radius, seen):
    return loaded_from(sphere_table(radius, seen), folder)


def sphere_table(radius, seen):
    sphere = {
        "shape": "sphere",
        "radius_m": radius,
        "position_m": [400.0, 0.0, -150.0],
        "visible_from_m": seen,
    }
    return northward("ahead", obstacle=[sphere])


def test_traffic_that_turns_is_where_it_was_aimed_at_and_turns_as_a_small_aircraft(tmp_path):
    climbs, turns, aimed = [], [], 0
    for number in range(20):
        scenario = loaded_from(scenario_of("turning", 1, number), tmp_path).scenario
        radius = scenario.avoidance.traffic_radius_m
        assert scenario.traffic_receiver.range_m == pytest.approx(400.0 + radius)
        for its in scenario.traffic:
            p_n, v_n = motion_at(path_of(its), np.arange(0.0, 60.0, 0.25))
            level = np.hypot(v_n[:, 0], v_n[:, 1])
            assert 4.9 < level.min() <= level.max() < 20.1
            course = np.unwrap(np.arctan2(v_n[:, 1], v_n[:, 0]))
            turns.append(np.abs(np.diff(course)).max() / 0.25)
            climbs.append(np.abs(v_n[:, 2]).max())
            times = np.arange(10.0, 35.0, 0.25)
            p_n = motion_at(path_of(its), times)[0]
            straight = np.column_stack((SPEED * times, 0.0 * times, np.full(len(times), -150.0)))
            aimed += np.linalg.norm(p_n - straight, axis=1).min() < 35.0
    assert len(turns) > 30
    assert aimed == len(turns)
    assert 0.12 < max(turns) < 0.16
    assert 2.5 < max(climbs) <= 3.0


def test_a_drawn_world_is_the_same_every_time():
    assert scenario_of("turning", 3, 5) == scenario_of("turning", 3, 5)
    assert scenario_of("turning", 3, 5) != scenario_of("turning", 3, 6)


@pytest.mark.parametrize("kind", ["field", "dead-end", "turning", "fence"])
def test_every_world_is_fenced_and_keeps_a_fence_of_its_own(kind, tmp_path):
    world = scenario_of(kind, 1, 0)
    loaded = loaded_from(fenced(world), tmp_path)
    fence = loaded.scenario.fence
    assert (fence.floor_m, fence.ceiling_m) == (90.0, 210.0)
    assert fence.zone[0].kind == "include"
    assert (fenced(world) == world) == (kind == "fence")


def test_the_tree_is_asked_when_an_obstacle_comes_in_sight(tmp_path):
    loaded = sphere_ahead(tmp_path, 60.0, 100.0)
    record = straight_on(loaded, 30.0)
    k, ground = known_from(loaded, record)
    assert ground == 0
    assert record.p_n[k, 0] == pytest.approx(400.0 - 60.0 - 100.0, abs=0.5)


def test_a_fence_is_known_from_the_start(tmp_path):
    loaded = loaded_from(scenario_of("fence", 1, 0), tmp_path)
    assert known_from(loaded, straight_on(loaded, 5.0)) == [0, 0, 0, 0]


def test_true_distances_of_a_flight_through_a_sphere(tmp_path):
    loaded = sphere_ahead(tmp_path, 60.0, 100.0)
    record = straight_on(loaded, 30.0)
    distances, nearest = true_distances(world_of(loaded, record), record.p_n, record.time)
    assert nearest[0] == 1
    assert nearest[np.argmin(distances)] == 0
    assert distances.min() == pytest.approx(-60.0, abs=0.5)
    assert distances[0] == pytest.approx(150.0, abs=0.5), "the ground, 150 m below"


def test_who_flies_straight_into_what_is_seen_early_had_an_escape(tmp_path):
    loaded = sphere_ahead(tmp_path, 40.0, 150.0)
    assert best_possible(loaded, straight_on(loaded, 30.0)) == pytest.approx(5.0)


def test_who_sees_a_hill_too_late_had_none(tmp_path):
    loaded = sphere_ahead(tmp_path, 100.0, 10.0)
    assert -100.0 < best_possible(loaded, straight_on(loaded, 30.0)) < 0.0


def test_what_comes_in_sight_later_is_no_excuse(tmp_path):
    """A second sphere that is seen when the first can no longer be missed."""
    table = sphere_table(40.0, 150.0)
    late = {**table["obstacle"][0], "position_m": [430.0, 90.0, -150.0], "visible_from_m": 65.0}
    table["obstacle"].append(late)
    loaded = loaded_from(table, tmp_path)
    record = straight_on(loaded, 30.0)
    first, second, _ = known_from(loaded, record)
    assert 0 < first < second
    assert best_possible(loaded, record) == pytest.approx(5.0)


def test_the_tree_knows_how_traffic_is_going_to_turn(tmp_path):
    """It comes along beside, and turns in when it is too late for whoever does not know."""
    beside = {
        "name": "BESIDE",
        "position_m": [0.0, 150.0, -150.0],
        "velocity_mps": [25.0, 0.0, 0.0],
        "change": [{"time_s": 5.0, "velocity_mps": [20.0, -15.0, 0.0], "within_s": 2.0}],
    }
    loaded = loaded_from(northward("traffic", traffic=[beside]), tmp_path)
    record = straight_on(loaded, 20.0)
    assert known_from(loaded, record) == [0, 0]
    world = world_of(loaded, record)
    assert world.volume == (50.0, 30.0)
    assert true_distances(world, record.p_n, record.time)[0].min() < 0.0
    assert best_possible(loaded, record) == pytest.approx(5.0)


@pytest.mark.parametrize(
    ("clearance", "best", "allowed"),
    [
        (3.0, math.nan, True),
        (-1.0, 2.0, False),
        (-1.0, -0.5, True),
        (-9.0, -3.0, False),
        (-1.0, math.nan, False),
    ],
)
def test_a_hit_is_allowed_where_there_was_no_escape_and_it_is_not_much_deeper(
    clearance, best, allowed
):
    assert flight(clearance_m=clearance, best_m=best).allowed == allowed
