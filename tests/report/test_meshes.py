"""Meshes of obstacles' surfaces, and their outlines."""

import math

import numpy as np
import pytest

from vfguide.field.obstacle import Obstacle, obstacle_rows
from vfguide.field.obstacle_arrays import levels
from vfguide.geometry.shapes import shape
from vfguide.geometry.shapes.distance import onto_surface
from vfguide.geometry.so3 import rot_z
from vfguide.report.meshes import outline, surface_mesh

SHAPES = {
    "sphere": shape.sphere(9.0),
    "egg": shape.ellipsoid((12.0, 6.0, 20.0)),
    "plate": shape.ellipsoid((100.0, 80.0, 0.01)),
    "cushion": shape.superquadric((14.0, 8.0, 6.0), (2.0, 1.0, 3.0)),
    "barrel on its side": shape.superquadric((5.0, 20.0, 5.0), (1.0, 50.0, 1.0)),
    "sharp box": shape.superquadric((30.0, 2.0, 1.0), (50.0, 50.0, 50.0)),
    "tower": shape.cylinder(8.0, 50.0),
    "house": shape.box((20.0, 14.0, 40.0)),
    "hill": shape.cone(25.0, 40.0),
    "grain": shape.sphere(1e-9),
}
PLANES = {
    "above": np.array([[0.0, 1.0], [1.0, 0.0], [0.0, 0.0]]),
    "side": np.array([[0.6, 0.0], [0.8, 0.0], [0.0, -1.0]]),
}


@pytest.fixture(params=SHAPES.values(), ids=SHAPES)
def obstacle(request):
    return Obstacle(request.param, (10.0, -20.0, -30.0), math.radians(37.0))


def dense_surface(body, rng):
    """Many points of the surface on rays that lie elsewhere than the mesh's, from its centre."""
    rays = rng.normal(size=(4000, 3)) * body.semi_axes
    return np.array([onto_surface(body, tuple(ray)) for ray in rays.tolist()])


def test_a_mesh_lies_on_its_surface(obstacle):
    rows = obstacle_rows([obstacle._replace(p_n=(0.0, 0.0, 0.0))])
    mesh = surface_mesh(obstacle._replace(p_n=(0.0, 0.0, 0.0)))
    assert levels(mesh, 0.0, rows)[..., 0] == pytest.approx(np.ones(mesh.shape[:2]), abs=1e-9)
    assert surface_mesh(obstacle) == pytest.approx(mesh + obstacle.p_n, abs=1e-12)


def test_a_mesh_goes_from_pole_to_pole_and_is_closed(obstacle):
    mesh = surface_mesh(obstacle)
    assert np.ptp(mesh[[0, -1]], axis=1) == pytest.approx(0.0, abs=1e-12)
    assert mesh[:, 0] == pytest.approx(mesh[:, -1], abs=1e-9)
    if obstacle.shape.semi_axes[2] > 1e-3:
        assert mesh[0, 0, 2] < obstacle.p_n[2] < mesh[-1, 0, 2]


def test_facets_of_a_mesh_lie_close_to_the_surface(obstacle):
    """Half-way between neighbours a mesh of a convex body cuts off little of it."""
    centred = obstacle._replace(p_n=(0.0, 0.0, 0.0))
    mesh = surface_mesh(centred)
    middles = (mesh[1:, 1:] + mesh[:-1, 1:] + mesh[1:, :-1] + mesh[:-1, :-1]) / 4.0
    R_no = np.array(rot_z(obstacle.heading))
    own = (middles @ R_no).reshape(-1, 3)
    surface = np.array([onto_surface(obstacle.shape, tuple(p)) for p in own.tolist()])
    parts = np.linalg.norm(own, axis=1) / np.linalg.norm(surface, axis=1)
    assert 0.9 < parts.min() <= parts.max() <= 1.0 + 1e-9


@pytest.mark.parametrize("onto", PLANES.values(), ids=PLANES)
def test_an_outline_is_the_silhouette(obstacle, onto):
    """Against points that the mesh does not have: nothing sticks out, and nothing is missing."""
    corners = outline(surface_mesh(obstacle) @ onto)
    R_no = np.array(rot_z(obstacle.heading))
    body = (dense_surface(obstacle.shape, np.random.default_rng(5)) @ R_no.T + obstacle.p_n) @ onto
    size = np.ptp(body, axis=0).max()
    angle = np.random.default_rng(6).uniform(0.0, 2.0 * np.pi, 200)
    directions = np.stack((np.cos(angle), np.sin(angle)))
    farthest, shown = (body @ directions).max(axis=0), (corners @ directions).max(axis=0)
    assert (shown >= farthest - 0.01 * size - 1e-12).all()
    assert (shown <= farthest + 0.06 * size + 1e-12).all()


@pytest.mark.parametrize("onto", PLANES.values(), ids=PLANES)
def test_an_outline_holds_the_projected_mesh(obstacle, onto):
    """It turns one way only, and no point of the mesh lies beyond any of its sides."""
    mesh = (surface_mesh(obstacle._replace(p_n=(0.0, 0.0, 0.0))) @ onto).reshape(-1, 2)
    corners = outline(mesh)
    sides = np.roll(corners, -1, axis=0) - corners
    out = np.stack((sides[:, 1], -sides[:, 0])) / np.linalg.norm(sides, axis=1)
    assert len(corners) >= 12
    beyond = mesh @ out - np.einsum("ij,ji->i", corners, out)
    assert beyond.max() <= 1e-12 * np.ptp(mesh, axis=0).max()


def test_the_outline_of_points_in_one_place_or_in_line():
    assert outline(np.ones((4, 3, 2))).tolist() == [[1.0, 1.0], [1.0, 1.0]]
    assert outline(np.arange(10.0).reshape(5, 2)).tolist() == [[0.0, 1.0], [8.0, 9.0]]


def test_the_heading_turns_clockwise_seen_from_above():
    bar = Obstacle(shape.box((40.0, 4.0, 4.0)), (0.0, 0.0, 0.0), math.radians(30.0))
    mesh = surface_mesh(bar)
    north, east, _ = mesh.reshape(-1, 3)[np.argmax(np.linalg.norm(mesh.reshape(-1, 3), axis=1))]
    assert math.degrees(math.atan2(east, north)) % 180.0 == pytest.approx(30.0, abs=6.0)


def test_a_cone_has_its_apex_up():
    mesh = surface_mesh(Obstacle(shape.cone(10.0, 20.0), (0.0, 0.0, -50.0)))
    radius = np.linalg.norm(mesh[..., :2], axis=-1)
    assert radius[mesh[..., 2] < -55.0].max() < 5.0
    assert radius[mesh[..., 2] > -45.0].max() > 8.0
