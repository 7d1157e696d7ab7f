"""Polylines: points of a path of straight lines, and where it comes nearest to the origin."""

from typing import NamedTuple

import numpy as np

from vfguide.geometry.vector import Series, Vectors


class NearestPoint(NamedTuple):
    """The point of a polyline that is nearest to the origin."""

    distance: float
    """Its distance from the origin."""
    along: float
    """Where it is: the number of whole segments before it, and the share of its own."""


def points_at(wanted: Series, times: Series, points: Vectors) -> Vectors:
    """Points (m, 3) at times (m,) of a path through points (n, 3) at times (n,), straight between.

    Before the first and after the last it stands still there.
    """
    return np.column_stack([np.interp(wanted, times, points[:, axis]) for axis in range(3)])


def nearest_to_origin(path: Vectors) -> NearestPoint:
    """The point nearest to the origin of the polyline through points (n, 3), n >= 1.

    The distance is in the unit of the points.
    """
    steps = np.diff(path, axis=0)
    squares = np.maximum(np.einsum("ij,ij->i", steps, steps), np.finfo(float).tiny)
    shares = np.clip(-np.einsum("ij,ij->i", path[:-1], steps) / squares, 0.0, 1.0)
    points = np.vstack((path[:-1] + shares[:, None] * steps, path[-1:]))
    distances = np.linalg.norm(points, axis=1)
    nearest = int(distances.argmin())
    return NearestPoint(float(distances[nearest]), nearest + float(np.append(shares, 0.0)[nearest]))
