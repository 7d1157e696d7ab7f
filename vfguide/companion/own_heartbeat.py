"""The companion's own heartbeat: who it is, and how it is."""

from vfguide.autopilots.engagement import Phase
from vfguide.geometry.units import SECOND
from vfguide.link.enums import MavAutopilot, MavState, MavType
from vfguide.link.messages import Heartbeat

STATUS = {
    Phase.FLYING: MavState.ACTIVE,
    Phase.RETURNING: MavState.ACTIVE,
    Phase.INTERRUPTED: MavState.CRITICAL,
}
"""State by the phase, STANDBY in all others: CRITICAL while the link to the autopilot is lost."""


class OwnHeartbeat:
    """Heartbeats, one a second."""

    def __init__(self) -> None:
        self.due_at = 0
        """When the next one is due [us since 1970]."""

    def send(self, now: int, phase: Phase) -> Heartbeat:
        """The heartbeat that goes out now [us since 1970]."""
        self.due_at = now + SECOND
        status = STATUS.get(phase, MavState.STANDBY)
        return Heartbeat(MavType.ONBOARD_CONTROLLER, MavAutopilot.INVALID, 0, 0, status)
