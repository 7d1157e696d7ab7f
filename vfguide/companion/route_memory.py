"""What one step of the companion leaves for the next."""

from typing import NamedTuple

import numpy as np
from numpy.typing import NDArray

from vfguide.companion.jump import Jumps, no_jumps, settled
from vfguide.companion.progress import Progress, fresh_progress
from vfguide.companion.tries import Tries, at_next, no_tries
from vfguide.flight.air_state import (
    AIR_NUMBERS,
    AIRSPEED,
    MODEL,
    PUSH,
    TRUST,
    AirReport,
    AirState,
    X,
    fresh_air,
    report_air,
)
from vfguide.flight.detour_leg import DETOUR_NUMBERS, DetourState, fresh_detour
from vfguide.flight.leg import Leg, new_leg
from vfguide.flight.memory import Memory, fresh_memory
from vfguide.flight.performance import Performance
from vfguide.flight.shortest import Word
from vfguide.flight.strong_wind import Stand, new_stand
from vfguide.flight.way import Way
from vfguide.geometry.compiled import compiled
from vfguide.geometry.vector import Vec3
from vfguide.safety.guard import HAZARD, REASON, GuardState, fresh_guard


class RouteMemory(NamedTuple):
    """Where on the way it is, what it knows of the air, and what the flight law remembers."""

    goal: int
    """Index of the goal that is flown to; the number of goals: all are behind it."""
    begun: bool
    """Whether a step was made on this leg, from here:"""
    p_n: Vec3
    v_n: Vec3
    """Position [m] and velocity over ground [m/s] at the last step, NED."""
    flight: Memory
    jumps: Jumps
    stand: Stand
    tries: Tries
    progress: Progress
    air: AirState
    guard: GuardState
    detour: DetourState


@compiled
def fresh_route(obstacles: int = 0) -> RouteMemory:
    """Memory of a vehicle that has not begun, among so many obstacles."""
    zero, guard = (0.0, 0.0, 0.0), fresh_guard(obstacles)
    return RouteMemory(
        0,
        False,
        zero,
        zero,
        fresh_memory(),
        no_jumps(),
        new_stand(),
        no_tries(),
        fresh_progress(),
        fresh_air(),
        guard,
        fresh_detour(),
    )


@compiled
def begin_leg(goal: int, tries: Tries, memory: RouteMemory) -> RouteMemory:
    """Memory at the beginning of a leg; what was learned in flight stays."""
    m, zero = memory.flight, (0.0, 0.0, 0.0)
    after = Memory(
        m.time, new_leg(), m.slope, m.turning, m.R_na, m.omega_a, m.thrust_integral, m.alpha_bias
    )
    begun = (tries, fresh_progress())
    kept = (memory.air, memory.guard, fresh_detour())
    return RouteMemory(goal, False, zero, zero, after, memory.jumps, memory.stand, *begun, *kept)


@compiled
def take_over(memory: RouteMemory) -> RouteMemory:
    """Memory when the autopilot begins to follow: only the way and the air are remembered."""
    zero = (0.0, 0.0, 0.0)
    begun = (memory.stand, memory.tries, fresh_progress())
    kept = (*begun, memory.air, memory.guard, fresh_detour())
    return RouteMemory(memory.goal, False, zero, zero, fresh_memory(), no_jumps(), *kept)


@compiled
def leave_goal(memory: RouteMemory) -> RouteMemory:
    """Memory at the beginning of the next leg, the goal of the present one given up."""
    return begin_leg(memory.goal + 1, at_next(memory.tries, True), memory)


@compiled
def begin_route(memory: RouteMemory) -> RouteMemory:
    """Memory at the beginning of another route; what is known of the air stays."""
    return take_over(begin_leg(0, no_tries(), memory))


def forget_learned(memory: RouteMemory, before: Performance, after: Performance) -> RouteMemory:
    """Memory without the corrections of what is known better now of the aircraft."""
    if before == after:
        return memory
    flight, air = memory.flight, memory.air.copy()
    air[X + PUSH], air[MODEL] = 0.0, air[X + AIRSPEED]
    if (after.alpha_zero, after.alpha_load) != (before.alpha_zero, before.alpha_load):
        flight = flight._replace(alpha_bias=0.0)
    if after.thrust_trim != before.thrust_trim:
        flight = flight._replace(thrust_integral=0.0)
    return memory._replace(flight=flight, air=air)


PackedMemory = NDArray[np.float64]
"""(GUARD + KNOWN + M,), the numbers of a RouteMemory in their order: an array crosses into
compiled code and back in a fraction of the time of nested records."""
OFFSET, JUMPS, JUMP_SIZE, RATIO, HOLDS = 42, 45, 46, 48, 49
MISSED, GIVEN_UP, LEAST, ALARMED, AIR = 51, 52, 53, 56, 57
AIR_TIME = AIR
"""Places: what is not let in yet of a jump, the count and the size of jumps, the ratio of wind and
airspeed and whether it is too large, missed passes, goals given up, the least length of the path
[m] and whether there is no progress, the air's numbers and the first of them."""
DETOUR = AIR + AIR_NUMBERS
GUARD = DETOUR + DETOUR_NUMBERS
"""Places: the detour that is flown, and what the guard remembers."""


@compiled
def packed_memory(memory: RouteMemory) -> PackedMemory:
    """The memory as an array."""
    f, jumps, stand = memory.flight, memory.jumps, memory.stand
    head = (float(memory.goal), 1.0 if memory.begun else 0.0, *memory.p_n, *memory.v_n)
    way, word = f.leg.way, f.leg.way.word
    plan = (float(f.leg.phase), f.leg.radius, f.leg.final, f.leg.away, f.leg.circles)
    turns = (word.first, word.arc, word.middle, word.reach, word.last, word.end)
    path = (way.x, way.y, way.course, *turns, way.radius, float(way.piece), way.left)
    R, reference = f.R_na, f.omega_a
    law = (f.time, *plan, *path, f.slope, f.turning, *R[0], *R[1], *R[2], *reference)
    learned = (f.thrust_integral, f.alpha_bias)
    jumped = (*jumps.offset_n, float(jumps.number), jumps.size, jumps.age)
    stood = (stand.ratio, 1.0 if stand.holds else 0.0, stand.down)
    tries, progress = memory.tries, memory.progress
    tried = (float(tries.missed), float(tries.given_up))
    alarm = 1.0 if progress.alarmed else 0.0
    circled = (progress.least, progress.longest, progress.flown, alarm)
    packed = np.empty(GUARD + len(memory.guard))
    packed[:AIR] = np.array((*head, *law, *learned, *jumped, *stood, *tried, *circled))
    packed[AIR:DETOUR] = memory.air
    packed[DETOUR:GUARD] = memory.detour
    packed[GUARD:] = memory.guard
    return packed


def goal_in(memory: PackedMemory) -> int:
    """Index of the goal that is flown to."""
    return int(memory[0])


def missed_in(memory: PackedMemory) -> int:
    """How often the goal that is flown to was missed."""
    return int(memory[MISSED])


def given_up_in(memory: PackedMemory) -> int:
    """How many goals were given up."""
    return int(memory[GIVEN_UP])


def decision_in(memory: PackedMemory) -> tuple[float, float, float, float]:
    """What the guard decided last: reason, margin [m], conflict [s], hazard."""
    reason, least, conflict, hazard = memory[GUARD + REASON : GUARD + HAZARD + 1].tolist()
    return reason, least, conflict, hazard


def settled_in(memory: PackedMemory) -> bool:
    """Whether no jump of the position is being let in."""
    north, east, down = memory[OFFSET:JUMPS]
    return settled(Jumps((north, east, down), 0, 0.0, 0.0))


def trusts_sensor_in(memory: PackedMemory) -> bool:
    """Whether the airspeed sensor is flown on."""
    return bool(memory[AIR + TRUST])


def holds_in(memory: PackedMemory) -> bool:
    """Whether the wind is too strong to fly to a goal."""
    return bool(memory[HOLDS])


@compiled
def air_in(memory: PackedMemory) -> AirReport:
    """What is believed of the air."""
    return report_air(memory[AIR:DETOUR])


class Noted(NamedTuple):
    """What records keep of a step."""

    wind_north: float
    wind_east: float
    wind_sigma: float
    """Where the wind is believed to blow to, and the standard deviation of either [m/s]."""
    airspeed: float
    airspeed_sigma: float
    """The true airspeed that is believed, and its standard deviation [m/s]."""
    reason: float
    """The value of the `Reason` of the assurance's decision."""
    margin: float
    """Least clearance of the way out [m]."""
    conflict: float
    """Time to the conflict that was seen [s]."""
    hazard: float
    """Number of the hazard."""


NotedTuple = tuple[float, float, float, float, float, float, float, float, float]
"""`Noted`, or the same nine numbers without names."""


@compiled
def noted_in(memory: PackedMemory) -> NotedTuple:
    """What records keep of a step: one call of compiled code, and no names, for each update."""
    air, g = air_in(memory), GUARD + REASON
    believed = (air.wind_north, air.wind_east, air.wind_sigma, air.airspeed, air.airspeed_sigma)
    return (*believed, memory[g], memory[g + 1], memory[g + 2], memory[g + 3])


@compiled
def has_news(before: PackedMemory, after: PackedMemory) -> bool:
    """Whether a step changed what the operator reads of air, jumps and progress."""
    return (
        before[AIR_TIME] < 0.0
        or after[JUMPS] != before[JUMPS]
        or after[HOLDS] != before[HOLDS]
        or after[ALARMED] != before[ALARMED]
        or after[AIR + TRUST] != before[AIR + TRUST]
    )


@compiled
def unpacked_memory(a: PackedMemory) -> RouteMemory:
    """What `packed_memory` packed."""
    word = Word(a[17], a[18], a[19], a[20], a[21], a[22])
    way = Way(a[14], a[15], a[16], word, a[23], int(a[24]), a[25])
    leg = Leg(int(a[9]), a[10], a[11], a[12], a[13], way)
    R_na = ((a[28], a[29], a[30]), (a[31], a[32], a[33]), (a[34], a[35], a[36]))
    flight = Memory(a[8], leg, a[26], a[27], R_na, (a[37], a[38], a[39]), a[40], a[41])
    return RouteMemory(
        int(a[0]),
        a[1] != 0.0,
        (a[2], a[3], a[4]),
        (a[5], a[6], a[7]),
        flight,
        Jumps((a[42], a[43], a[44]), int(a[45]), a[46], a[47]),
        Stand(a[48], a[49] != 0.0, a[50]),
        Tries(int(a[MISSED]), int(a[GIVEN_UP])),
        Progress(a[53], a[54], a[55], a[56] != 0.0),
        a[AIR:DETOUR].copy(),
        a[GUARD:].copy(),
        a[DETOUR:GUARD].copy(),
    )
