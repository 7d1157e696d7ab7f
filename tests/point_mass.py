"""A point-mass aeroplane that follows body rates, and `step` flying it in closed loop."""

import math
from collections.abc import Callable
from typing import NamedTuple

from loop_steps import step_told

from vfguide.aircraft.command import GuidanceCommand
from vfguide.aircraft.performance import Performance
from vfguide.aircraft.state import FlightState
from vfguide.airspace.detection import Airspace
from vfguide.companion.loop_report import goal_of_row
from vfguide.companion.plan import Plan
from vfguide.companion.route import ASSUMED_GUST
from vfguide.geometry.compiled import compiled
from vfguide.geometry.rows import Row
from vfguide.geometry.so3 import exp, from_euler
from vfguide.geometry.units import G0
from vfguide.geometry.vector import Mat3, Vec3, add, matmul, matvec, scale, sub, transpose, unit
from vfguide.loop.state import LoopState, fresh_state, row_of_state, state_of_row

RATE_LAG = 0.08
"""Of the body rates behind their setpoints [s]."""
SIDE_FORCE = 18.0
"""Lateral acceleration per sideslip [m/s^2]."""
UPDATE = 0.04
"""Time between two steps of the guidance [s]."""
SUBSTEPS = 2


class Body(NamedTuple):
    time: float
    p_n: Vec3
    air_n: Vec3
    R_nb: Mat3
    omega_b: Vec3


class Moment(NamedTuple):
    """What was flown at one update."""

    state: FlightState
    row: Row
    """Of the `LoopState` that the step left."""
    wish: GuidanceCommand

    @property
    def goal(self) -> int:
        return goal_of_row(self.row)

    @property
    def loop(self) -> LoopState:
        return state_of_row(self.row)


@compiled
def advance(body: Body, wanted_b: Vec3, wind_n: Vec3, aircraft: Performance, dt: float) -> Body:
    """Body rates lag, lift follows the angle of attack; the airspeed stays."""
    speed = math.sqrt(body.air_n[0] ** 2 + body.air_n[1] ** 2 + body.air_n[2] ** 2)
    lag = 1.0 - math.exp(-dt / RATE_LAG)
    omega = add(body.omega_b, scale(lag, sub(wanted_b, body.omega_b)))
    R_nb = matmul(body.R_nb, exp(scale(dt, omega)))
    u, v, w = matvec(transpose(R_nb), body.air_n)
    load = (math.atan2(w, u) - aircraft.alpha_zero) * speed**2 / aircraft.alpha_load
    force = matvec(R_nb, (0.0, -SIDE_FORCE * math.asin(v / speed), -load * G0))
    turned = add(body.air_n, scale(dt, add(force, (0.0, 0.0, G0))))
    air = scale(speed, unit(turned))
    p_n = add(body.p_n, scale(dt, add(scale(0.5, add(body.air_n, air)), wind_n)))
    return Body(body.time + dt, p_n, air, R_nb, omega)


def level(p_n: Vec3, heading: float, airspeed: float, aircraft: Performance) -> Body:
    """Level flight."""
    alpha = aircraft.alpha_zero + aircraft.alpha_load / airspeed**2
    air = (airspeed * math.cos(heading), airspeed * math.sin(heading), 0.0)
    return Body(0.0, p_n, air, from_euler(0.0, alpha, heading), (0.0, 0.0, 0.0))


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
        omega_b, row, wish = step_told(state, row, plan.legs, airspace, plan.law, plan.vehicle_row)
        flown.append(Moment(state, row, wish))
        for _ in range(SUBSTEPS):
            body = advance(body, omega_b, wind_n, plan.aircraft, UPDATE / SUBSTEPS)
    return flown
