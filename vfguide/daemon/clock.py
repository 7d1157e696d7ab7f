"""The date and time, for a process that must not see it step."""

import time

from vfguide.geometry.units import NS_PER_US


class Clock:
    """Microseconds since 1970, read once from the system and carried on by a monotonic clock."""

    def __init__(self) -> None:
        self._offset = time.time_ns() - time.monotonic_ns()

    def now(self) -> int:
        """The date and time, UTC [us since 1970]; it never goes back."""
        return (time.monotonic_ns() + self._offset) // NS_PER_US
