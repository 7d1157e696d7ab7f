"""Steps of the loop for a state that is told, quick enough for whole flights from Python."""

import numpy as np

from vfguide.aircraft.command import GuidanceCommand
from vfguide.aircraft.state import FlightState
from vfguide.aircraft.vehicle import read_vehicle
from vfguide.airspace.detection import Airspace
from vfguide.earth.atmosphere import DENSITY_0
from vfguide.estimation.estimation import Inputs
from vfguide.geometry.so3 import log
from vfguide.geometry.vector import ZERO, Vec3, matmul, scale, transpose
from vfguide.guidance.laws import Law
from vfguide.kernels.compiled import compiled
from vfguide.kernels.rows import Row
from vfguide.loop.legs import Legs
from vfguide.loop.state import read_state, write_state
from vfguide.loop.step import step


@compiled
def step_told(
    state: FlightState, before: Row, legs: Legs, airspace: Airspace | None, law: Law, vehicle: Row
) -> tuple[Vec3, Row, GuidanceCommand]:
    """Body rates, the row of what the step left, and what was flown; nothing is predicted.

    The measured body rates are those with which the attitude has turned since the step before.
    """
    s = read_state(before)
    seen, omega_b = s.estimation.consistency, ZERO
    if 0.0 <= seen.time < state.time:
        turn = log(matmul(transpose(seen.attitude.R_nb), state.R_nb))
        omega_b = scale(1.0 / (state.time - seen.time), turn)
    inputs = Inputs(state, state, omega_b, False, 0.0, DENSITY_0)
    setpoint, left, outcome = step(inputs, s, legs, airspace, law, read_vehicle(vehicle))
    after = np.empty(len(before))
    write_state(left, after)
    return setpoint.omega_b, after, outcome.command
