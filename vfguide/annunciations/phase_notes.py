"""Notes of the link to an autopilot, and of who flies."""

from vfguide.autopilots.autopilot import Autopilot
from vfguide.autopilots.engagement import Phase

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
"""Note where the autopilot that is found is none that can be flown with."""
FOREIGN_HEARTBEAT = "a heartbeat of vehicle {sysid} that says {who} is not its autopilot's: ignored"
"""Note where somebody else speaks with the address of the autopilot."""
STOOD_STILL = "the companion stood still for {gap:.1f} s"
"""Note where this program did not run for a while."""
ENDED_UNFOUND = "ended: no autopilot was found"
"""Note at the end where no autopilot was ever found."""
ENDED_UNHEARD = "ended: the autopilot is not heard any more"
"""Note at the end where it is unknown what the autopilot flies, after a time without control."""
FALLEN_BACK = "the autopilot has fallen back on {mode} by itself"
"""Reason for silence where the autopilot's failsafe acts."""
NOT_ARMED = "the autopilot is not armed any more, as after a restart"
"""Reason for silence where the mode that it flies is nobody's choice."""
RESTARTED = "the autopilot has restarted or is another one: its clock has begun anew"
"""Reason for silence where the autopilot was not heard for long and reports another time."""
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
