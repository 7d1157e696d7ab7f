"""Law `paper` at points of a scenario: the composite field of the paper."""

import math
from collections.abc import Sequence
from typing import Any

import numpy as np
from numpy.typing import NDArray

from vfguide.field.composite_arrays import composite_fields
from vfguide.field.robots import Spacing
from vfguide.field_points.field_point import FieldPoint, Point
from vfguide.field_points.points_file import Points
from vfguide.geometry.so3 import from_euler
from vfguide.geometry.units import DEG
from vfguide.geometry.vector import Mat3, Vec3, scale
from vfguide.kernels.rows import columns
from vfguide.scenario.obstacles import rows_of
from vfguide.scenario.plans import frame_of
from vfguide.scenario.resolved import Scenario, Vehicle


def paper_fields(scenario: Scenario, vehicle: Vehicle, points: Points) -> list[FieldPoint]:
    """The composite field of the paper among obstacles and the robots to give way to."""
    avoidance = scenario.avoidance
    at: Any = columns(Point, points)
    fields = composite_fields(
        frame_of(vehicle.goals[0]),
        at.p_n,
        at.v_n,
        at.time,
        rows_of(scenario.obstacles),
        others_at(scenario, vehicle, at.time),
        Spacing(avoidance.safety_radius_m, avoidance.detection_range_m),
    )
    lists = (array.tolist() for array in fields)
    return [
        FieldPoint(vec(F), vec(G), vec(H), mat(R), vec(Omega_a), tuple(chi))
        for F, G, H, R, Omega_a, chi in zip(*lists, strict=True)
    ]


def vec(values: Sequence[float]) -> Vec3:
    """Three numbers as a vector."""
    x, y, z = values
    return (x, y, z)


def mat(rows: Sequence[Sequence[float]]) -> Mat3:
    """Three rows as a matrix."""
    x, y, z = rows
    return (vec(x), vec(y), vec(z))


def others_at(scenario: Scenario, vehicle: Vehicle, t: NDArray[np.float64]) -> Points:
    """The robots that `vehicle` gives way to at times (N,): position and velocity, (N, K, 6).

    Each flies straight on from its start at the velocity that law paper has there.
    """
    above = [other for other in scenario.vehicles if other.id < vehicle.id]
    if not (above and scenario.avoidance.between_vehicles):
        return np.zeros((len(t), 0, 6))
    start = np.array([other.position_m for other in above])
    velocity = np.array([velocity_at_start(scenario, other) for other in above])
    now = start + t[:, None, None] * velocity
    return np.concatenate((now, np.broadcast_to(velocity, now.shape)), axis=-1)


def velocity_at_start(scenario: Scenario, vehicle: Vehicle) -> Vec3:
    """k_v |p - p_d| along body x, NED [m/s]."""
    R_nb = from_euler(*(angle * DEG for angle in vehicle.euler_deg))
    away = math.dist(vehicle.position_m, vehicle.goals[0].position_m)
    speed = scenario.guidance.k_v * away
    return scale(speed, (R_nb[0][0], R_nb[1][0], R_nb[2][0]))
