"""Flights of the point mass along goals, and how long the shortest ones would be."""

import math
from dataclasses import dataclass
from functools import cached_property
from itertools import pairwise

import numpy as np
from aeroplanes import AEROSONDE
from point_mass import UPDATE, Moment, fly
from rate_body import level

from vfguide.aircraft.performance import Gains
from vfguide.companion.plan import Plan
from vfguide.geometry.angles import wrap
from vfguide.geometry.units import DEG
from vfguide.geometry.vector import Vec3, dot, norm, scale, sub
from vfguide.loop.legs import Goal

GAINS = Gains(25.0)
TURN = 2.0 * math.pi
STILL: Vec3 = (0.0, 0.0, 0.0)


def goal(x, y, z=-150.0, course=0.0, climb=0.0, tolerance=5.0):
    """A goal; angles in degrees."""
    return Goal((x, y, z), course * DEG, climb * DEG, tolerance, 10.0 * DEG)


def plan_of(goals, side=1.0, radius=100.0):
    origin = (0.8, 0.1, 400.0)
    return Plan(origin, tuple(goals), side, radius, 1.0 / UPDATE, AEROSONDE, GAINS)


def blowing(speed, toward):
    """A wind; the direction in degrees."""
    return (speed * math.cos(toward * DEG), speed * math.sin(toward * DEG), 0.0)


@dataclass(frozen=True)
class Pass:
    """Where a goal was reached, or passed in vain."""

    time: float
    miss: float
    course_error: float
    climb_error: float
    reached: bool


def passed(before: Moment, after: Moment, to: Goal):
    """The pass of a goal between two moments; None if the distance was not least there."""
    if dot(sub(before.state.p_n, to.p_n), before.state.v_n) >= 0.0:
        return None
    v_n, off = after.state.v_n, sub(after.state.p_n, to.p_n)
    if (opening := dot(off, v_n)) < 0.0:
        return None
    miss = norm(sub(off, scale(opening / dot(v_n, v_n), v_n)))
    course = abs(wrap(math.atan2(v_n[1], v_n[0]) - to.course))
    climb = abs(math.atan2(-v_n[2], math.hypot(v_n[0], v_n[1])) - to.climb)
    on = after.goal > before.goal
    return Pass(after.state.time, miss, course, climb, on)


@dataclass(frozen=True)
class Flight:
    goals: tuple[Goal, ...]
    moments: list[Moment]

    @property
    def finished(self):
        return self.moments[-1].goal == len(self.goals)

    @cached_property
    def passes(self):
        """Every local minimum of the distance to the goal that is flown to."""
        left = [(a, b) for a, b in pairwise(self.moments) if a.goal < len(self.goals)]
        each = [passed(before, after, self.goals[before.goal]) for before, after in left]
        return [one for one in each if one]

    @property
    def reached(self):
        return [each for each in self.passes if each.reached]

    @property
    def path(self):
        """(n, 3)"""
        return np.array([moment.state.p_n for moment in self.moments])

    @property
    def length(self):
        """Over ground [m]."""
        return float(np.linalg.norm(np.diff(self.path, axis=0), axis=1).sum())

    @property
    def radius(self):
        return max(moment.command.radius for moment in self.moments)

    @property
    def switches(self):
        """How often the phase changed."""
        return sum(a.command.phase != b.command.phase for a, b in pairwise(self.moments))

    @property
    def reversals(self):
        """How often a bank to one side was followed by one to the other, 25 degrees and more."""
        steep = [m.command.bank for m in self.moments if abs(m.command.bank) > 25.0 * DEG]
        return sum(a * b < 0.0 for a, b in pairwise(steep))


def flown(start, heading, goals, wind=STILL, seconds=300.0, **loiter):
    """The flight to the last of the goals; the heading in degrees."""
    body = level(start, heading * DEG, GAINS.airspeed, AEROSONDE)
    plan = plan_of(goals, **loiter)
    moments = fly(body, plan, wind, seconds, lambda moment: moment.goal == len(goals))
    return Flight(tuple(goals), moments)


def shortest(start, course, radius, to):
    """Length of the shortest of the four turn-straight-turn paths over ground, all of `radius`.

    They lead to the beginning of the straight end of the approach, and along it.
    """
    final = GAINS.final_approach * radius
    c, s = math.cos(to.course), math.sin(to.course)
    north, east = start[0] - to.p_n[0], start[1] - to.p_n[1]
    x, y, course = c * north + s * east + final, c * east - s * north, course - to.course
    lengths = []
    for first in (1.0, -1.0):
        for last in (1.0, -1.0):
            dx = first * radius * math.sin(course) - x
            dy = last * radius - first * radius * math.cos(course) - y
            aside, apart = 0.5 * (last - first) * 2.0 * radius, math.hypot(dx, dy)
            if apart >= abs(aside):
                line = math.atan2(dy, dx) - (math.asin(aside / apart) if apart else 0.0)
                turns = (first * (line - course)) % TURN + (-last * line) % TURN
                lengths.append(radius * turns + math.sqrt(apart**2 - aside**2))
    return min(lengths) + final
