"""One aircraft, states for it, a step without a mission, and what every setpoint must keep to."""

import math
from typing import NamedTuple

from vfguide.aircraft.command import GuidanceCommand
from vfguide.aircraft.performance import Gains, Performance
from vfguide.aircraft.state import FlightState, RateSetpoint
from vfguide.aircraft.vehicle import Vehicle
from vfguide.control import control, limits
from vfguide.control.control import ControlState, fresh_control
from vfguide.estimation.estimation import known_state
from vfguide.geometry.compiled import compiled
from vfguide.geometry.so3 import from_euler
from vfguide.geometry.units import DEG
from vfguide.geometry.vector import matmul, matvec
from vfguide.guidance import flight_law
from vfguide.guidance.guidance_state import GuidanceState, fresh_guidance
from vfguide.planning import planning
from vfguide.planning.objective import GuidanceTarget, objective_at
from vfguide.planning.route import Route, fresh_route

AEROSONDE = Performance(
    airspeed_min=18.0,
    airspeed_cruise=25.0,
    airspeed_max=32.0,
    bank_max=50.0 * DEG,
    load_max=1.7,
    load_min=0.3,
    climb_max=10.0 * DEG,
    descent_max=10.0 * DEG,
    rate_max=(80.0 * DEG, 35.0 * DEG, 29.0 * DEG),
    alpha_zero=-2.48 * DEG,
    alpha_load=3493.0 * DEG,
    thrust_trim=0.3,
    thrust_per_climb=3.0,
    thrust_per_load=0.04,
    thrust_per_airspeed=0.24,
    thrust_integral=0.046,
)
GAINS = Gains(25.0)
VEHICLE = Vehicle(AEROSONDE, GAINS)
GOAL = GuidanceTarget((0.0, 0.0, -150.0), 0.5, 0.0, 0.0, 0.0)


class Memory(NamedTuple):
    """What a step leaves for the next."""

    time: float
    route: Route
    guidance: GuidanceState
    control: ControlState


@compiled
def fresh_memory() -> Memory:
    return Memory(-1.0, fresh_route(), fresh_guidance(), fresh_control())


@compiled
def guide(
    here: FlightState, target: GuidanceTarget, vehicle: Vehicle, memory: Memory
) -> tuple[RateSetpoint, Memory, GuidanceCommand]:
    """From a state that is known to a setpoint that is not limited yet: no hazards, no mission."""
    nav, goal, m = known_state(here, memory.time), objective_at(target, here), memory
    route = planning.update(nav, goal, None, True, m.route, m.guidance.slope, vehicle)
    wish, guidance = flight_law.update(nav, goal, route, None, m.guidance, vehicle)
    setpoint, controlled = control.update(nav, wish, m.control, vehicle)
    return setpoint, Memory(here.time, route, guidance, controlled), wish


@compiled
def guide_within_limits(
    here: FlightState, target: GuidanceTarget, vehicle: Vehicle, memory: Memory
) -> tuple[RateSetpoint, Memory, GuidanceCommand]:
    """The same, its setpoint limited."""
    setpoint, after, wish = guide(here, target, vehicle, memory)
    return limits.apply(setpoint, vehicle), after, wish


def state(p_n, yaw, roll=0.1, wind=(0.0, 0.0, 0.0), time=1.0):
    v_n = (25.0 * math.cos(yaw) + wind[0], 25.0 * math.sin(yaw) + wind[1], 0.5)
    return FlightState(time, p_n, v_n, from_euler(roll, 0.06, yaw), 25.0, wind)


def steps(states, target):
    memory = fresh_memory()
    for each in states:
        setpoint, memory, wish = guide(each, target, VEHICLE, memory)
    return setpoint, wish


def turned(R, each):
    return FlightState(
        each.time,
        matvec(R, each.p_n),
        matvec(R, each.v_n),
        matmul(R, each.R_nb),
        each.airspeed,
        matvec(R, each.wind_n),
    )


def is_within_limits(setpoint):
    rates = zip(setpoint.omega_b, AEROSONDE.rate_max, strict=True)
    return all(abs(rate) <= most for rate, most in rates) and 0.0 <= setpoint.thrust <= 1.0
