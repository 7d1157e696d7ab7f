"""Other aircraft of a scenario, as they are written."""

from typing import Annotated, Literal

from pydantic import AfterValidator, Field

from vfguide.files.toml_types import Position, Table, Vector, above, between, rule_broken, word


def _address(text: str) -> str:
    """Six hexadecimal digits, as aircraft registers print it."""
    digits = set("0123456789abcdefABCDEF")
    if len(text) != 6 or not set(text) <= digits or int(text, 16) == 0:
        raise rule_broken('allowed are six hexadecimal digits, "000001" to "FFFFFF"')
    return text.upper()


def _callsign(text: str) -> str:
    if not 1 <= len(text) <= 8 or not text.isascii() or not text.isalnum():
        raise rule_broken("allowed are 1 to 8 letters and digits")
    return text


def _flyable(values: tuple[float, float, float]) -> tuple[float, float, float]:
    if not all(abs(value) <= 300.0 for value in values) or abs(values[2]) > 100.0:
        raise rule_broken("out of range, allowed -300 to 300, downward -100 to 100")
    return values


Address = Annotated[str, AfterValidator(_address)]
Velocity = Annotated[Vector, AfterValidator(_flyable)]
"""North, east, down [m/s]."""


AltitudeType = Annotated[Literal["geometric", "qne", "qnh"], word("geometric", "qne", "qnh")]
"""Heights of transponders: above the ellipsoid; in the standard atmosphere; above mean sea level,
by the pressure of the day."""


class TrafficChange(Table):
    """A velocity that the aircraft changes to."""

    time_s: Annotated[float, between(0, 86_400)]
    """When it begins to."""
    velocity_mps: Velocity
    within_s: Annotated[float, above(0, 600)] = 5.0
    """How long it takes."""


class TrafficEntry(Table):
    """Another aircraft with a transponder; it avoids no other."""

    name: Annotated[str, AfterValidator(_callsign)]
    """Its callsign."""
    icao: Address | None = None
    """None: its index, from 1."""
    position_m: Position
    """At time zero."""
    velocity_mps: Velocity
    interval_s: Annotated[float, between(0.1, 60)] = 1.0
    """Between two reports."""
    delay_s: Annotated[float, between(0, 60)] = 0.0
    """From a position to the arrival of its report."""
    position_error_m: Annotated[float, between(0, 1000)] = 0.0
    """Standard deviation of each axis of the reported position."""
    altitude_type: AltitudeType = "geometric"
    """Which height it reports."""
    change: list[TrafficChange] = Field(default_factory=list[TrafficChange])


class TrafficReceiver(Table):
    """What every vehicle hears transponders with."""

    range_m: Annotated[float, between(0, 1_000_000)] = 20_000.0
