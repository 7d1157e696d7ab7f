"""The command of a law of guidance, which the assurance may replace."""

from typing import NamedTuple

from vfguide.kernels.compiled import compiled


class CommandRates(NamedTuple):
    """How a command, and the air velocity that flies it, change along the motion."""

    are_known: bool
    """Whether the law gives them; else the others are zero."""
    azimuth: float
    """Of the azimuth of the air velocity [rad/s]."""
    path: float
    """Of its path angle [rad/s]."""
    gamma: float
    """Of the commanded path angle [rad/s]."""
    bank: float
    """Of the commanded bank [rad/s]."""
    load: float
    """Of the commanded load factor [1/s]."""


@compiled
def unknown_rates() -> CommandRates:
    """The rates of a command whose law does not give them."""
    return CommandRates(False, 0.0, 0.0, 0.0, 0.0, 0.0)


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
    rates: CommandRates
    """How it changes along the motion."""
