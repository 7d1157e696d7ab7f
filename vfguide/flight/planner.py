"""Which of the courses of `approach` to fly: the leg to a goal as a small state machine."""

import math
from typing import NamedTuple

from vfguide.flight.approach import (
    Course,
    Planar,
    arc_to_goal,
    circle_course,
    field_course,
    loiter_course,
)
from vfguide.flight.performance import Gains
from vfguide.geometry.angles import wrap
from vfguide.geometry.compiled import compiled

NEW, FIELD, CIRCLE, GAIN_HEIGHT = 0, 1, 2, 3
"""Phases: nothing flown yet; along the paper's field; onto a goal circle; round a circle to
change height."""

PENETRATION = 0.04
"""How far inside a goal circle the field is still flown, in radii."""
COMMITTED = 0.03
"""So much farther once the field is being flown close before the goal."""
AGREEMENT = 0.1
"""From a goal circle the field is taken up where the course is within this of it [rad]."""
DETOUR = 1.03
"""At the beginning of a leg the field may be longer than the goal circle by this factor."""
ASIDE = 0.01
"""The straight end is begun between its ends no farther aside than this, in radii, ..."""
OFF_COURSE = 0.05
"""... and within this of its course [rad]."""
SWITCH_GAIN = 0.7
"""The other goal circle is taken when it is shorter by this many radii."""


class Leg(NamedTuple):
    """Memory of the leg to one goal."""

    phase: int
    side: float
    """Goal circle that is flown: +1 right-hand, -1 left-hand."""
    x: float
    y: float
    """Centre of the circle that is flown to change height [m]."""
    radius: float
    """Radius of the goal circles [m]: kept, so that they do not move during the approach."""


@compiled
def new_leg() -> Leg:
    """A leg of which nothing has been flown."""
    return Leg(NEW, 1.0, 0.0, 0.0, 0.0)


@compiled
def turn_radius(airspeed: float, wind: float, bank: float, margin: float) -> float:
    """Radius over ground that the bank allows flying downwind [m], times `margin`."""
    return margin * (airspeed + wind) ** 2 / (9.80665 * math.tan(bank))


@compiled
def keep_radius(leg: Leg, radius: float) -> Leg:
    """The leg with the radius [m] of its circles, changed only if aircraft or wind ask for it."""
    if 0.85 * leg.radius < radius <= 1.05 * leg.radius:
        return leg
    return Leg(leg.phase, leg.side, leg.x, leg.y, radius)


@compiled
def fly_leg(leg: Leg, at: Planar, climb_needed: float, gains: Gains) -> Leg:
    """The memory of the leg after one step: the phase that is flown now.

    Args:
        leg: memory of the leg.
        at: the vehicle in the plane of the goal frame.
        climb_needed: path length that the remaining change of height takes [m].
        gains: of the approach.
    """
    course = math.atan2(at.vy, at.vx)
    direct = fly_direct(leg, at, course, gains)
    wanted = leg_course(direct, at, gains)
    if leg.phase == GAIN_HEIGHT:
        return leg if climb_needed > 0.9 * wanted.remaining else direct
    to_go = wanted.remaining + leg.radius * abs(wrap(wanted.chi - course))
    far = leg.phase == NEW or to_go > 2.0 * leg.radius
    return circle_here(direct, at) if far and climb_needed > to_go else direct


@compiled
def leg_course(leg: Leg, at: Planar, gains: Gains) -> Course:
    """The course of the phase that is flown, and the path length to the goal.

    On the circle for height the goal counts as near, so that the path is as steep as it may be.
    """
    if leg.phase == GAIN_HEIGHT:
        about = Planar(at.x - leg.x, at.y - leg.y, at.vx, at.vy)
        around = loiter_course(about, leg.side, leg.radius)
        return Course(around.chi, around.chi_rate, leg.radius)
    final = gains.final * leg.radius
    entry = Planar(at.x + final, at.y, at.vx, at.vy)
    if leg.phase == FIELD:
        toward = field_course(entry, gains.core * leg.radius)
    else:
        toward = circle_course(entry, leg.side, leg.radius)
    return Course(toward.chi, toward.chi_rate, toward.remaining + final)


@compiled
def circle_here(leg: Leg, at: Planar) -> Leg:
    """Round a circle that touches the present path, for height."""
    offset = leg.side * leg.radius / max(math.hypot(at.vx, at.vy), 1e-3)
    return Leg(GAIN_HEIGHT, leg.side, at.x - offset * at.vy, at.y + offset * at.vx, leg.radius)


@compiled
def fly_direct(leg: Leg, at: Planar, course: float, gains: Gains) -> Leg:
    """The field where it is flyable, else a goal circle."""
    final = gains.final * leg.radius
    entry = Planar(at.x + final, at.y, at.vx, at.vy)
    side = choose_side(leg, entry, course)
    circle = circle_length(entry, course, side, leg.radius)
    if is_lined_up(leg, entry, course, final) or field_is_flyable(leg, entry, course, circle):
        return Leg(FIELD, leg.side, leg.x, leg.y, leg.radius)
    return Leg(CIRCLE, side, leg.x, leg.y, leg.radius)


@compiled
def is_lined_up(leg: Leg, at: Planar, course: float, final: float) -> bool:
    """Whether the vehicle is on the straight end of the approach, as between goals in line."""
    return 0.0 < at.x < final and abs(at.y) < ASIDE * leg.radius and abs(course) < OFF_COURSE


@compiled
def choose_side(leg: Leg, at: Planar, course: float) -> float:
    """The goal circle with the shorter path; once flown it is kept unless much longer."""
    right = circle_length(at, course, 1.0, leg.radius)
    left = circle_length(at, course, -1.0, leg.radius)
    if leg.phase != CIRCLE:
        return 1.0 if right < left else -1.0
    shorter = right < left if leg.side < 0.0 else left < right
    return -leg.side if shorter and abs(right - left) > SWITCH_GAIN * leg.radius else leg.side


@compiled
def circle_length(at: Planar, course: float, side: float, radius: float) -> float:
    """Length of the path over the goal circle of `side`, the first turn included [m]."""
    wanted = circle_course(at, side, radius)
    return wanted.remaining + radius * abs(wrap(wanted.chi - course))


@compiled
def field_is_flyable(leg: Leg, at: Planar, course: float, circle: float) -> bool:
    """Whether the field leads to the goal without a turn tighter than the leg's radius.

    It is taken up from a goal circle where both agree, and at the beginning of a leg where
    its path is not much longer than the one over the circle, `circle` [m].
    """
    side = 1.0 if at.y >= 0.0 else -1.0
    inside = leg.radius - math.hypot(at.x, at.y - side * leg.radius)
    if leg.phase == FIELD and math.hypot(at.x, at.y) < leg.radius and abs(course) < 1.2:
        return inside <= (PENETRATION + COMMITTED) * leg.radius or at.x > 0.0
    if at.x >= -abs(at.y) or inside > PENETRATION * leg.radius:
        return False
    error = abs(wrap(course - 2.0 * math.atan2(at.y, at.x)))
    if leg.phase == FIELD:
        return error < 2.0
    if leg.phase == CIRCLE:
        return error < AGREEMENT
    return arc_to_goal(at.x, at.y) + leg.radius * error <= DETOUR * circle
