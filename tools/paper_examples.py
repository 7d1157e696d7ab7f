"""Figures of the paper's three examples, from flights of `paper/example-1`, `-2` and `-3`."""

import itertools
import tempfile
from collections.abc import Iterator
from pathlib import Path
from typing import Any

import numpy as np
from matplotlib.axes import Axes
from matplotlib.figure import Figure
from matplotlib.ticker import MultipleLocator

from vfguide.geometry.units import DEG
from vfguide.geometry.vector import Vector
from vfguide.preflight.load import load_scenario
from vfguide.report.drawing import (
    GOAL_COLOUR,
    MUTED_COLOUR,
    Flights,
    broken,
    line_of,
    vehicle_lines,
)
from vfguide.report.meshes import outline
from vfguide.report.obstacle_drawing import OBSTACLE_COLOUR
from vfguide.runs.lockstep import fly_scenario

AXES = "xyz"


def fly(name: str) -> Flights:
    """Fly a shipped scenario."""
    loaded = load_scenario(name)
    with tempfile.TemporaryDirectory() as folder:
        return Flights(loaded, fly_scenario(loaded, Path(folder)).records)


def draw_paths(figure: Figure, flights: Flights) -> None:
    """fig_one_UAV_tra: the paths in space."""
    figure.set_size_inches(7.0, 6.0)
    figure.set_layout_engine("constrained")
    draw_space(figure.add_subplot(projection="3d", computed_zorder=False), flights)
    figure.legend(handles=vehicle_lines(flights), loc="outside lower center", ncols=6)


def draw_histories(figure: Figure, flights: Flights) -> None:
    """fig_one_UAV_curve: position and Euler angles over time."""
    figure.set_size_inches(8.6, 6.6)
    figure.set_layout_engine("constrained")
    grid = figure.subplots(3, 2, sharex=True)
    angles = ("Roll", "Pitch", "Yaw")
    for k, (left, right) in enumerate(grid):
        for index, record in enumerate(flights.records):
            line = line_of(index)
            left.plot(record.time, record.p_n[:, k], **line)
            right.plot(record.time, broken(record.euler[:, k] / DEG), **line)
        left.set_ylabel(f"{AXES[k]} [m]")
        right.set_ylabel(f"{angles[k]} [°]")
        right.yaxis.set_major_locator(MultipleLocator(90.0 if k != 1 else 45.0))
    first, _, last = grid
    for axes, title in zip(first, ("Position", "Orientation"), strict=True):
        axes.set_title(title)
    for axes in last:
        axes.set_xlabel("Time [s]")
    figure.legend(handles=vehicle_lines(flights), loc="outside lower center", ncols=6)


def draw_projections(figure: Figure, flights: Flights) -> None:
    """fig_one_UAV_ob, fig_seven_UAVs_CA: the paths in space and in the planes x-z and y-z."""
    figure.set_size_inches(11.0, 6.4)
    figure.set_layout_engine("constrained")
    grid = figure.add_gridspec(2, 2, width_ratios=(1.6, 1.0))
    draw_space(figure.add_subplot(grid[:, 0], projection="3d", computed_zorder=False), flights)
    for row, across in enumerate((0, 1)):
        draw_plane(figure.add_subplot(grid[row, 1]), flights, across)
    figure.legend(handles=vehicle_lines(flights), loc="outside lower center", ncols=7)


def draw_distances(figure: Figure, flights: Flights) -> None:
    """Distances between vehicles, a line each pair; the least of all, and the distance to keep."""
    figure.set_size_inches(8.0, 4.4)
    figure.set_layout_engine("constrained")
    axes = figure.add_subplot()
    time = flights.records[0].time
    pairs = itertools.combinations([record.p_n for record in flights.records], 2)
    distances = np.array([np.linalg.norm(a - b, axis=1) for a, b in pairs])
    axes.plot(time, distances.T, color="#c3cad4", lw=1.0)
    axes.plot(time, distances.min(axis=0), color=line_of(0)["color"], label="Nearest pair")
    keep = 2.0 * flights.loaded.scenario.avoidance.safety_radius_m
    axes.axhline(keep, color=line_of(1)["color"], ls="--", label=f"2 r_c = {keep:g} m")
    axes.set(xlabel="Time [s]", ylabel="Distance [m]", ylim=(0.0, None))
    axes.set_title("Distances between all pairs")
    figure.legend(loc="outside lower center", ncols=2)


def draw_space(axes: Any, flights: Flights) -> None:
    """Draw obstacles, paths, starts and goals in space; axes to one scale."""
    for body in flights.bodies:
        axes.plot_surface(
            *np.moveaxis(body.surface, -1, 0), color=OBSTACLE_COLOUR, alpha=0.55, lw=0, shade=True
        )
    for index, record in enumerate(flights.records):
        line = line_of(index)
        axes.plot(*record.p_n.T, **line)
        axes.scatter(*record.p_n[0], color=line["color"], s=24)
    low, high = box(flights)
    for goal, ahead in goals(flights):
        length = 0.13 * float((high - low).max())
        axes.scatter(*goal, color=GOAL_COLOUR, s=18)
        axes.quiver(*goal, *ahead, length=length, color=GOAL_COLOUR, lw=1.8)
    xlim, ylim, zlim = zip(low, high, strict=True)
    axes.set(xlim=xlim, ylim=ylim, zlim=zlim)
    axes.set_box_aspect(high - low, zoom=0.95)
    axes.set(xlabel="x [m]", ylabel="y [m]", zlabel="z [m]")
    axes.locator_params(nbins=5)
    axes.view_init(elev=26, azim=-60)


def draw_plane(axes: Axes, flights: Flights, across: int) -> None:
    """Draw the same from the side, with coordinate number `across` to the right and z upward."""
    for body in flights.bodies:
        axes.fill(
            *outline(body.surface[..., [across, 2]]).T,
            fc=OBSTACLE_COLOUR,
            ec=MUTED_COLOUR,
            lw=0.6,
            alpha=0.6,
        )
    for index, record in enumerate(flights.records):
        line = line_of(index)
        axes.plot(record.p_n[:, across], record.p_n[:, 2], **line)
        axes.plot(record.p_n[0, across], record.p_n[0, 2], "o", color=line["color"], ms=5)
    for goal, _ in goals(flights):
        axes.plot(goal[across], goal[2], "o", color=GOAL_COLOUR, ms=4, zorder=5)
    low, high = box(flights)
    axes.set(xlim=(low[across], high[across]), ylim=(low[2], high[2]), aspect="equal")
    axes.set(xlabel=f"{AXES[across]} [m]", ylabel="z [m]")
    axes.set_title(f"Plane {AXES[across]}-z")


def goals(flights: Flights) -> Iterator[tuple[Vector, Vector]]:
    """The different goals of all vehicles, each with its direction."""
    seen = {}
    for record in flights.records:
        for goal in record.vehicle.goals:
            h, c = goal.heading_deg * DEG, goal.climb_deg * DEG
            ahead = (np.cos(c) * np.cos(h), np.cos(c) * np.sin(h), -np.sin(c))
            seen[tuple(goal.position_m)] = np.array(ahead)
    return ((np.array(position), ahead) for position, ahead in seen.items())


def box(flights: Flights) -> tuple[Vector, Vector]:
    """The lowest and the highest corner of a box of all that is drawn, with a margin, not flat."""
    paths = [record.p_n for record in flights.records]
    bodies = [body.surface.reshape(-1, 3) for body in flights.bodies]
    points = np.vstack([*paths, *bodies, *(goal for goal, _ in goals(flights))])
    low, high = points.min(axis=0), points.max(axis=0)
    longest = float((high - low).max())
    half = np.maximum(high - low, 0.3 * longest) / 2.0 + 0.05 * longest
    return (low + high) / 2.0 - half, (low + high) / 2.0 + half
