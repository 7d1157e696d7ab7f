"""Drawing of law `field` in the horizontal plane of a goal: its arrows and reactive areas.

Arrows are directions of F_OA. The shaded areas are those in which hazards that are approached bend
it: chi is 1 where the free field leads alone, and 0 where a hazard does.
"""

from dataclasses import dataclass
from itertools import compress
from typing import Any

import numpy as np
from matplotlib.artist import Artist
from matplotlib.axes import Axes
from matplotlib.lines import Line2D
from matplotlib.patches import Circle, Patch

from vfguide.aircraft.envelope import radius_in, usable_bank
from vfguide.companion.plan import Plan
from vfguide.field_points.field_law_points import remedies_of
from vfguide.field_points.field_plane import FieldPlane, field_plane
from vfguide.field_points.shortest_plan import plan_in_air
from vfguide.geometry.vector import Vec3, Vectors
from vfguide.geometry.velocity import horizontal_norm
from vfguide.guidance.field_progress import APPROACH_RADII
from vfguide.report.drawing import GOAL_COLOUR, MUTED_COLOUR
from vfguide.scenario.resolved import Goal

CELL_POINTS = 5
"""Number of points from one arrow to the next at which chi is evaluated; chosen, for smooth edges
of reactive areas."""
ARROW_SHARE = 0.62
"""Ratio of the length of an arrow to the distance from one arrow to the next; chosen."""
LEVELS = (0.02, 0.2, 0.4, 0.6, 0.8, 1.001)
"""Values of 1 - chi at the edges of the shades of reactive areas, dimensionless; chosen."""
AREA_COLOURS = ("#fdf3e0", "#fbe7c1", "#f8daa1", "#f6cd80", "#f3c05f")
"""Colours of reactive areas, from the edge inward: an amber of the palette, lightened."""

_ARROW: Any = {
    "color": MUTED_COLOUR,
    "pivot": "mid",
    "angles": "xy",
    "scale_units": "xy",
    "scale": 1.0,
    "units": "inches",
    "width": 0.012,
    "headwidth": 4.0,
    "headlength": 4.5,
    "headaxislength": 4.0,
}
_APPROACH: Any = {"color": GOAL_COLOUR, "linestyle": (0, (1, 1.5)), "linewidth": 1.2}


@dataclass(frozen=True)
class GoalPlane:
    """The horizontal plane of a goal, and what the field in it depends on."""

    plan: Plan
    number: int
    """Index of the goal in the plan, from 0."""
    goal: Goal
    time: float
    """Time on the clock of the obstacles [s]."""
    wind_n: Vec3
    """Wind vector, NED [m/s]."""

    @property
    def down(self) -> float:
        """Height of the plane, as z of NED [m]."""
        return self.goal.position_m[2]

    @property
    def approach(self) -> float:
        """Radius about the goal within which law `flight` leads [m]; 0 where it never does."""
        aircraft, gains, _ = plan_in_air(self.plan, self.down).vehicle
        bank = usable_bank(aircraft, gains, gains.airspeed)
        radius = APPROACH_RADII * radius_in(horizontal_norm(self.wind_n), bank, gains)
        return radius if remedies_of(self.plan).approach else 0.0


def draw_field_in(axes: Axes, plane: GoalPlane, limits: Vectors, arrows: int) -> None:
    """Draw the reactive areas, the arrows, and the circle of the approach.

    Args:
        axes: east to the right, north up [m].
        plane: the plane of the goal.
        limits: least and greatest coordinate to the east and to the north, (2, 2) [m].
        arrows: number of arrows along the longer side.
    """
    spacing = float(np.ptp(limits, axis=1).max()) / arrows
    east, north = (np.arange(low, high, spacing / CELL_POINTS) for low, high in limits)
    grid = np.stack(np.meshgrid(north, east, plane.down, indexing="ij"), axis=-1)
    field = field_plane(plane.plan, plane.number, grid.reshape(-1, 3), plane.time, plane.wind_n)
    near = field.distance > -spacing / CELL_POINTS
    led_by_hazards = np.where(near, 1.0 - field.chi, np.nan).reshape(grid.shape[:2])
    axes.contourf(east, north, led_by_hazards, LEVELS, colors=AREA_COLOURS, zorder=0.3)
    axes.grid(visible=False)
    draw_arrows(axes, grid.reshape(len(north), len(east), 3), field, spacing)
    at = (plane.goal.position_m[1], plane.goal.position_m[0])
    axes.add_patch(Circle(at, plane.approach, fill=False, zorder=1.4, **_APPROACH))


def draw_arrows(axes: Axes, grid: Vectors, field: FieldPlane, spacing: float) -> None:
    """Draw directions of F_OA at every CELL_POINTS-th point of a grid, none inside hazards.

    The `grid` (n, m, 3), NED [m], has those points north and east at which `field` was evaluated;
    `spacing` is the distance from one arrow to the next [m].
    """
    few = slice(CELL_POINTS // 2, None, CELL_POINTS)
    north, east, _ = np.moveaxis(field.F.reshape(grid.shape)[few, few], -1, 0)
    speed = np.hypot(north, east)
    shown = (field.distance.reshape(grid.shape[:2])[few, few] > 0.0) & (speed > 0.0)
    y, x, _ = grid[few, few][shown].T
    length = ARROW_SHARE * spacing / speed[shown]
    axes.quiver(x, y, length * east[shown], length * north[shown], zorder=1.1, **_ARROW)


def field_marks(plane: GoalPlane) -> list[Artist]:
    """Entries of the legend for what `draw_field_in` draws."""
    arrow = Line2D([], [], color=MUTED_COLOUR, marker=r"$\rightarrow$", markersize=15, ls="none")
    arrow.set_label(r"Direction of $F_\mathrm{OA}$")
    area = Patch(facecolor=AREA_COLOURS[-2], label="Reactive area, χ < 1")
    circle = Line2D([], [], label="Approach by law flight", **_APPROACH)
    shown = (True, plane.plan.hazards is not None, plane.approach > 0.0)
    return list(compress((arrow, area, circle), shown))
