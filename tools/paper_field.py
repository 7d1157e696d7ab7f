"""Figures of the paper that need only its field, in the goal frame: goal at 0, direction e_x."""

import math
from typing import Any

import numpy as np
from matplotlib.figure import Figure
from matplotlib.patches import Circle
from scipy.integrate import solve_ivp

from vfguide.field.arrays import navigation_fields
from vfguide.field.neighbours import Neighbours, robots_in_range, robots_with_priority
from vfguide.field.obstacle import Obstacle, obstacle_rows, obstacle_surface
from vfguide.geometry.dual import Dual3
from vfguide.geometry.shapes import shape
from vfguide.geometry.vector import Vectors
from vfguide.report.drawing import COLOURS, GOAL_COLOUR, MUTED_COLOUR

BLUE, ORANGE, GREEN = COLOURS[:3]
STILL = (0.0, 0.0, 0.0)
TRIAD = (
    ("$n$", BLUE),
    (r"$\tau^a = n \times F$", ORANGE),
    (r"$\tau^b = \tau^a \times n$", GREEN),
)
EGG: Any = {
    "color": "#eef2f7",
    "edgecolor": "#cfd8e3",
    "lw": 0.5,
    "rstride": 2,
    "cstride": 3,
    "shade": False,
    "antialiased": True,
}
LABEL: Any = {
    "textcoords": "offset points",
    "ha": "center",
    "bbox": {"fc": "w", "ec": "none", "pad": 0.6},
}
ROBOTS = np.array([[0.0, 0.0, 0.0], [-30.0, 80.0, 0.0], [55.0, 25.0, 0.0], [25.0, -75.0, 0.0]])
"""Positions of the robots [m], such that their sets are those of the paper's example."""
DETECTION_RANGE = 110.0


def draw_coordinates(figure: Figure) -> None:
    """fig_coordinates: a point in the frames (x, y, z), (x, r, theta) and (rho, phi, theta)."""
    axes = space(figure, (6.0, 4.8), elev=20, azim=-38)
    x, r, theta = 1.1, 1.2, math.radians(62.0)
    e_x, e_r = np.array([1.0, 0.0, 0.0]), np.array([0.0, math.cos(theta), math.sin(theta)])
    foot, point = x * e_x, x * e_x + r * e_r
    draw_frame(axes, 1.55 * e_x, 1.5 * e_r)
    segment(axes, (np.zeros(3), point), BLUE, r"$\rho$ ")
    segment(axes, (foot, point), ORANGE, "$r$ ")
    below = point * (1.0, 1.0, 0.0)
    axes.plot(*np.column_stack((point, below, foot)), color=MUTED_COLOUR, lw=0.9, ls=":")
    arc(axes, 0.45 * turned(e_x, e_r, math.atan2(r, x)), r"$\varphi$")
    arc(axes, foot + 0.4 * turned([0, 1, 0], [0, 0, 1], theta), r"$\theta$")
    axes.scatter(*point, color=GOAL_COLOUR, s=26)
    axes.text(*np.add(point, (0.0, 0.07, 0.07)), "$p$")
    axes.set(xlim=(0.0, 1.7), ylim=(0.0, 1.7), zlim=(0.0, 1.5))
    axes.set_box_aspect((1.7, 1.7, 1.5), zoom=1.0)
    axes.set_axis_off()


def draw_frame(axes: Any, along: np.ndarray, outward: np.ndarray) -> None:
    """Draw the axes x, y, z and the plane xOr as a parallelogram."""
    for tip, name in zip(np.diag((1.75, 1.4, 1.45)), "xyz", strict=True):
        axes.quiver(0, 0, 0, *tip, color=GOAL_COLOUR, lw=1.2, arrow_length_ratio=0.06)
        axes.text(*(1.06 * tip), f"${name}$", ha="center", va="center")
    corners = np.array([0.0 * along, along, along + outward, outward])
    axes.plot_trisurf(*corners.T, triangles=[[0, 1, 2], [0, 2, 3]], color=BLUE, alpha=0.13)
    axes.text(*(0.07 * along + 1.04 * outward), "plane $xOr$", color=BLUE, fontsize=9)


def turned(a: Any, b: Any, angle: float) -> np.ndarray:
    """Unit vectors (n, 3) from `a` towards `b`, turned by angles (n,) [rad]."""
    steps = np.linspace(0.0, angle, 40)[:, None]
    return np.cos(steps) * a + np.sin(steps) * b


def segment(axes: Any, ends: tuple[np.ndarray, np.ndarray], colour: str, name: str) -> None:
    """Draw a line with its name beside the middle."""
    axes.plot(*np.column_stack(ends), color=colour)
    middle = 0.5 * (ends[0] + ends[1])
    axes.text(*middle, name, color=colour, ha="right", va="bottom", fontsize=12)


def arc(axes: Any, points: Vectors, name: str) -> None:
    """Draw the arc of an angle with its name."""
    axes.plot(*points.T, color=GREEN, lw=1.4)
    axes.text(*(1.15 * points[len(points) // 2]), name, color=GREEN)


def draw_plane(figure: Figure) -> None:
    """fig_VF_xor: directions of F in the half-plane xOr and its integral curves, C > 0."""
    figure.set_size_inches(7.0, 5.2)
    figure.set_layout_engine("constrained")
    axes = figure.add_subplot()
    x, r = np.meshgrid(np.linspace(-4.0, 4.0, 25), np.linspace(0.0, 5.6, 18))
    F = navigation_fields(np.stack([x, r, np.zeros_like(x)], axis=-1))
    size = np.linalg.norm(F, axis=-1)
    u, w = (np.divide(F[..., k], size, where=size > 0.0, out=0.0 * size) for k in (0, 1))
    axes.quiver(x, r, u, w, color=MUTED_COLOUR, pivot="mid", scale=34, width=0.0028)
    for diameter in (1.0, 2.0, 3.5, 5.0):
        axes.add_patch(Circle((0.0, diameter / 2), diameter / 2, fill=False, ec=BLUE, lw=1.8))
        axes.annotate(f"C = {diameter:g}", (0.0, diameter), (0, 3), color=BLUE, fontsize=9, **LABEL)
    axes.annotate("", (1.3, 0.0), (0.0, 0.0), arrowprops={"arrowstyle": "-|>", "lw": 2.2})
    axes.plot(0.0, 0.0, "o", color=GOAL_COLOUR, markersize=6)
    axes.set(xlim=(-4.3, 4.3), ylim=(-0.35, 5.9), aspect="equal")
    axes.set(xlabel="x [m]", ylabel="r [m]")
    axes.set_title("Field and its circles in a plane through the axis")
    axes.grid(visible=False)


def draw_curves(figure: Figure) -> None:
    """fig_VF_stream: integral curves of F in space, from beside the axis beyond the goal."""
    axes = space(figure, (6.6, 5.6), elev=24, azim=-58)
    for k, theta in enumerate(np.arange(0.0, 2.0 * math.pi, math.pi / 4)):
        for diameter in (2.0, 4.0):
            aside = np.array([0.0, math.cos(theta), math.sin(theta)])
            axes.plot(*integral_curve(aside, diameter), color=COLOURS[k % 4], lw=1.2)
    axes.quiver(0, 0, 0, 2.6, 0, 0, color=GOAL_COLOUR, lw=2.2, arrow_length_ratio=0.1)
    axes.set(xlim=(-3.2, 3.2), ylim=(-4.2, 4.2), zlim=(-4.2, 4.2))
    axes.set_box_aspect((6.4, 8.4, 8.4), zoom=1.1)
    axes.set(xlabel="x [m]", ylabel="y [m]", zlabel="z [m]")
    figure.suptitle("Integral curves", x=0.02, ha="left", fontsize=12, fontweight="bold")


def integral_curve(aside: np.ndarray, diameter: float) -> np.ndarray:
    """The curve of F that begins near the goal where it leads away, (3, n)."""

    def along(_: float, p: np.ndarray) -> np.ndarray:
        F = navigation_fields(p)
        return F / np.linalg.norm(F)

    phi = 0.03
    start = (
        diameter
        * math.sin(phi)
        * (math.cos(phi) * np.array((1.0, 0.0, 0.0)) + math.sin(phi) * aside)
    )
    length = (math.pi - 2.0 * phi) * diameter
    return solve_ivp(along, (0.0, length), start, max_step=0.03 * length, rtol=1e-8).y


def draw_surface(figure: Figure) -> None:
    """fig_obstacle: n, tau_a = n x F and tau_b = tau_a x n on the surface of an obstacle."""
    axes = space(figure, (6.8, 5.4), elev=22, azim=-135)
    obstacle = Obstacle(shape.ellipsoid((3.0, 2.2, 1.8)), (-12.0, 2.0, 0.0))
    u, w = np.meshgrid(np.linspace(0.0, 2.0 * math.pi, 61), np.linspace(0.0, math.pi, 31))
    globe = np.stack([np.cos(u) * np.sin(w), np.sin(u) * np.sin(w), np.cos(w)], axis=-1)
    surface: Vectors = globe * obstacle.shape.semi_axes + obstacle.p_n
    axes.plot_surface(*np.moveaxis(surface, -1, 0), **EGG)
    draw_triads(axes, obstacle, surface[6:26:4, :-1:4].reshape(-1, 3))
    figure.legend(loc="outside lower center", ncols=3)
    axes.set(xlim=(-15.4, -8.6), ylim=(-0.6, 4.6), zlim=(-2.3, 2.3))
    axes.set_box_aspect((6.8, 5.2, 4.6), zoom=1.15)
    axes.set(xlabel="x [m]", ylabel="y [m]", zlabel="z [m]")
    figure.suptitle("Fields on the surface of an obstacle", x=0.02, ha="left", fontweight="bold")


def draw_triads(axes: Any, obstacle: Obstacle, points: np.ndarray) -> None:
    """Draw the directions of n, tau_a and tau_b at the points that face the viewer."""
    rows, eye = obstacle_rows([obstacle]), direction_of_view(axes)
    for p in points:
        n = np.array(obstacle_surface(rows, 0, Dual3(tuple(p), STILL), 0.0).n.value)
        if n @ eye < 0.3 * np.linalg.norm(n):
            continue
        tau_a = np.cross(n, navigation_fields(p))
        for a, (_, colour) in zip((n, tau_a, np.cross(tau_a, n)), TRIAD, strict=True):
            axes.quiver(*p, *(a / np.linalg.norm(a)), length=0.7, color=colour, lw=1.5)
    for name, colour in TRIAD:
        axes.plot([], [], color=colour, label=name)


def direction_of_view(axes: Any) -> np.ndarray:
    """Unit vector towards the viewer."""
    up, round_ = math.radians(axes.elev), math.radians(axes.azim)
    return np.array(
        [math.cos(up) * math.cos(round_), math.cos(up) * math.sin(round_), math.sin(up)]
    )


def draw_robots(figure: Figure) -> None:
    """fig_four_UAVs: four robots, their detection ranges, and the sets N_i and N_i^+."""
    figure.set_size_inches(6.2, 6.6)
    figure.set_layout_engine("constrained")
    axes = figure.add_subplot()
    near = robots_in_range(ROBOTS, DETECTION_RANGE)
    above = robots_with_priority(ROBOTS, DETECTION_RANGE)
    for i, (x, y, _) in enumerate(ROBOTS):
        axes.add_patch(Circle((x, y), DETECTION_RANGE, fill=True, fc=COLOURS[i], alpha=0.07))
        axes.add_patch(Circle((x, y), DETECTION_RANGE, fill=False, ec=COLOURS[i], lw=1.4))
        axes.plot(x, y, "o", color=COLOURS[i], markersize=9)
        axes.annotate(str(i + 1), (x, y), (9, 5), textcoords="offset points", fontweight="bold")
        text = f"$N_{i + 1}$ = {numbers(near, i)}   $N_{i + 1}^+$ = {numbers(above, i)}"
        axes.plot([], [], "o", color=COLOURS[i], label=text)
    axes.set(xlim=(-150, 175), ylim=(-195, 200), aspect="equal", xlabel="x [m]", ylabel="y [m]")
    axes.set_title("Who sees whom, and who gives way")
    figure.legend(loc="outside lower center", ncols=2)


def numbers(sets: Neighbours, i: int) -> str:
    """The set of robot `i`, numbered from 1."""
    found = sets.others[sets.start[i] : sets.start[i + 1]]
    return "{" + ", ".join(str(j + 1) for j in found) + "}" if len(found) else "∅"


def space(figure: Figure, size: tuple[float, float], elev: float, azim: float) -> Any:
    """Add axes in space to a figure, to one scale."""
    figure.set_size_inches(*size)
    figure.set_layout_engine("constrained")
    axes: Any = figure.add_subplot(projection="3d", computed_zorder=False)
    axes.view_init(elev=elev, azim=azim)
    return axes
