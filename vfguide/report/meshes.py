"""Surfaces U = 1 of obstacles as meshes, and their outlines in a plane."""

from typing import Any

import numpy as np
from numpy.typing import NDArray

from vfguide.field.obstacle import Obstacle
from vfguide.geometry.shapes.base import Shape
from vfguide.geometry.shapes.distance import onto_surface
from vfguide.geometry.shapes.shape import surface_rays
from vfguide.geometry.so3 import rot_z
from vfguide.geometry.vector import Vectors

Array = NDArray[np.float64]

MESH_ROWS = 25
"""Number of rows of a mesh from pole to pole; chosen odd, so that they meet the middle of every
edge."""
MESH_COLUMNS = 49
"""Number of columns of a mesh around the vertical; chosen, so that they meet the middle of every
edge."""


def surface_mesh(obstacle: Obstacle) -> Array:
    """Points of the surface U = 1 at time zero, (MESH_ROWS, MESH_COLUMNS, 3), NED [m].

    They lie on rays from the centre that are denser where the shape has an edge. The first and the
    last column are the same; all points of the first row are one pole, all of the last the other.
    """
    shape = obstacle.shape
    rays = mesh_rays(shape).reshape(-1, 3).tolist()
    points = np.array([onto_surface(shape, (x, y, z)) for x, y, z in rays])
    R_no: Any = np.array(rot_z(obstacle.heading))
    return (points @ R_no.T + obstacle.p_n).reshape(MESH_ROWS, MESH_COLUMNS, 3)


def mesh_rays(shape: Shape) -> Array:
    """Directions in the axes of the shape, (MESH_ROWS, MESH_COLUMNS, 3), from z < 0 to z > 0.

    They are scaled by the semi-axes [m], so that they are no unit vectors.
    """
    latitude = np.linspace(-np.pi / 2.0, np.pi / 2.0, MESH_ROWS)[:, None]
    longitude = np.linspace(-np.pi, np.pi, MESH_COLUMNS)
    rays = np.broadcast_arrays(*surface_rays(shape, latitude, longitude))
    return np.stack(rays, axis=-1) * shape.semi_axes


def outline(points: Array) -> Array:
    """Corners of the convex hull of `points` (..., 2) in a plane, (k, 2), in order around it.

    A. M. Andrew, Another efficient algorithm for convex hulls in two dimensions, 1979.
    """
    flat: list[list[float]] = np.unique(points.reshape(-1, 2), axis=0).tolist()
    return np.array(_chain(flat) + _chain(flat[::-1]))


def section(surface: Array, down: float) -> Vectors:
    """Corners of the horizontal section of a surface mesh at z = `down`, NED [m], (k, 2).

    They are north and east, in order around it; none where the surface does not reach that height.
    """
    north, east, below = np.moveaxis(surface, -1, 0)
    if not below.min() < down < below.max():
        return np.empty((0, 2))
    meridians = zip(north.T, east.T, below.T, strict=True)
    return np.array([(np.interp(down, z, x), np.interp(down, z, y)) for x, y, z in meridians])


def _chain(points: list[list[float]]) -> list[list[float]]:
    """Corners of half the hull, from the first of sorted points to the one before the last."""
    corners: list[list[float]] = []
    for point in points:
        while len(corners) > 1 and not _turns(corners[-2], corners[-1], point):
            corners.pop()
        corners.append(point)
    return corners[:-1] or corners


def _turns(a: list[float], b: list[float], c: list[float]) -> bool:
    """Whether the polyline `a`, `b`, `c` turns from the first axis toward the second."""
    return (b[0] - a[0]) * (c[1] - b[1]) > (b[1] - a[1]) * (c[0] - b[0])
