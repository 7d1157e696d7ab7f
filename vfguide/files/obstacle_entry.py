"""An obstacle as it is written, and the sizes that each shape takes."""

from typing import Annotated, Literal

from pydantic import AfterValidator

from vfguide.files.source import Location, Source
from vfguide.files.toml_types import (
    Angle,
    Position,
    Table,
    Vector,
    above,
    listed,
    rule_broken,
    word,
)

Size = Annotated[float, above(0, 10_000)]
"""A size of an obstacle [m]."""


def _label(text: str) -> str:
    """The name, if it fits into one line of a message."""
    if not text.isprintable() or not text.strip() or len(text) > 100:
        raise rule_broken("allowed are 1 to 100 printable characters")
    return text


def _sizes(values: tuple[float, float, float]) -> tuple[float, float, float]:
    if not all(0.0 < value <= 10_000.0 for value in values):
        raise rule_broken("out of range, allowed above 0, up to 10000 each")
    return values


def _exponents(values: tuple[float, float, float]) -> tuple[float, float, float]:
    if not all(1.0 <= value <= 50.0 for value in values):
        raise rule_broken("out of range, allowed 1 to 50 each")
    return values


def _velocity(values: tuple[float, float, float]) -> tuple[float, float, float]:
    if not all(abs(value) <= 1000.0 for value in values):
        raise rule_broken("out of range, allowed -1000 to 1000 each")
    return values


Sizes = Annotated[Vector, AfterValidator(_sizes)]
"""Three sizes of an obstacle along its axes [m]."""
SIZES: dict[str, tuple[str, ...]] = {
    "sphere": ("radius_m",),
    "ellipsoid": ("semi_axes_m",),
    "superquadric": ("semi_axes_m", "exponents"),
    "cylinder": ("radius_m", "height_m"),
    "box": ("size_m",),
    "cone": ("radius_m", "height_m"),
}
"""The keys of the sizes of each shape; it takes no others."""
ShapeName = Annotated[
    Literal["sphere", "ellipsoid", "superquadric", "cylinder", "box", "cone"], word(*SIZES)
]
"""The names of the shapes, those of `SIZES`."""


class ObstacleEntry(Table):
    """A body to keep clear of; U = 1 is its surface."""

    name: Annotated[str, AfterValidator(_label)] | None = None
    """Its name; None: its index."""
    shape: ShapeName
    position_m: Position
    """Position of its centre at time zero, north, east and down of the origin."""
    radius_m: Size | None = None
    height_m: Size | None = None
    semi_axes_m: Sizes | None = None
    exponents: Annotated[Vector, AfterValidator(_exponents)] | None = None
    size_m: Sizes | None = None
    heading_deg: Angle = 0.0
    """Angle by which it is turned about the vertical, from north toward east."""
    velocity_mps: Annotated[Vector, AfterValidator(_velocity)] = (0.0, 0.0, 0.0)
    """Its velocity north, east and down."""
    reactive_level: Annotated[float, above(1, 1_000_000)] = 4.0
    """Level U below which it acts on the field, dimensionless: the paper's c-bar."""
    visible_from_m: Annotated[float, above(0, 100_000)] | None = None
    """Largest distance from its surface at which it is detected; None: the detection range."""


def check_sizes(entry: ObstacleEntry, source: Source, at: Location) -> None:
    """Check that the sizes of an obstacle are those of its shape.

    Raises:
        InputError: one is missing, or another is given.
    """
    wanted = SIZES[entry.shape]
    every = sorted({key for keys in SIZES.values() for key in keys})
    article = "an" if entry.shape[0] in "aeiou" else "a"
    for key in every:
        if getattr(entry, key) is not None and key not in wanted:
            rule = f"not a size of {article} {entry.shape}, allowed {listed(wanted)}"
            raise source.error((*at, key), rule, getattr(entry, key))
    for key in wanted:
        if getattr(entry, key) is None:
            rule = f"missing, {article} {entry.shape} needs {listed(wanted)}"
            raise source.error((*at, key), rule)
