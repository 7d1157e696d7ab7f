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
        self._sent: int | None = None

    def due(self, now: int, phase: Phase) -> list[Heartbeat]:
        """The heartbeat to send now [us], if it is time for one."""
        if self._sent is not None and now - self._sent < SECOND:
            return []
        self._sent = now
        status = STATUS.get(phase, MavState.STANDBY)
        return [Heartbeat(MavType.ONBOARD_CONTROLLER, MavAutopilot.INVALID, 0, 0, status)]
