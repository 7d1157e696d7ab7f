"""Notes of what a step has changed in position, progress and wind."""

from vfguide.annunciations.goal_notes import leg_note
from vfguide.estimation.position_resets import settled
from vfguide.guidance.guidance_state import Leader
from vfguide.kernels.rows import Row
from vfguide.link.messages import GpsGlobalOrigin
from vfguide.loop.loop_report import is_alarmed, leader_of_row, number_of_resets
from vfguide.loop.state import LoopState, state_of_row

JUMPED = "the position told by the autopilot has jumped by {size:.0f} m: let in slowly"
"""Note of a position reset."""
ORIGIN_MOVED = "the autopilot has moved the origin of its local frame: heeded"
"""Note of an origin that has moved."""
WEAK_AGAIN = "the wind has fallen"
"""Note at the end of a wind hold."""
NO_PROGRESS = (
    "no progress to goal {goal}: flown a full circle more than its path has, "
    "and no nearer than {least:.0f} m along it"
)
"""Note on a leg without progress."""

ROUTE_BEGINS = "the field does not lead to goal {goal}: a route is flown"
"""Note where law `field` asks for a route."""
APPROACH_LEFT = "the approach leads away from goal {goal}: a route is flown"
"""Note where an approach leaves the last turn radii."""
FIELD_AGAIN = "the field leads again to goal {goal}"
"""Note at the end of that route."""


def origin_notes(before: GpsGlobalOrigin | None, after: GpsGlobalOrigin | None) -> list[str]:
    """Note of an origin of the local frame that was received again, unchanged or moved."""
    if before is None or after is None:
        return []
    was = (before.latitude, before.longitude, before.altitude)
    return [] if was == (after.latitude, after.longitude, after.altitude) else [ORIGIN_MOVED]


def progress_notes(before: Row, after: Row) -> list[str]:
    """Notes of a leg that has begun to make no progress."""
    if is_alarmed(before) or not is_alarmed(after):
        return []
    s = state_of_row(after)
    return [NO_PROGRESS.format(goal=s.mission.goal + 1, least=s.progress.least)]


def leader_notes(before: Row, after: Row) -> list[str]:
    """Notes of a route that law `field` has begun or ended in a step on one leg."""
    was, now = leader_of_row(before), leader_of_row(after)
    goal = state_of_row(after).mission.goal
    if was == now or state_of_row(before).mission.goal != goal:
        return []
    if (was, now) == (Leader.FIELD, Leader.ROUTE):
        return [ROUTE_BEGINS.format(goal=goal + 1)]
    if (was, now) == (Leader.APPROACH, Leader.ROUTE):
        return [APPROACH_LEFT.format(goal=goal + 1)]
    ends = (was, now) == (Leader.ROUTE, Leader.FIELD)
    return [FIELD_AGAIN.format(goal=goal + 1)] if ends else []


def reset_notes(before: Row, after: Row) -> list[str]:
    """Note of a position reset in a step."""
    resets, was = state_of_row(after).estimation.resets, number_of_resets(before)
    if resets.number == was or settled(resets):
        return []
    return [JUMPED.format(size=resets.size)]


def wind_notes(before: Row, after: Row, goals: int, airspeed: float) -> list[str]:
    """Note of a wind hold that begins or ends in a step.

    Args:
        before: row of the `LoopState` before the step.
        after: row of the `LoopState` after it.
        goals: number of the goals.
        airspeed: true airspeed that the plan asks for [m/s].
    """
    now, held = state_of_row(after), state_of_row(before).mission.wind_hold.holds
    return [] if now.mission.wind_hold.holds == held else [wind_note(now, goals, airspeed)]


def wind_note(s: LoopState, goals: int, airspeed: float) -> str:
    """Note of a wind hold that begins or ends, of an aircraft that flies at `airspeed` [m/s]."""
    goal, hold = s.mission.goal, s.mission.wind_hold
    if not hold.holds:
        return f"{WEAK_AGAIN}: {leg_note(goal, goals)}"
    what = f"goal {goal + 1} unreachable" if goal < goals else "no circle"
    return f"{what} now: wind {hold.ratio * airspeed:.0f} of {airspeed:.0f} m/s, holding against it"
