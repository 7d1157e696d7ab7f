"""The step over rows of numbers, which cross quickly between Python and compiled code."""

import numpy as np

from vfguide.aircraft.state import FlightState
from vfguide.aircraft.vehicle import read_vehicle
from vfguide.airspace.detection import AirspaceTuple, airspace_of
from vfguide.earth.geodesy import tangent_plane
from vfguide.estimation.estimation import Inputs, exact_inputs
from vfguide.estimation.local_frame import (
    Measurement,
    MeasurementTuple,
    Quaternion,
    measured_in,
    place_in,
)
from vfguide.geometry.vector import ZERO, Matrix, Vec3, Vector, mat3, matvec
from vfguide.guidance.laws import Law, law_of
from vfguide.kernels.compiled import compiled
from vfguide.kernels.rows import Row
from vfguide.loop.legs import Legs
from vfguide.loop.state import read_state, write_state
from vfguide.loop.step import step


@compiled
def step_measured(
    measured: MeasurementTuple,
    origin: Vec3,
    before: Row,
    legs: Legs,
    airspace: AirspaceTuple | None,
    law: Law | None,
    vehicle: Row,
) -> tuple[Vec3, float, Quaternion, Row, float]:
    """A step on a measurement of an autopilot.

    Args:
        measured: a `Measurement`, as a plain tuple: a named one takes longer to cross.
        origin: latitude, longitude [rad] and altitude [m] of the origin of the plan's frame.
        before: a `LoopState`.
        legs: legs of the mission.
        airspace: the hazards, from `unnested_airspace`, or None.
        law: the law that guides, as `crossing` gives it.
        vehicle: a `Vehicle`.

    Returns:
        Body rates [rad/s], thrust, reference attitude, the next state, and the miss of a goal
        that was passed [m].
    """
    measurement = Measurement(*measured)
    plane = tangent_plane(origin[0], origin[1], origin[2])
    predicted, here = place_in(measurement, plane), measured_in(measurement, plane)
    inputs = Inputs(
        predicted, here, measurement.omega_b, False, measurement.lead, measurement.density
    )
    state, aircraft = read_state(before), read_vehicle(vehicle)
    known, guides = airspace_of(airspace), law_of(law)
    setpoint, left, outcome = step(inputs, state, legs, known, guides, aircraft)
    after = np.empty(len(before))
    write_state(left, after)
    return setpoint.omega_b, setpoint.thrust, setpoint.q_nb, after, outcome.passage.miss


@compiled
def step_body(
    time: float, p: Vector, R: Matrix, before: Row, legs: Legs, law: Law, vehicle: Row
) -> tuple[Vec3, Row, float]:
    """A step for a rigid body whose state is known.

    It flies at the airspeed of its gains, where its nose points.

    Args:
        time: time [s].
        p: position (3,), NED [m].
        R: attitude (3, 3), body to NED.
        before: a `LoopState`.
        legs: legs of the mission.
        law: the record of the law.
        vehicle: a `Vehicle` that is a point.

    Returns:
        Body rates [rad/s], the next state, and the miss of a goal that was passed [m].
    """
    body, R_nb = read_vehicle(vehicle), mat3(R)
    speed = body.gains.airspeed
    v_n = matvec(R_nb, (speed, 0.0, 0.0))
    state = FlightState(time, (p[0], p[1], p[2]), v_n, R_nb, speed, ZERO)
    setpoint, left, outcome = step(exact_inputs(state), read_state(before), legs, None, law, body)
    after = np.empty(len(before))
    write_state(left, after)
    return setpoint.omega_b, after, outcome.passage.miss
