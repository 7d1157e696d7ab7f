"""The fence of a scenario: its zones and heights, as written and in SI units."""

import math
from typing import Annotated, Literal

from pydantic import BeforeValidator, Field

from vfguide.airspace.fence import Zone
from vfguide.files.source import Location, Source
from vfguide.files.toml_types import Table, above, between, rule_broken, word
from vfguide.geometry.crossing_sides import crossing_sides

Height = Annotated[float, between(-500, 10_000)]
"""A height above the origin [m]."""


def _two(value: object) -> object:
    if not isinstance(value, list | tuple) or len(value) != 2:
        raise rule_broken("a list of two numbers, north and east, is required")
    return tuple(value)


Place = Annotated[tuple[float, float], BeforeValidator(_two)]
"""Coordinates north and east of the origin [m]."""


class ZoneEntry(Table):
    """A vertical prism or cylinder to stay in or out of, as it is written."""

    kind: Annotated[Literal["include", "exclude"], word("include", "exclude")]
    """Whether vehicles have to stay in it or out of it."""
    polygon_m: list[Place] | None = None
    """Corners of its polygon; None: it is a circle."""
    centre_m: Place | None = None
    """Centre of its circle; None: it is a polygon."""
    radius_m: Annotated[float, above(0, 100_000)] | None = None
    """Radius of its circle; None: it is a polygon."""
    lowest_m: Height | None = None
    """Least height above the origin at which the zone holds; None: any."""
    highest_m: Height | None = None
    """Greatest height above the origin at which the zone holds; None: any."""


class Fence(Table):
    """The region in which every vehicle has to stay; heights are above the origin's altitude."""

    floor_m: Height | None = None
    """Least height; None: any."""
    ceiling_m: Height | None = None
    """Greatest height; None: any."""
    zone: list[ZoneEntry] = Field(default_factory=list[ZoneEntry])


def zone_of(entry: ZoneEntry) -> Zone:
    """The zone of an entry, with infinite heights where none are written."""
    corners = entry.polygon_m or [entry.centre_m or (0.0, 0.0)]
    low = -math.inf if entry.lowest_m is None else entry.lowest_m
    high = math.inf if entry.highest_m is None else entry.highest_m
    return Zone(entry.kind == "include", tuple(corners), entry.radius_m or 0.0, low, high)


def check_zones(fence: Fence, source: Source) -> None:
    """Check that every zone is a polygon or a circle, and that all heights are in order.

    Raises:
        InputError: a zone is neither, the sides of a polygon cross or touch, or a greatest height
            is not above the least one.
    """
    for index, zone in enumerate(fence.zone):
        at: Location = ("fence", "zone", index)
        if (zone.polygon_m is None) == (zone.centre_m is None):
            raise source.error(at, "must be given in exactly one way: polygon_m, or centre_m")
        if (zone.centre_m is None) != (zone.radius_m is None):
            raise source.error(at, "a circle needs centre_m and radius_m, a polygon neither")
        if zone.polygon_m is not None and len(zone.polygon_m) < 3:
            rule = "too few corners, allowed at least three"
            raise source.error((*at, "polygon_m"), rule, zone.polygon_m)
        if zone.polygon_m is not None and (sides := crossing_sides(zone.polygon_m)):
            first, second = sides
            rule = f"its sides {first} and {second} cross or touch, counted from 1"
            raise source.error((*at, "polygon_m"), rule, zone.polygon_m)
        if _upside_down(zone.lowest_m, zone.highest_m):
            raise source.error((*at, "highest_m"), "not above lowest_m", zone.highest_m)
    if _upside_down(fence.floor_m, fence.ceiling_m):
        raise source.error(("fence", "ceiling_m"), "not above floor_m", fence.ceiling_m)


def _upside_down(low: float | None, high: float | None) -> bool:
    return low is not None and high is not None and low >= high
