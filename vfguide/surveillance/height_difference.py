"""A difference of heights that the autopilot reports, as the range of what it may be.

The height of mean sea level above the ellipsoid changes by metres over tens of kilometres, and the
difference that weather makes to a pressure altitude by metres in an hour. One that changes faster
was wrong before or is wrong now, and nothing shows which: both are allowed for, until it could have
changed as far.
"""

from typing import NamedTuple

from vfguide.link.boot_time import elapsed

FOLLOWING_SPEED = 0.1
"""Speed with which a difference of heights is followed [m/s]; chosen, so that a change of 100 m is
followed after a quarter of an hour, and what was reported before is 6 m off after a minute."""


class HeightDifference(NamedTuple):
    """The range in which a difference of heights is, as the autopilot reports it."""

    least: float
    """Lower end of the range [m]."""
    greatest: float
    """Upper end of the range [m]."""
    time_ms: int
    """Time of the newest message, as time_boot_ms [ms]."""

    @property
    def middle(self) -> float:
        """The middle of the range [m]."""
        return 0.5 * (self.least + self.greatest)

    @property
    def doubt(self) -> float:
        """Half the width of the range [m]."""
        return 0.5 * (self.greatest - self.least)


def difference_after(
    before: HeightDifference | None, height: float, time_ms: int
) -> HeightDifference:
    """The range after a message that reports `height` [m] at a time_boot_ms [ms]."""
    if before is None:
        return HeightDifference(height, height, time_ms)
    followed = FOLLOWING_SPEED * max(0.0, elapsed(before.time_ms, time_ms))
    least = min(height, before.least + followed)
    return HeightDifference(least, max(height, before.greatest - followed), time_ms)
