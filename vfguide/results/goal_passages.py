"""Passes of goals: where the true path comes closest to one, and whether it reaches it."""

import math
from collections.abc import Sequence
from typing import NamedTuple

from vfguide.annunciations.goal_announcement import GoalAnnouncement
from vfguide.geometry.angles import wrap
from vfguide.geometry.units import DEG
from vfguide.geometry.vector import Vec3
from vfguide.loop.attempts import ATTEMPT_MISS
from vfguide.results.hermite import derivative_at, hermite, value_at
from vfguide.scenario.resolved import Goal


class Sample(NamedTuple):
    """A point of a path."""

    time: float
    """Time since the start of the run [s]."""
    p_n: Vec3
    """Position in the scenario frame [m]."""
    v_n: Vec3
    """Velocity over ground in the same frame [m/s]."""


class Pass(NamedTuple):
    """A local minimum of the distance to a goal, on the leg to it."""

    time: float
    """Time since the start of the run [s]."""
    miss: float
    """Distance from the goal [m]."""
    course_error: float
    """Angle between the course and the goal's, not negative [rad]."""
    climb_error: float
    """Difference of the climb from the goal's, not negative [rad]."""
    reaches: bool
    """All three are within the goal's tolerances."""


MAX_ATTEMPT_ANGLE = 60.0 * DEG
"""Course error above which a pass of a goal is no attempt [rad]; chosen, since a vehicle may circle
near its goal for height."""


class Legs:
    """The legs of one vehicle from goal to goal, fed with its path one sample at a time.

    A goal is passed where the distance to it is least; a vehicle that has missed it attempts again,
    as often as the goal says.
    """

    def __init__(self, goals: Sequence[Goal]) -> None:
        self.goals = tuple(goals)
        self.passes: tuple[list[Pass], ...] = tuple([] for _ in self.goals)
        """The passes of each goal, in the order of time."""
        self.leg = 0
        """Index of the goal that is flown to; the number of goals when none is left."""
        self.last: Sample | None = None
        """The newest sample."""
        self.reached = 0
        """Number of goals that have been reached."""

    @property
    def finished(self) -> bool:
        """Every goal has been reached or given up."""
        return self.leg == len(self.goals)

    def feed(self, sample: Sample) -> bool:
        """Take the next sample; true if a goal was reached or given up since the sample before.

        Between two samples the path is the cubic with their positions and velocities.
        """
        before, leg = self.last, self.leg
        while not self.finished:
            passed = self.find(before, sample)
            if passed is None:
                break
            self.add(self.leg, judged(passed, self.goals[self.leg]))
            if not (self.passes[self.leg][-1].reaches or self.gives_up):
                break
            before, self.leg = passed, self.leg + 1
        self.last = sample
        return self.leg > leg

    def add(self, goal: int, a_pass: Pass) -> None:
        """Note a pass of a goal."""
        self.reached += a_pass.reaches and not any(each.reaches for each in self.passes[goal])
        self.passes[goal].append(a_pass)

    @property
    def gives_up(self) -> bool:
        """Whether the present goal has been missed as often as its `attempts` allow."""
        goal = self.goals[self.leg]
        attempts = sum(self.is_attempt(a_pass, goal) for a_pass in self.passes[self.leg])
        return 0 < goal.attempts <= attempts

    def is_attempt(self, a_pass: Pass, goal: Goal) -> bool:
        """Whether a pass counts as an attempt to reach the goal: near it, and near its course."""
        return (
            a_pass.miss <= max(ATTEMPT_MISS, goal.tolerance_m)
            and a_pass.course_error <= MAX_ATTEMPT_ANGLE
        )

    def find(self, before: Sample | None, sample: Sample) -> Sample | None:
        """Where the present goal is passed between two samples, if it is."""
        return passed_between(before, sample, self.goals[self.leg])

    def best(self) -> list[Pass | None]:
        """The pass of each goal that counts: the first that reaches it, else the nearest."""
        return [min(passes, key=_rank, default=None) for passes in self.passes]

    def believed(self, goal: int) -> GoalAnnouncement | None:
        """What the vehicle announced of the pass of a goal that counts; None: nothing."""
        return None

    def left_behind(self, goal: int) -> GoalAnnouncement | None:
        """The announcement with which the vehicle went on from a goal; None: it made none."""
        return None


def _rank(a_pass: Pass) -> tuple[bool, float]:
    """Sorting key of the passes of a goal: those that reach it first, the others by their miss."""
    return (not a_pass.reaches, 0.0 if a_pass.reaches else a_pass.miss)


def interpolate(one: Sample, other: Sample, time: float) -> Sample:
    """The path at a `time` [s] between two samples: the Hermite cubic through both."""
    span = other.time - one.time
    s = (time - one.time) / span
    axes = [
        hermite(p0, p1, v0 * span, v1 * span)
        for p0, p1, v0, v1 in zip(one.p_n, other.p_n, one.v_n, other.v_n, strict=True)
    ]
    x, y, z = (value_at(axis, s) for axis in axes)
    u, v, w = (derivative_at(axis, s) / span for axis in axes)
    return Sample(time, (x, y, z), (u, v, w))


def passed_between(before: Sample | None, sample: Sample, goal: Goal) -> Sample | None:
    """Where the distance to a goal is least between two samples, if it is."""
    if before is None or not approach(before, goal) < 0.0 <= approach(sample, goal):
        return None
    return _closest(before, sample, goal)


def approach(at: Sample, goal: Goal) -> float:
    """Half the rate of the squared distance to the goal: (p - p_d) . v, negative on approach."""
    x, y, z = goal.position_m
    _, (px, py, pz), (vx, vy, vz) = at
    return (px - x) * vx + (py - y) * vy + (pz - z) * vz


def _closest(one: Sample, other: Sample, goal: Goal) -> Sample:
    """The point between two samples where the approach ends, by bisection."""
    low, high = one.time, other.time
    while low < (middle := 0.5 * (low + high)) < high:
        if approach(interpolate(one, other, middle), goal) < 0.0:
            low = middle
        else:
            high = middle
    return interpolate(one, other, high)


def judged(at: Sample, goal: Goal) -> Pass:
    """The pass of a goal at a point of the path, judged by the goal's tolerances."""
    north, east, down = at.v_n
    course, climb = math.atan2(east, north), math.atan2(-down, math.hypot(north, east))
    miss = math.dist(at.p_n, goal.position_m)
    course_error = abs(wrap(course - goal.heading_deg * DEG))
    climb_error = abs(climb - goal.climb_deg * DEG)
    reaches = (
        miss <= goal.tolerance_m and max(course_error, climb_error) <= goal.tolerance_deg * DEG
    )
    return Pass(at.time, miss, course_error, climb_error, reaches)
