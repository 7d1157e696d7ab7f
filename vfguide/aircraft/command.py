"""The command of a law of guidance, which the assurance may replace."""

from typing import NamedTuple


class GuidanceCommand(NamedTuple):
    """What control flies at one step, and what displays and logs show of it."""

    course: float
    """Wanted course over ground [rad]."""
    azimuth: float
    """Wanted azimuth of the air velocity [rad]."""
    gamma: float
    """Path angle through the air to fly [rad], up positive."""
    climb: float
    """Path angle that thrust is set for [rad]: `gamma`, or more where the height asks for more."""
    bank: float
    """Bank to fly [rad], right wing down positive."""
    load: float
    """Load factor to fly."""
    remaining: float
    """Path length to the goal [m]."""
    phase: int
    """Phase of the leg, see `vfguide.paths.leg`."""
    radius: float
    """Turn radius of the approach [m]."""
