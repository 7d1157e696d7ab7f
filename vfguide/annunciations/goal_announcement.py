"""What the companion announces of goals that it has passed, as it saw them."""

from enum import IntEnum
from typing import NamedTuple

from vfguide.kernels.rows import Row, getter
from vfguide.loop.loop_report import goal_of_row
from vfguide.loop.state import LoopState, state_of_row

_missed_of_row = getter(LoopState, "mission.attempts.missed")


class GoalOutcome(IntEnum):
    """What became of a goal in the companion's belief."""

    REACHED = 0
    """It goes on to the next one."""
    MISSED = 1
    """It goes round and tries again."""
    GIVEN_UP = 2
    """It goes on to the next one, having missed this one as often as it may."""


class GoalAnnouncement(NamedTuple):
    """A pass of a goal as the companion announces it."""

    goal: int
    """Index of the goal, from 0."""
    outcome: GoalOutcome
    miss: float
    """Distance from the goal that the companion believes [m]; not a number where it has none."""
    missed: int
    """Number of passes that have missed the goal before this one."""


def is_passed(before: Row, after: Row) -> bool:
    """Whether a goal was passed between two rows of `LoopState`."""
    return (goal_of_row(before), _missed_of_row(before)) != (
        goal_of_row(after),
        _missed_of_row(after),
    )


def announcement(before: Row, after: Row, miss: float) -> GoalAnnouncement:
    """What is announced of a goal passed with a `miss` [m] between two rows of `LoopState`."""
    was, now = state_of_row(before).mission, state_of_row(after).mission
    outcome = GoalOutcome.REACHED
    if now.attempts.given_up > was.attempts.given_up:
        outcome = GoalOutcome.GIVEN_UP
    elif now.goal == was.goal:
        outcome = GoalOutcome.MISSED
    return GoalAnnouncement(was.goal, outcome, miss, was.attempts.missed)
