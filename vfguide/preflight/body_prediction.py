"""Predicted flights of rigid bodies, made of the same steps as those of plant `kinematic`.

Nothing disturbs such a body, so that the predicted path is the one that it flies.
"""

import math

import numpy as np

from vfguide.aircraft.vehicle import Vehicle, read_vehicle, vehicle_numbers
from vfguide.geometry.so3 import from_euler
from vfguide.geometry.units import DEG
from vfguide.geometry.vector import Matrix, Vectors, mat3, vec3
from vfguide.guidance.laws import FLIGHT, Law
from vfguide.kernels.compiled import compiled
from vfguide.kernels.rows import Row
from vfguide.loop.legs import Legs
from vfguide.loop.rows import step_body
from vfguide.loop.state import fresh_state, read_state, row_of_state
from vfguide.preflight.route_checks import GuidedAircraft
from vfguide.scenario.resolved import Scenario
from vfguide.scenario.resolved import Vehicle as ScenarioVehicle
from vfguide.sim.kinematic import move


def predict_body(
    scenario: Scenario, vehicle: ScenarioVehicle, guided: GuidedAircraft, legs: Legs
) -> tuple[Vectors, int]:
    """Positions (N, 3), NED [m], a guidance period apart, for as long as a run may take.

    The second result is the index of the first position after the last goal, from which on the body
    circles; N where there is none.
    """
    rate = scenario.guidance.rate_hz
    path: Vectors = np.empty((math.ceil(scenario.duration_s * rate) + 1, 3))
    path[:1] = vehicle.position_m
    circles_from = fly_body(
        np.array(from_euler(*(angle * DEG for angle in vehicle.euler_deg))),
        row_of_state(fresh_state()),
        legs,
        FLIGHT,
        np.array(vehicle_numbers(Vehicle(guided.aircraft, guided.gains, True))),
        1.0 / rate,
        path,
    )
    return path, circles_from


@compiled
def fly_body(
    R: Matrix, row: Row, legs: Legs, law: Law, vehicle: Row, dt: float, path: Vectors
) -> int:
    """Write the positions of a body into `path`; the index of the first after the last goal.

    Args:
        R: attitude at the start, body FRD to NED, (3, 3); it becomes that at the end.
        row: the row of the `LoopState` at the start.
        legs: legs of the mission.
        law: the record of the law.
        vehicle: the row of a `Vehicle` that is a rigid body.
        dt: time from one position to the next [s].
        path: positions (N, 3), NED [m], of which the first is that of the start.
    """
    circles_from, R_nb = len(path), mat3(R)
    speed = read_vehicle(vehicle).gains.airspeed
    for k in range(len(path) - 1):
        omega_b, row, _ = step_body(k * dt, path[k], R, row, legs, law, vehicle)
        if read_state(row).mission.goal == len(legs) - 1 and circles_from == len(path):
            circles_from = k
        R_nb, p_n = move(R_nb, vec3(path[k]), speed, omega_b, dt)
        path[k + 1, 0], path[k + 1, 1], path[k + 1, 2] = p_n
        for i in range(3):
            R[i, 0], R[i, 1], R[i, 2] = R_nb[i]
    return circles_from
