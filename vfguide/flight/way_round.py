"""When to look for a way round hazards, or over them, and what becomes of the leg then.

The way that is flown is looked along several times a second; where something that is known comes
too near to it, or where the flight law has changed it by itself, the coarse search finds another.
"""

import math
from typing import NamedTuple

from vfguide.field.obstacle import Rows
from vfguide.flight.approach import arc_to_goal
from vfguide.flight.clearance import NOTHING, clearance_at
from vfguide.flight.detour import CLEARANCES, find_detour
from vfguide.flight.detour_leg import (
    CLEARANCE,
    COUNT,
    FALL,
    INDEX,
    LEFT,
    LEVEL,
    LOOKED,
    PIECE,
    SHIFTED,
    SOUGHT,
    DetourState,
    begin_detour,
    go_on_detour,
    hop_at,
    hops_left,
    is_on_detour,
    level_of,
    vehicle_from,
)
from vfguide.flight.hop import HOP_COLUMNS, Hop, Piece, hop_row, next_word
from vfguide.flight.hop_check import Air, Task, check_piece, demand_of, way_is_clear
from vfguide.flight.leg import AWAY, FIELD, NEW, WAY, Leg, with_final
from vfguide.flight.memory import Target
from vfguide.flight.outlines import Outlines, hazards_of, joined
from vfguide.flight.passing import (
    NO_LEVEL,
    Heights,
    band_of,
    cost_of,
    heights_by,
    heights_left,
    left_in_way,
    levels_for,
)
from vfguide.flight.performance import Gains, Performance
from vfguide.flight.shortest import Word, length_of
from vfguide.flight.state import FlightState
from vfguide.flight.way import TURN_IN, Pose
from vfguide.geometry.compiled import compiled

LOOK = 0.2
"""Between two looks along the way [s]."""
SEEK = 1.0
"""Between two searches that found nothing [s]."""
TOLERATED = 0.6
"""Part of the clearance that was found of which so much is left when a way is given up."""


class Journey(NamedTuple):
    """Who flies where."""

    state: FlightState
    target: Target
    aircraft: Performance
    gains: Gains


class Scene(NamedTuple):
    """What may be in the way."""

    obstacles: Rows
    """That are known."""
    fence: Outlines
    """To stay in or out of."""
    highest: float
    """Nothing is passed over above this, down from the origin [m]."""
    t: float
    """Now, on the clock of the obstacles [s]."""


@compiled
def seek_way(journey: Journey, leg: Leg, scene: Scene, detour: DetourState) -> Leg:
    """The leg with a way that keeps clear of the hazards, if it needs another; fills `detour`."""
    t = scene.t
    if is_on_detour(detour):
        leg = go_on_detour(detour, journey.state, leg)
    is_unplanned = leg.phase == NEW and not is_on_detour(detour)
    if is_unplanned or (detour[SHIFTED] == 0.0 and t - detour[LOOKED] < LOOK):
        return leg
    detour[LOOKED], detour[SHIFTED] = t, 0.0
    drop_level(journey, leg, scene, detour)
    heights = heights_of(journey, detour)
    if is_clear(journey, leg, scene, detour, heights, tolerated(detour)):
        return leg
    if detour[CLEARANCE] < 0.0 and t - detour[SOUGHT] < SEEK:
        return leg
    return with_new_way(journey, leg, scene, detour)


@compiled
def heights_of(journey: Journey, detour: DetourState) -> Heights:
    """Heights from here to the goal."""
    its, (level, fall) = journey, level_of(detour)
    return heights_left(level, fall, its.state, its.target, its.aircraft, its.gains)


@compiled
def tolerated(detour: DetourState) -> float:
    """Clearance with which a way is not given up yet [m]."""
    return TOLERATED * (detour[CLEARANCE] if detour[CLEARANCE] > 0.0 else CLEARANCES[0])


@compiled
def task_from(journey: Journey, start: Pose, goal: Pose, radius: float, t: float) -> Task:
    """What is to be flown from a pose in this wind."""
    wind_n = journey.state.wind_n
    return Task(start, goal, radius, Air(journey.gains.airspeed, wind_n[0], wind_n[1]), t)


@compiled
def entry_of(target: Target, final: float) -> Pose:
    """Where the straight end of the approach begins."""
    c, s = math.cos(target.course), math.sin(target.course)
    return Pose(target.p_n[0] - final * c, target.p_n[1] - final * s, target.course)


@compiled
def pose_of(state: FlightState, ahead: float) -> Pose:
    """Where the vehicle will be `ahead` [s] from now, straight on."""
    x = state.p_n[0] + ahead * state.v_n[0]
    y = state.p_n[1] + ahead * state.v_n[1]
    return Pose(x, y, math.atan2(state.v_n[1], state.v_n[0]))


@compiled
def is_clear(
    journey: Journey,
    leg: Leg,
    scene: Scene,
    detour: DetourState,
    heights: Heights,
    wanted: float,
) -> bool:
    """Whether the rest of the way is clear by what is wanted [m]."""
    state, target = journey.state, journey.target
    obstacles = left_in_way(scene.obstacles, heights, wanted)
    hazards = joined(hazards_of(obstacles, band_of(heights), wanted), scene.fence)
    here, entry = pose_of(state, 0.0), entry_of(target, leg.final)
    task = task_from(journey, here, entry_of(target, 0.0), leg.radius, scene.t)
    if is_on_detour(detour):
        index, piece = int(detour[INDEX]), int(detour[PIECE])
        gone = gone_in(hop_at(detour, index).word, piece, detour[LEFT], leg.radius)
        return way_is_clear(hazards, task, wanted, hops_left(detour), index, piece, gone)
    if leg.phase == WAY:
        way = leg.way
        hop = Hop(placed(entry, Pose(way.x, way.y, way.course)), way.word)
        rows = hop_row(hop).reshape(1, HOP_COLUMNS)
        gone = gone_in(way.word, way.piece, way.left, way.radius)
        return way_is_clear(hazards, task, wanted, rows, 0, way.piece, gone)
    if leg.phase == FIELD:
        return field_is_clear(state, leg, hazards, task, entry, wanted)
    return True


@compiled
def field_is_clear(
    state: FlightState, leg: Leg, hazards: Outlines, task: Task, entry: Pose, wanted: float
) -> bool:
    """Whether the arc of the paper's field from here to the straight end is clear."""
    at = vehicle_from(entry, state)
    radius = max((at.x * at.x + at.y * at.y) / max(2.0 * abs(at.y), 1e-3), leg.radius)
    begin = placed(entry, Pose(at.x, at.y, 2.0 * math.atan2(at.y, at.x)))
    arc = Piece(begin, 1.0 if at.y > 0.0 else -1.0, arc_to_goal(at.x, at.y))
    if at.x >= 0.0:
        arc = Piece(entry, 0.0, leg.final)
    demand = demand_of(hazards, task, wanted)
    task = Task(task.start, task.goal, radius, task.air, task.t)
    return check_piece(hazards, task, demand, arc, 0.0, task.t).blocker == NOTHING


@compiled
def gone_in(word: Word, piece: int, left: float, radius: float) -> float:
    """Length of a piece of a word that lies behind where so much is `left` of it [m]."""
    lengths = (word.arc, word.reach, word.end)
    return radius * max(0.0, lengths[piece] - left)


@compiled
def placed(frame: Pose, pose: Pose) -> Pose:
    """A pose that is given in the axes of another, NED."""
    c, s = math.cos(frame.course), math.sin(frame.course)
    x = frame.x + c * pose.x - s * pose.y
    return Pose(x, frame.y + s * pose.x + c * pose.y, frame.course + pose.course)


@compiled
def with_new_way(journey: Journey, leg: Leg, scene: Scene, detour: DetourState) -> Leg:
    """The leg along what is found, or as it was: over what is in its way, or with nothing found.

    A level that is kept is kept on a new way too. Where there is no way to the beginning of the
    straight end, one to the goal itself is taken.
    """
    state, target, radius = journey.state, journey.target, leg.radius
    heights, may_climb = heights_of(journey, detour), not is_on_detour(detour)
    may_climb = may_climb and math.isinf(heights.level)
    obstacles = left_in_way(scene.obstacles, heights, TOLERATED * CLEARANCES[0])
    detour[SOUGHT] = detour[LOOKED] = scene.t
    detour[COUNT], detour[CLEARANCE] = 0.0, -1.0
    begin = pose_of(state, TURN_IN)
    for end in (journey.gains.final * radius, 0.0):
        entry = entry_of(target, end)
        task = task_from(journey, begin, entry, radius, scene.t + TURN_IN)
        found = find_detour(obstacles, scene.fence, band_of(heights), task)
        if len(found.hops) > 0:
            longer = found.length - radius * length_of(next_word(begin, entry, radius, -1.0))
            if may_climb and finds_level(journey, leg, scene, detour, longer):
                return leg
            detour[CLEARANCE] = found.clearance
            begin_detour(detour, found, entry, radius)
            return go_on_detour(detour, state, with_final(leg, end))
    if may_climb:
        finds_level(journey, leg, scene, detour, math.inf)
    return leg


@compiled
def finds_level(journey: Journey, leg: Leg, scene: Scene, detour: DetourState, most: float) -> bool:
    """Whether the leg is clear at another height, for less than `most` [m]; fills `detour`."""
    its, wanted = journey, CLEARANCES[0]
    here, goal = its.state.p_n[2], its.target.p_n[2]
    for level in levels_for(scene.obstacles, here, goal, scene.highest, wanted):
        if cost_of(level, here, goal) >= most:
            break
        heights = heights_by(level, its.state, its.target, its.aircraft, its.gains)
        if is_free(journey, leg, scene, detour, heights):
            detour[LEVEL], detour[FALL], detour[CLEARANCE] = level, heights.fall, wanted
            return True
    return False


@compiled
def drop_level(journey: Journey, leg: Leg, scene: Scene, detour: DetourState) -> None:
    """Forget the level once the way is clear without it."""
    if not math.isinf(detour[LEVEL]):
        state, target = journey.state, journey.target
        heights = Heights(state.p_n, target.p_n, NO_LEVEL, 0.0, 0.0)
        if leg.phase != AWAY and is_free(journey, leg, scene, detour, heights):
            detour[LEVEL] = NO_LEVEL


@compiled
def is_free(
    journey: Journey, leg: Leg, scene: Scene, detour: DetourState, heights: Heights
) -> bool:
    """Whether the rest of the way has all the clearance, and so has the place where it begins.

    Near a hazard less is asked for round the beginning, and none of it above one.
    """
    wanted, p_n = CLEARANCES[0], journey.state.p_n
    obstacles = left_in_way(scene.obstacles, heights, wanted)
    near = hazards_of(obstacles, band_of(heights), wanted)
    if clearance_at(near, p_n[0], p_n[1], scene.t).distance < wanted:
        return False
    return is_clear(journey, leg, scene, detour, heights, wanted)
