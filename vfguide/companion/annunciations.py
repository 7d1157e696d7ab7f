"""Annunciations: notes to the operator, in plain words."""

from vfguide.aircraft.identification import Identified
from vfguide.autopilots.autopilot import Autopilot
from vfguide.companion.engagement import Phase
from vfguide.companion.goal_announcement import GoalAnnouncement, Outcome
from vfguide.companion.loop_report import is_alarmed
from vfguide.companion.plan import Plan
from vfguide.estimation.position_resets import settled
from vfguide.geometry.rows import Row
from vfguide.link.messages import GpsGlobalOrigin
from vfguide.loop.state import LoopState, state_of_row

SILENT_UNTIL_CHANGE = (
    "the autopilot already follows somebody's setpoints: silent until it flies another mode"
)
"""Note where somebody else's setpoints are followed already."""
FOUND = "the autopilot is found, it flies {mode}; setpoints go out, "
"""Beginning of the note where an autopilot is found; CHOICE_COMES or CHOICE_LEFT ends it."""
CHOICE_COMES = "{follow} will be asked for"
"""Note where the companion will ask for the follow mode."""
CHOICE_LEFT = "waiting for the operator to choose {follow}"
"""Note where the operator has to choose the follow mode."""
SENT_AGAIN = "setpoints go out again"
"""Note where nothing keeps setpoints from going out any more."""
OFFERED_AGAIN = f"{SENT_AGAIN}, "
"""Beginning of the note where the companion could not guide and can again; CHOICE_LEFT ends it."""
LINK_LOST = "link lost, {why}: no setpoints until the autopilot is heard again"
"""Note where the link is lost."""
STRANGER = "vehicle {sysid} says {who}: flown is only {flown}, nothing is sent to it"
"""Note where another autopilot is found than one that can be flown."""
INTRUDER = "a heartbeat of vehicle {sysid} that says {who} is not its autopilot's: ignored"
"""Note where somebody else speaks with the address of the autopilot."""
STOOD_STILL = "the companion stood still for {gap:.1f} s"
"""Note where this program did not run for a while."""
FALLEN_BACK = "the autopilot has fallen back on {mode} by itself"
"""Reason for silence where the autopilot's failsafe acts."""
TOO_SLOW = "the link is too slow, a setpoint would act {delay:.1f} s after the state it is made for"
"""Reason for silence where the link is too slow."""

ON_ENTERING = {
    Phase.SEARCHING: LINK_LOST,
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


def phase_note(
    before: Phase,
    after: Phase,
    autopilot: Autopilot,
    custom_mode: int | None,
    engage: bool,
    why: str = "",
) -> str:
    """Note of a change of phase.

    Args:
        before: the phase that ends.
        after: the phase that begins.
        autopilot: the make of the autopilot, which names its modes.
        custom_mode: the mode that it flies; None: unknown.
        engage: whether the companion asks for the follow mode by itself.
        why: the reason, where the phase does not say it.
    """
    return note_on(before, after, engage).format(
        mode=autopilot.mode_name(custom_mode),
        follow=autopilot.follow_mode.name,
        hold=autopilot.hold_mode.name,
        why=why,
    )


def note_on(before: Phase, after: Phase, engage: bool) -> str:
    """Note of a change of phase, with placeholders for the names of modes."""
    if after is not Phase.OFFERING:
        return ON_ENTERING[after]
    if before is Phase.ASKING:
        return CHOICE_LEFT
    if before is Phase.YIELDING:
        return OFFERED_AGAIN + CHOICE_LEFT
    return FOUND + (CHOICE_COMES if engage else CHOICE_LEFT)


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


NO_SENSOR = "no airspeed sensor"
"""Note on an aircraft without an airspeed sensor."""
SENSOR_LOST = "the airspeed sensor is not believed any more"
"""Note where the airspeed sensor has failed."""
ESTIMATED = "airspeed is estimated, it flies faster and with less bank"
"""Note where the airspeed is estimated."""
SENSOR_BACK = "the airspeed sensor is believed again"
"""Note where the airspeed sensor works again."""
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


def air_notes(before: Row, after: Row, plan: Plan) -> list[str]:
    """Notes of changes of the airspeed sensor, the position and the wind hold in a step."""
    was, now, notes = state_of_row(before), state_of_row(after), list[str]()
    trusted, begins = now.estimation.air.sensor.trusted, was.estimation.air.time < 0.0
    if trusted != was.estimation.air.sensor.trusted or begins:
        is_told = now.estimation.consistency.air.airspeed_doubt > 0.0
        notes += sensor_notes(trusted, begins=begins, is_told=is_told)
    resets = now.estimation.resets
    if resets.number != was.estimation.resets.number and not settled(resets):
        notes.append(JUMPED.format(size=resets.size))
    if now.mission.wind_hold.holds != was.mission.wind_hold.holds:
        notes.append(wind_note(now, plan))
    return notes


def sensor_notes(trusted: bool, *, begins: bool, is_told: bool) -> list[str]:
    """Notes of the state of the airspeed sensor; none where a flight begins with a good one.

    Args:
        trusted: whether it is believed.
        begins: whether the flight begins.
        is_told: whether it tells an airspeed.
    """
    if trusted:
        return [] if begins else [SENSOR_BACK]
    return [f"{NO_SENSOR if begins and not is_told else SENSOR_LOST}: {ESTIMATED}"]


def wind_note(s: LoopState, plan: Plan) -> str:
    """Note of a wind hold that begins or ends."""
    goal, hold = s.mission.goal, s.mission.wind_hold
    if not hold.holds:
        return f"{WEAK_AGAIN}: {route_note(goal, plan)}"
    what = f"goal {goal + 1} unreachable" if goal < len(plan.goals) else "no circle"
    speed = plan.gains.airspeed
    return f"{what} now: wind {hold.ratio * speed:.0f} of {speed:.0f} m/s, holding against it"
