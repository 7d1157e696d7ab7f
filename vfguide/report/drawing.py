"""Style of figures, what they show, and how they become PNG."""

import warnings
from collections.abc import Callable, Sequence
from dataclasses import dataclass
from functools import cached_property
from io import BytesIO
from typing import Any, TypeVar

import matplotlib as mpl
import numpy as np
from matplotlib.figure import Figure
from matplotlib.lines import Line2D

from vfguide.geometry.units import DEG
from vfguide.geometry.vector import Series, Vec3
from vfguide.report.obstacle_drawing import DrawnObstacle, drawn_obstacle
from vfguide.report.traffic_drawing import TrafficPath, traffic_paths_of
from vfguide.results.record import FlightRecord
from vfguide.scenario.loaded import LoadedScenario

COLOURS = ("#0072B2", "#D55E00", "#009E73", "#CC79A7", "#E69F00", "#56B4E9")
"""Colours of lines that the colour-blind can distinguish: the palette of Okabe and Ito (2008)
without its yellow, which is too light on white."""
LINE_STYLES = ("solid", "dashed", "dashdot", "dotted")
"""Styles of lines of one colour, in their order."""
LEGEND_COLUMNS = 6
"""Largest number of entries in a row of a legend; chosen."""
GOAL_COLOUR = "#111111"
"""Colour of goals, and of what is commanded."""
MUTED_COLOUR = "#6b7280"
"""Colour of limits and other secondary lines."""

_LOOK: Any = {
    "font.family": "DejaVu Sans",
    "font.size": 10,
    "axes.titlesize": 12,
    "axes.titleweight": "bold",
    "axes.titlelocation": "left",
    "axes.edgecolor": "#9ca3af",
    "axes.axisbelow": True,
    "axes.grid": True,
    "axes.spines.top": False,
    "axes.spines.right": False,
    "grid.color": "#e5e7eb",
    "grid.linewidth": 0.8,
    "legend.frameon": False,
    "lines.linewidth": 1.8,
    "lines.solid_capstyle": "round",
    "savefig.dpi": 140,
    "savefig.pad_inches": 0.15,
}


@dataclass(frozen=True)
class Flights:
    """What the figures show: a scenario and the flights of its vehicles."""

    loaded: LoadedScenario
    records: Sequence[FlightRecord]

    @property
    def several(self) -> bool:
        """Whether there is more than one vehicle, so that their lines need a legend."""
        return len(self.records) > 1

    @property
    def kinematic(self) -> bool:
        """Whether the vehicles are rigid bodies without air, engine or ground."""
        return self.loaded.scenario.plant == "kinematic"

    @property
    def follow_field(self) -> bool:
        """Whether the vehicles were led by law `field`."""
        return self.loaded.scenario.law == "field"

    @property
    def assured(self) -> bool:
        """Whether the run-time assurance had something to keep clear of."""
        return any(record.decisions is not None for record in self.records)

    @cached_property
    def bodies(self) -> tuple[DrawnObstacle, ...]:
        """The obstacles as they are drawn, over the time of the flights."""
        seconds = float(self.records[0].time[-1])
        return tuple(drawn_obstacle(each, seconds) for each in self.loaded.scenario.obstacles)

    @cached_property
    def traffic(self) -> tuple[TrafficPath, ...]:
        """The other aircraft over the time of the flights."""
        return traffic_paths_of(self.loaded.scenario, self.records)


Drawn = TypeVar("Drawn")
"""What a figure shows."""


def to_png(draw: Callable[[Figure, Drawn], None], drawn: Drawn) -> bytes:
    """The PNG of the figure that `draw` fills; matplotlib's settings are as before afterwards.

    Figures whose layout matplotlib makes are cropped to what they show. Those that set their layout
    themselves are not: they take a third of the time.
    """
    with mpl.rc_context(_LOOK), warnings.catch_warnings():
        warnings.filterwarnings("ignore", "Glyph .* missing")
        figure = Figure()
        draw(figure, drawn)
        png = BytesIO()
        bbox = "tight" if figure.get_layout_engine() else None
        figure.savefig(png, format="png", bbox_inches=bbox)
    return png.getvalue()


def line_of(index: int) -> dict[str, Any]:
    """Colour and style of the line of a vehicle, by its place in the scenario."""
    style = LINE_STYLES[index // len(COLOURS) % len(LINE_STYLES)]
    return {"color": COLOURS[index % len(COLOURS)], "linestyle": style}


def vehicle_lines(flights: Flights) -> list[Line2D]:
    """Legend entries of the vehicles."""
    return [
        Line2D([], [], **line_of(index), label=f"Vehicle {record.vehicle.id}")
        for index, record in enumerate(flights.records)
    ]


def goal_axis(heading_deg: float, climb_deg: float) -> Vec3:
    """The x axis of the goal frame, a unit vector, NED: (cos c cos h, cos c sin h, -sin c).

    h is the heading of the goal and c its climb.
    """
    h, c = heading_deg * DEG, climb_deg * DEG
    return (
        float(np.cos(c) * np.cos(h)),
        float(np.cos(c) * np.sin(h)),
        float(-np.sin(c)),
    )


def broken(angle_deg: Series) -> Series:
    """Angles (n,) [deg], with NaN where they jump by more than half a turn: no line goes there."""
    jumps = np.abs(np.diff(angle_deg, prepend=angle_deg[:1])) > 180.0
    return np.where(jumps, np.nan, angle_deg)
