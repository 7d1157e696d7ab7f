"""What the operator reads of a step: what differs between the state before it and after it."""

import math
from typing import NamedTuple

from vfguide.annunciations.airspeed_notes import AirspeedAnnunciator
from vfguide.annunciations.doubt_notes import doubt_notes, unfit
from vfguide.annunciations.flight_notes import leader_notes, reset_notes, wind_notes
from vfguide.annunciations.hazard_notes import HazardAnnunciator
from vfguide.kernels.rows import Row
from vfguide.loop.loop_report import changes, doubts_of_row, trusts_sensor_of_row

RESET_NOTE_INTERVAL = 5000
"""Least time between two notes of position resets [ms]; chosen."""


class Briefing(NamedTuple):
    """What notes of its steps mention of a plan."""

    goals: int
    """Number of its goals."""
    airspeed: float
    """True airspeed that it asks for [m/s]."""
    hazard_names: tuple[str, ...] | None
    """Names of its hazards, by their numbers; None: it knows none."""


class StepAnnunciator:
    """Makes the notes of the steps of one vehicle, and remembers what the operator knows."""

    def __init__(self, plan: Briefing) -> None:
        """No step of the plan has been flown."""
        self.unfit: str | None = None
        """Why what the autopilot reports cannot be flown on; None where it can."""
        self.has_news = False
        """Whether the last step changed anything of air, position, wind, progress and who leads."""
        self._airspeed = AirspeedAnnunciator()
        self._told_reset: int | None = None
        self.begin(plan)

    def begin(self, plan: Briefing) -> None:
        """A plan is flown from now on, or flown again: of its hazards nothing was told."""
        self._plan, names = plan, plan.hazard_names
        self._hazards = None if names is None else HazardAnnunciator(names)

    def doubts(self, before: Row, after: Row) -> list[str]:
        """Notes of doubts that a step, flown or not, begins or ends; rows of `LoopState`."""
        in_doubt, self.has_news = changes(before, after)
        self.unfit = None
        if not in_doubt:
            return []
        doubts = doubts_of_row(after)
        self.unfit = unfit(doubts)
        return doubt_notes(doubts_of_row(before), doubts)

    def events(
        self, before: Row, after: Row, now_ms: int, t: float, calibrated: float
    ) -> list[str]:
        """Notes of what a step that is flown has changed for the operator, doubts apart.

        Args:
            before: row of the `LoopState` before the step.
            after: row of the `LoopState` after it.
            now_ms: time of the attitude [ms].
            t: time on the clock of the obstacles [s].
            calibrated: calibrated airspeed that is told [m/s]; not a number where none is.
        """
        notes: list[str] = []
        if self.has_news:
            believes, hears = trusts_sensor_of_row(after), not math.isnan(calibrated)
            notes += self._airspeed.notes(believes, hears)
            notes += self._resets(before, after, now_ms)
            notes += leader_notes(before, after)
            notes += wind_notes(before, after, self._plan.goals, self._plan.airspeed)
        if self._hazards is not None:
            notes += self._hazards.notes(after, t)
        return notes

    def _resets(self, before: Row, after: Row, now_ms: int) -> list[str]:
        """The note of a position reset, and of no other one for a while: they come in a row."""
        notes = reset_notes(before, after)
        if self._told_reset is not None and now_ms - self._told_reset < RESET_NOTE_INTERVAL:
            return []
        if notes:
            self._told_reset = now_ms
        return notes
