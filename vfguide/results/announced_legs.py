"""Legs of a vehicle that announces when it goes on to its next goal.

Which goal the vehicle flies to is taken from its announcements; whether it reached a goal is judged
on the true path. An announcement comes a little before or after the true pass that it is about,
because the vehicle predicts, and because its position is in error. So a leg ends at the true pass
nearest to its announcement.
"""

from collections import deque
from collections.abc import Iterable, Sequence
from typing import NamedTuple

from vfguide.annunciations.goal_announcement import GoalAnnouncement, GoalOutcome
from vfguide.results.goal_passages import Legs, Pass, Sample, approach, judged, passed_between
from vfguide.scenario.resolved import Goal


class TimedAnnouncement(NamedTuple):
    """An announcement and when it was made."""

    time: float
    """Time since the start of the run [s]."""
    said: GoalAnnouncement


class _AnnouncedPass(NamedTuple):
    """An announcement and the pass of the goal that it is about."""

    at: int
    """Index of the pass among those of its goal; -1: there is none."""
    said: GoalAnnouncement


class AnnouncedLegs(Legs):
    """Legs that end when the vehicle announces that it goes on to the next goal."""

    def __init__(self, goals: Sequence[Goal]) -> None:
        super().__init__(goals)
        self.announced: list[TimedAnnouncement] = []
        """What was announced, in the order of time."""
        self._told: tuple[list[_AnnouncedPass], ...] = tuple([] for _ in self.goals)
        self._ending: int | None = None  # index of a goal left before the true path passes it
        self._early: list[Pass] = []  # passes of the next goal until then

    @property
    def finished(self) -> bool:
        """The last goal has been reached, or was given up."""
        if any(a_pass.reaches for a_pass in self.passes[-1]):
            return True
        said = self.left_behind(len(self.goals) - 1)
        return self._ending is None and said is not None and said.outcome is GoalOutcome.GIVEN_UP

    def announce(self, said: GoalAnnouncement) -> None:
        """Take an announcement that was made at the newest sample."""
        goal, now = said.goal, self.last
        self._end_leg()
        is_to_come = now is not None and approach(now, self.goals[goal]) < 0.0
        passes = len(self.passes[goal])
        self._told[goal].append(_AnnouncedPass(passes if is_to_come else passes - 1, said))
        self.announced.append(TimedAnnouncement(0.0 if now is None else now.time, said))
        if said.outcome is not GoalOutcome.MISSED:
            self.leg = goal + 1
            self._ending = goal if is_to_come else None

    def feed(self, sample: Sample) -> bool:
        """Take the next sample; true if a goal was reached since the sample before.

        While the pass that ends a leg is still to come, the next leg has not begun.
        """
        before, reached = self.last, self.reached
        if (goal := self._ending) is not None:
            passed = passed_between(before, sample, self.goals[goal])
            if passed is not None:
                self.add(goal, judged(passed, self.goals[goal]))
                before, self._ending = passed, None
                self._early.clear()
        if self.leg < len(self.goals):
            passed = self.find(before, sample)
            if passed is not None:
                self._take(judged(passed, self.goals[self.leg]))
        self.last = sample
        return self.reached > reached

    def _end_leg(self) -> None:
        """End a leg whose true pass never came; the passes since then are of the present goal."""
        if self._ending is not None:
            for a_pass in self._early:
                self.add(self.leg, a_pass)
            self._early.clear()
            self._ending = None

    def _take(self, a_pass: Pass) -> None:
        """Note a pass of the present goal, whose leg may not have begun."""
        if self._ending is None:
            self.add(self.leg, a_pass)
        else:
            self._early.append(a_pass)

    def believed(self, goal: int) -> GoalAnnouncement | None:
        """What the vehicle announced of the pass of a goal that counts; None: nothing.

        Of a goal that the true path never passed it is the last announcement.
        """
        best, passes, told = self.best()[goal], self.passes[goal], self._told[goal]
        if best is None:
            return told[-1].said if told else None
        about = [each.said for each in told if each.at == passes.index(best)]
        return about[-1] if about else None

    def left_behind(self, goal: int) -> GoalAnnouncement | None:
        """The announcement with which the vehicle went on from a goal; None: it did not go on."""
        said = self._told[goal][-1].said if self._told[goal] else None
        return None if said is None or said.outcome is GoalOutcome.MISSED else said


def announced_legs(
    goals: Sequence[Goal], samples: Iterable[Sample], announced: Sequence[TimedAnnouncement]
) -> AnnouncedLegs:
    """The legs of a recorded path, and of what was announced on it."""
    legs, coming = AnnouncedLegs(goals), deque(announced)
    for sample in samples:
        legs.feed(sample)
        while coming and coming[0].time <= sample.time:
            legs.announce(coming.popleft().said)
    return legs
