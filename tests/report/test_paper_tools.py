"""The tools that measure and draw the field, on smaller samples."""

import importlib.util
from io import BytesIO
from pathlib import Path

import matplotlib.image
import numpy as np
import pytest
from drawings import drawn

from vfguide.report.drawing import to_png

pytestmark = pytest.mark.slow

TOOLS = Path(__file__).parents[2] / "tools"
DRAWINGS = ("draw_coordinates", "draw_plane", "draw_curves", "draw_surface", "draw_robots")


def tool(name):
    spec = importlib.util.spec_from_file_location(name, TOOLS / f"{name}.py")
    module = importlib.util.module_from_spec(spec)
    spec.loader.exec_module(module)
    return module


def test_what_the_field_holds_to():
    rows = list(tool("measure_field").exactness(seed=77, points=800))
    assert len(rows) == 18
    for what, _, value in rows:
        if what.startswith("least"):
            assert float(value) > 0.0, what
        else:
            assert float(value) <= (1e-5 if "Omega_a" in what else 1e-12), what


@pytest.mark.parametrize("name", DRAWINGS)
def test_drawings_of_the_field(name):
    draw = getattr(tool("paper_field"), name)
    picture = matplotlib.image.imread(BytesIO(to_png(lambda figure, _: draw(figure), None)))
    assert min(picture.shape[:2]) > 400
    dark = np.mean(picture[..., :3].min(axis=2) < 0.8)
    assert 0.003 < dark < 0.5


def test_paths_beside_that_of_law_field():
    """The paper's rigid body stays before the first wall, as the page says."""
    figures = tool("field_figures")
    aeroplane, rigid_body = figures.paths_beside()
    assert aeroplane[:, 0].max() > 850.0
    assert rigid_body[:, 0].max() < -460.0
    assert np.abs(rigid_body[:, 1]).max() < 1.0


def test_the_drawing_of_law_field_holds_all_paths():
    figures = tool("field_figures")
    figure = drawn(figures.draw, figures.fly(figures.NAME))
    (axes,) = figure.axes
    longest = [line for line in axes.lines if len(line.get_xdata()) > 1000]
    assert len({line.get_color() for line in longest} - {"white"}) == 3
    (legend,) = figure.legends
    assert {*figures.BESIDE, "Aeroplane, law field"} < {
        text.get_text() for text in legend.get_texts()
    }
