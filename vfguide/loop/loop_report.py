"""What displays, logs and notes take from the state of the loop."""

from typing import NamedTuple

from vfguide.estimation.air_state import AirReport, report_air
from vfguide.kernels.compiled import compiled
from vfguide.kernels.rows import Row, getter, part_reader
from vfguide.loop.state import LoopState

goal_of_row = getter(LoopState, "mission.goal")
"""Index of the goal that is flown to, from 0."""
decision_of_row = getter(LoopState, "assurance.decision")
"""What the assurance decided last."""
reason_of_row = getter(LoopState, "assurance.decision.reason")
"""The `Reason` of the last decision alone."""
route_of_row = getter(LoopState, "planning.following")
"""The route around hazards."""
sought_of_row = getter(LoopState, "planning.following.sought")
"""Time of the last search for a route [s]."""
looked_of_row = getter(LoopState, "planning.following.looked")
"""Time of the last check of the route [s]."""
number_of_resets = getter(LoopState, "estimation.resets.number")
"""How often the position has jumped."""
leader_of_row = getter(LoopState, "guidance.progress.leader")
"""The `Leader` of the last step of law `field`."""
is_alarmed = getter(LoopState, "progress.alarmed")
"""Whether there is no progress on the leg."""
trusts_sensor_of_row = getter(LoopState, "estimation.air.sensor.trusted")
"""Whether the airspeed sensor is flown on."""

_consistency = getter(LoopState, "estimation.consistency")
_air = part_reader(LoopState, "estimation.air")
_decision = part_reader(LoopState, "assurance.decision")
_leader = part_reader(LoopState, "guidance.progress.leader")
_resets = part_reader(LoopState, "estimation.resets.number")
_holds = part_reader(LoopState, "mission.wind_hold.holds")
_alarmed = part_reader(LoopState, "progress.alarmed")
_trusts = part_reader(LoopState, "estimation.air.sensor.trusted")
_air_time = part_reader(LoopState, "estimation.air.time")
_yaw_doubt = part_reader(LoopState, "estimation.consistency.yaw_doubt")
_velocity_doubt = part_reader(LoopState, "estimation.consistency.velocity_doubt")
_wind_doubt = part_reader(LoopState, "estimation.consistency.air.wind_doubt")
_airspeed_doubt = part_reader(LoopState, "estimation.consistency.air.airspeed_doubt")
_attitude_doubt = part_reader(LoopState, "estimation.consistency.attitude_doubt")


class Noted(NamedTuple):
    """What records keep of one step."""

    wind_north: float
    """Wind toward north [m/s]."""
    wind_east: float
    """Wind toward east [m/s]."""
    wind_sigma: float
    """Standard deviation of the wind [m/s]."""
    airspeed: float
    """True airspeed [m/s]."""
    airspeed_sigma: float
    """Standard deviation of the airspeed [m/s]."""
    reason: float
    """The `Reason` of the assurance's decision."""
    margin: float
    """Least clearance along its escape [m]."""
    conflict: float
    """Time until the command, if held, would hit a hazard [s]; infinite if never."""
    hazard: float
    """Number of that hazard; -1 for none."""
    leader: float
    """The `Leader` of the step, in law `field`."""


class Doubts(NamedTuple):
    """For how long each thing that the autopilot reports is doubted [s]; 0: it is believed."""

    yaw: float
    velocity: float
    """Velocity over ground."""
    wind: float
    airspeed: float
    attitude: float
    """Roll and pitch."""


def doubts_of_row(row: Row) -> Doubts:
    """What is doubted."""
    s = _consistency(row)
    air = s.air
    return Doubts(
        s.yaw_doubt, s.velocity_doubt, air.wind_doubt, air.airspeed_doubt, s.attitude_doubt
    )


@compiled
def changes(before: Row, after: Row) -> tuple[bool, bool]:
    """Whether anything is or was doubted, and `has_news`: whether there is anything to annunciate.

    This one call of compiled code at each step takes less time than `doubts_of_row`.
    """
    return is_in_doubt(after) or is_in_doubt(before), has_news(before, after)


@compiled
def is_in_doubt(row: Row) -> bool:
    """Whether anything is doubted."""
    return (
        _yaw_doubt(row) > 0.0
        or _velocity_doubt(row) > 0.0
        or _wind_doubt(row) > 0.0
        or _airspeed_doubt(row) > 0.0
        or _attitude_doubt(row) > 0.0
    )


@compiled
def air_report(row: Row) -> AirReport:
    """The estimate of the air, from the row of a `LoopState`."""
    return report_air(_air(row))


@compiled
def noted_numbers(row: Row) -> tuple[float, ...]:
    """The numbers of `Noted` in one call of compiled code, a plain tuple: made at every update."""
    air, decision = report_air(_air(row)), _decision(row)
    return (
        air.wind_north,
        air.wind_east,
        air.wind_sigma,
        air.airspeed,
        air.airspeed_sigma,
        float(decision.reason),
        decision.margin,
        decision.conflict,
        float(decision.hazard),
        float(_leader(row)),
    )


@compiled
def has_news(before: Row, after: Row) -> bool:
    """Whether a step changed what the operator reads of air, jumps, progress and who leads."""
    return (
        _air_time(before) < 0.0
        or _resets(after) != _resets(before)
        or _holds(after) != _holds(before)
        or _alarmed(after) != _alarmed(before)
        or _leader(after) != _leader(before)
        or _trusts(after) != _trusts(before)
    )
