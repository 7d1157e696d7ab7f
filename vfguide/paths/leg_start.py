"""How a leg begins: straight on, along the field, along the shortest way, or away from the goal.

Where the way is too short for the height it gets full circles, and for what they are too much a
longer straight end, or the vehicle first flies away from the goal. A descent that takes more path
than the way has is flown faster, in wider turns: the drag then takes away more height.
"""

import math
from typing import NamedTuple

from vfguide.aircraft.performance import Gains
from vfguide.geometry.compiled import compiled
from vfguide.paths.course_laws import Planar
from vfguide.paths.dubins import FULL, Word, is_hasty, length_of, shortest_word
from vfguide.paths.field_capture import begins_in_field, is_lined_up
from vfguide.paths.leg import (
    AWAY,
    FIELD,
    WAY,
    Leg,
    before_end,
    in_phase,
    moved,
    with_final,
    with_radius,
)
from vfguide.paths.path_progress import TURN_IN, new_way
from vfguide.paths.path_stretching import best_away, best_end

SETTLING = 0.9
"""The straight end is this long [radii] where the turns before it follow in haste."""
BRIEF = 0.3
"""No straight end is shortened to less than this [radii]."""
LEAP = 5.0
"""A way that is longer by so many radii has leapt."""
ENDS = 6
"""Straight ends from the longest to the briefest that are tried, in equal steps."""


class Paths(NamedTuple):
    """Paths over ground that the rest of the change of height takes [m]."""

    needed: float
    """With turns of the leg's radius."""
    wider: float
    """Those of a faster descent are wider by this; 1: there is none."""
    needed_wide: float
    """With these."""


class Begun(NamedTuple):
    """A leg as it begins."""

    leg: Leg
    length: float
    """Of the path to the goal [m]."""


@compiled
def begin_leg(leg: Leg, at: Planar, paths: Paths, gains: Gains) -> Leg:
    """The leg from here, with wider turns where a faster descent makes it shorter.

    Args:
        leg: new.
        at: the vehicle in the plane of the goal frame.
        paths: that the change of height takes.
        gains: of the approach.
    """
    level = begin_here(leg, at, paths.needed, gains)
    if paths.wider > 1.0 and paths.needed_wide < paths.needed:
        wide = with_radius(leg, paths.wider * leg.radius)
        descent = begin_here(wide, at, paths.needed_wide, gains)
        if descent.length < level.length:
            return descent.leg
    return level.leg


@compiled
def begin_here(leg: Leg, at: Planar, path_needed: float, gains: Gains) -> Begun:
    """The leg from here, with turns of its radius.

    Args:
        leg: new, or flown away from the goal until now.
        at: the vehicle in the plane of the goal frame.
        path_needed: path length that the remaining change of height takes [m].
        gains: of the approach.
    """
    final = gains.final * leg.radius
    fresh = with_final(leg, final)
    entry = before_end(fresh, at)
    if is_lined_up(fresh, entry) and path_needed <= final - entry.x:
        return Begun(in_phase(fresh, FIELD, leg.way), final - entry.x)
    begin = Planar(entry.x + TURN_IN * at.vx, entry.y + TURN_IN * at.vy, at.vx, at.vy)
    word = word_from(begin, leg.radius)
    lead = math.hypot(begin.x - entry.x, begin.y - entry.y)
    length = leg.radius * length_of(word) + lead
    if begins_in_field(fresh, entry, length, path_needed - final):
        return Begun(in_phase(fresh, FIELD, leg.way), final + length)
    longest = max(final, SETTLING * leg.radius) if is_hasty(word) else final
    end = longest_end(begin, leg.radius, final, longest)
    begin, fresh = moved(begin, end - final), with_final(fresh, end)
    word = word_from(begin, leg.radius)
    begun = way_or_away(fresh, begin, word, path_needed - fresh.final)
    return Begun(begun.leg, lead + begun.length)


@compiled
def longest_end(begin: Planar, radius: float, final: float, longest: float) -> float:
    """The longest straight end before which the way does not leap [m].

    The shortest way to an end that begins a little earlier may be longer by a circle, because
    another word is the shortest.

    Args:
        begin: of the way, the origin where a straight end of length `final` begins.
        radius: of the turns [m].
        final: [m].
        longest: that is tried [m].
    """
    chosen, shortest = longest, math.inf
    for k in range(ENDS + 1):
        end = longest + (min(BRIEF * radius, final) - longest) * k / ENDS
        word = word_from(moved(begin, end - final), radius)
        length = end + radius * length_of(word)
        if length < shortest - LEAP * radius:
            chosen, shortest = end, length
    return chosen


@compiled
def way_or_away(leg: Leg, begin: Planar, word: Word, path_needed: float) -> Begun:
    """The leg along a word that is long enough for the height.

    It gets full circles, and for what is less than one a longer straight end, or it is begun away
    from the goal.
    """
    missing = (path_needed / leg.radius - length_of(word)) / FULL  # in circles
    circles = float(math.floor(missing)) if missing > 0.0 else 0.0
    if leg.phase == AWAY:
        circles = leg.circles
    if missing <= circles:
        return along_word(leg, begin, with_circles(word, circles))
    if leg.phase == AWAY:
        return Begun(leg, math.inf)
    round_once = FULL * circles * leg.radius
    path_needed -= round_once
    farther, with_end = best_end(begin, leg.radius, path_needed)
    course, with_away = best_away(begin, leg.radius, path_needed)
    if with_away < with_end:
        away = Leg(AWAY, leg.radius, leg.final, course, circles, leg.way)
        return Begun(away, with_away + round_once + leg.final)
    begin = moved(begin, farther)
    word = with_circles(word_from(begin, leg.radius), circles)
    return along_word(with_final(leg, leg.final + farther), begin, word)


@compiled
def along_word(leg: Leg, begin: Planar, word: Word) -> Begun:
    """The leg along a word."""
    way = new_way(begin, word, leg.radius)
    return Begun(in_phase(leg, WAY, way), leg.final + leg.radius * length_of(word))


@compiled
def with_circles(word: Word, circles: float) -> Word:
    """The word with full circles more at its beginning."""
    arc = word.arc + FULL * circles
    return Word(word.first, arc, word.middle, word.reach, word.last, word.end)


@compiled
def word_from(at: Planar, radius: float) -> Word:
    """The shortest word from here to the origin."""
    return shortest_word(at.x, at.y, math.atan2(at.vy, at.vx), radius)
