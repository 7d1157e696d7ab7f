"""Rows of flights made by hand, and a pool that flies them in whatever order."""

import random

from vfguide.campaign.draws import Draw
from vfguide.campaign.flight import Job
from vfguide.campaign.rows import FlightRow, failed_row
from vfguide.results.result import GoalResult, ObstacleResult, VehicleResult


def goal(miss: float | None = 0.5, *, reached: bool = True) -> GoalResult:
    return GoalResult(reached, 20.0, miss, miss, 0.25, 0.125)


def vehicle(*goals: GoalResult, clearances: tuple[float | None, ...] = ()) -> VehicleResult:
    obstacles = tuple(
        ObstacleResult(str(index), 1.5, clearance) for index, clearance in enumerate(clearances)
    )
    ranges = ((0.9, 1.5), (24.0, 26.0), (630.0, 640.0))
    return VehicleResult(1, goals, obstacles, None, None, None, 40.0, *ranges, 1000, 50.0)


def flown_row(draw: Draw) -> FlightRow:
    """A good flight whose miss follows from its seed."""
    miss = draw.seed / 2**32
    return FlightRow(
        draw.index, draw.seed, "good", (), "a", "b", True, 1, miss, vehicles=(vehicle(goal(miss)),)
    )


class HandPool:
    """Flies by hand: each flight ends when chance has it, with the row that `fly` makes."""

    def __init__(self, seed: int = 0, room: int = 8, fly=flown_row):
        self._chance, self._room, self._fly = random.Random(seed), room, fly
        self._flying: list[Job] = []
        self.flown: list[int] = []

    @property
    def has_room(self):
        return len(self._flying) < self._room

    @property
    def is_idle(self):
        return not self._flying

    def submit(self, job):
        self._flying.append(job)

    def ended(self, timeout):
        self._chance.shuffle(self._flying)
        count = self._chance.randint(0, len(self._flying))
        done, self._flying = self._flying[:count], self._flying[count:]
        self.flown += [job.draw.index for job in done]
        return [(job, self._fly(job.draw)) for job in done]


def failing(draw: Draw) -> FlightRow:
    """Every third flight fails."""
    return failed_row(draw, "no engine", "a", "b") if draw.index % 3 == 0 else flown_row(draw)
