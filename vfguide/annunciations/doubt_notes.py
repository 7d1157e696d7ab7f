"""What the operator reads of doubts, and when a doubt ends the flight.

Yaw, ground velocity, wind and airspeed are replaced while they are doubted, and the flight goes on.
Roll and pitch cannot be: setpoints stop at once. Yaw and ground velocity are replaced only for a
time, since a second fault would not be seen meanwhile. Wind and airspeed are estimated for as long
as it takes: many autopilots report neither.
"""

from typing import NamedTuple

from vfguide.loop.loop_report import Doubts

TOLD_AFTER = 0.5
"""Time of a doubt after which the operator is told [s]; chosen, so that a reset is no news."""
LONGEST_DOUBT = 30.0
"""Time for which yaw or ground velocity may be doubted before the flight ends [s]; chosen."""


class Words(NamedTuple):
    """What a doubt is called."""

    what: str
    """What is doubted."""
    instead: str
    """What is flown on instead."""


WORDS = {
    "yaw": Words("yaw", "with the yaw that ground velocity and wind ask for"),
    "velocity": Words("ground velocity", "with the motion of the position"),
    "wind": Words("wind", "with the estimated wind"),
}
"""Names of the doubts that are told here, by the fields of `Doubts`."""
DOUBTED = "the {what} told by the autopilot contradicts the rest: flown {instead}"
"""Note of a doubt that begins."""
BELIEVED = "the {what} told by the autopilot is believed again"
"""Note of a doubt that has ended."""
TILTED = "roll or pitch told by the autopilot contradict its body rates or the lift"
"""Reason for silence where roll or pitch are doubted."""
LASTS = "the {what} told by the autopilot has contradicted the rest for {time:.0f} s"
"""Reason for silence where a doubt lasts."""


def doubt_notes(before: Doubts, after: Doubts) -> list[str]:
    """Notes of the doubts that begin or end in a step."""
    notes: list[str] = []
    for name, words in WORDS.items():
        was, now = (getattr(doubts, name) > TOLD_AFTER for doubts in (before, after))
        if was != now:
            note = DOUBTED if now else BELIEVED
            notes.append(note.format(what=words.what, instead=words.instead))
    return notes


def unfit(doubts: Doubts) -> str | None:
    """Why the flight cannot go on with what the autopilot reports; None: it can."""
    if doubts.attitude > 0.0:
        return TILTED
    for name in ("yaw", "velocity"):
        if getattr(doubts, name) > LONGEST_DOUBT:
            return LASTS.format(what=WORDS[name].what, time=LONGEST_DOUBT)
    return None
