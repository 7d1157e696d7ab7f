"""What the operator should read, in plain words."""

from vfguide.companion.engagement import Phase
from vfguide.companion.plan import Plan
from vfguide.companion.route_memory import (
    AIR_TIME,
    ALARMED,
    JUMP_SIZE,
    JUMPS,
    LEAST,
    RATIO,
    PackedMemory,
    given_up_in,
    goal_in,
    holds_in,
    missed_in,
    settled_in,
    trusts_sensor_in,
)
from vfguide.flight.identification import Identified
from vfguide.link.messages import GpsGlobalOrigin
from vfguide.link.px4 import Px4Mode

SILENT_UNTIL_CHANGE = (
    "the autopilot already follows somebody's setpoints: silent until it flies another mode"
)
CHOICE_LEFT = "waiting for the operator to choose OFFBOARD"
LINK_LOST = "link lost, no heartbeat for 3 s: no setpoints until the autopilot is heard again"

ON_ENTERING = {
    Phase.SEARCHING: LINK_LOST,
    Phase.ASKING: "asking the autopilot for OFFBOARD",
    Phase.FLYING: "the autopilot follows",
    Phase.INTERRUPTED: LINK_LOST,
    Phase.RETURNING: "handing over: asking the autopilot for HOLD",
    Phase.RELEASED: "released: the mode was changed to {mode}, no more setpoints",
    Phase.ENDED: "ended: the autopilot flies {mode}",
    Phase.UNCONFIRMED: "ended without a link: what the autopilot flies is up to its failsafe",
}


def mode_name(custom_mode: int | None) -> str:
    """The autopilot's mode, in PX4's words."""
    if custom_mode is None:
        return "nothing known"
    known = custom_mode in set(Px4Mode)
    return Px4Mode(custom_mode).name if known else f"mode {custom_mode}"


def phase_note(before: Phase, after: Phase, custom_mode: int | None, engage: bool) -> str:
    """What a change of phase means.

    Args:
        before: the phase that is over.
        after: the one that begins.
        custom_mode: what the autopilot flies; None: unknown.
        engage: whether the companion asks for OFFBOARD by itself.
    """
    mode = mode_name(custom_mode)
    if after is not Phase.OFFERING:
        return ON_ENTERING[after].format(mode=mode)
    if before is Phase.ASKING:
        return CHOICE_LEFT
    plan = "OFFBOARD will be asked for" if engage else CHOICE_LEFT
    return f"the autopilot is found, it flies {mode}; setpoints go out, {plan}"


def route_note(goal: int, plan: Plan) -> str:
    """What is flown to."""
    goals = len(plan.goals)
    return f"flying to goal {goal + 1} of {goals}" if goal < goals else "loitering"


def passage_note(before: PackedMemory, after: PackedMemory, miss: float, plan: Plan) -> str:
    """A goal was passed with a `miss` [m]; the memory before and after."""
    goal = goal_in(before) + 1
    if given_up_in(after) > given_up_in(before):
        return f"goal {goal} missed {times(missed_in(before) + 1)}: {onward(goal, plan)}"
    if goal_in(after) == goal_in(before):
        return f"goal {goal} missed by {miss:.1f} m or by its course: going round"
    return f"goal {goal} reached, {miss:.1f} m off; {route_note(goal_in(after), plan)}"


def onward(passed: int, plan: Plan) -> str:
    """What follows after so many goals."""
    return f"going on to goal {passed + 1}" if passed < len(plan.goals) else "loitering"


def times(number: int) -> str:
    """How often, in words."""
    return "once" if number == 1 else f"{number} times"


TESTING = "test flight: {what}"
NO_ROOM = "no room for a test flight here: flown with what is known of the aircraft"
BROKEN_OFF = "test flight broken off, something is in its way: nothing was measured"
MEASURED = "measured: {names}"
UNSEEN = "not seen well enough, flown as it was known before: {names}"


def identified_notes(found: Identified) -> list[str]:
    """What a test flight has shown."""
    seen = [str(its) for its in found.findings if its.used]
    unseen = [its.key for its in found.findings if not its.used]
    lists = ((MEASURED, seen), (UNSEEN, unseen))
    return [note.format(names=", ".join(names)) for note, names in lists if names]


NO_SENSOR = "no airspeed sensor"
SENSOR_LOST = "the airspeed sensor is not believed any more"
ESTIMATED = "airspeed is estimated, it flies faster and with less bank"
SENSOR_BACK = "the airspeed sensor is believed again"
JUMPED = "the position told by the autopilot has jumped by {size:.0f} m: let in slowly"
ORIGIN_MOVED = "the autopilot has moved the origin of its local frame: heeded"
WEAK_AGAIN = "the wind has fallen"
NO_PROGRESS = (
    "no progress to goal {goal}: flown a full circle more than its way has, "
    "and no nearer than {least:.0f} m along it"
)


def origin_notes(before: GpsGlobalOrigin | None, after: GpsGlobalOrigin | None) -> list[str]:
    """The origin of the local frame was told again: where it was, or elsewhere."""
    if before is None or after is None:
        return []
    was = (before.latitude, before.longitude, before.altitude)
    return [] if was == (after.latitude, after.longitude, after.altitude) else [ORIGIN_MOVED]


def progress_notes(before: PackedMemory, after: PackedMemory) -> list[str]:
    """A leg has begun to come to no end."""
    if after[ALARMED] <= before[ALARMED]:
        return []
    return [NO_PROGRESS.format(goal=goal_in(after) + 1, least=after[LEAST])]


def air_notes(before: PackedMemory, after: PackedMemory, plan: Plan) -> list[str]:
    """What has changed in a step about the air and the autopilot's place."""
    notes: list[str] = []
    if trusts_sensor_in(after) != trusts_sensor_in(before) or before[AIR_TIME] < 0.0:
        notes += sensor_notes(trusts_sensor_in(after), begins=before[AIR_TIME] < 0.0)
    if after[JUMPS] != before[JUMPS] and not settled_in(after):
        notes.append(JUMPED.format(size=after[JUMP_SIZE]))
    if holds_in(after) != holds_in(before):
        notes.append(wind_note(after, plan))
    return notes


def sensor_notes(trusted: bool, *, begins: bool) -> list[str]:
    """What the airspeed sensor is worth now; nothing where a flight begins with a good one."""
    if trusted:
        return [] if begins else [SENSOR_BACK]
    return [f"{NO_SENSOR if begins else SENSOR_LOST}: {ESTIMATED}"]


def wind_note(memory: PackedMemory, plan: Plan) -> str:
    """A goal cannot be reached in this wind, or can again."""
    goal = goal_in(memory)
    if not holds_in(memory):
        return f"{WEAK_AGAIN}: {route_note(goal, plan)}"
    what = f"goal {goal + 1} unreachable" if goal < len(plan.goals) else "no circle"
    speed = plan.gains.airspeed
    return f"{what} now: wind {memory[RATIO] * speed:.0f} of {speed:.0f} m/s, holding against it"
