"""The vehicles of a run as its loop sees them, whatever they are made of."""

from collections.abc import Sequence
from enum import Enum
from typing import Protocol

from vfguide.results.goal_passages import Legs
from vfguide.results.record import FlightRecord
from vfguide.scenario.resolved import Vehicle


class Ending(Enum):
    """Why a flight ended."""

    REACHED = "reached"
    """5 s after every vehicle reached its last goal, or gave it up."""
    TIME = "time"
    """The time allowed is over."""
    GROUND = "ground"
    """A vehicle touched the ground."""
    FAR_AWAY = "away"
    """A vehicle is farther away than `FAR_AWAY` of `vfguide.results.verdict`."""
    STOPPED = "interrupted"
    """The user stopped it."""


class Flown(Protocol):
    """One vehicle of a run."""

    @property
    def vehicle(self) -> Vehicle:
        """What it is in the scenario."""
        ...

    @property
    def legs(self) -> Legs:
        """Its legs so far."""
        ...


class Fleet(Protocol):
    """All the vehicles of a run, on one clock."""

    @property
    def members(self) -> Sequence[Flown]:
        """The vehicles in the order of the scenario."""
        ...

    @property
    def period(self) -> float:
        """Time from one update to the next [s]."""
        ...

    @property
    def ending(self) -> Ending | None:
        """Why no vehicle can fly on, if that is so."""
        ...

    def advance(self) -> None:
        """Every vehicle flies on to the next update."""
        ...

    def records(self) -> tuple[FlightRecord, ...]:
        """What was noted of the flights, in the order of the scenario."""
        ...
