"""Figures and the report."""

import base64
import re
from collections.abc import Iterator
from dataclasses import replace
from html.parser import HTMLParser
from io import BytesIO
from pathlib import Path
from typing import Any, NamedTuple

import matplotlib as mpl
import numpy as np
import pytest
from drawings import drawn
from flight_samples import moved, record_of, spiral, straight
from matplotlib.figure import Figure
from matplotlib.image import imread
from scenario_samples import loaded_from
from scenario_texts import MINIMAL, SECOND

from vfguide.report.drawing import Flights, broken, goal_axis, to_png
from vfguide.report.figures import draw_figures
from vfguide.report.path_figures import draw_plan, draw_side, draw_space
from vfguide.report.report import number, render, span, write_report
from vfguide.report.time_figures import (
    draw_air,
    draw_attitude,
    draw_envelope,
    draw_position,
    draw_rates,
)
from vfguide.results.judge import judge
from vfguide.results.result import Result
from vfguide.results.verdict import in_words

pytestmark = pytest.mark.slow

COMMAND = "vfguide run x.toml --set 'wind.turbulence=\"none\"'"
WINDY = ("wind.speed_mps=8", "wind.from_deg=45")


class Run(NamedTuple):
    folder: Path
    flights: Flights
    result: Result


def flights_of(folder: Path, text: str, seconds: float = 25.0) -> Flights:
    loaded = loaded_from(folder, text, WINDY)
    paths = (straight, moved(spiral, (0.0, 300.0, 0.0)))
    records = [
        record_of(vehicle, path, seconds)
        for vehicle, path in zip(loaded.scenario.vehicles, paths, strict=False)
    ]
    return Flights(loaded, records)


@pytest.fixture(scope="module")
def run(tmp_path_factory: pytest.TempPathFactory) -> Run:
    folder = tmp_path_factory.mktemp("run")
    flights = flights_of(folder, MINIMAL + SECOND)
    result = judge(flights.loaded.scenario, flights.records, 25.0, 0.1)
    write_report(folder, flights.loaded, flights.records, result, COMMAND)
    return Run(folder, flights, result)


class Page(HTMLParser):
    """What a page refers to, and its text."""

    def __init__(self) -> None:
        super().__init__()
        self.open: list[str] = []
        self.references: list[str] = []
        self.alternatives: list[str | None] = []
        self.words: list[str] = []

    def handle_starttag(self, tag: str, attrs: list[tuple[str, str | None]]) -> None:
        if tag not in {"meta", "img"}:
            self.open.append(tag)
        for key, value in attrs:
            if key in {"src", "href", "srcset", "data", "action"}:
                self.references.append(value or "")
            if key == "alt":
                self.alternatives.append(value)

    def handle_endtag(self, tag: str) -> None:
        assert self.open.pop() == tag

    def handle_data(self, data: str) -> None:
        self.words.append(data)

    @property
    def text(self) -> str:
        return " ".join(" ".join(self.words).split())


@pytest.fixture(scope="module")
def page(run: Run) -> Iterator[Page]:
    page = Page()
    page.feed((run.folder / "report.html").read_text())
    page.close()
    return page


def test_the_report_needs_nothing_beside_it(run: Run, page: Page) -> None:
    assert page.open == []
    assert len(page.references) == 9
    assert all(re.match("data:image/png;base64,", its) for its in page.references)
    text = (run.folder / "report.html").read_text()
    assert "<script" not in text
    assert "url(" not in text
    assert "@import" not in text
    assert not re.search(r"https?://", text)


def test_the_report_holds_the_figures_that_lie_beside_it(run: Run, page: Page) -> None:
    files = sorted((run.folder / "figures").iterdir())
    assert [file.name for file in files] == sorted(
        f"{name}.png"
        for name in (
            "path-3d",
            "path-plan",
            "path-side",
            "separation",
            "position",
            "attitude",
            "envelope",
            "rates",
            "air",
        )
    )
    embedded = {base64.b64decode(its.split(",")[1]) for its in page.references}
    assert embedded == {file.read_bytes() for file in files}
    assert all(page.alternatives)


def test_the_report_says_how_it_went_and_how_to_repeat_it(run: Run, page: Page) -> None:
    assert "Verdict: bad" in page.text
    assert "goal 1 of vehicle 2 not reached" in page.text
    assert COMMAND in page.text
    assert " ".join(run.flights.loaded.scenario.to_toml().split()) in page.text
    assert "Vehicle 1, goal 1 yes 20.0 0.000 - 0.00 0.00 5 m, 10°" in page.text
    assert "588.0 to 588.0" in page.text
    assert str(run.folder) not in page.text


def test_a_good_flight_has_no_reasons(tmp_path: Path) -> None:
    flights = flights_of(tmp_path, MINIMAL)
    result = judge(flights.loaded.scenario, flights.records, 25.0, 0.1)
    text = render(flights.loaded, result, [], COMMAND)
    assert "Verdict: good" in text
    assert "<h2>Why</h2>" not in text


def pixels_of(run: Run) -> Iterator[tuple[str, Any]]:
    for file in (run.folder / "figures").iterdir():
        yield file.name, imread(BytesIO(file.read_bytes()), format="png")[..., :3]


def test_figures_show_something(run: Run) -> None:
    for name, pixels in pixels_of(run):
        height, width, _ = pixels.shape
        assert 700 <= width <= 1600, name
        assert 400 <= height <= 1300, name
        assert 0.005 < np.mean(pixels.min(axis=2) < 0.9) < 0.5, name


def test_nothing_touches_the_edge_of_a_figure(run: Run) -> None:
    for name, pixels in pixels_of(run):
        edges = (pixels[:8], pixels[-8:], pixels[:, :8], pixels[:, -8:])
        assert all(edge.min() > 0.9 for edge in edges), name


@pytest.mark.parametrize("draw", [draw_plan, draw_side])
def test_flat_views_have_one_scale_and_hold_the_path(run: Run, draw: object) -> None:
    assert callable(draw)
    (axes,) = drawn(draw, run.flights).axes
    box = axes.get_window_extent()
    (left, right), (low, high) = axes.get_xlim(), axes.get_ylim()
    assert box.width / (right - left) == pytest.approx(box.height / (high - low), rel=1e-6)
    for line in axes.lines:
        x, y = np.asarray(line.get_xdata()), np.asarray(line.get_ydata())
        assert left <= x.min() <= x.max() <= right
        assert low <= y.min() <= y.max() <= high


def test_the_plan_has_north_up_and_east_right(run: Run) -> None:
    figure = Figure()
    draw_plan(figure, run.flights)
    (axes,) = figure.axes
    assert axes.get_xlabel().startswith("East")
    assert axes.get_ylabel().startswith("North")
    first = axes.lines[0]
    assert np.asarray(first.get_xdata()) == pytest.approx(run.flights.records[0].p_n[:, 1])
    assert np.asarray(first.get_ydata()) == pytest.approx(run.flights.records[0].p_n[:, 0])
    assert axes.get_xlim() == tuple(sorted(axes.get_xlim()))
    assert axes.get_ylim() == tuple(sorted(axes.get_ylim()))


def test_the_wind_arrow_points_where_the_wind_blows(run: Run) -> None:
    (axes,) = drawn(draw_plan, run.flights).axes
    (text,) = [its for its in axes.texts if "Wind" in its.get_text()]
    assert text.get_text() == "Wind 8 m/s\nfrom 045°"
    arrows = [its.arrow_patch for its in axes.texts if its.arrow_patch and its.get_text() == ""]
    path = arrows[-1].get_path().vertices
    toward = path[2] - path[0]
    assert toward / np.hypot(*toward) == pytest.approx([-np.sqrt(0.5)] * 2, abs=0.01)


CHANGES = "wind.change=[{time_s=30, speed_mps=0}, {time_s=50, speed_mps=12, from_deg=320}]"


def test_a_wind_that_changes_is_shown_as_it_changes(tmp_path: Path) -> None:
    loaded = loaded_from(tmp_path, MINIMAL, (*WINDY, CHANGES))
    record = record_of(loaded.scenario.vehicles[0], straight, 25.0)
    (axes,) = drawn(draw_plan, Flights(loaded, [record])).axes
    texts = [its.get_text() for its in axes.texts if "Wind" in its.get_text()]
    assert texts == [
        "Wind 8 m/s\nfrom 045°",
        "Wind 0 m/s\nfrom 045°\nat 30 s",
        "Wind 12 m/s\nfrom 320°\nat 50 s",
    ]
    arrows = [its for its in axes.texts if its.arrow_patch and its.get_text() == ""]
    assert len(arrows) == 1 + 2  # of the goal, of the winds that blow
    card = render(loaded, judge(loaded.scenario, [record], 25.0, 1.0), [], COMMAND)
    assert "at 30 s 0 m/s from 045°" in card
    assert "at 50 s 12 m/s from 320°" in card


def test_the_view_in_space_has_one_scale(run: Run) -> None:
    figure = Figure()
    draw_space(figure, run.flights)
    (axes,) = figure.axes
    spans = [np.diff(limits)[0] for limits in (axes.get_xlim(), axes.get_ylim(), axes.get_zlim())]
    ratio = np.array(spans) / axes._box_aspect
    assert ratio == pytest.approx([ratio[0]] * 3, rel=1e-6)


def test_figures_of_a_flight_without_a_setpoint(tmp_path: Path) -> None:
    flights = flights_of(tmp_path, MINIMAL, seconds=0.02)
    silent = [
        replace(its, thrust=its.thrust * np.nan, omega_wanted_b=its.omega_wanted_b * np.nan)
        for its in flights.records
    ]
    for draw in (draw_envelope, draw_rates):
        assert to_png(draw, Flights(flights.loaded, silent)).startswith(b"\x89PNG")


def test_figures_of_one_sample(tmp_path: Path) -> None:
    assert len(draw_figures(flights_of(tmp_path, MINIMAL, seconds=0.0))) == 8


def test_figures_of_positions_that_are_no_numbers(tmp_path: Path) -> None:
    flights = flights_of(tmp_path, MINIMAL)
    (record,) = flights.records
    p_n = record.p_n.copy()
    p_n[100:] = np.nan
    for draw in (draw_space, draw_plan, draw_side, draw_position):
        broken_off = Flights(flights.loaded, [replace(record, p_n=p_n)])
        assert to_png(draw, broken_off).startswith(b"\x89PNG")


def test_drawing_again_gives_the_same_bytes_and_changes_no_setting(run: Run) -> None:
    before = dict(mpl.rcParams)
    for picture in draw_figures(run.flights):
        assert (run.folder / "figures" / f"{picture.name}.png").read_bytes() == picture.png
    assert dict(mpl.rcParams) == before


@pytest.mark.parametrize("difference", [0.0, 0.004, 0.03, 0.4, 30.0])
@pytest.mark.parametrize(
    "draw", [draw_air, draw_attitude, draw_envelope, draw_position, draw_rates]
)
def test_what_stands_beside_an_axis_does_not_overlap(
    tmp_path: Path, draw: Any, difference: float
) -> None:
    """However little there is to show."""
    flights = flights_of(tmp_path, MINIMAL)
    (record,) = flights.records
    wave = difference * np.sin(record.time)
    little = replace(
        record,
        p_n=record.p_n * (1.0, 0.0, 1.0) - wave[:, None] * (0.0, 0.0, 1.0),
        euler=record.euler + 0.01 * wave[:, None],
        airspeed=25.78 + wave,
        wind_n=record.wind_n + wave[:, None],
    )
    for axes in drawn(draw, Flights(flights.loaded, [little])).axes:
        label = axes.yaxis.label.get_window_extent()
        low, high = sorted(axes.get_ylim())
        ticks = [
            tick.get_window_extent()
            for tick, value in zip(axes.get_yticklabels(), axes.get_yticks(), strict=True)
            if low <= value <= high
        ]
        assert ticks
        assert not any(label.overlaps(tick) for tick in ticks), axes.get_ylabel()


def test_a_difference_that_does_not_matter_does_not_fill_a_figure(run: Run) -> None:
    *_, airspeed = drawn(draw_air, run.flights).axes
    *_, height = drawn(draw_position, run.flights).axes
    _, pitch, yaw = drawn(draw_attitude, run.flights).axes
    for axes, least in ((airspeed, 2.0), (height, 5.0), (pitch, 10.0)):
        assert np.ptp(axes.get_ylim()) >= least
    assert yaw.get_yticks().tolist() == [0.0, 90.0, 180.0, 270.0, 360.0]


def test_a_reason_is_told_in_words(run: Run) -> None:
    result = judge(run.flights.loaded.scenario, run.flights.records, 25.0, 0.1, ("time",))
    assert result.reasons[0] == "time"
    assert "time: duration_s was over first" in render(run.flights.loaded, result, [], COMMAND)
    assert in_words("time") == "time: duration_s was over first"
    assert in_words(result.reasons[1]) == result.reasons[1]


def test_no_line_is_drawn_where_an_angle_jumps() -> None:
    angles = np.array([350.0, 359.0, 1.0, 2.0, 90.0])
    assert np.isnan(broken(angles)).tolist() == [False, False, True, False, False]


@pytest.mark.parametrize(
    ("heading", "climb", "axis"),
    [
        (0.0, 0.0, (1.0, 0.0, 0.0)),
        (90.0, 0.0, (0.0, 1.0, 0.0)),
        (180.0, 30.0, (-np.sqrt(0.75), 0.0, -0.5)),
    ],
)
def test_goal_axis(heading: float, climb: float, axis: tuple[float, float, float]) -> None:
    assert goal_axis(heading, climb) == pytest.approx(axis, abs=1e-12)


def test_numbers_in_tables() -> None:
    assert number(1.2345) == "1.23"
    assert number(None) == "-"
    assert span((1.0, 2.0)) == "1.0 to 2.0"
