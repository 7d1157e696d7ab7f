"""The figures of a run."""

from collections.abc import Callable
from typing import NamedTuple

from matplotlib.figure import Figure

from vfguide.report.assurance_figure import draw_assurance
from vfguide.report.distance_figures import draw_clearance, draw_separation
from vfguide.report.drawing import Flights, to_png
from vfguide.report.field_figure import draw_field
from vfguide.report.path_figures import draw_plan, draw_side, draw_space
from vfguide.report.time_figures import (
    draw_air,
    draw_attitude,
    draw_envelope,
    draw_position,
    draw_rates,
    draw_speed,
)


class Picture(NamedTuple):
    """A figure as it is stored, and shown in the report."""

    name: str
    """Name of its file without the suffix."""
    caption: str
    """Sentence below the figure in the report."""
    png: bytes
    """Content of the file."""


class Drawing(NamedTuple):
    """A figure before it is drawn; its name and caption are those of the `Picture`."""

    name: str
    caption: str
    draw: Callable[[Figure, Flights], None]


_PATHS = (
    Drawing(
        "path-3d",
        "The path in space and its shadow; arrows are goals and their courses.",
        draw_space,
    ),
    Drawing("path-plan", "The path from above: north is up, both axes have one scale.", draw_plan),
    Drawing("path-side", "The path from the side: both axes have one scale.", draw_side),
)
_FIELD = Drawing(
    "field",
    "Law field in the horizontal plane of a goal, all hazards known: arrows are directions of "
    "F_OA, and shaded is where hazards that are approached bend it, the darker the less the free "
    "field counts. Paths may lie above or below the plane; they are hollow where an escape or a "
    "route was flown.",
    draw_field,
)
_CLEARANCE = Drawing(
    "clearance",
    "Distance of the centre from the surface U = 1 of obstacles, negative inside; the scale is "
    "even near zero and logarithmic far from it.",
    draw_clearance,
)
_ASSURANCE = Drawing(
    "assurance",
    "Distance from the nearest obstacle, volume of another aircraft or border of the fence, the "
    "margin that escapes keep, and the times in which the run-time assurance overruled the "
    "guidance.",
    draw_assurance,
)
_SEPARATION = Drawing(
    "separation",
    "Distance of the centres of every two vehicles; the scale is even near zero and logarithmic "
    "far from it.",
    draw_separation,
)
_MOTION = (
    Drawing("position", "Position in the scenario frame.", draw_position),
    Drawing("attitude", "Attitude of the body against north-east-down.", draw_attitude),
)
_AEROPLANE = (
    Drawing("envelope", "What the flight took of the aircraft, and its limits.", draw_envelope),
    Drawing("rates", "Body rates: commanded by the companion, and flown.", draw_rates),
    Drawing("air", "The air: what it does, and what the companion makes of it.", draw_air),
)
_RIGID_BODY = (
    Drawing("speed", "Speed along the body's x axis.", draw_speed),
    Drawing("rates", "Body rates, which are flown as they are commanded.", draw_rates),
)


def draw_figures(flights: Flights) -> list[Picture]:
    """The figures of a run, as PNG; those without anything to show are left out."""
    drawings = (
        *_PATHS,
        *((_FIELD,) if flights.follow_field else ()),
        *((_CLEARANCE,) if flights.loaded.scenario.obstacles else ()),
        *((_ASSURANCE,) if flights.assured else ()),
        *((_SEPARATION,) if flights.several else ()),
        *_MOTION,
        *(_RIGID_BODY if flights.kinematic else _AEROPLANE),
    )
    return [Picture(each.name, each.caption, to_png(each.draw, flights)) for each in drawings]
