"""A step of planning, guidance and control, without a mission."""

from typing import NamedTuple

from flight_states import VEHICLE

from vfguide.aircraft.command import GuidanceCommand
from vfguide.aircraft.state import FlightState, RateSetpoint
from vfguide.aircraft.vehicle import Vehicle
from vfguide.control import control, limits
from vfguide.control.control import ControlState, fresh_control
from vfguide.estimation.estimation import known_state
from vfguide.guidance import flight_law
from vfguide.guidance.guidance_state import GuidanceState, fresh_guidance
from vfguide.kernels.compiled import compiled
from vfguide.planning import planning
from vfguide.planning.objective import GuidanceTarget, objective_at
from vfguide.planning.route import Route, fresh_route


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


def steps(states, target):
    memory = fresh_memory()
    for each in states:
        setpoint, memory, wish = guide(each, target, VEHICLE, memory)
    return setpoint, wish
