"""Which of the courses of `approach` to fly: the leg to a goal as a small state machine.

    NEW -> (AWAY ->) WAY -> FIELD

A leg begins with the paper's field where that is flyable and hardly longer than the shortest way,
else with that way; from its last turn the field is taken up. Where the way is too short for the
height it gets full circles, and for what they are too much the vehicle first flies away from the
goal. What does not lead on any more is planned anew.
"""

import math

from vfguide.flight.approach import Course, Planar, field_course
from vfguide.flight.field_phase import (
    begins_in_field,
    is_lined_up,
    off_field,
    rolls_out,
    stays_in_field,
    takes_up_field,
)
from vfguide.flight.leg import AWAY, FIELD, NEW, WAY, Leg, before_end, in_phase, with_final
from vfguide.flight.longer import best_away, best_end
from vfguide.flight.performance import Gains
from vfguide.flight.shortest import FULL, Word, is_hasty, length_of, shortest_word
from vfguide.flight.way import (
    TURN_IN,
    along,
    beside,
    leads_straight_on,
    new_way,
    way_course,
    way_left,
)
from vfguide.geometry.compiled import compiled

SETTLING = 0.9
"""The straight end is this long [radii] where the turns before it follow in haste."""
OFF_WAY = 0.5
"""A way is planned anew where the vehicle is farther beside it than this, in radii."""
BREAK_OFF = 0.9
"""A way is planned anew when it is shorter than this part of what the height needs."""


@compiled
def fly_leg(leg: Leg, at: Planar, path_needed: float, gains: Gains) -> Leg:
    """The memory of the leg after one step: the phase that is flown now.

    Args:
        leg: memory of the leg.
        at: the vehicle in the plane of the goal frame.
        path_needed: path length that the remaining change of height takes [m].
        gains: of the approach.
    """
    final = gains.final * leg.radius
    entry = before_end(leg, at)
    after = go_on(leg, entry)
    if after.phase in (NEW, AWAY):
        return begin_here(after, at, path_needed, final)
    to_go = entry_course(after, entry, leg.radius).remaining
    if after.phase == FIELD:
        to_go += leg.radius * off_field(entry)
    if BREAK_OFF * (path_needed - leg.final) > to_go > 2.0 * leg.radius:
        return begin_here(in_phase(leg, NEW, leg.way), at, path_needed, final)
    return after


@compiled
def leg_course(leg: Leg, at: Planar, core: float) -> Course:
    """The course of the phase that is flown, and the path length to the goal.

    `core` is where the field becomes that of a line [m], see `field_course`.
    """
    toward = entry_course(leg, before_end(leg, at), core)
    return Course(toward.chi, toward.chi_rate, toward.remaining + leg.final)


@compiled
def entry_course(leg: Leg, at: Planar, core: float) -> Course:
    """The same to the beginning of the straight end, which is the origin here.

    Away from the goal the path counts as no longer than the radius, so that it is as steep as it
    may be.
    """
    if leg.phase == WAY:
        return way_course(leg.way, at)
    if leg.phase == AWAY:
        return Course(leg.away, 0.0, leg.radius)
    return field_course(at, core)


@compiled
def go_on(leg: Leg, entry: Planar) -> Leg:
    """The leg as far as it leads on, else a new one."""
    if leg.phase == FIELD:
        leads_on = stays_in_field(leg, entry) and entry.x < leg.final
        return in_phase(leg, FIELD if leads_on else NEW, leg.way)
    if leg.phase == WAY:
        way = along(leg.way, entry)
        if leads_straight_on(way) and takes_up_field(leg, entry):
            return in_phase(leg, FIELD, way)
        if rolls_out(leg, entry, way_left(way)):
            return in_phase(leg, FIELD, way)
        if way_left(way) <= 0.0:
            return in_phase(leg, NEW, way)
        return in_phase(leg, WAY if beside(way, entry) < OFF_WAY * leg.radius else NEW, way)
    return leg


@compiled
def begin_here(leg: Leg, at: Planar, path_needed: float, final: float) -> Leg:
    """The leg from here: straight on, along the field, the shortest way, or away from the goal.

    Args:
        leg: new, or flown away from the goal until now.
        at: the vehicle in the plane of the goal frame.
        path_needed: path length that the remaining change of height takes [m].
        final: length of the straight end [m].
    """
    fresh = with_final(leg, final)
    entry = before_end(fresh, at)
    if is_lined_up(fresh, entry) and path_needed <= final - entry.x:
        return in_phase(fresh, FIELD, leg.way)
    begin = Planar(entry.x + TURN_IN * at.vx, entry.y + TURN_IN * at.vy, at.vx, at.vy)
    word = word_from(begin, leg.radius)
    lead = math.hypot(begin.x - entry.x, begin.y - entry.y)
    length = leg.radius * length_of(word) + lead
    if begins_in_field(fresh, entry, length, path_needed - final):
        return in_phase(fresh, FIELD, leg.way)
    if is_hasty(word):
        fresh = with_final(leg, max(final, SETTLING * leg.radius))
        begin = Planar(begin.x + fresh.final - final, begin.y, at.vx, at.vy)
        word = word_from(begin, leg.radius)
    return way_or_away(fresh, begin, word, path_needed - fresh.final)


@compiled
def way_or_away(leg: Leg, begin: Planar, word: Word, path_needed: float) -> Leg:
    """The leg along a word that is long enough for the height.

    It gets full circles, and for what is less than one a longer straight end, or it is begun away
    from the goal.
    """
    missing = (path_needed / leg.radius - length_of(word)) / FULL  # in circles
    circles = float(math.floor(missing)) if missing > 0.0 else 0.0
    if leg.phase == AWAY:
        circles = leg.circles
    if missing <= circles:
        return in_phase(leg, WAY, new_way(begin, with_circles(word, circles), leg.radius))
    if leg.phase == AWAY:
        return leg
    path_needed -= FULL * circles * leg.radius
    farther, with_end = best_end(begin, leg.radius, path_needed)
    course, with_away = best_away(begin, leg.radius, path_needed)
    if with_away < with_end:
        return Leg(AWAY, leg.radius, leg.final, course, circles, leg.way)
    begin = Planar(begin.x + farther, begin.y, begin.vx, begin.vy)
    word = with_circles(word_from(begin, leg.radius), circles)
    return in_phase(with_final(leg, leg.final + farther), WAY, new_way(begin, word, leg.radius))


@compiled
def with_circles(word: Word, circles: float) -> Word:
    """The word with full circles more at its beginning."""
    arc = word.arc + FULL * circles
    return Word(word.first, arc, word.middle, word.reach, word.last, word.end)


@compiled
def word_from(at: Planar, radius: float) -> Word:
    """The shortest word from here to the origin."""
    return shortest_word(at.x, at.y, math.atan2(at.vy, at.vx), radius)
