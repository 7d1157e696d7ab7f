"""The one step that the aircraft, the simulation and the replay share.

No clock, no socket, no log. `step` takes a flight state; `step_on` takes what a link delivers and
is what runs in flight: one call of compiled code that only tuples and arrays cross into.
"""

import math
from typing import NamedTuple

from vfguide.companion.jump import follow_jumps, settled, smoothed
from vfguide.companion.legs import Goal, Legs, goal_of, target_of
from vfguide.companion.place import Heard, place_state, place_told
from vfguide.companion.progress import Progress, after_step
from vfguide.companion.route_memory import (
    PackedMemory,
    RouteMemory,
    begin_leg,
    leave_goal,
    packed_memory,
    unpacked_memory,
)
from vfguide.companion.tries import NEAR, at_next, gives_up, once_more
from vfguide.flight.air_data import cautious, sense_air
from vfguide.flight.air_state import with_thrust
from vfguide.flight.leg import FIELD, Leg
from vfguide.flight.memory import Wish
from vfguide.flight.outlines import Outlines
from vfguide.flight.performance import Law, unpacked, with_gains
from vfguide.flight.rising_air import feel_rise
from vfguide.flight.state import FlightState, RateSetpoint
from vfguide.flight.strong_wind import in_air_frame, into_wind, stand_against
from vfguide.geometry.angles import wrap
from vfguide.geometry.compiled import compiled
from vfguide.geometry.rows import replacing
from vfguide.geometry.vector import Vec3, dot, norm, scale, sub
from vfguide.safety.guard import Watch, guide_clear
from vfguide.safety.hazards import Hazards
from vfguide.safety.limits import guide_within_limits

Quaternion = tuple[float, float, float, float]

GUST = 1.0
"""Speed of the gusts that tracks are predicted for, one standard deviation [m/s]: nothing tells the
true one."""


class Passage(NamedTuple):
    """How a goal was passed between two steps; infinite where it was not."""

    miss: float
    """Where the distance was least [m]."""
    angle: float
    """The larger error of course and climb of the ground velocity [rad]."""


NO_PASSAGE = Passage(math.inf, math.inf)

with_air = replacing(RouteMemory, "air")


@compiled
def step(
    state: FlightState,
    legs: Legs,
    law: Law,
    memory: RouteMemory,
    hazards: Hazards | None,
    fence: Outlines,
    t: float,
) -> tuple[RateSetpoint, RouteMemory, Wish, Passage]:
    """The setpoint for this state, within the limits of the aircraft.

    Args:
        state: of the vehicle.
        legs: of `leg_rows`.
        law: aircraft and gains, of `packed`.
        memory: of the step before.
        hazards: what to keep clear of; None compiles to a step that knows nothing of it.
        fence: its zones as the search for ways takes them.
        t: on the clock of the obstacles [s].

    Returns:
        The setpoint, the memory for the next step, what the law wished for, and how the goal
        that was flown to before this step was passed since.
    """
    aircraft, gains = unpacked(law)
    state, air = sense_air(state, memory.air, aircraft, gains.airspeed)
    gains = cautious(gains, air, aircraft)
    law = with_gains(law, gains)
    dt = state.time - memory.flight.time if memory.begun else 0.0
    jumps = follow_jumps(memory.jumps, (memory.p_n, memory.v_n), state, dt)
    state = smoothed(state, jumps)
    stand = stand_against(memory.stand, state, gains.airspeed, dt)
    passage = passage_since(memory, state, legs)
    if stand.holds or not settled(jumps):
        passage = NO_PASSAGE
    memory = note_passage(passage, legs, memory)
    if memory.stand.holds and not stand.holds:
        memory = begin_leg(memory.goal, memory.tries, memory)
    if stand.holds:
        flown_in, target = in_air_frame(state), into_wind(stand, state)
    else:
        flown_in, target = state, target_of(legs, memory.goal)
    guard, detour = memory.guard, memory.detour
    if hazards is None:
        setpoint, flight, wish = guide_within_limits(flown_in, target, law, memory.flight)
    else:
        guard, detour = guard.copy(), detour.copy()
        watch = Watch(hazards, fence, t, GUST)
        setpoint, flight, wish = guide_clear(
            state, flown_in, target, law, memory.flight, watch, guard, detour
        )
    progress = memory.progress
    if not stand.holds:
        progress = progress_since(memory, state, wish, flight.leg, legs)
    air = with_thrust(air, setpoint.thrust)
    kept = (jumps, stand, memory.tries, progress, air, guard, detour)
    after = RouteMemory(memory.goal, True, state.p_n, state.v_n, flight, *kept)
    return setpoint, after, wish, passage


@compiled
def step_on(
    heard: Heard,
    origin: Vec3,
    legs: Legs,
    law: Law,
    memory: PackedMemory,
    hazards: Hazards | None,
    fence: Outlines,
    t: float,
) -> tuple[Vec3, float, Quaternion, PackedMemory, float]:
    """`step` for what the autopilot said, in the tangent plane at `origin`.

    Returns:
        Body rates [rad/s], thrust, reference attitude, memory, and the miss of the passage [m].
    """
    state, before = place_state(heard, origin), unpacked_memory(memory)
    air = feel_rise(place_told(heard, origin), before.air, unpacked(law)[0])
    before = with_air(before, air)
    setpoint, after, _, passage = step(state, legs, law, before, hazards, fence, t)
    miss = passage.miss
    return setpoint.omega_b, setpoint.thrust, setpoint.q_nb, packed_memory(after), miss


@compiled
def note_passage(passage: Passage, legs: Legs, memory: RouteMemory) -> RouteMemory:
    """Go on when the goal was reached or is given up, begin the leg anew when it was missed."""
    if math.isinf(passage.miss):
        return memory
    goal = goal_of(legs, memory.goal)
    if is_reached(passage, goal):
        return begin_leg(memory.goal + 1, at_next(memory.tries, False), memory)
    tries = once_more(memory.tries)
    if gives_up(tries, goal):
        return leave_goal(memory)
    return begin_leg(memory.goal, tries, memory)


@compiled
def progress_since(
    memory: RouteMemory, state: FlightState, wish: Wish, leg: Leg, legs: Legs
) -> Progress:
    """Progress on the leg since the last step; on the circle after the last goal there is none."""
    if not memory.begun or memory.goal == len(legs) - 1:
        return memory.progress
    before, now = memory.p_n, state.p_n
    flown = math.hypot(now[0] - before[0], now[1] - before[1])
    return after_step(memory.progress, wish.remaining, leg, flown)


@compiled
def is_reached(passage: Passage, goal: Goal) -> bool:
    """Whether the goal counts as reached."""
    return passage.miss <= goal.tolerance and passage.angle <= goal.tolerance_angle


@compiled
def passage_since(memory: RouteMemory, state: FlightState, legs: Legs) -> Passage:
    """How the goal that is flown to was passed since the last step.

    A vehicle that is still on its way there, or far off, passes it only by reaching it.
    """
    if not memory.begun or memory.goal == len(legs) - 1:
        return NO_PASSAGE
    goal = goal_of(legs, memory.goal)
    passage = passage_of(goal, (memory.p_n, memory.v_n), (state.p_n, state.v_n))
    tries = memory.flight.leg.phase == FIELD and passage.miss <= max(NEAR, goal.tolerance)
    return passage if tries or is_reached(passage, goal) else NO_PASSAGE


@compiled
def passage_of(goal: Goal, before: tuple[Vec3, Vec3], after: tuple[Vec3, Vec3]) -> Passage:
    """How a goal was passed between two instants, each a position [m] and a velocity [m/s]."""
    p_n, v_n = after
    opening = dot(sub(p_n, goal.p_n), v_n)
    if not (dot(sub(before[0], goal.p_n), before[1]) < 0.0 <= opening):
        return NO_PASSAGE
    late = opening / max(dot(v_n, v_n), 1e-6)
    course_error = wrap(math.atan2(v_n[1], v_n[0]) - goal.course)
    climb_error = math.atan2(-v_n[2], math.hypot(v_n[0], v_n[1])) - goal.climb
    miss = norm(sub(sub(p_n, goal.p_n), scale(late, v_n)))
    return Passage(miss, max(abs(course_error), abs(climb_error)))
