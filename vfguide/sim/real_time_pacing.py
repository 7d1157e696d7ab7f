"""When the steps of a simulation are due on a clock: pure arithmetic, nothing waits in here."""

import math

LONGEST_BACKLOG = 1.0
"""Delay beyond which lost time is not made up for [s]; chosen."""


class RealTimePacing:
    """The schedule of equal steps: step n is due n periods after the start, so nothing drifts.

    Times are readings of one clock that never goes back [s].
    """

    def __init__(self, start: float, period: float) -> None:
        """A schedule with one step each `period` [s] from `start` on."""
        self.period = period
        self.taken = 0
        """Steps taken so far."""
        self.worst = 0.0
        """The longest that a step was late [s]."""
        self.lost = 0.0
        """Time that was given up [s]: the schedule was moved by it."""
        self._start = start

    def due(self, now: float) -> int:
        """How many steps are due and not taken yet; counts how late the first of them is."""
        late = now - self._next()
        if late < 0.0:
            return 0
        self.worst = max(self.worst, late)
        if late > LONGEST_BACKLOG:
            self._start += late - LONGEST_BACKLOG
            self.lost += late - LONGEST_BACKLOG
            late = LONGEST_BACKLOG
        return 1 + math.floor(late / self.period)

    def take(self) -> int:
        """Take a step; returns its number, from 1 on."""
        self.taken += 1
        return self.taken

    def wait(self, now: float) -> float:
        """Time until the next step is due [s]; 0 if it already is."""
        return max(0.0, self._next() - now)

    def _next(self) -> float:
        return self._start + (self.taken + 1) * self.period
