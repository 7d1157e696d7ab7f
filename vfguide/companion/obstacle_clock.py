"""The clock of the obstacles: by the autopilot's date, else from when the autopilot follows.

The choice is settled when the autopilot begins to follow, so that obstacles do not leap in flight
because a date becomes known.
"""

from datetime import UTC, datetime
from typing import NamedTuple

from vfguide.companion.plan import Plan
from vfguide.geometry.units import MS, US
from vfguide.telemetry.knowledge import Knowledge

BY_DATE = "moving obstacles: by the autopilot's date it is {since:.0f} s after start_time"
"""Note where moving obstacles are by the date."""
BY_ENGAGEMENT = "moving obstacles count their time from when the autopilot follows: {why}"
"""Note where moving obstacles count their time from the engagement."""
NO_DATE = "it tells no date"
"""Reason where no date is known."""
FAR_DATE = "its date is {day}, start_time is farther away than the {longest:.0f} s of the plan"
"""Reason where the date is another one than that of the plan."""


class Timing(NamedTuple):
    """How the obstacles count their time."""

    by_date: bool
    """Whether by the autopilot's date."""
    why: str
    """Why not by the date; empty where it is."""


class ObstacleClock:
    """The time of the obstacles of one plan."""

    def __init__(self, plan: Plan) -> None:
        """A clock that has heard nothing yet."""
        self._plan = plan
        self._began: int | None = None
        self._settled: Timing | None = None
        self._told: Timing | None = None

    def time(self, known: Knowledge) -> float:
        """The time at the newest attitude [s]."""
        if self._began is None:
            self._began = known.time_ms
        timing = self._settled or self._timing(known)
        if timing.by_date and known.date is not None:
            return known.date.at(known.time_ms, self._plan.epoch)
        return (known.time_ms - self._began) * MS

    def settle(self, known: Knowledge) -> None:
        """Record that the autopilot begins to follow; only the first time counts."""
        if self._settled is None:
            self._settled = self._timing(known)
            self._began = known.time_ms

    def objection(self, known: Knowledge) -> str | None:
        """Why the autopilot must not follow yet: a start_time was chosen and is not now."""
        if self._settled is not None or not self._plan.has_start_time or not self._plan.moves:
            return None
        timing = self._timing(known)
        return None if timing.by_date else f"moving obstacles need the date, and {timing.why}"

    def notes(self, known: Knowledge) -> list[str]:
        """What the operator should read before the flight, each once."""
        if self._settled is not None or not self._plan.moves:
            return []
        before, self._told = self._told, self._timing(known)
        if before is not None and self._told.by_date == before.by_date:
            return []
        if not self._told.by_date:
            return [BY_ENGAGEMENT.format(why=self._told.why)]
        return [BY_DATE.format(since=self.time(known))]

    def _timing(self, known: Knowledge) -> Timing:
        """How the obstacles count their time, by what is known now."""
        plan, date = self._plan, known.date
        if date is None:
            return Timing(False, NO_DATE)
        since = date.at(known.time_ms, plan.epoch)
        if plan.moves and abs(since) > plan.longest:
            day = datetime.fromtimestamp(date.unix * US, UTC).date()
            return Timing(False, FAR_DATE.format(day=day, longest=plan.longest))
        return Timing(True, "")
