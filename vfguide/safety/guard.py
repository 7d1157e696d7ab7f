"""The flight law with hazards: what it wishes is flown only if a way out remains after it."""

import math
from typing import NamedTuple

import numpy as np
from numpy.typing import NDArray

from vfguide.field.near import distance_bound
from vfguide.field.obstacle import Rows, obstacle_distance, put_out_of_sight, read_obstacle
from vfguide.flight.detour import CLEARANCES
from vfguide.flight.detour_leg import CLEARANCE, SHIFTED, DetourState
from vfguide.flight.guidance import azimuth_of, fly_wish, path_of, plan_flight
from vfguide.flight.horizontal import usable_bank
from vfguide.flight.memory import Memory, Target, Wish, with_leg
from vfguide.flight.outlines import Outlines, joined
from vfguide.flight.passing import band_of
from vfguide.flight.performance import Law, unpacked
from vfguide.flight.state import FlightState, RateSetpoint
from vfguide.flight.vertical import ZOOM, allowed_path, path_limits
from vfguide.flight.way_round import Journey, Scene, heights_of, seek_way
from vfguide.geometry.compiled import compiled
from vfguide.geometry.vector import Vec3, norm, sub
from vfguide.safety.assurance import Assurance, Decision, Reason, Stored, assurance, assure
from vfguide.safety.hazards import Hazards, traffic_outlines
from vfguide.safety.limits import limit_setpoint
from vfguide.safety.motion import Dynamics, Motion

SIDE, TURNING, CLIMB, ACTING = 0, 1, 2, 3
"""Places of what the last decision stored."""
REASON, LEAST, CONFLICT, HAZARD = 4, 5, 6, 7
"""Places of the last decision itself."""
KNOWN = 8
"""First of as many places as there are obstacles: 1 once they are known."""

GuardState = NDArray[np.float64]
"""(KNOWN + M,), what the guard remembers."""
NARROW, LEAST_ROOM = 1.25, 4.0
"""Where the way has less room than the margin times the first, the margin is less in proportion,
down to the second [m]."""
LASTING = 0.5
"""Part of the present rise or sink of the air that is expected to last while an escape is flown."""


class Watch(NamedTuple):
    """What the guard looks at."""

    hazards: Hazards
    """All of the plan, known or not."""
    fence: Outlines
    """The fence as the search for ways takes it."""
    time: float
    """On the clock of the obstacles [s]."""
    gust: float
    """Speed of the gusts, one standard deviation [m/s]."""


@compiled
def fresh_guard(obstacles: int) -> GuardState:
    """Nothing decided, no obstacle known."""
    return np.zeros(KNOWN + obstacles)


@compiled
def guide_clear(
    state: FlightState,
    flown_in: FlightState,
    target: Target,
    law: Law,
    memory: Memory,
    watch: Watch,
    guard: GuardState,
    detour: DetourState,
) -> tuple[RateSetpoint, Memory, Wish]:
    """One step of the flight law that leaves a way out; fills `guard` and `detour`.

    Args:
        state: of the vehicle.
        flown_in: the same in the frame that the flight law flies in.
        target: what it flies to.
        law: aircraft and gains, of `packed`.
        memory: of the step before.
        watch: what to keep clear of.
        guard: what was decided at the step before.
        detour: that is flown.
    """
    aircraft, gains = unpacked(law)
    hazards = in_sight(watch.hazards, guard, state.p_n, watch.time)
    leg = memory.leg
    if target.circle == 0.0:
        journey = Journey(state, target, aircraft, gains)
        shut, highest = watch.fence, CLEARANCES[0] - hazards.ceiling
        if len(hazards.traffic) > 0:
            band = band_of(heights_of(journey, detour))
            moving = traffic_outlines(hazards.traffic, band, CLEARANCES[0], watch.time)
            shut, highest = joined(shut, moving), math.inf
        scene = Scene(hazards.obstacles, shut, highest, watch.time)
        leg = seek_way(journey, leg, scene, detour)
    with_way, above = with_leg(memory, leg), -state.p_n[2] - hazards.floor
    wish, planned = plan_flight(flown_in, target, aircraft, gains, with_way, detour, above)
    if planned.leg.phase != leg.phase or planned.leg.way.x != leg.way.x:
        detour[SHIFTED] = 1.0
    room = detour[CLEARANCE]
    wish = assured(state, wish, hazards, watch, law, memory.time, room, guard)
    setpoint, after = fly_wish(flown_in, wish, aircraft, gains, planned)
    return limit_setpoint(setpoint, aircraft), after, wish


@compiled
def assured(
    state: FlightState,
    wish: Wish,
    hazards: Hazards,
    watch: Watch,
    law: Law,
    before: float,
    room: float,
    guard: GuardState,
) -> Wish:
    """The wish, or what is flown instead.

    `before` is the time of the step before [s], `room` the clearance of the way that was found
    [m], not above zero where there is none.
    """
    aircraft, gains = unpacked(law)
    air = norm(sub(state.v_n, state.wind_n))
    sinking = state.wind_n[2] / max(air, 1.0)
    decision, stored = assure(
        motion_of(state),
        (wish.bank, raised(wish.gamma, -sinking)),
        (state.wind_n[0], state.wind_n[1], 0.0),
        watch.gust,
        hazards,
        watch.time,
        0.0 if before < 0.0 else max(state.time - before, 0.0),
        in_air(in_room(assurance(aircraft, gains), room), sinking),
        Stored(guard[SIDE], guard[TURNING], guard[CLIMB], guard[ACTING]),
    )
    note_decision(guard, decision, stored)
    limits = path_limits(air, gains.airspeed, -state.p_n[2] - hazards.floor, aircraft)
    path = allowed_path(raised(decision.gamma, sinking), limits)
    bank_max = usable_bank(aircraft, gains, max(air, state.airspeed))
    return as_decided(wish, decision, path, bank_max)


@compiled
def in_room(aircraft: Assurance, room: float) -> Assurance:
    """The assurance with a smaller margin on a way that has little room: else it forbids it."""
    part = min(1.0, room / (NARROW * aircraft.margin)) if room > 0.0 else 1.0
    margin = min(aircraft.margin, max(LEAST_ROOM, part * aircraft.margin))
    return Assurance(aircraft.limits, aircraft.scale, margin)


@compiled
def in_air(aircraft: Assurance, sinking: float) -> Assurance:
    """The assurance in air that sinks: what the steepest climb there makes good over the ground.

    `sinking` is the speed of the air down over the airspeed, negative where it rises.
    """
    its = aircraft.limits
    up = min(
        its.climb_max,
        raised(its.climb_max, (ZOOM - 1.0) * math.sin(its.climb_max) - LASTING * sinking),
    )
    down = min(its.descent_max, raised(its.descent_max, LASTING * sinking))
    limits = Dynamics(its.bank_max, up, down, its.roll_rate, its.bank_lag, its.path_lag)
    return Assurance(limits, aircraft.scale, aircraft.margin)


@compiled
def raised(gamma: float, sine: float) -> float:
    """A path angle whose sine is larger by `sine` [rad]."""
    return math.asin(max(-1.0, min(1.0, math.sin(gamma) + sine)))


@compiled
def motion_of(state: FlightState) -> Motion:
    """The motion from which tracks are predicted: its path angle is that over the ground."""
    air, R = sub(state.v_n, state.wind_n), state.R_nb
    speed = max(state.airspeed, 1.0)
    bank = math.atan2(R[2][1], R[2][2])
    return Motion(state.p_n, azimuth_of(air), bank, path_of(state.v_n, speed), speed)


@compiled
def in_sight(hazards: Hazards, guard: GuardState, p_n: Vec3, t: float) -> Hazards:
    """The hazards with every obstacle that is not known yet out of the way; once known stays so."""
    obstacles = hazards.obstacles
    if len(obstacles) == 0:
        return hazards
    seen = obstacles.copy()
    for i in range(len(obstacles)):
        if guard[KNOWN + i] == 0.0 and comes_into_sight(obstacles, i, p_n, t):
            guard[KNOWN + i] = 1.0
        if guard[KNOWN + i] == 0.0:
            put_out_of_sight(seen[i])
    return Hazards(seen, hazards.traffic, hazards.fences, hazards.floor, hazards.ceiling)


@compiled
def comes_into_sight(obstacles: Rows, i: int, p_n: Vec3, t: float) -> bool:
    """Whether obstacle `i` is near enough to be seen from `p_n` (NED)."""
    visible_from = read_obstacle(obstacles[i]).visible_from
    if distance_bound(obstacles, i, p_n, t) > visible_from:
        return False
    return obstacle_distance(obstacles, i, p_n, t) <= visible_from


@compiled
def note_decision(guard: GuardState, decision: Decision, stored: Stored) -> None:
    """Fill the places of the guard."""
    guard[SIDE], guard[TURNING] = stored.side, stored.turning
    guard[CLIMB], guard[ACTING] = stored.climb, stored.acting
    guard[REASON], guard[LEAST] = float(decision.reason), decision.margin
    guard[CONFLICT], guard[HAZARD] = decision.conflict, float(decision.hazard)


@compiled
def as_decided(wish: Wish, decision: Decision, path: tuple[float, float], bank_max: float) -> Wish:
    """The wish, or what is flown instead: the lift carries the weight in the bank decided on.

    `path` has the path angle through the air that makes good the decision's, and the one that
    thrust is set for [rad]; the bank is no larger than `bank_max` [rad], which the wing carries
    now.
    """
    if decision.reason == Reason.CLEAR.value:
        return wish
    bank = max(-bank_max, min(bank_max, decision.bank))
    gamma, climb = path
    load = math.cos(gamma) / math.cos(bank)
    return Wish(
        wish.course,
        wish.azimuth,
        gamma,
        climb,
        bank,
        load,
        wish.remaining,
        wish.phase,
        wish.radius,
    )
