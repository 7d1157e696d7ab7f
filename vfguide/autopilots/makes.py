"""The makes of autopilots that the companion can fly with."""

from vfguide.autopilots.autopilot import Autopilot
from vfguide.autopilots.px4 import PX4

AUTOPILOTS: tuple[Autopilot, ...] = (PX4,)
"""Every one that is known."""
BY_MAKE: dict[int, Autopilot] = {autopilot.make: autopilot for autopilot in AUTOPILOTS}
"""The same by HEARTBEAT.autopilot, a MAV_AUTOPILOT."""
ASSUMED = PX4
"""Stands for an autopilot that was not heard yet, or whose make is not known."""


def autopilot_of(make: int) -> Autopilot:
    """The autopilot whose heartbeat tells this MAV_AUTOPILOT."""
    return BY_MAKE.get(make, ASSUMED)
