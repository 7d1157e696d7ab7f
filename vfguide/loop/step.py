"""The control loop: one step, which the aircraft, the simulation and the replay share.

It has no clock, socket or log: everything it needs is an argument, everything it leaves a result.
"""

from typing import NamedTuple

from vfguide.aircraft.air_density import vehicle_in_air
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
from vfguide.guidance import laws
from vfguide.guidance.laws import Law
from vfguide.kernels.compiled import compiled
from vfguide.loop import mission, progress
from vfguide.loop.legs import Legs
from vfguide.loop.mission import Passage
from vfguide.loop.state import LoopState
from vfguide.planning import planning


class StepOutcome(NamedTuple):
    """Results of a step besides its setpoint, for displays, logs and notes."""

    command: GuidanceCommand
    """The command that is flown: the law's, or that of an escape."""
    passage: Passage
    """The passage of the goal since the step before."""


@compiled
def step(
    inputs: Inputs,
    s: LoopState,
    legs: Legs,
    airspace: Airspace | None,
    law: Law,
    vehicle: Vehicle,
) -> tuple[RateSetpoint, LoopState, StepOutcome]:
    """The setpoint of one step, within the limits of the aircraft.

    Args:
        inputs: predicted and measured state, and the density of the air.
        s: the state after the step before.
        legs: legs of the mission, from `leg_rows`.
        airspace: the hazards; None compiles to a step without them.
        law: the record of the law.
        vehicle: the aircraft at sea-level density, and its gains.

    Returns:
        The setpoint, the next state, and the outcome for displays.
    """
    vehicle = vehicle_in_air(vehicle, inputs.density)
    nav, estimation_state = estimation.update(inputs, s.thrust, s.estimation, vehicle)
    vehicle = cautious(nav, vehicle)
    phase, slope = s.planning.leg.phase, s.guidance.slope
    objective, mission_state, passage = mission.update(nav, s.mission, phase, legs, vehicle)
    known, detection_state = detection.update(nav, airspace, s.detection)
    route = planning.update(
        nav, objective, known, laws.wants_route(law, s.guidance), s.planning, slope, vehicle
    )
    wanted, guidance_state = laws.update(law, nav, objective, route, known, s.guidance, vehicle)
    command, assurance_state = assurance.update(
        nav, wanted, known, law.is_assured, route.following.clearance, s.assurance, vehicle
    )
    asked, control_state = control.update(nav, command, s.control, vehicle)
    setpoint = limits.apply(asked, vehicle)
    progress_state = progress.update(nav, objective, command, s.progress)
    after = LoopState(
        estimation_state,
        mission_state,
        route,
        guidance_state,
        assurance_state,
        control_state,
        setpoint.thrust,
        progress_state,
        detection_state,
    )
    return setpoint, after, StepOutcome(command, passage)
