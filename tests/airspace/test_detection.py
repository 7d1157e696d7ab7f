"""Detection: which obstacles are known when, and that they stay known."""

import numpy as np
from hazard_samples import ball, hazards

from vfguide.aircraft.state import FlightState
from vfguide.airspace import detection
from vfguide.airspace.detection import Airspace, DetectionState, in_sight
from vfguide.airspace.keep_out import NO_FENCE
from vfguide.estimation.estimation import known_state
from vfguide.field.obstacle import OUT_OF_SIGHT, PlacedObstacle
from vfguide.geometry.so3 import IDENTITY
from vfguide.kernels.rows import columns

HERE = (0.0, 0.0, -150.0)


def with_sight(seen, *obstacles):
    known = hazards(obstacles)
    columns(PlacedObstacle, known.obstacles).visible_from[:] = seen
    return known


def north(known):
    ((north, _, _),) = columns(PlacedObstacle, known.obstacles).p_n
    return north


def test_an_obstacle_is_known_from_its_distance_on_and_stays_known():
    everything, known = with_sight(100.0, ball((200.0, 0.0, -150.0))), np.zeros(1)
    assert north(in_sight(everything, known, HERE, 0.0)) == OUT_OF_SIGHT
    assert known[0] == 0.0
    near = (61.0, 0.0, -150.0)
    assert north(in_sight(everything, known, near, 0.0)) == 200.0
    assert known[0] == 1.0
    assert north(in_sight(everything, known, (-5000.0, 0.0, -150.0), 0.0)) == 200.0
    assert north(everything) == 200.0, "what is looked at is left as it was"


def test_one_that_moves_comes_into_sight_by_itself():
    everything = with_sight(100.0, ball((400.0, 0.0, -150.0), v_n=(-20.0, 0.0, 0.0)))
    known = np.zeros(1)
    in_sight(everything, known, HERE, 12.9)
    assert known[0] == 0.0
    in_sight(everything, known, HERE, 13.1)
    assert known[0] == 1.0


def test_without_obstacles_there_is_nothing_to_see():
    nothing, known = hazards(floor=100.0), np.zeros(0)
    assert in_sight(nothing, known, HERE, 0.0) is not None
    assert len(known) == 0


def nav_at(p_n):
    return known_state(FlightState(1.0, p_n, (25.0, 0.0, 0.0), IDENTITY, 25.0, (0.0,) * 3), 0.98)


def test_the_stage_leaves_what_it_was_given_as_it_was():
    everything = with_sight(100.0, ball((200.0, 0.0, -150.0)))
    airspace, before = Airspace(everything, NO_FENCE, 3.0, 0.7), DetectionState(np.zeros(1))
    far, after = detection.update(nav_at(HERE), airspace, before)
    assert (north(far.hazards), after.known.tolist()) == (OUT_OF_SIGHT, [0.0])
    near, after = detection.update(nav_at((61.0, 0.0, -150.0)), airspace, before)
    assert (north(near.hazards), after.known.tolist()) == (200.0, [1.0])
    assert (near.time, near.gust) == (3.0, 0.7)
    assert before.known.tolist() == [0.0]
    assert north(everything) == 200.0
    still, _ = detection.update(nav_at((-5000.0, 0.0, -150.0)), airspace, after)
    assert north(still.hazards) == 200.0


def test_without_an_airspace_nothing_is_known():
    state = DetectionState(np.zeros(2))
    airspace, after = detection.update(nav_at(HERE), None, state)
    assert airspace is None
    assert (after.known == state.known).all()
