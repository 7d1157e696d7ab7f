"""The vehicles of a run as its loop sees them, whatever they are made of."""

from collections.abc import Sequence
from typing import Protocol

from vfguide.scenario.passes import Legs
from vfguide.scenario.record import FlightRecord
from vfguide.scenario.resolved import Vehicle


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
    def grounded(self) -> bool:
        """Whether a flight has ended on the ground."""
        ...

    def advance(self) -> None:
        """Every vehicle flies on to the next update."""
        ...

    def records(self) -> tuple[FlightRecord, ...]:
        """What was noted of the flights, in the order of the scenario."""
        ...
