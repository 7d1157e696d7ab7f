"""Notes of the goals: which one is flown to, and how one was passed."""

from vfguide.annunciations.goal_announcement import GoalAnnouncement, GoalOutcome


def leg_note(goal: int, goals: int) -> str:
    """Note of what is flown to: the goal of index `goal`, from 0, of `goals`, or the circle."""
    return f"flying to goal {goal + 1} of {goals}" if goal < goals else "loitering"


def passage_note(said: GoalAnnouncement, goals: int) -> str:
    """Note of one of `goals` goals that was passed."""
    goal = said.goal + 1
    if said.outcome is GoalOutcome.GIVEN_UP:
        return f"goal {goal} missed {times(said.missed + 1)}: {onward(goal, goals)}"
    if said.outcome is GoalOutcome.MISSED:
        return f"goal {goal} missed by {said.miss:.1f} m or by its course: going round"
    return f"goal {goal} reached, {said.miss:.1f} m off; {leg_note(goal, goals)}"


def onward(passed: int, goals: int) -> str:
    """Note of what follows after `passed` of `goals` goals."""
    return f"going on to goal {passed + 1}" if passed < goals else "loitering"


def times(number: int) -> str:
    """A number of times in words."""
    return "once" if number == 1 else f"{number} times"
