#!/usr/bin/env python3
"""The figure of law `field` in `field/slalom`, beside the paths of law `flight` and of the paper.

python tools/field_figures.py --out DIR

The paper's rigid body flies in still air, with reactive areas that reach 100 m beyond the walls.
The figure in `docs/images` comes from here.
"""

import argparse
import tempfile
import tomllib
from collections.abc import Iterator
from pathlib import Path
from typing import Any

import numpy as np
import tomli_w
from compare_laws import on_papers_plant, with_reach
from flown_worlds import Table
from matplotlib.figure import Figure
from matplotlib.lines import Line2D
from paper_figures import smaller

from vfguide.files.data import find_scenario
from vfguide.geometry.vector import Vectors
from vfguide.preflight.load import load_scenario
from vfguide.report.drawing import COLOURS, Flights, line_of, to_png
from vfguide.report.field_drawing import field_marks
from vfguide.report.field_figure import draw_plane, goal_planes, led_elsewhere_marks
from vfguide.report.obstacle_drawing import section_mark
from vfguide.report.path_figures import EAST_AXIS, NORTH_AXIS
from vfguide.report.view import PATH_MARKS, view_of
from vfguide.runs.lockstep import fly_scenario

NAME = "field/slalom"
REACH = 100.0
"""Distance beyond the walls that the reactive areas of the paper's rigid body reach [m]; chosen."""
STEPS = 200.0
"""Rate at which the paper's law is evaluated [Hz]; chosen high, since it turns late."""
END: Any = {"marker": "X", "markevery": [-1], "markersize": 9, "markeredgecolor": "white"}
BESIDE: dict[str, Any] = {
    "Aeroplane, law flight": {"color": COLOURS[2], "linestyle": "dashed", "zorder": 2.1},
    "The paper's rigid body": {"color": COLOURS[3], "linestyle": "dashdot", "zorder": 4, **END},
}
"""Lines of what is flown beside law field, by its name."""


def paths_beside() -> Iterator[Vectors]:
    """The paths of `BESIDE`, NED [m]."""
    yield path_of(NAME, "law=flight")
    table = tomllib.loads(find_scenario(NAME).read_text())
    with tempfile.TemporaryDirectory() as folder:
        file = Path(folder, "rigid-body.toml")
        file.write_text(tomli_w.dumps(for_rigid_body(table)))
        yield path_of(str(file))


def for_rigid_body(table: Table) -> Table:
    """The scenario for the paper's rigid body and law, over the same time."""
    world = on_papers_plant(with_reach(table, REACH))
    guidance = {**world["guidance"], "rate_hz": STEPS}
    return {**world, "guidance": guidance, "duration_s": table["duration_s"]}


def path_of(name: str, *changes: str) -> Vectors:
    """The path of the first vehicle, NED [m]."""
    return fly(name, *changes).records[0].p_n


def fly(name: str, *changes: str) -> Flights:
    """A scenario, flown."""
    loaded = load_scenario(name, changes)
    with tempfile.TemporaryDirectory() as folder:
        return Flights(loaded, fly_scenario(loaded, Path(folder)).records)


def draw(figure: Figure, flights: Flights) -> None:
    """The field in the plane of the goal, its flight, and the others beside it."""
    figure.set_size_inches(6.6, 7.4)
    figure.set_layout_engine("constrained")
    axes = figure.add_subplot()
    (plane,) = goal_planes(flights)
    draw_plane(axes, flights, plane, view_of(flights, np.array((EAST_AXIS, NORTH_AXIS))))
    for p_n, line in zip(paths_beside(), BESIDE.values(), strict=True):
        north, east, _ = p_n.T
        axes.plot(east, north, **line)
    axes.set_anchor("E")
    axes.set_title("Four walls, in the plane of the goal")
    led = Line2D([], [], **line_of(0), label="Aeroplane, law field")
    others = [Line2D([0], [0], label=name, **line) for name, line in BESIDE.items()]
    marks = [led, *others, *PATH_MARKS, section_mark(), *field_marks(plane)]
    marks += led_elsewhere_marks(flights)
    figure.legend(handles=marks, loc="outside right center", labelspacing=0.9)


def main() -> None:
    """Draw the figure and write it."""
    parser = argparse.ArgumentParser(description=__doc__)
    parser.add_argument("--out", type=Path, required=True)
    out = parser.parse_args().out
    out.mkdir(parents=True, exist_ok=True)
    (out / "field-slalom.png").write_bytes(smaller(to_png(draw, fly(NAME))))


if __name__ == "__main__":
    main()
