"""Drawing of obstacles: surfaces and outlines, moving ones at several times."""

from collections.abc import Sequence
from dataclasses import dataclass
from typing import Any

import numpy as np
from matplotlib.axes import Axes
from matplotlib.lines import Line2D
from matplotlib.patches import Patch
from matplotlib.patheffects import withStroke

from vfguide.geometry.vector import Series, Vector, Vectors
from vfguide.report.meshes import Array, outline, section, surface_mesh
from vfguide.scenario.obstacles import obstacle_of
from vfguide.scenario.resolved import Obstacle

OBSTACLE_COLOUR = "#b8c2cf"
"""Colour of the surfaces of obstacles."""
EDGE_COLOUR = "#7d8a9b"
"""Colour of the edges of obstacles."""
NAME_COLOUR = "#374151"
"""Colour of the names of obstacles."""
EARLIER_OPACITY = 0.35
"""Ratio of the opacity of a moving obstacle at earlier times to that at the end; chosen."""
SHOWN_TIMES = 5
"""Number of times at which a moving obstacle is shown, equally spaced over the flight; chosen."""
LONGEST_NAME = 20
"""Largest number of characters of a name in a figure; chosen."""
MAX_NAMES = 20
"""Largest number of obstacles, or of other aircraft, that are named in a figure; chosen."""
_SECTION: Any = {"facecolor": OBSTACLE_COLOUR, "edgecolor": EDGE_COLOUR, "linewidth": 0.8}
_TRACK: Any = {"color": EDGE_COLOUR, "linestyle": (0, (5, 3)), "linewidth": 1.1}


@dataclass(frozen=True)
class DrawnObstacle:
    """An obstacle as it is drawn, over the first seconds of a run."""

    name: str
    surface: Array
    """(n, m, 3) mesh of its surface at the start, NED [m]."""
    track: Vectors
    """(2, 3) its centre at the start and at the end, NED [m]."""

    @property
    def moves(self) -> bool:
        """Whether the obstacle moves."""
        return bool((self.track[0] != self.track[1]).any())

    @property
    def places(self) -> list[tuple[Vector, float]]:
        """The displacements at which it is shown, (3,), NED [m], each with its opacity."""
        shift = self.track[1] - self.track[0]
        parts: Series = np.linspace(0.0, 1.0, SHOWN_TIMES if self.moves else 1)
        return [(part * shift, EARLIER_OPACITY) for part in parts[:-1]] + [(shift, 1.0)]


def drawn_obstacle(obstacle: Obstacle, seconds: float) -> DrawnObstacle:
    """The obstacle over the first `seconds` of a run."""
    start, velocity = np.array(obstacle.position_m), np.array(obstacle.velocity_mps)
    track = np.array((start, start + velocity * seconds))
    return DrawnObstacle(obstacle.name, surface_mesh(obstacle_of(obstacle)), track)


def shortened(name: str) -> str:
    """A name cut to LONGEST_NAME characters, with its dollar signs escaped for matplotlib."""
    cut = name if len(name) <= LONGEST_NAME else name[: LONGEST_NAME - 1] + "…"
    return cut.replace("$", r"\$")


def draw_outlines(axes: Axes, bodies: Sequence[DrawnObstacle], onto: Array) -> None:
    """Draw the outlines of obstacles on a plane; `onto`, (3, 2), projects NED to its axes."""
    for body in bodies:
        corners = outline(body.surface @ onto)
        for shift, opacity in body.places:
            x, y = (corners + shift @ onto).T
            face, edge = (OBSTACLE_COLOUR, 0.6 * opacity), (EDGE_COLOUR, opacity)
            axes.fill(x, y, facecolor=face, edgecolor=edge, linewidth=0.8, zorder=1.2)
        if body.moves:
            axes.plot(*(body.track @ onto).T, zorder=1.3, **_TRACK)


def draw_sections(axes: Axes, bodies: Sequence[DrawnObstacle], down: float) -> None:
    """Draw the horizontal sections of obstacles at z = `down`, NED [m], and their names.

    Each is drawn where it is at the end. The name of a moving one, which is small, stands above it.
    """
    for body in bodies:
        corners = section(body.surface + body.track[1] - body.track[0], down)
        if len(corners):
            north, east = corners.T
            axes.fill(east, north, zorder=1.2, **_SECTION)
            at = np.array((east.mean(), north.max() if body.moves else north.mean()))
            if len(bodies) <= MAX_NAMES:
                write_name(axes, body.name, at, NAME_COLOUR, above=body.moves)


def write_names(axes: Axes, bodies: Sequence[DrawnObstacle], onto: Array) -> None:
    """Write the names of obstacles where they are at the end, unless there are too many.

    `onto`, (3, 2), projects NED to the axes of the figure.
    """
    for body in bodies if len(bodies) <= MAX_NAMES else ():
        write_name(axes, body.name, body.track[1] @ onto, NAME_COLOUR)


def write_name(axes: Axes, name: str, at: Vector, color: str, *, above: bool = False) -> None:
    """Write a name centred on a place, (2,), or above it, readable on lines and surfaces."""
    halo = [withStroke(linewidth=2.5, foreground="white", alpha=0.8)]
    side = "bottom" if above else "center"
    look: Any = {"ha": "center", "va": side, "fontsize": 8, "path_effects": halo}
    axes.text(at[0], at[1], shortened(name), clip_on=True, color=color, zorder=2.4, **look)


def draw_surfaces(axes: Any, bodies: Sequence[DrawnObstacle], floor: float) -> None:
    """Draw the surfaces of obstacles in axes east, north, up, with their outlines on the floor.

    `floor` is the height of the floor above the origin [m].
    """
    for body in bodies:
        for shift, opacity in body.places:
            x, y, z = np.moveaxis(east_north_up(body.surface + shift), -1, 0)
            grid: Any = {"rcount": len(x), "ccount": len(x.T), "axlim_clip": True}
            look: Any = {"color": OBSTACLE_COLOUR, "alpha": 0.35 * opacity, "linewidth": 0.0}
            axes.plot_surface(x, y, z, zorder=1.0, **grid, **look)
            shadow: Vectors = outline(np.stack((x, y), axis=-1))
            axes.plot(
                *np.vstack((shadow, shadow[:1])).T,
                floor,
                color="#d1d5db",
                lw=1.0,
                zorder=0.5,
                axlim_clip=True,
            )
        if body.moves:
            axes.plot(*east_north_up(body.track).T, zorder=1.5, axlim_clip=True, **_TRACK)


def east_north_up(p_n: Vectors) -> Vectors:
    """Positions (..., 3), NED, as east, north, up: the axes of a figure in space."""
    return p_n[..., [1, 0, 2]] * (1.0, 1.0, -1.0)


def body_marks(bodies: Sequence[DrawnObstacle]) -> list[Patch | Line2D]:
    """Entries of the legend for obstacles."""
    here = Patch(facecolor=OBSTACLE_COLOUR, edgecolor=EDGE_COLOUR, alpha=0.7)
    if not any(body.moves for body in bodies):
        here.set_label("Obstacle")
        return [here] if bodies else []
    here.set_label("Obstacle, at the end")
    before = Patch(
        facecolor=OBSTACLE_COLOUR,
        edgecolor=EDGE_COLOUR,
        alpha=EARLIER_OPACITY * 0.7,
        label="Obstacle, before",
    )
    return [here, before, Line2D([], [], **_TRACK, label="Path of its centre")]


def section_mark() -> Patch:
    """Entry of the legend for what `draw_sections` draws."""
    return Patch(label="Obstacle", **_SECTION)
