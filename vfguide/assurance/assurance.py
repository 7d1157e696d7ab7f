"""The stage of assurance: a command of guidance is flown only if an escape remains after it.

It is the monitor and the recovery function of a run-time assurance (ASTM F3269). It knows nothing
of the law that it guards: it sees the command, the known hazards and the motion of the aircraft.
"""

import math
from typing import NamedTuple

from vfguide.aircraft.command import GuidanceCommand, unknown_rates
from vfguide.aircraft.envelope import usable_bank
from vfguide.aircraft.path_limits import ZOOM_RATIO, allowed_path, path_limits
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
from vfguide.geometry.so3 import bank_angle
from vfguide.geometry.vector import norm, sub
from vfguide.geometry.velocity import azimuth_of, path_of
from vfguide.kernels.compiled import compiled
from vfguide.kernels.rows import replacing

NARROW_ROUTE = 1.25
"""Ratio of the clearance of a route to the margin below which the margin becomes smaller in
proportion; tuned with `tools/measure_avoidance.py`: with the whole margin, narrow routes were
planned and left again and again."""
LEAST_ROOM = 4.0
"""Least margin on a narrow route [m]; tuned with `tools/measure_avoidance.py`."""
LASTING = 0.5
"""Share of the present vertical wind that is taken to last during an escape; tuned with
`tools/measure_avoidance.py`: with all of it nothing improved."""

with_flown = replacing(GuidanceCommand, "gamma", "climb", "bank", "load", "rates")
with_margin = replacing(Assurance, "margin")
with_dynamics = replacing(Assurance, "limits")
with_paths = replacing(Dynamics, "climb_max", "descent_max")


class AssuranceState(NamedTuple):
    """What the assurance keeps from one step to the next."""

    backup: BackupManoeuvre
    """The escape that the last decision stored."""
    decision: Decision
    """The last decision, for displays and logs."""


@compiled
def fresh_assurance() -> AssuranceState:
    """The state of the assurance before the first decision."""
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
    """The command, or the escape that is flown instead, and the next state.

    Args:
        nav: state of the vehicle.
        command: the command of guidance.
        airspace: the known hazards; None compiles to a stage that passes every command.
        is_on: whether it decides; else every command passes.
        room: clearance with which the route was found [m], 0 or less where none was.
        s: state of the step before.
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
    """The assurance with a smaller margin on a narrow route, which it would forbid otherwise.

    `room` is the clearance with which the route was found [m], 0 or less where none was.
    """
    part = min(1.0, room / (NARROW_ROUTE * aircraft.margin)) if room > 0.0 else 1.0
    margin = min(aircraft.margin, max(LEAST_ROOM, part * aircraft.margin))
    return with_margin(aircraft, margin)


@compiled
def in_air(aircraft: Assurance, sinking: float) -> Assurance:
    """The assurance with the path angles over ground that remain in air that sinks.

    `sinking` is the ratio of the downward wind to the airspeed, negative where the air rises.
    """
    limits = aircraft.limits
    up = min(
        limits.climb_max,
        raised(
            limits.climb_max, (ZOOM_RATIO - 1.0) * math.sin(limits.climb_max) - LASTING * sinking
        ),
    )
    down = min(limits.descent_max, raised(limits.descent_max, LASTING * sinking))
    return with_dynamics(aircraft, with_paths(limits, up, down))


@compiled
def raised(gamma: float, sine: float) -> float:
    """The path angle [rad] whose sine is that of `gamma` plus `sine`."""
    return math.asin(max(-1.0, min(1.0, math.sin(gamma) + sine)))


@compiled
def point_mass_of(state: FlightState) -> PointMass:
    """The point mass from which trajectories are predicted.

    The sine of its path angle is the vertical speed over ground, over the airspeed.
    """
    air, bank = sub(state.v_n, state.wind_n), bank_angle(state.R_nb)
    speed = max(state.airspeed, 1.0)
    return PointMass(state.p_n, azimuth_of(air), bank, path_of(state.v_n, speed), speed)


@compiled
def as_decided(
    command: GuidanceCommand, decision: Decision, path: tuple[float, float], bank_max: float
) -> GuidanceCommand:
    """The command of guidance, or that of the escape, whose lift carries the weight at its bank.

    Args:
        command: the command of guidance.
        decision: what the assurance decided.
        path: path angle through the air that makes good the decision's, and the one that thrust is
            set for [rad].
        bank_max: largest bank that the wing carries now [rad].
    """
    if decision.reason == Reason.NOMINAL.value:
        return command
    bank = max(-bank_max, min(bank_max, decision.bank))
    gamma, climb = path
    return with_flown(
        command, gamma, climb, bank, math.cos(gamma) / math.cos(bank), unknown_rates()
    )
