"""The autopilots that the companion can fly with, and who is none of them."""

from vfguide.autopilots.autopilot import Autopilot
from vfguide.autopilots.px4 import PX4
from vfguide.link.enums import MavAutopilot, MavType
from vfguide.link.messages import Heartbeat

AUTOPILOTS: tuple[Autopilot, ...] = (PX4,)
"""The record of every make that is known."""
BY_MAKE: dict[int, Autopilot] = {autopilot.make: autopilot for autopilot in AUTOPILOTS}
"""The record of each make, by HEARTBEAT.autopilot, a MAV_AUTOPILOT."""
ASSUMED = PX4
"""The record that is used before the first HEARTBEAT."""
MAVLINK_VERSION = 3
"""Version of the protocol in the HEARTBEAT of MAVLink 1 and 2, a number (its XML definition)."""


def autopilot_of(said: Heartbeat) -> Autopilot | None:
    """The record of who says this; None: it is no autopilot that the companion can fly with."""
    found = BY_MAKE.get(said.autopilot)
    if found is None or said.mavlink_version != MAVLINK_VERSION:
        return None
    return found if said.type in found.kinds else None


def describe(said: Heartbeat) -> str:
    """Who says a HEARTBEAT, in words."""
    make, kind = name_in(MavAutopilot, said.autopilot), name_in(MavType, said.type)
    version = said.mavlink_version
    protocol = "" if version == MAVLINK_VERSION else f", protocol version {version}"
    return f"autopilot {make}, type {kind}{protocol}"


def flown() -> str:
    """All that the companion can fly with, in words."""
    return " or ".join(
        f"{each.make.name} with type {', '.join(kind.name for kind in each.kinds)}"
        for each in AUTOPILOTS
    )


def name_in(names: type[MavAutopilot] | type[MavType], number: int) -> str:
    """The name of a number, or the number where it has none."""
    return names(number).name if number in set(names) else str(number)
