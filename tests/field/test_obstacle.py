import math

import numpy as np
import pytest
from hypothesis import given
from hypothesis import strategies as st
from obstacle_samples import STILL, at_level
from shape_samples import SHAPES, every_shape, floats, random_directions

from vfguide.field.obstacle import (
    OUT_OF_SIGHT,
    Obstacle,
    PlacedObstacle,
    obstacle_rows,
    obstacle_surface,
    placed,
    put_out_of_sight,
    read_obstacle,
)
from vfguide.field.obstacle_arrays import distances, levels
from vfguide.geometry.dual import Dual3
from vfguide.geometry.shapes import shape
from vfguide.geometry.shapes.shape import shape_level
from vfguide.kernels.rows import width

pytestmark = pytest.mark.slow

coordinates = st.floats(-60.0, 60.0)
points = st.tuples(coordinates, coordinates, coordinates)
angles = st.floats(-math.pi, math.pi)
SHIP = Obstacle(shape.box((20.0, 60.0, 40.0)), (100.0, 50.0, -5.0), 0.5, (3.0, -4.0, 1.0), 9.0)


def test_rows_hold_the_obstacles_as_they_are_placed():
    ship, cone = map(read_obstacle, obstacle_rows([SHIP, Obstacle(shape.cone(3.0, 4.0), STILL)]))
    assert ship == placed(SHIP)
    assert (ship.p_n, ship.v_n) == ((100.0, 50.0, -5.0), (3.0, -4.0, 1.0))
    assert (ship.heading_cos, ship.heading_sin) == (math.cos(0.5), math.sin(0.5))
    assert (ship.semi_axes, ship.exponents) == ((10.0, 30.0, 20.0), (4.0, 4.0, 4.0))
    assert ship.reactive_level == 9.0
    assert (cone.kind, cone.semi_axes) == (shape.Kind.CONE, (3.0, 3.0, 2.0))
    assert obstacle_rows([]).shape == (0, width(PlacedObstacle))


def test_an_obstacle_out_of_sight_is_otherwise_as_it_was():
    (row,) = obstacle_rows([SHIP])
    put_out_of_sight(row)
    assert read_obstacle(row) == placed(SHIP)._replace(p_n=(OUT_OF_SIGHT, 50.0, -5.0))


@pytest.mark.parametrize("level", [1.0, 0.0, -3.0, math.nan, math.inf, 1e31])
def test_reactive_levels_that_leave_no_area_are_refused(level):
    with pytest.raises(ValueError, match="reactive level"):
        obstacle_rows([Obstacle(SHAPES["sphere"], STILL, reactive_level=level)])


def test_heading_turns_clockwise_from_above():
    """A box that is long to its left and right: headed east, that is north and south."""
    box = shape.box((20.0, 60.0, 40.0))
    rows = obstacle_rows([Obstacle(box, STILL, heading=math.pi / 2)])
    assert levels((30.0, 0.0, 0.0), 0.0, rows) == pytest.approx([1.0])
    assert levels((0.0, 10.0, 0.0), 0.0, rows) == pytest.approx([1.0])


@given(points, angles, points, st.floats(-20.0, 20.0))
@every_shape
def test_levels_and_distances_move_and_turn_with_the_obstacle(body, x, heading, v, t):
    rows = obstacle_rows([Obstacle(body, (7.0, 8.0, 9.0), heading, v)])
    c, s = math.cos(heading), math.sin(heading)
    place = np.array([c * x[0] - s * x[1], s * x[0] + c * x[1], x[2]])
    p = np.array((7.0, 8.0, 9.0)) + t * np.array(v) + place
    at_home = obstacle_rows([Obstacle(body, STILL)])
    assert levels(p, t, rows) == pytest.approx(levels(x, 0.0, at_home), rel=1e-9, abs=1e-9)
    distance = distances(x, 0.0, at_home)
    assert distances(p, t, rows) == pytest.approx(distance, rel=1e-3, abs=1e-6)


@given(points, points, points, angles)
@every_shape
def test_rates_are_central_differences(body, x, v, v_o, heading):
    """U and n as a moving point sees them on a moving obstacle."""
    x = floats(np.multiply(x, np.array(body.semi_axes) / 40.0))
    rows, h = obstacle_rows([Obstacle(body, STILL, heading, v_o)]), 1e-5

    def seen(s):
        p = floats(np.add(x, s * np.array(v)))
        return obstacle_surface(rows, 0, Dual3(p, v), s)

    here, after, before = seen(0.0), seen(h), seen(-h)
    speed = 1.0 + np.linalg.norm(np.subtract(v, v_o))
    bend = np.abs(shape_level(body, floats(into_axes(x, heading))).hessian).max()
    slope = np.linalg.norm(here.n.value)
    U_rate = (after.U.value - before.U.value) / (2.0 * h)
    assert abs(here.U.rate - U_rate) <= 1e-3 * speed * (slope + h * speed * bend + 1e-6)
    n_rate = np.subtract(after.n.value, before.n.value) / (2.0 * h)
    assert np.abs(here.n.rate - n_rate).max() <= 0.02 * speed * (bend + 0.1)


def into_axes(a, heading):
    c, s = math.cos(heading), math.sin(heading)
    return np.array([c * a[0] + s * a[1], c * a[1] - s * a[0], a[2]])


@every_shape
@pytest.mark.parametrize("level", [1.01, 4.0, 1e6])
def test_the_reach_holds_the_reactive_area(body, level):
    obstacle = Obstacle(body, (5.0, 6.0, 7.0), 0.7, reactive_level=level)
    rows = obstacle_rows([obstacle])
    edge = at_level(rows, random_directions(np.random.default_rng(7), 2000), level)
    assert np.linalg.norm(edge - (5.0, 6.0, 7.0), axis=1).max() <= placed(obstacle).reach


def test_arrays_broadcast_points_against_times():
    rows = obstacle_rows([SHIP, Obstacle(SHAPES["cone"], STILL)])
    p, t = np.zeros((4, 1, 3)), np.arange(5.0)
    assert levels(p, t, rows).shape == distances(p, t, rows).shape == (4, 5, 2)
    assert levels(p[0, 0], 2.0, rows)[0] == levels(p, t, rows)[3, 2, 0]
    assert levels(p, t, obstacle_rows([])).shape == (4, 5, 0)
