"""The figures of a run."""

from typing import NamedTuple

from vfguide.scenario.drawing import Flights, to_png
from vfguide.scenario.path_figures import draw_plan, draw_side, draw_space
from vfguide.scenario.time_figures import draw_attitude, draw_envelope, draw_position, draw_rates


class Picture(NamedTuple):
    """A figure as it is stored."""

    name: str
    """Of the file, without its ending."""
    caption: str
    png: bytes


_FIGURES = (
    (
        "path-3d",
        "The path in space and its shadow; arrows are goals and their courses.",
        draw_space,
    ),
    ("path-plan", "The path from above: north is up, both axes have one scale.", draw_plan),
    ("path-side", "The path from the side: both axes have one scale.", draw_side),
    ("position", "Position in the scenario frame.", draw_position),
    ("attitude", "Attitude of the body against north-east-down.", draw_attitude),
    ("envelope", "What the flight took of the aircraft, and its limits.", draw_envelope),
    ("rates", "Body rates: commanded by the companion, and flown.", draw_rates),
)


def draw_figures(flights: Flights) -> list[Picture]:
    """All the figures, as PNG."""
    return [Picture(name, caption, to_png(draw, flights)) for name, caption, draw in _FIGURES]
