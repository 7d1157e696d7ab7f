"""The makes of autopilots that the companion can fly with."""

from vfguide.autopilots.autopilot import Autopilot
from vfguide.autopilots.px4 import PX4

AUTOPILOTS: tuple[Autopilot, ...] = (PX4,)
"""The record of every make that is known."""
BY_MAKE: dict[int, Autopilot] = {autopilot.make: autopilot for autopilot in AUTOPILOTS}
"""The record of each make, by HEARTBEAT.autopilot, a MAV_AUTOPILOT."""
ASSUMED = PX4
"""The record that is used before the first HEARTBEAT, and for makes that are not known."""


def autopilot_of(make: int) -> Autopilot:
    """The record of the make in a HEARTBEAT, a MAV_AUTOPILOT; ASSUMED if it is not known."""
    return BY_MAKE.get(make, ASSUMED)
