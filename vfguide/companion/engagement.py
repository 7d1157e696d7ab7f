"""Who flies: the table of the companion's phases.

The companion takes control only when asked to, gives it back when stopped, and never takes
it again after somebody else changed the mode.
"""

from enum import Enum, auto


class Phase(Enum):
    """What the companion is doing."""

    SEARCHING = auto()
    """No autopilot is heard, or one that already follows somebody's setpoints: silent."""
    OFFERING = auto()
    """Setpoints go out, the autopilot flies in a mode of its own."""
    FLYING = auto()
    """The autopilot follows the setpoints."""
    INTERRUPTED = auto()
    """It followed them when it was last heard: silent until it is known still to do so."""
    RETURNING = auto()
    """Stopping: the autopilot was asked to hold, setpoints go out until it does."""
    RELEASED = auto()
    """Somebody else took over: silent."""
    ENDED = auto()
    """Control was handed over, or never taken: silent."""


class Event(Enum):
    """What can happen."""

    OFFBOARD_SEEN = auto()
    """A heartbeat tells that the autopilot follows setpoints."""
    OTHER_MODE_SEEN = auto()
    """A heartbeat tells of any other mode."""
    LINK_LOST = auto()
    """No heartbeat for three seconds."""
    STOP_ASKED = auto()
    """The operator of the companion ends it."""


SENDING = frozenset({Phase.OFFERING, Phase.FLYING, Phase.RETURNING})
"""Phases in which setpoints go out."""

NEXT: dict[tuple[Phase, Event], Phase] = {
    (Phase.SEARCHING, Event.OFFBOARD_SEEN): Phase.SEARCHING,
    (Phase.SEARCHING, Event.OTHER_MODE_SEEN): Phase.OFFERING,
    (Phase.SEARCHING, Event.LINK_LOST): Phase.SEARCHING,
    (Phase.SEARCHING, Event.STOP_ASKED): Phase.ENDED,
    (Phase.OFFERING, Event.OFFBOARD_SEEN): Phase.FLYING,
    (Phase.OFFERING, Event.OTHER_MODE_SEEN): Phase.OFFERING,
    (Phase.OFFERING, Event.LINK_LOST): Phase.SEARCHING,
    (Phase.OFFERING, Event.STOP_ASKED): Phase.ENDED,
    (Phase.FLYING, Event.OFFBOARD_SEEN): Phase.FLYING,
    (Phase.FLYING, Event.OTHER_MODE_SEEN): Phase.RELEASED,
    (Phase.FLYING, Event.LINK_LOST): Phase.INTERRUPTED,
    (Phase.FLYING, Event.STOP_ASKED): Phase.RETURNING,
    (Phase.INTERRUPTED, Event.OFFBOARD_SEEN): Phase.FLYING,
    (Phase.INTERRUPTED, Event.OTHER_MODE_SEEN): Phase.RELEASED,
    (Phase.INTERRUPTED, Event.LINK_LOST): Phase.INTERRUPTED,
    (Phase.INTERRUPTED, Event.STOP_ASKED): Phase.ENDED,
    (Phase.RETURNING, Event.OFFBOARD_SEEN): Phase.RETURNING,
    (Phase.RETURNING, Event.OTHER_MODE_SEEN): Phase.ENDED,
    (Phase.RETURNING, Event.LINK_LOST): Phase.ENDED,
    (Phase.RETURNING, Event.STOP_ASKED): Phase.RETURNING,
    (Phase.RELEASED, Event.OFFBOARD_SEEN): Phase.RELEASED,
    (Phase.RELEASED, Event.OTHER_MODE_SEEN): Phase.RELEASED,
    (Phase.RELEASED, Event.LINK_LOST): Phase.RELEASED,
    (Phase.RELEASED, Event.STOP_ASKED): Phase.ENDED,
    (Phase.ENDED, Event.OFFBOARD_SEEN): Phase.ENDED,
    (Phase.ENDED, Event.OTHER_MODE_SEEN): Phase.ENDED,
    (Phase.ENDED, Event.LINK_LOST): Phase.ENDED,
    (Phase.ENDED, Event.STOP_ASKED): Phase.ENDED,
}
"""Every pair of phase and event."""
