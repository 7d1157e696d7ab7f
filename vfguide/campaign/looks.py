"""Looks at a campaign while it flies: whether its flights are enough to know what was asked."""

from collections.abc import Iterable, Mapping
from dataclasses import dataclass, field

from vfguide.campaign.condition import Condition

FLIGHTS_A_LOOK = 20
"""Number of flights between two looks; chosen. Looks are at fixed numbers of flights, in the order
of the flights, so that a campaign ends with the same one whoever flies it."""


@dataclass
class Looks:
    """The looks at one campaign."""

    condition: Condition | None
    """None: only the number of flights ends it."""
    successes: int = field(default=0, init=False)
    """Number of flights that count, among those that were looked at."""
    trials: int = field(default=0, init=False)
    """Number of flights that were looked at."""
    enough: int | None = field(default=None, init=False)
    """Number of flights at which the condition was decided; None: it is not."""
    is_met: bool | None = field(default=None, init=False)
    """Whether the condition is met; None: it is not decided."""

    def take(self, rows: Iterable[Mapping[str, object]]) -> None:
        """Look at the next flights, until it is decided."""
        if self.condition is None:
            return
        for row in rows:
            if self.enough is not None:
                return
            self.trials += 1
            self.successes += self.condition.holds(row)
            if self.trials % FLIGHTS_A_LOOK == 0:
                self.is_met = self.condition.decided(self.successes, self.trials)
                self.enough = None if self.is_met is None else self.trials
