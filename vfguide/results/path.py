"""The true path between the samples of a flight."""

import numpy as np
from numpy.typing import NDArray

from vfguide.geometry.vector import Matrices
from vfguide.results.hermite import hermite, value_at
from vfguide.results.record import Array, FlightRecord
from vfguide.sim.kinematic import Bodies, Commands, advance

Steps = NDArray[np.int64]


def positions(record: FlightRecord, time: Array) -> Array:
    """Positions (..., 3) [m], NED, at times (...) [s] within the flight.

    Those of a rigid body are exact. The path of an aeroplane is the Hermite cubic with the
    positions and velocities of the samples before and after.
    """
    if len(record.time) == 1:
        return np.broadcast_to(record.p_n[0], (*time.shape, 3))
    times = time.ravel()
    steps = np.searchsorted(record.time, times, side="right") - 1
    steps = np.clip(steps, 0, len(record.time) - 2)
    since = times - record.time[steps]
    if record.R_nb is None:
        p_n = _on_cubics(record, steps, since)
    else:
        p_n = _on_helices(record, record.R_nb, steps, since)
    return p_n.reshape(*time.shape, 3)


def _on_cubics(record: FlightRecord, steps: Steps, since: Array) -> Array:
    span = np.diff(record.time)[steps][:, None]
    s = since[:, None] / span
    p_n, d_n = record.p_n, span * record.v_n[steps]
    return value_at(hermite(p_n[steps], p_n[steps + 1], d_n, span * record.v_n[steps + 1]), s)


def _on_helices(record: FlightRecord, R_nb: Matrices, steps: Steps, since: Array) -> Array:
    """Positions after times `since` [s] at constant speed and body rates.

    To advance each for a time of its own, its speed and rates are multiplied by that time, and held
    for 1 s.
    """
    speed = np.einsum("ij,ij->i", record.v_n[steps + 1], R_nb[steps + 1, :, 0])
    driven = Commands(since * speed, since[:, None] * record.omega_b[steps + 1])
    return advance(Bodies(record.p_n[steps], R_nb[steps]), driven, 1.0).p_n
