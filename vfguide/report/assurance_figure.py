"""The figure of the run-time assurance: how near hazards were, and when it acted."""

from typing import Any

import numpy as np
from matplotlib.axes import Axes
from matplotlib.figure import Figure
from matplotlib.lines import Line2D
from matplotlib.patches import Patch

from vfguide.assurance.decision import assurance
from vfguide.report.drawing import GOAL_COLOUR, Flights, line_of
from vfguide.report.panels import LIMIT_LINE, lay_out, make_near_large, name_axis
from vfguide.results.clearance import clearances
from vfguide.results.fence_distance import fence_distances
from vfguide.results.interventions import interventions_of
from vfguide.results.record import Array, FlightRecord
from vfguide.results.traffic_results import volume_distance
from vfguide.scenario.obstacles import rows_of

STRIP_HEIGHT = 2.8
"""Height of a panel [inch]; chosen."""
SHADES: dict[str, Any] = {
    "escape": {"facecolor": "#f6c667", "alpha": 0.6, "linewidth": 0},
    "least bad": {"facecolor": "#d9480f", "alpha": 0.6, "linewidth": 0},
}
"""Style of the shade of an intervention, by its reason."""
LABELS = {"escape": "An escape is flown", "least bad": "Nothing is clear"}
"""Legend entry of an intervention, by its reason."""
MARGIN_LINE: Any = {"color": GOAL_COLOUR, "linestyle": (0, (1, 1.5)), "linewidth": 1.2}
"""Style of the line at the margin of the assurance."""
SHORTEST_INTERVENTION = 0.004
"""Least width of a drawn intervention, as a share of the flight; chosen, so that each is seen."""


def draw_assurance(figure: Figure, flights: Flights) -> None:
    """A panel a vehicle: its distance from the nearest hazard, the margin, interventions shaded."""
    marks = [
        Line2D([], [], **line_of(0), label="Nearest obstacle, aircraft or fence"),
        Line2D([], [], **MARGIN_LINE, label="Margin of the assurance"),
        Line2D([], [], **LIMIT_LINE, label="Surface, volume or the fence"),
        *(Patch(label=LABELS[reason], **look) for reason, look in SHADES.items()),
    ]
    title = "Nearest hazard, and when the assurance acted"
    grid = lay_out(figure, title, len(flights.records), marks, STRIP_HEIGHT)
    for axes, record in zip(grid, flights.records, strict=True):
        _draw_vehicle(axes, flights, record)


def nearest_hazard(flights: Flights, record: FlightRecord) -> Array:
    """Distance from the nearest hazard at each sample, (n,) [m], negative inside.

    Hazards are obstacles, the volumes of other aircraft, and the rules of the fence.
    """
    scenario = flights.loaded.scenario
    fence = fence_distances(scenario.fence, record.p_n)
    volumes = [
        volume_distance(scenario.avoidance, each.p_n - record.p_n) for each in flights.traffic
    ]
    each = np.column_stack((clearances(record, rows_of(scenario.obstacles)), *volumes, fence))
    return np.fmin.reduce(each, axis=1)


def _draw_vehicle(axes: Axes, flights: Flights, record: FlightRecord) -> None:
    loaded, seconds = flights.loaded, float(record.time[-1])
    margin = assurance(
        loaded.performance_aloft(record.vehicle), loaded.gains(record.vehicle)
    ).margin
    for each in interventions_of(loaded.scenario, record):
        end = max(each.to_s, each.from_s + SHORTEST_INTERVENTION * seconds)
        axes.axvspan(each.from_s, end, zorder=0.5, **SHADES[each.reason])
    axes.axhline(0.0, **LIMIT_LINE)
    axes.axhline(margin, **MARGIN_LINE)
    axes.plot(record.time, nearest_hazard(flights, record), **line_of(0))
    which = f", vehicle {record.vehicle.id}" if flights.several else ""
    name_axis(axes, f"Clearance{which} [m]")
    make_near_large(axes, margin)
