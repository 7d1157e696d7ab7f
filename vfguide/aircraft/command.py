"""What a law of guidance commands, and what the assurance makes of it."""

from typing import NamedTuple


class GuidanceCommand(NamedTuple):
    """What control is asked to fly at one step, and what displays and logs show of it."""

    course: float
    """Over ground [rad]."""
    azimuth: float
    """Of the air velocity [rad]."""
    gamma: float
    """Path angle through the air [rad]."""
    climb: float
    """The same, or the steeper one that the height asks for: thrust is set for it [rad]."""
    bank: float
    load: float
    remaining: float
    """Path length to the goal [m]."""
    phase: int
    radius: float
    """Turn radius of the approach [m]."""
