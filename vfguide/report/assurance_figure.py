"""The figure of the run-time assurance: how near hazards were, and when it acted."""

from typing import Any

import numpy as np
from matplotlib.axes import Axes
from matplotlib.figure import Figure
from matplotlib.lines import Line2D
from matplotlib.patches import Patch

from vfguide.assurance.decision import assurance
from vfguide.report.distance_axis import make_near_large
from vfguide.report.drawing import GOAL, Flights, line_of
from vfguide.report.panels import LIMIT, lay_out, name_axis
from vfguide.results.clearance import clearances
from vfguide.results.fence_distance import fence_distances
from vfguide.results.interventions import interventions_of
from vfguide.results.record import Array, FlightRecord
from vfguide.results.traffic_results import volume_distance
from vfguide.scenario.obstacles import rows_of

TALL = 2.8
"""Height of a panel [inch]."""
SHADES: dict[str, Any] = {
    "escape": {"facecolor": "#f6c667", "alpha": 0.6, "linewidth": 0},
    "least bad": {"facecolor": "#d9480f", "alpha": 0.6, "linewidth": 0},
}
LABELS = {"escape": "An escape is flown", "least bad": "Nothing is clear"}
MARGIN: Any = {"color": GOAL, "linestyle": (0, (1, 1.5)), "linewidth": 1.2}
SHORTEST = 0.004
"""An episode is drawn at least so wide, in parts of the flight."""


def draw_assurance(figure: Figure, flights: Flights) -> None:
    """Distance of each vehicle from its nearest hazard, the margin, and the episodes shaded."""
    marks = [
        Line2D([], [], **line_of(0), label="Nearest obstacle, aircraft or fence"),
        Line2D([], [], **MARGIN, label="Margin of the assurance"),
        Line2D([], [], **LIMIT, label="Surface, volume or the fence"),
        *(Patch(label=LABELS[reason], **look) for reason, look in SHADES.items()),
    ]
    title = "Nearest hazard, and when the assurance acted"
    grid = lay_out(figure, title, len(flights.records), marks, TALL)
    for axes, record in zip(grid, flights.records, strict=True):
        _draw_vehicle(axes, flights, record)


def nearest_hazard(flights: Flights, record: FlightRecord) -> Array:
    """Distance from the nearest obstacle, volume or rule of the fence, (n,) [m]; inside < 0."""
    scenario = flights.loaded.scenario
    fence = fence_distances(scenario.fence, record.p_n)
    volumes = [
        volume_distance(scenario.avoidance, each.p_n - record.p_n) for each in flights.passers
    ]
    each = np.column_stack((clearances(record, rows_of(scenario.obstacles)), *volumes, fence))
    return np.fmin.reduce(each, axis=1)


def _draw_vehicle(axes: Axes, flights: Flights, record: FlightRecord) -> None:
    loaded, seconds = flights.loaded, float(record.time[-1])
    margin = assurance(loaded.performance(record.vehicle), loaded.gains(record.vehicle)).margin
    for episode in interventions_of(loaded.scenario, record):
        end = max(episode.to_s, episode.from_s + SHORTEST * seconds)
        axes.axvspan(episode.from_s, end, zorder=0.5, **SHADES[episode.reason])
    axes.axhline(0.0, **LIMIT)
    axes.axhline(margin, **MARGIN)
    axes.plot(record.time, nearest_hazard(flights, record), **line_of(0))
    which = f", vehicle {record.vehicle.id}" if flights.several else ""
    name_axis(axes, f"Clearance{which} [m]")
    make_near_large(axes, margin)
