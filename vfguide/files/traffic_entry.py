"""Other aircraft of a scenario, as they are written."""

from typing import Annotated, Literal

from pydantic import AfterValidator, Field

from vfguide.files.toml_types import Position, Table, Vector, above, between, rule_broken, word


def _address(text: str) -> str:
    """The address in upper case, if it is one of six hexadecimal digits."""
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
"""An ICAO address: six hexadecimal digits."""
Velocity = Annotated[Vector, AfterValidator(_flyable)]
"""Velocity north, east and down [m/s]."""


AltitudeType = Annotated[Literal["geometric", "qne", "qnh"], word("geometric", "qne", "qnh")]
"""Heights that transponders report: above the WGS-84 ellipsoid; pressure altitude in the standard
atmosphere; above mean sea level by the pressure of the day."""


class TrafficChange(Table):
    """A velocity that the aircraft changes to."""

    time_s: Annotated[float, between(0, 86_400)]
    """When the change begins."""
    velocity_mps: Velocity
    within_s: Annotated[float, above(0, 600)] = 5.0
    """Duration of the change."""


class TrafficEntry(Table):
    """Another aircraft with a transponder; it avoids no other."""

    name: Annotated[str, AfterValidator(_callsign)]
    """Its callsign."""
    icao: Address | None = None
    """Its ICAO address; None: its index, from 1."""
    position_m: Position
    """Position at time zero, north, east and down of the origin."""
    velocity_mps: Velocity
    """Velocity at time zero, north, east and down."""
    interval_s: Annotated[float, between(0.1, 60)] = 1.0
    """Time between two reports."""
    delay_s: Annotated[float, between(0, 60)] = 0.0
    """Time from a position to the arrival of its report."""
    position_error_m: Annotated[float, between(0, 1000)] = 0.0
    """Standard deviation of each axis of the reported position."""
    altitude_type: AltitudeType = "geometric"
    """The kind of height that it reports."""
    change: list[TrafficChange] = Field(default_factory=list[TrafficChange])


class TrafficReceiver(Table):
    """The receiver of transponders that every vehicle has."""

    range_m: Annotated[float, between(0, 1_000_000)] = 20_000.0
    """Largest distance at which it hears a transponder."""
