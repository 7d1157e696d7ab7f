"""Engagement: whether companion or autopilot flies, as a table of phases and events.

The companion takes control only when asked to, gives it back when stopped, and never takes
it again after somebody else changed the mode. What it could not do itself, and what the autopilot's
failsafe did, nobody decided: after that it waits for the operator to choose.
"""

from enum import Enum, auto


class Phase(Enum):
    """The phases of the companion."""

    SEARCHING = auto()
    """No autopilot is heard, or one that already follows somebody's setpoints: silent."""
    OFFERING = auto()
    """Setpoints go out, the autopilot flies in a mode of its own."""
    ASKING = auto()
    """Setpoints go out, and the autopilot was asked to follow them."""
    FLYING = auto()
    """The autopilot follows the setpoints."""
    INTERRUPTED = auto()
    """It followed them when it was last heard: silent until it is known still to do so."""
    RETURNING = auto()
    """Stopping: the autopilot was asked to hold, setpoints go out until it does."""
    YIELDING = auto()
    """It cannot guide, or the autopilot has fallen back on its own failsafe: silent until the
    autopilot flies a mode that somebody chose."""
    RELEASED = auto()
    """Somebody else took over: silent."""
    ENDED = auto()
    """Control was handed over, or never taken: silent."""
    UNCONFIRMED = auto()
    """Stopped without knowing what the autopilot flies: silent."""


class Event(Enum):
    """The events that may change the phase."""

    FOLLOWING_SEEN = auto()
    """The autopilot reports that it follows setpoints."""
    OTHER_MODE_SEEN = auto()
    """The autopilot reports any other mode."""
    FALLBACK_SEEN = auto()
    """The autopilot reports any other mode, which its own failsafe chose."""
    LINK_LOST = auto()
    """Nothing is heard of the autopilot, or not what mode it flies."""
    UNABLE = auto()
    """The companion cannot guide: it stood still for too long, or the link is too slow."""
    ABLE_AGAIN = auto()
    """It can guide again, and the autopilot flies a mode that somebody chose."""
    FOLLOWING_ASKED = auto()
    """The companion asks the autopilot to follow."""
    ASKING_GIVEN_UP = auto()
    """The companion will not ask again: the decision is the operator's."""
    STOP_ASKED = auto()
    """The operator of the companion ends it."""
    STOP_ASKED_OF_OTHER_MODE = auto()
    """So he does, while the companion yields and the autopilot flies any other mode."""


SENDING = (Phase.OFFERING, Phase.ASKING, Phase.FLYING, Phase.RETURNING)
"""Phases in which setpoints are sent."""
FINAL_PHASES = (Phase.ENDED, Phase.UNCONFIRMED)
"""Phases that have no successor."""

_CHANGES: dict[tuple[Phase, Event], Phase] = {
    (Phase.SEARCHING, Event.OTHER_MODE_SEEN): Phase.OFFERING,
    (Phase.SEARCHING, Event.FALLBACK_SEEN): Phase.OFFERING,
    (Phase.SEARCHING, Event.STOP_ASKED): Phase.ENDED,
    (Phase.OFFERING, Event.FOLLOWING_SEEN): Phase.FLYING,
    (Phase.OFFERING, Event.LINK_LOST): Phase.SEARCHING,
    (Phase.OFFERING, Event.FOLLOWING_ASKED): Phase.ASKING,
    (Phase.OFFERING, Event.STOP_ASKED): Phase.ENDED,
    (Phase.ASKING, Event.FOLLOWING_SEEN): Phase.FLYING,
    (Phase.ASKING, Event.LINK_LOST): Phase.SEARCHING,
    (Phase.ASKING, Event.UNABLE): Phase.YIELDING,
    (Phase.ASKING, Event.ASKING_GIVEN_UP): Phase.OFFERING,
    (Phase.ASKING, Event.STOP_ASKED): Phase.RETURNING,
    (Phase.FLYING, Event.OTHER_MODE_SEEN): Phase.RELEASED,
    (Phase.FLYING, Event.FALLBACK_SEEN): Phase.YIELDING,
    (Phase.FLYING, Event.LINK_LOST): Phase.INTERRUPTED,
    (Phase.FLYING, Event.UNABLE): Phase.YIELDING,
    (Phase.FLYING, Event.STOP_ASKED): Phase.RETURNING,
    (Phase.INTERRUPTED, Event.FOLLOWING_SEEN): Phase.FLYING,
    (Phase.INTERRUPTED, Event.OTHER_MODE_SEEN): Phase.RELEASED,
    (Phase.INTERRUPTED, Event.FALLBACK_SEEN): Phase.YIELDING,
    (Phase.INTERRUPTED, Event.UNABLE): Phase.YIELDING,
    (Phase.INTERRUPTED, Event.STOP_ASKED): Phase.UNCONFIRMED,
    (Phase.YIELDING, Event.ABLE_AGAIN): Phase.OFFERING,
    (Phase.YIELDING, Event.STOP_ASKED): Phase.RETURNING,
    (Phase.YIELDING, Event.STOP_ASKED_OF_OTHER_MODE): Phase.ENDED,
    (Phase.RETURNING, Event.OTHER_MODE_SEEN): Phase.ENDED,
    (Phase.RETURNING, Event.FALLBACK_SEEN): Phase.ENDED,
    (Phase.RETURNING, Event.LINK_LOST): Phase.UNCONFIRMED,
    (Phase.RELEASED, Event.STOP_ASKED): Phase.ENDED,
}

TRANSITIONS: dict[tuple[Phase, Event], Phase] = {
    (phase, event): _CHANGES.get((phase, event), phase) for phase in Phase for event in Event
}
"""The next phase for every pair of phase and event; pairs without an entry in `_CHANGES` change
nothing."""
