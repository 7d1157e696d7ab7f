"""The stage of assurance: what guidance commands is flown only if a way out remains after it.

It knows nothing of the law that it stands above: the command, what is known to be in the way, and
how the aircraft moves are all that it looks at.
"""

import math
from typing import NamedTuple

from vfguide.aircraft.command import GuidanceCommand
from vfguide.aircraft.envelope import usable_bank
from vfguide.aircraft.path_limits import ZOOM, allowed_path, path_limits
from vfguide.aircraft.point_mass import Dynamics, PointMass
from vfguide.aircraft.state import FlightState
from vfguide.aircraft.vehicle import Vehicle
from vfguide.airspace.detection import Airspace
from vfguide.assurance.decision import (
    Assurance,
    BackupManoeuvre,
    Decision,
    Reason,
    assurance,
    assure,
    no_backup,
)
from vfguide.estimation.estimation import NavState
from vfguide.geometry.compiled import compiled
from vfguide.geometry.rows import replacing
from vfguide.geometry.vector import norm, sub
from vfguide.geometry.velocity import azimuth_of, path_of

NARROW, LEAST_ROOM = 1.25, 4.0
"""Where the way has less room than the margin times the first, the margin is less in proportion,
down to the second [m]."""
LASTING = 0.5
"""Part of the present rise or sink of the air that is expected to last while an escape is flown."""

with_flown = replacing(GuidanceCommand, "gamma", "climb", "bank", "load")
with_margin = replacing(Assurance, "margin")
with_dynamics = replacing(Assurance, "limits")
with_paths = replacing(Dynamics, "climb_max", "descent_max")


class AssuranceState(NamedTuple):
    """What one step leaves for the next."""

    backup: BackupManoeuvre
    decision: Decision


@compiled
def fresh_assurance() -> AssuranceState:
    """Nothing was decided yet."""
    return AssuranceState(no_backup(), Decision(0.0, 0.0, Reason.NOMINAL.value, 0.0, 0.0, 0))


@compiled
def update(
    nav: NavState,
    command: GuidanceCommand,
    airspace: Airspace | None,
    is_on: bool,
    room: float,
    s: AssuranceState,
    vehicle: Vehicle,
) -> tuple[GuidanceCommand, AssuranceState]:
    """The command, or what is flown instead.

    Args:
        nav: the vehicle.
        command: of guidance.
        airspace: what is known; None compiles to a stage that lets everything pass.
        is_on: whether it may decide; else everything passes.
        room: clearance with which the way was found [m], not above zero where none was.
        s: what the step before left.
        vehicle: its aircraft and gains.
    """
    if airspace is None:
        return command, s
    if not is_on:
        return command, s
    state, (aircraft, gains, _) = nav.state, vehicle
    hazards = airspace.hazards
    air = norm(sub(state.v_n, state.wind_n))
    sinking = state.wind_n[2] / max(air, 1.0)
    decision, backup = assure(
        point_mass_of(state),
        (command.bank, raised(command.gamma, -sinking)),
        (state.wind_n[0], state.wind_n[1], 0.0),
        airspace.gust,
        hazards,
        airspace.time,
        0.0 if nav.is_first else max(nav.elapsed, 0.0),
        in_air(in_room(assurance(aircraft, gains), room), sinking),
        s.backup,
    )
    limits = path_limits(air, gains.airspeed, -state.p_n[2] - hazards.floor, aircraft)
    path = allowed_path(raised(decision.gamma, sinking), limits)
    bank_max = usable_bank(aircraft, gains, max(air, state.airspeed))
    return as_decided(command, decision, path, bank_max), AssuranceState(backup, decision)


@compiled
def in_room(aircraft: Assurance, room: float) -> Assurance:
    """The assurance with a smaller margin on a way that has little room: else it forbids it."""
    part = min(1.0, room / (NARROW * aircraft.margin)) if room > 0.0 else 1.0
    margin = min(aircraft.margin, max(LEAST_ROOM, part * aircraft.margin))
    return with_margin(aircraft, margin)


@compiled
def in_air(aircraft: Assurance, sinking: float) -> Assurance:
    """The assurance in air that sinks: what the steepest climb there makes good over the ground.

    `sinking` is the speed of the air down over the airspeed, negative where it rises.
    """
    limits = aircraft.limits
    up = min(
        limits.climb_max,
        raised(limits.climb_max, (ZOOM - 1.0) * math.sin(limits.climb_max) - LASTING * sinking),
    )
    down = min(limits.descent_max, raised(limits.descent_max, LASTING * sinking))
    return with_dynamics(aircraft, with_paths(limits, up, down))


@compiled
def raised(gamma: float, sine: float) -> float:
    """A path angle whose sine is larger by `sine` [rad]."""
    return math.asin(max(-1.0, min(1.0, math.sin(gamma) + sine)))


@compiled
def point_mass_of(state: FlightState) -> PointMass:
    """The motion from which trajectories are predicted: its path angle is that over the ground."""
    air, R = sub(state.v_n, state.wind_n), state.R_nb
    speed = max(state.airspeed, 1.0)
    bank = math.atan2(R[2][1], R[2][2])
    return PointMass(state.p_n, azimuth_of(air), bank, path_of(state.v_n, speed), speed)


@compiled
def as_decided(
    command: GuidanceCommand, decision: Decision, path: tuple[float, float], bank_max: float
) -> GuidanceCommand:
    """The command, or what is flown instead: the lift carries the weight in the bank decided on.

    `path` has the path angle through the air that makes good the decision's, and the one that
    thrust is set for [rad]; the bank is no larger than `bank_max` [rad], which the wing carries
    now.
    """
    if decision.reason == Reason.NOMINAL.value:
        return command
    bank = max(-bank_max, min(bank_max, decision.bank))
    gamma, climb = path
    return with_flown(command, gamma, climb, bank, math.cos(gamma) / math.cos(bank))
