"""How near the true path came to obstacles.

U and the distance from a surface are convex functions of the place relative to the body. So where a
step of the path, nearly straight, goes lower than its ends, one of them is lower than the sample
on its other side: there the path is looked at between the samples.
"""

from collections.abc import Callable

import numpy as np
from numpy.typing import NDArray

from vfguide.field.obstacle import POSITION, SEMI_AXES, VELOCITY, Rows
from vfguide.field.obstacle_arrays import distances, levels
from vfguide.scenario.record import Array, FlightRecord

PARTS = 16
"""A step of the path is looked at in so many parts."""

Measure = Callable[[Array, Array, Rows], Array]
"""Values (n, M) at positions (n, 3) [m], NED, and times (n,) [s]."""


def min_levels(record: FlightRecord, obstacles: Rows) -> Array:
    """Least U of each obstacle on the path, (M,)."""
    values = levels(record.p_n, record.time, obstacles)
    each = zip(values.T, obstacles[:, None], strict=True)
    return np.array([_refined(record, its, levels, row) for its, row in each])


def min_clearances(record: FlightRecord, obstacles: Rows) -> Array:
    """Least distance of the centre from each surface, (M,) [m], negative inside."""
    return np.array([_min_clearance(record, row) for row in obstacles[:, None]])


def clearances(record: FlightRecord, obstacles: Rows) -> Array:
    """Distance from each surface at the samples, (n, M) [m]."""
    return distances(record.p_n, record.time, obstacles)


def _min_clearance(record: FlightRecord, row: Rows) -> float:
    """The same for one obstacle, (1, COLUMNS); exact distances only where they can be the least."""
    from_centre = np.linalg.norm(record.p_n - centres(row, record.time), axis=1)
    nearest = int(np.argmin(from_centre))
    reached = distances(record.p_n[nearest], record.time[nearest], row)[0]
    candidates = from_centre - np.linalg.norm(row[0, SEMI_AXES]) <= reached
    values = np.full(len(from_centre), np.inf)
    values[candidates] = distances(record.p_n[candidates], record.time[candidates], row)[:, 0]
    return _refined(record, values, distances, row)


def centres(row: Rows, time: Array) -> Array:
    """Where the centre of one obstacle is, (n, 3) [m]."""
    return row[0, POSITION] + time[:, None] * row[0, VELOCITY]


def _refined(record: FlightRecord, values: Array, measure: Measure, row: Rows) -> float:
    """The least of `values` at the samples, and of those near their local minima."""
    padded = np.concatenate(([np.inf], values, [np.inf]))
    minima = np.flatnonzero((values < padded[:-2]) & (values <= padded[2:]))
    steps = np.unique(np.concatenate((minima - 1, minima)))
    steps = steps[(steps >= 0) & (steps < len(values) - 1)]
    p_n, time = between(record, steps)
    return float(min(values.min(), measure(p_n, time, row).min(initial=np.inf)))


def between(record: FlightRecord, steps: NDArray[np.int64]) -> tuple[Array, Array]:
    """Positions and times within some steps of the path, K, (K (PARTS - 1), 3).

    On the cubics with the positions and velocities of their ends.
    """
    s = (np.arange(1, PARTS) / PARTS)[:, None]
    span = np.diff(record.time)[steps][:, None, None]
    p0, p1 = record.p_n[steps, None], record.p_n[steps + 1, None]
    d0, d1 = span * record.v_n[steps, None], span * record.v_n[steps + 1, None]
    b, c = 3.0 * (p1 - p0) - 2.0 * d0 - d1, d0 + d1 - 2.0 * (p1 - p0)
    p_n = p0 + s * (d0 + s * (b + s * c))
    time = record.time[steps, None] + span[:, 0] * s.T
    return p_n.reshape(-1, 3), time.ravel()
