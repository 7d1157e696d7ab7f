"""A point-mass aeroplane that follows body rates, and `step` flying it in closed loop."""

import math
from collections.abc import Callable
from typing import NamedTuple

from loop_steps import step_told
from rate_body import Body, advance

from vfguide.aircraft.command import GuidanceCommand
from vfguide.aircraft.state import FlightState
from vfguide.airspace.detection import Airspace
from vfguide.companion.guided_flight import ASSUMED_GUST
from vfguide.companion.plan import Plan
from vfguide.geometry.vector import Vec3, add
from vfguide.kernels.rows import Row
from vfguide.loop.loop_report import goal_of_row
from vfguide.loop.state import LoopState, fresh_state, row_of_state, state_of_row

UPDATE = 0.04
"""Time between two steps of the guidance [s]."""
SUBSTEPS = 2


class Moment(NamedTuple):
    """What was flown at one update."""

    state: FlightState
    row: Row
    """Of the `LoopState` that the step left."""
    command: GuidanceCommand

    @property
    def goal(self) -> int:
        return goal_of_row(self.row)

    @property
    def loop(self) -> LoopState:
        return state_of_row(self.row)


def fly(
    body: Body,
    plan: Plan,
    wind_n: Vec3,
    seconds: float,
    until: Callable[[Moment], bool] = lambda moment: False,
    loop: LoopState | None = None,
) -> list[Moment]:
    """The flight, a moment an update, until a time or until something is so.

    It goes on from the state of a `loop`, or begins.
    """
    known = 0 if plan.hazards is None else len(plan.hazards.obstacles)
    flown, airspeed = list[Moment](), math.hypot(*body.air_n)
    row = row_of_state(fresh_state(known) if loop is None else loop)
    while body.time < seconds and not (flown and until(flown[-1])):
        v_n = add(body.air_n, wind_n)
        state = FlightState(body.time, body.p_n, v_n, body.R_nb, airspeed, wind_n)
        airspace = None
        if plan.hazards is not None:
            airspace = Airspace(plan.hazards, plan.fence, body.time, ASSUMED_GUST)
        omega_b, row, command = step_told(
            state, row, plan.legs, airspace, plan.law, plan.vehicle_row
        )
        flown.append(Moment(state, row, command))
        for _ in range(SUBSTEPS):
            body = advance(body, omega_b, wind_n, plan.aircraft, UPDATE / SUBSTEPS)
    return flown
