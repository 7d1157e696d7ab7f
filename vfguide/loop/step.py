"""The control loop: one step, which the aircraft, the simulation and the replay share.

No clock, no socket, no log: what a step needs are its arguments, and what it leaves is its result.
"""

from typing import NamedTuple

from vfguide.aircraft.command import GuidanceCommand
from vfguide.aircraft.state import RateSetpoint
from vfguide.aircraft.vehicle import Vehicle
from vfguide.airspace import detection
from vfguide.airspace.detection import Airspace
from vfguide.assurance import assurance
from vfguide.control import control, limits
from vfguide.estimation import estimation
from vfguide.estimation.caution import cautious
from vfguide.estimation.estimation import Inputs
from vfguide.geometry.compiled import compiled
from vfguide.guidance import laws
from vfguide.guidance.laws import Law
from vfguide.loop import mission, progress
from vfguide.loop.legs import Legs
from vfguide.loop.mission import Passage
from vfguide.loop.state import LoopState
from vfguide.planning import planning


class Outcome(NamedTuple):
    """What a step tells besides its setpoint, for displays, logs and notes."""

    command: GuidanceCommand
    """What is flown: the law's command, or an escape."""
    passage: Passage
    """How the goal that was flown to before this step was passed since."""


@compiled
def step(
    inputs: Inputs,
    s: LoopState,
    legs: Legs,
    airspace: Airspace | None,
    law: Law,
    vehicle: Vehicle,
) -> tuple[RateSetpoint, LoopState, Outcome]:
    """The setpoint for what is known now, within the limits of the aircraft.

    Args:
        inputs: what was told of the vehicle and of the air.
        s: what the step before left.
        legs: of the mission, of `leg_rows`.
        airspace: what to keep clear of; None compiles to a step that knows nothing of it.
        law: that guides.
        vehicle: the aircraft and its gains.

    Returns:
        The setpoint, what this step leaves for the next, and what it tells.
    """
    nav, estimation_state = estimation.update(inputs, s.thrust, s.estimation, vehicle)
    vehicle = cautious(nav, vehicle)
    phase, slope = s.planning.leg.phase, s.guidance.slope
    goal, mission_state, passage = mission.update(nav, s.mission, phase, legs, vehicle)
    known, detection_state = detection.update(nav, airspace, s.detection)
    route = planning.update(nav, goal, known, law.plans, s.planning, slope, vehicle)
    wanted, guidance_state = laws.update(law, nav, goal, route, known, s.guidance, vehicle)
    command, assurance_state = assurance.update(
        nav, wanted, known, law.is_assured, route.following.clearance, s.assurance, vehicle
    )
    asked, control_state = control.update(nav, command, s.control, vehicle)
    setpoint = limits.apply(asked, vehicle)
    left = progress.update(nav, goal, route.leg, command.remaining, s.progress)
    after = LoopState(
        estimation_state,
        mission_state,
        route,
        guidance_state,
        assurance_state,
        control_state,
        setpoint.thrust,
        left,
        detection_state,
    )
    return setpoint, after, Outcome(command, passage)
