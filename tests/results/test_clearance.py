"""Least levels and clearances against brute force on finely sampled paths."""

import numpy as np
import pytest
from flight_samples import loaded_from, record_of, spiral
from hypothesis import given, settings
from hypothesis import strategies as st
from scipy.spatial.transform import Rotation

from vfguide.field.obstacle import Obstacle, obstacle_rows
from vfguide.field.obstacle_arrays import distances, levels
from vfguide.geometry.arrays import euler_angles
from vfguide.geometry.shapes import shape
from vfguide.results.clearance import clearances, min_clearances, min_levels
from vfguide.results.path import positions
from vfguide.results.record import FlightRecord
from vfguide.sim.kinematic import Bodies, Commands, advance

pytestmark = pytest.mark.slow

SHAPES = st.sampled_from(
    (
        shape.sphere(8.0),
        shape.ellipsoid((30.0, 5.0, 8.0)),
        shape.box((4.0, 60.0, 20.0)),
        shape.superquadric((6.0, 12.0, 20.0), (1.5, 3.0, 5.0)),
        shape.cylinder(5.0, 80.0),
        shape.cone(20.0, 40.0),
        shape.sphere(0.3),
    )
)
HEADINGS = st.floats(-3.0, 3.0)
VELOCITIES = st.tuples(*[st.floats(-15.0, 15.0)] * 3)
SEEDS = st.integers(0, 10_000)
FINE = 200


@pytest.fixture(scope="module")
def vehicle(tmp_path_factory):
    return loaded_from(tmp_path_factory.mktemp("vehicle")).scenario.vehicles[0]


def rigid_record(vehicle, seed, rate=10.0, steps=40):
    """A body whose speed jumps from step to step, and the same flight sampled finely."""
    rng = np.random.default_rng(seed)
    dt = 1.0 / rate
    start = Rotation.from_quat(rng.normal(size=(1, 4))).as_matrix()
    bodies = Bodies(rng.uniform(-20.0, 20.0, (1, 3)), np.ascontiguousarray(start))
    noted = [(bodies, Commands(np.zeros(1), np.zeros((1, 3))))]
    fine = [bodies.p_n]
    for _ in range(steps):
        commands = Commands(rng.uniform(0.0, 60.0, 1), 2.0 * rng.normal(size=(1, 3)))
        parts = [advance(bodies, commands, dt * k / FINE).p_n for k in range(1, FINE + 1)]
        bodies = advance(bodies, commands, dt)
        noted.append((bodies, commands))
        fine += parts
    R_nb = np.array([its.R_nb[0] for its, _ in noted])
    p_n = np.array([its.p_n[0] for its, _ in noted])
    speed = np.array([commands.speed[0] for _, commands in noted])
    omega_b = np.array([commands.omega_b[0] for _, commands in noted])
    none = np.full(len(p_n), np.nan)
    record = FlightRecord(
        vehicle,
        np.arange(len(p_n)) * dt,
        p_n,
        speed[:, None] * R_nb[:, :, 0],
        euler_angles(R_nb),
        omega_b,
        omega_b,
        *(none, none, none, np.zeros_like(p_n), none, none),
        setpoints=steps,
        R_nb=R_nb,
    )
    return record, np.concatenate(fine), np.arange(len(fine)) * dt / FINE


def somewhere_on(path, time, velocity, rng):
    """Where a body has to start to come near a point of the path at its time."""
    k = rng.integers(len(path))
    return tuple((path[k] + rng.normal(0.0, 6.0, 3) - time[k] * np.array(velocity)).tolist())


def assert_least(record, rows, path, time):
    least_U = levels(path, time, rows).min(axis=0)
    least_d = distances(path, time, rows).min(axis=0)
    assert min_levels(record, rows) == pytest.approx(least_U, rel=0.01)
    assert min_clearances(record, rows) == pytest.approx(least_d, abs=0.02, rel=0.001)


@settings(max_examples=50)
@given(SEEDS, SHAPES, HEADINGS, VELOCITIES)
def test_of_a_rigid_body(vehicle, seed, body, heading, velocity):
    record, path, time = rigid_record(vehicle, seed)
    rng = np.random.default_rng(seed)
    rows = obstacle_rows(
        [
            Obstacle(body, somewhere_on(path, time, velocity, rng), heading, velocity),
            Obstacle(body, (300.0, 40.0, 0.0), heading),
        ]
    )
    assert_least(record, rows, path, time)


@settings(max_examples=30)
@given(SEEDS, SHAPES, HEADINGS, VELOCITIES)
def test_of_an_aeroplane(vehicle, seed, body, heading, velocity):
    record = record_of(vehicle, spiral, 20.0, rate=20.0)
    time = np.linspace(0.0, 20.0, 40_001)
    path = spiral(time)
    place = somewhere_on(path, time, velocity, np.random.default_rng(seed))
    rows = obstacle_rows([Obstacle(body, place, heading, velocity)])
    assert_least(record, rows, path, time)


def test_something_small_and_fast_is_found_between_two_samples(vehicle):
    record = record_of(vehicle, spiral, 20.0, rate=5.0)
    crossing = spiral(np.array([10.1]))[0]
    velocity = np.array((0.0, 0.0, 900.0))
    rows = obstacle_rows(
        [Obstacle(shape.sphere(0.5), tuple(crossing - 10.1 * velocity), 0.0, tuple(velocity))]
    )
    assert clearances(record, rows).min() > 80.0
    assert min_clearances(record, rows) == pytest.approx(-0.5, abs=0.1)


@pytest.mark.parametrize("seed", range(5))
def test_positions_of_a_rigid_body_are_exact_between_samples(vehicle, seed):
    record, path, time = rigid_record(vehicle, seed, steps=10)
    assert positions(record, time) == pytest.approx(path, abs=1e-9)


def test_positions_at_the_samples_and_of_a_flight_that_did_not_begin(vehicle):
    record = record_of(vehicle, spiral, 2.0)
    assert positions(record, record.time) == pytest.approx(record.p_n, abs=1e-12)
    first = record_of(vehicle, spiral, 0.0)
    assert positions(first, np.zeros((2, 3))).shape == (2, 3, 3)
    rows = obstacle_rows([Obstacle(shape.sphere(2.0), (0.0, 3.0, -100.0))])
    assert min_clearances(first, rows) == pytest.approx(1.0, abs=1e-9)
    assert min_levels(first, rows) == pytest.approx(2.25)


def test_among_no_obstacles(vehicle):
    record = record_of(vehicle, spiral, 2.0)
    assert min_levels(record, obstacle_rows([])).shape == (0,)
    assert min_clearances(record, obstacle_rows([])).shape == (0,)
