"""Clearance of the true path from obstacles.

U and the distance from a surface are convex functions of the position relative to the body, and a
step of the path is nearly straight. So the values at both ends of a step and halfway bound those
between them from below. Only the steps that may contain the least value are divided further.
"""

from collections.abc import Callable

import numpy as np

from vfguide.field.obstacle import PlacedObstacle, Rows
from vfguide.field.obstacle_arrays import distances, levels
from vfguide.geometry.vector import Series
from vfguide.kernels.rows import columns
from vfguide.results.path import positions
from vfguide.results.record import Array, FlightRecord

PARTS = 16
"""Number of parts into which a step is divided where the least value may lie in it; chosen."""
REFINEMENTS = 4
"""Number of times that the two parts around the least value are divided again; chosen."""

Measure = Callable[[Array, Array, Rows], Array]
"""Values (..., M) at positions (..., 3) [m], NED, and times (...) [s]."""


def min_levels(record: FlightRecord, obstacles: Rows) -> Array:
    """Least level U of each obstacle on the path, (M,), dimensionless."""
    values = levels(record.p_n, record.time, obstacles)
    each = zip(values.T, obstacles[:, None], strict=True)
    return np.array([_refined(record, each, levels, row) for each, row in each])


def min_clearances(record: FlightRecord, obstacles: Rows) -> Array:
    """Least distance of the vehicle's centre from each surface, (M,) [m], negative inside."""
    return np.array([_min_clearance(record, row) for row in obstacles[:, None]])


def clearances(record: FlightRecord, obstacles: Rows) -> Array:
    """Distance from each surface at the samples, (n, M) [m]; NaN where the position is."""
    values = np.full((len(record.time), len(obstacles)), np.nan)
    known = np.isfinite(record.p_n).all(axis=1)
    values[known] = distances(record.p_n[known], record.time[known], obstacles)
    return values


def _min_clearance(record: FlightRecord, row: Rows) -> float:
    """Least distance from one obstacle [m]; computed only where it can be the least."""
    offset = record.p_n - centres(row, record.time)
    from_centre = np.linalg.norm(offset, axis=1)
    nearest = int(np.argmin(from_centre))
    (reached,) = distances(record.p_n[nearest], record.time[nearest], row)
    longest = np.linalg.norm(np.diff(offset, axis=0), axis=1).max(initial=0.0)
    reach = np.linalg.norm(columns(PlacedObstacle, row).semi_axes)
    candidates = from_centre - reach - longest <= reached
    values = np.full(len(from_centre), np.inf)
    values[candidates] = distances(record.p_n[candidates], record.time[candidates], row).ravel()
    return _refined(record, values, distances, row)


def centres(row: Rows, time: Array) -> Array:
    """Positions of the centre of one obstacle at times (n,) [s], (n, 3), NED [m]."""
    obstacle = columns(PlacedObstacle, row)
    return obstacle.p_n + time[:, None] * obstacle.v_n


def _refined(record: FlightRecord, values: Series, measure: Measure, row: Rows) -> float:
    """The least of `values` (n,) at the samples, and of those within the steps between them.

    A step with a value that is not finite at either end is left out.
    """
    steps = np.flatnonzero(np.isfinite(values[:-1]) & np.isfinite(values[1:]))
    low, high = record.time[steps], record.time[steps + 1]
    halfway = _between(record, 0.5 * (low + high), measure, row)
    least = min(float(values.min()), float(halfway.min(initial=np.inf)))
    may_be_least = 2.0 * halfway - np.maximum(values[steps], values[steps + 1]) < least
    low, high = low[may_be_least], high[may_be_least]
    each = np.arange(len(low))
    for _ in range(REFINEMENTS):
        time = np.linspace(low, high, PARTS + 1, axis=1)
        between = _between(record, time, measure, row)
        at = between.argmin(axis=1)
        least = min(least, float(between.min(initial=np.inf)))
        low = time[each, np.maximum(at - 1, 0)]
        high = time[each, np.minimum(at + 1, PARTS)]
    return least


def _between(record: FlightRecord, time: Array, measure: Measure, row: Rows) -> Array:
    """Values at times between the samples, of the same shape."""
    return np.squeeze(measure(positions(record, time), time, row), axis=-1)
