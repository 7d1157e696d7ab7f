"""The state of the control loop: one record, with a branch for each stage.

As a row of numbers it crosses quickly between Python and compiled code.
"""

from typing import NamedTuple

import numpy as np

from vfguide.aircraft.performance import Performance
from vfguide.airspace.detection import DetectionState
from vfguide.assurance.assurance import AssuranceState, fresh_assurance
from vfguide.control.control import ControlState, fresh_control
from vfguide.estimation.air_state import without_model_error
from vfguide.estimation.estimation import EstimationState, fresh_estimation
from vfguide.guidance.guidance_state import GuidanceState, fresh_guidance
from vfguide.kernels.rows import Row, flattener, python_reader, reader, writer
from vfguide.loop.attempts import Attempts, at_next, no_attempts
from vfguide.loop.mission import MissionState, fresh_mission
from vfguide.loop.progress import Progress, fresh_progress
from vfguide.planning.route import Route, fresh_route


class LoopState(NamedTuple):
    """The states of all stages."""

    estimation: EstimationState
    mission: MissionState
    planning: Route
    guidance: GuidanceState
    assurance: AssuranceState
    control: ControlState
    thrust: float
    """Thrust setpoint of the last step, 0 to 1."""
    progress: Progress
    detection: DetectionState


read_state, write_state = reader(LoopState), writer(LoopState)
state_of_row = python_reader(LoopState)
"""Reader of the row of a `LoopState` in Python; its arrays are views of the row."""
_numbers = flattener(LoopState)


def row_of_state(s: LoopState) -> Row:
    """The row of a state."""
    return np.array(_numbers(s))


def fresh_state(obstacles: int = 0) -> LoopState:
    """The state of a vehicle before its first step, among `obstacles` obstacles."""
    return LoopState(
        fresh_estimation(),
        fresh_mission(),
        fresh_route(),
        fresh_guidance(),
        fresh_assurance(),
        fresh_control(),
        0.0,
        fresh_progress(),
        DetectionState(np.zeros(obstacles)),
    )


def begin_leg(s: LoopState, goal: int, attempts: Attempts) -> LoopState:
    """The state at the start of a leg; what was learned in flight stays."""
    return s._replace(
        estimation=s.estimation._replace(is_continuous=False),
        mission=s.mission._replace(goal=goal, attempts=attempts),
        planning=fresh_route(),
        progress=fresh_progress(),
    )


def leave_goal(s: LoopState) -> LoopState:
    """The state at the start of the next leg, the present goal given up."""
    return begin_leg(s, s.mission.goal + 1, at_next(s.mission.attempts, True))


def watching(before: Row, after: Row) -> Row:
    """The row `before`, with the doubts of the step that led to `after`.

    No more of a step is kept while the autopilot does not follow setpoints.
    """
    s, estimation = state_of_row(before), state_of_row(after).estimation
    kept = s.estimation._replace(consistency=estimation.consistency)
    return row_of_state(s._replace(estimation=kept))


def take_over(s: LoopState) -> LoopState:
    """The state when the autopilot begins to follow setpoints: mission, air and doubts are kept."""
    estimation = fresh_estimation()._replace(
        air=s.estimation.air, consistency=s.estimation.consistency
    )
    return s._replace(
        estimation=estimation,
        planning=fresh_route(),
        guidance=fresh_guidance(),
        control=fresh_control(),
        progress=fresh_progress(),
    )


def begin_mission(s: LoopState) -> LoopState:
    """The state at the start of another mission; the estimate of the air stays."""
    return take_over(begin_leg(s, 0, no_attempts()))


def forget_learned(s: LoopState, before: Performance, after: Performance) -> LoopState:
    """The state without learned corrections of parameters that have changed."""
    if before == after:
        return s
    control, air = s.control, without_model_error(s.estimation.air)
    if (after.alpha_zero, after.alpha_load) != (before.alpha_zero, before.alpha_load):
        control = control._replace(alpha_bias=0.0)
    if after.thrust_trim != before.thrust_trim:
        control = control._replace(thrust_integral=0.0)
    return s._replace(estimation=s.estimation._replace(air=air), control=control)
