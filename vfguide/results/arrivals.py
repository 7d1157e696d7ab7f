"""Arrivals at goals, for robots that slow down towards a goal and stop there."""

import math

from vfguide.geometry.vector import Vec3, add, dot, scale, sub
from vfguide.results.goal_passages import Legs, Pass, Sample
from vfguide.scenario.resolved import Goal

ARRIVED = 0.05
"""Distance from its goal below which a robot of law `paper` has arrived [m]; chosen, because its
speed goes to zero there."""


def arrival_radius(goal: Goal) -> float:
    """Distance from the goal at which a robot has arrived [m]: at most the goal's tolerance."""
    return min(goal.tolerance_m, ARRIVED)


class Arrivals(Legs):
    """Legs whose goal is passed once, where the distance first falls to the arrival radius.

    Instead of velocities, the samples have the direction of the nose, so that a robot at rest has a
    course too.
    """

    @property
    def standing(self) -> bool:
        """The robot stays where it is: at its last goal, or at one with a wrong attitude."""
        return self.finished or bool(self.passes[self.leg])

    def is_attempt(self, a_pass: Pass, goal: Goal) -> bool:
        """Every arrival counts as an attempt, whatever its direction."""
        return True

    def find(self, before: Sample | None, sample: Sample) -> Sample | None:
        """Where the line between the samples enters the ball about the goal; None: nowhere."""
        goal = self.goals[self.leg]
        if self.passes[self.leg]:
            return None
        start = before or sample
        moved = sub(sample.p_n, start.p_n)
        part = entry(sub(start.p_n, goal.position_m), moved, arrival_radius(goal))
        if part is None:
            return None
        return Sample(
            start.time + part * (sample.time - start.time),
            add(start.p_n, scale(part, moved)),
            add(scale(1.0 - part, start.v_n), scale(part, sample.v_n)),
        )


def entry(p: Vec3, moved: Vec3, radius: float) -> float | None:
    """Share of the displacement `moved` from `p` after which |p| is first at most `radius` [m].

    It is the smaller root s of |p + s moved| = radius; None: there is none from 0 to 1.
    """
    outside = dot(p, p) - radius * radius
    if outside <= 0.0:
        return 0.0
    length, toward = dot(moved, moved), -dot(p, moved)
    discriminant = toward * toward - length * outside
    if toward <= 0.0 or discriminant < 0.0:
        return None
    part = outside / (toward + math.sqrt(discriminant))
    return part if part <= 1.0 else None
