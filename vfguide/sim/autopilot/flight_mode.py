"""The flight modes of the software autopilot and the table of their changes."""

from enum import Enum, auto

from vfguide.autopilots.px4 import Px4Mode


class Mode(Enum):
    """What the autopilot is flying."""

    HOLD = auto()
    """A circle at constant height."""
    RETURN = auto()
    """A circle about the place where it started."""
    OFFBOARD = auto()
    """The setpoints of a companion."""
    LOST_TO_HOLD = auto()
    """HOLD as failsafe: setpoints have ceased; until they resume or a mode is asked for."""
    LOST_TO_RETURN = auto()
    """RETURN as failsafe: setpoints have ceased; until they resume or a mode is asked for."""


class Event(Enum):
    """What can happen."""

    HOLD_ASKED = auto()
    """HOLD is asked for."""
    RETURN_ASKED = auto()
    """RETURN is asked for."""
    OFFBOARD_ASKED = auto()
    """OFFBOARD is asked for while setpoints arrive; without them it is refused before."""
    STREAM_LOST_HOLD = auto()
    """Setpoints have ceased to arrive, and the parameters ask for a hold then."""
    STREAM_LOST_RETURN = auto()
    """Setpoints have ceased to arrive, and the parameters ask for a return then."""
    STREAM_BACK = auto()
    """Setpoints arrive again."""


FAILSAFE_MODES = (Mode.LOST_TO_HOLD, Mode.LOST_TO_RETURN)
"""Modes of the failsafe that setpoints which cease start."""

_ASKED = {
    Event.HOLD_ASKED: Mode.HOLD,
    Event.RETURN_ASKED: Mode.RETURN,
    Event.OFFBOARD_ASKED: Mode.OFFBOARD,
}
_BY_ITSELF = {
    (Mode.OFFBOARD, Event.STREAM_LOST_HOLD): Mode.LOST_TO_HOLD,
    (Mode.OFFBOARD, Event.STREAM_LOST_RETURN): Mode.LOST_TO_RETURN,
    (Mode.LOST_TO_HOLD, Event.STREAM_BACK): Mode.OFFBOARD,
    (Mode.LOST_TO_RETURN, Event.STREAM_BACK): Mode.OFFBOARD,
}

NEXT_MODE: dict[tuple[Mode, Event], Mode] = {
    (mode, event): _ASKED.get(event) or _BY_ITSELF.get((mode, event), mode)
    for mode in Mode
    for event in Event
}
"""The next mode for every pair of mode and event; a mode that was asked for is always taken."""

REPORTED = {
    Mode.HOLD: Px4Mode.HOLD,
    Mode.RETURN: Px4Mode.RETURN,
    Mode.OFFBOARD: Px4Mode.OFFBOARD,
    Mode.LOST_TO_HOLD: Px4Mode.HOLD,
    Mode.LOST_TO_RETURN: Px4Mode.RETURN,
}
"""The mode that the heartbeat reports."""

INTENDED = REPORTED | dict.fromkeys(FAILSAFE_MODES, Px4Mode.OFFBOARD)
"""The mode that was asked for last, to which the failsafe goes back."""

ASKED_BY = {
    Px4Mode.HOLD: Event.HOLD_ASKED,
    Px4Mode.RETURN: Event.RETURN_ASKED,
    Px4Mode.OFFBOARD: Event.OFFBOARD_ASKED,
}
"""The event of each mode that can be asked for; the others need a pilot, a runway or a mission."""
