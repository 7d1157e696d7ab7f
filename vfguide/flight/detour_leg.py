"""A detour flown: hop after hop, until the last one is a leg's own way to the goal.

The hops lie in the horizontal plane, NED. Each is a way that ends at its end pose, as `way` has
them.
"""

import math

import numpy as np
from numpy.typing import NDArray

from vfguide.flight.approach import Course, Planar
from vfguide.flight.detour import Detour
from vfguide.flight.hop import HOP_COLUMNS, Hop, hop_in, hop_row
from vfguide.flight.leg import WAY, Leg, in_phase
from vfguide.flight.passing import NO_LEVEL
from vfguide.flight.roadmap import MOST_HOPS
from vfguide.flight.shortest import length_of
from vfguide.flight.state import FlightState
from vfguide.flight.way import FIRST_TURN, LAST_TURN, TURN_IN, Pose, Way, along, beside, way_course
from vfguide.flight.way import way_left as rest_of
from vfguide.geometry.angles import wrap
from vfguide.geometry.compiled import compiled

COUNT, INDEX, PIECE, LEFT, RADIUS = 0, 1, 2, 3, 4
"""Places: hops, zero while none is flown; the one that is flown; its `Way.piece` and `Way.left`;
radius of the turns [m]."""
END, CLEARANCE, LOOKED, SOUGHT, SHIFTED = 5, 8, 9, 10, 11
"""Places: pose where the last hop ends (3); clearance that was found, negative: no way was [m];
times of the last look along the way and of the last search [s]; 1 where the leg was changed since
the last search."""
LEVEL, FALL = 12, 13
"""Places: level at which things are passed over, down from the origin, infinite: none is kept;
how long before the goal its height is flown to again [m]."""
ROWS = 14
"""First of MOST_HOPS rows of HOP_COLUMNS."""
DETOUR_NUMBERS = ROWS + MOST_HOPS * HOP_COLUMNS
LOST = 0.7
"""A hop is given up farther beside it than this, in radii."""

DetourState = NDArray[np.float64]
"""(DETOUR_NUMBERS,), the numbers at the places above; (0,) where none is ever flown."""


@compiled
def fresh_detour() -> DetourState:
    """No detour."""
    state = np.zeros(DETOUR_NUMBERS)
    state[LOOKED] = state[SOUGHT] = -math.inf
    state[SHIFTED], state[LEVEL] = 1.0, NO_LEVEL
    return state


@compiled
def is_on_detour(detour: DetourState) -> bool:
    """Whether a detour is flown."""
    return len(detour) > 0 and detour[COUNT] > 0.0


@compiled
def level_of(detour: DetourState) -> tuple[float, float]:
    """Level at which things are passed over, infinite where there is none, and FALL [m]."""
    if len(detour) == 0:
        return NO_LEVEL, 0.0
    return detour[LEVEL], detour[FALL]


@compiled
def begin_detour(detour: DetourState, found: Detour, end: Pose, radius: float) -> None:
    """Fly the hops that were found to `end`."""
    count = len(found.hops)
    detour[COUNT], detour[INDEX], detour[RADIUS] = float(count), 0.0, radius
    detour[END], detour[END + 1], detour[END + 2] = end
    for i in range(count):
        at = ROWS + i * HOP_COLUMNS
        detour[at : at + HOP_COLUMNS] = found.hops[i]
    begin_hop(detour, 0)


@compiled
def begin_hop(detour: DetourState, i: int) -> None:
    """Fly hop `i` from its beginning."""
    detour[INDEX], detour[PIECE] = float(i), float(FIRST_TURN)
    detour[LEFT] = hop_at(detour, i).word.arc


@compiled
def hop_at(detour: DetourState, i: int) -> Hop:
    """Hop `i`."""
    at = ROWS + i * HOP_COLUMNS
    return hop_in(detour[at : at + HOP_COLUMNS].reshape(1, HOP_COLUMNS), 0)


@compiled
def end_at(detour: DetourState, i: int) -> Pose:
    """Where hop `i` ends."""
    if i + 1 < int(detour[COUNT]):
        return hop_at(detour, i + 1).begin
    return Pose(detour[END], detour[END + 1], detour[END + 2])


@compiled
def way_to(detour: DetourState, i: int) -> Way:
    """Hop `i` as a way that ends at the origin along x."""
    hop, end = hop_at(detour, i), end_at(detour, i)
    x, y, course = seen_from(end, hop.begin)
    radius = detour[RADIUS]
    return Way(x, y, course, hop.word, radius, int(detour[PIECE]), detour[LEFT])


@compiled
def seen_from(frame: Pose, pose: Pose) -> Pose:
    """A pose in the axes of another."""
    c, s = math.cos(frame.course), math.sin(frame.course)
    dx, dy = pose.x - frame.x, pose.y - frame.y
    return Pose(c * dx + s * dy, c * dy - s * dx, wrap(pose.course - frame.course))


@compiled
def vehicle_from(frame: Pose, state: FlightState) -> Planar:
    """The vehicle in the axes of a pose."""
    c, s = math.cos(frame.course), math.sin(frame.course)
    dx, dy = state.p_n[0] - frame.x, state.p_n[1] - frame.y
    vx, vy = state.v_n[0], state.v_n[1]
    return Planar(c * dx + s * dy, c * dy - s * dx, c * vx + s * vy, c * vy - s * vx)


@compiled
def go_on_detour(detour: DetourState, state: FlightState, leg: Leg) -> Leg:
    """Go along the hops; the last one becomes the way of the leg, and the detour ends."""
    last = int(detour[COUNT]) - 1
    while int(detour[INDEX]) < last:
        i = int(detour[INDEX])
        at = vehicle_from(end_at(detour, i), state)
        way = along(way_to(detour, i), at)
        detour[PIECE], detour[LEFT] = float(way.piece), way.left
        if beside(way, at) > LOST * detour[RADIUS]:
            detour[SHIFTED] = 1.0
        if rest_of(way) > lead_into(detour, i, state):
            return leg
        begin_hop(detour, i + 1)
    way = way_to(detour, last)
    detour[COUNT] = 0.0
    radius = detour[RADIUS]
    return in_phase(Leg(WAY, radius, leg.final, leg.away, leg.circles, way), WAY, way)


@compiled
def lead_into(detour: DetourState, i: int, state: FlightState) -> float:
    """How far before its end hop `i` goes over into the next one, for the lag of the bank [m]."""
    word, following = hop_at(detour, i).word, hop_at(detour, i + 1).word
    now = word.last if int(detour[PIECE]) == LAST_TURN and word.end > 0.0 else 0.0
    then = following.first if following.arc > 0.0 else 0.0
    speed = math.hypot(state.v_n[0], state.v_n[1])
    return TURN_IN * speed * abs(then - now)


@compiled
def detour_course(detour: DetourState, state: FlightState, leg: Leg, course: float) -> Course:
    """Course along the hop that is flown, relative to `course`, and the path length to the goal."""
    i = int(detour[INDEX])
    end = end_at(detour, i)
    onto = way_course(way_to(detour, i), vehicle_from(end, state))
    remaining = onto.remaining + leg.final
    for k in range(i + 1, int(detour[COUNT])):
        remaining += detour[RADIUS] * length_of(hop_at(detour, k).word)
    return Course(wrap(end.course + onto.chi - course), onto.chi_rate, remaining)


@compiled
def hops_left(detour: DetourState) -> NDArray[np.float64]:
    """All hops as rows."""
    count = int(detour[COUNT])
    rows = np.empty((count, HOP_COLUMNS))
    for i in range(count):
        rows[i] = hop_row(hop_at(detour, i))
    return rows
