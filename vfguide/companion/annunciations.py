"""Annunciations: notes to the operator, in plain words."""

from vfguide.aircraft.identification import Identified
from vfguide.autopilots.autopilot import Autopilot
from vfguide.companion.engagement import Phase
from vfguide.companion.goal_announcement import GoalAnnouncement, Outcome
from vfguide.companion.loop_report import is_alarmed, number_of_resets
from vfguide.companion.plan import Plan
from vfguide.estimation.position_resets import settled
from vfguide.geometry.rows import Row
from vfguide.link.messages import GpsGlobalOrigin
from vfguide.loop.state import LoopState, state_of_row

SILENT_UNTIL_CHANGE = (
    "the autopilot already follows somebody's setpoints: silent until it flies another mode"
)
"""Note where somebody else's setpoints are followed already."""
FOUND = "the autopilot is found, it flies {mode}"
"""Note where an autopilot is found."""
CHOICE_COMES = "{follow} will be asked for"
"""Note where the companion will ask for the follow mode."""
CHOICE_LEFT = "waiting for the operator to choose {follow}"
"""Note where the operator has to choose the follow mode."""
LINK_LOST = "link lost, {why}: no setpoints until the autopilot is heard again"
"""Note where the link is lost."""
STRANGER = "vehicle {sysid} says {who}: flown is only {flown}, nothing is sent to it"
"""Note where another autopilot is found than one that can be flown."""
INTRUDER = "a heartbeat of vehicle {sysid} that says {who} is not its autopilot's: ignored"
"""Note where somebody else speaks with the address of the autopilot."""
STOOD_STILL = "the companion stood still for {gap:.1f} s"
"""Note where this program did not run for a while."""
ENDED_UNFOUND = "ended: no autopilot was found"
"""Note at the end where there never was one to fly."""
ENDED_UNHEARD = "ended: the autopilot is not heard any more"
"""Note at the end where it is unknown what the autopilot flies, after a time without control."""
FALLEN_BACK = "the autopilot has fallen back on {mode} by itself"
"""Reason for silence where the autopilot's failsafe acts."""
NOT_ARMED = "the autopilot is not armed any more, as after a restart"
"""Reason for silence where the mode that it flies is nobody's choice."""
RESTARTED = "the autopilot has restarted or is another one: its clock has begun anew"
"""Reason for silence where it was not heard for long and tells another time."""
TOO_SLOW = "the link is too slow, a setpoint would act {delay:.1f} s after the state it is made for"
"""Reason for silence where the link is too slow."""

ON_ENTERING = {
    Phase.SEARCHING: LINK_LOST,
    Phase.OFFERING: FOUND,
    Phase.ASKING: "asking the autopilot for {follow}",
    Phase.FLYING: "the autopilot follows",
    Phase.INTERRUPTED: LINK_LOST,
    Phase.YIELDING: "{why}: no more setpoints for now",
    Phase.RETURNING: "handing over: asking the autopilot for {hold}",
    Phase.RELEASED: "released: the mode was changed to {mode}, no more setpoints",
    Phase.ENDED: "ended: the autopilot flies {mode}",
    Phase.UNCONFIRMED: "ended without a link: what the autopilot flies is up to its failsafe",
}
"""Notes on entering a phase; others have none."""


def phase_notes(
    before: Phase, after: Phase, autopilot: Autopilot, custom_mode: int | None, why: str = ""
) -> list[str]:
    """Notes of a change of phase.

    Args:
        before: the phase that ends.
        after: the phase that begins.
        autopilot: the make of the autopilot, which names its modes.
        custom_mode: the mode that it flies; None: unknown.
        why: the reason, where the phase does not say it.
    """
    if (before, after) == (Phase.YIELDING, Phase.OFFERING):
        return []  # told by the first setpoint
    note = ON_ENTERING[after]
    if (before, after) == (Phase.ASKING, Phase.OFFERING):
        note = CHOICE_LEFT
    elif after is Phase.ENDED and custom_mode is None:
        note = ENDED_UNFOUND if before is Phase.SEARCHING else ENDED_UNHEARD
    mode = "" if custom_mode is None else autopilot.mode_name(custom_mode)
    follow, hold = autopilot.follow_mode.name, autopilot.hold_mode.name
    return [note.format(mode=mode, follow=follow, hold=hold, why=why)]


def choice_note(phase: Phase, autopilot: Autopilot, engage: bool) -> str:
    """Note of who chooses the follow mode, empty where the autopilot does not wait for it.

    Args:
        phase: the phase.
        autopilot: the make of the autopilot, which names its modes.
        engage: whether the companion asks for the follow mode by itself.
    """
    if phase is not Phase.OFFERING:
        return ""
    return (CHOICE_COMES if engage else CHOICE_LEFT).format(follow=autopilot.follow_mode.name)


def route_note(goal: int, plan: Plan) -> str:
    """Note of what is flown to; `goal` counts from 0."""
    goals = len(plan.goals)
    return f"flying to goal {goal + 1} of {goals}" if goal < goals else "loitering"


def passage_note(said: GoalAnnouncement, plan: Plan) -> str:
    """Note of a goal that was passed."""
    goal = said.goal + 1
    if said.outcome is Outcome.GIVEN_UP:
        return f"goal {goal} missed {times(said.missed + 1)}: {onward(goal, plan)}"
    if said.outcome is Outcome.MISSED:
        return f"goal {goal} missed by {said.miss:.1f} m or by its course: going round"
    return f"goal {goal} reached, {said.miss:.1f} m off; {route_note(goal, plan)}"


def onward(passed: int, plan: Plan) -> str:
    """Note of what follows after a number of goals."""
    return f"going on to goal {passed + 1}" if passed < len(plan.goals) else "loitering"


def times(number: int) -> str:
    """A number of times in words."""
    return "once" if number == 1 else f"{number} times"


TESTING = "test flight: {what}"
"""Note on a leg of the identification flight."""
NO_ROOM = "no room for a test flight here: flown with what is known of the aircraft"
"""Note where there is no room for an identification flight."""
BROKEN_OFF = "test flight broken off, something is in its way: nothing was measured"
"""Note where an identification flight is broken off."""
MEASURED = "measured: {names}"
"""Note of the estimates that are used."""
UNSEEN = "not seen well enough, flown as it was known before: {names}"
"""Note of the estimates that are not used."""


def identified_notes(found: Identified) -> list[str]:
    """Notes of the estimates of an identification flight."""
    seen = [str(each) for each in found.estimates if each.used]
    unseen = [each.key for each in found.estimates if not each.used]
    lists = ((MEASURED, seen), (UNSEEN, unseen))
    return [note.format(names=", ".join(names)) for note, names in lists if names]


JUMPED = "the position told by the autopilot has jumped by {size:.0f} m: let in slowly"
"""Note of a position reset."""
ORIGIN_MOVED = "the autopilot has moved the origin of its local frame: heeded"
"""Note of an origin that has moved."""
WEAK_AGAIN = "the wind has fallen"
"""Note at the end of a wind hold."""
NO_PROGRESS = (
    "no progress to goal {goal}: flown a full circle more than its way has, "
    "and no nearer than {least:.0f} m along it"
)
"""Note on a leg without progress."""


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


def reset_notes(before: Row, after: Row) -> list[str]:
    """Note of a position reset in a step."""
    resets, was = state_of_row(after).estimation.resets, number_of_resets(before)
    if resets.number == was or settled(resets):
        return []
    return [JUMPED.format(size=resets.size)]


def wind_notes(before: Row, after: Row, plan: Plan) -> list[str]:
    """Note of a wind hold that begins or ends in a step."""
    now, held = state_of_row(after), state_of_row(before).mission.wind_hold.holds
    return [] if now.mission.wind_hold.holds == held else [wind_note(now, plan)]


def wind_note(s: LoopState, plan: Plan) -> str:
    """Note of a wind hold that begins or ends."""
    goal, hold = s.mission.goal, s.mission.wind_hold
    if not hold.holds:
        return f"{WEAK_AGAIN}: {route_note(goal, plan)}"
    what = f"goal {goal + 1} unreachable" if goal < len(plan.goals) else "no circle"
    speed = plan.gains.airspeed
    return f"{what} now: wind {hold.ratio * speed:.0f} of {speed:.0f} m/s, holding against it"
