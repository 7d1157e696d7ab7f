"""Figures and report of rigid bodies among obstacles."""

import re
from dataclasses import replace
from itertools import pairwise
from pathlib import Path
from typing import NamedTuple

import numpy as np
import pytest
from drawings import drawn
from flight_samples import moved, record_of, spiral, straight
from scenario_samples import loaded_from
from scenario_texts import MINIMAL, SECOND

from vfguide.report.distance_figures import MAX_OBSTACLES, draw_clearance, draw_separation, nearest
from vfguide.report.drawing import Flights, to_png
from vfguide.report.figures import draw_figures
from vfguide.report.obstacle_drawing import LONGEST_NAME, SHOWN_TIMES, shortened
from vfguide.report.path_figures import draw_plan, draw_side, draw_space
from vfguide.report.report import render, span, write_report
from vfguide.report.time_figures import draw_attitude, draw_position, draw_rates, draw_speed
from vfguide.results.clearance import clearances
from vfguide.results.closest import closest
from vfguide.results.judge import judge
from vfguide.results.result import Result
from vfguide.runs.lockstep import fly_scenario
from vfguide.scenario.obstacles import rows_of
from vfguide.terminal import flight_display

pytestmark = pytest.mark.slow

HEAD = """\
name = "bodies"
plant = "kinematic"
law = "paper"
duration_s = 8
guidance.k_v = 0.1
avoidance.detection_range_m = 30
"""
VEHICLE = """
[[vehicle]]
id = {id}
position_m = [-100, {east}, -20]
attitude_deg = [0, 0, 0]

[[vehicle.goal]]
position_m = [100, {east}, -30]
heading_deg = 10
"""
OBSTACLE = """
[[obstacle]]
name = '{name}'
shape = "{shape}"
position_m = {at}
{sizes}
heading_deg = 25
reactive_level = 2
velocity_mps = {velocity}
"""
STILL = [0, 0, 0]
OBSTACLES = (
    ("ball", "sphere", [0, -60, -20], "radius_m = 8", STILL),
    ("egg", "ellipsoid", [0, -30, -20], "semi_axes_m = [9, 5, 12]", STILL),
    (
        "cushion",
        "superquadric",
        [0, 0, -20],
        "semi_axes_m = [9, 7, 5]\nexponents = [2, 1, 3]",
        STILL,
    ),
    ("tower", "cylinder", [0, 30, -20], "radius_m = 6\nheight_m = 60", STILL),
    ("house", "box", [40, 60, -10], "size_m = [20, 14, 30]", STILL),
    ("hill", "cone", [40, -50, -10], "radius_m = 20\nheight_m = 40", STILL),
    ("balloon", "sphere", [60, 10, -40], "radius_m = 5", [2, -3, -1]),
)
DRAWINGS = (
    draw_plan,
    draw_side,
    draw_space,
    draw_clearance,
    draw_separation,
    draw_position,
    draw_attitude,
    draw_speed,
    draw_rates,
)


def obstacle_text(name: str, shape: str, at: list[float], sizes: str, velocity: list[float]) -> str:
    return OBSTACLE.format(name=name, shape=shape, at=at, sizes=sizes, velocity=velocity)


def scenario_text(vehicles: int, obstacles: tuple = OBSTACLES, head: str = HEAD) -> str:
    starts = [VEHICLE.format(id=k + 1, east=40 * k - 40) for k in range(vehicles)]
    return head + "".join(starts) + "".join(obstacle_text(*its) for its in obstacles)


def flown(folder: Path, text: str) -> Flights:
    loaded = loaded_from(folder, text)
    return Flights(loaded, fly_scenario(loaded, folder).records)


def values_of(line) -> np.ndarray:
    return np.asarray(line.get_ydata(), float)


class Run(NamedTuple):
    folder: Path
    flights: Flights
    result: Result
    page: str


@pytest.fixture(scope="module")
def run(tmp_path_factory: pytest.TempPathFactory) -> Run:
    folder = tmp_path_factory.mktemp("bodies")
    flights = flown(folder, scenario_text(3))
    result = judge(flights.loaded.scenario, flights.records, 8.0, 0.1)
    write_report(folder, flights.loaded, flights.records, result, "vfguide run x.toml")
    return Run(folder, flights, result, (folder / "report.html").read_text())


def test_there_is_a_figure_of_all_that_rigid_bodies_have(run: Run) -> None:
    files = sorted(file.stem for file in (run.folder / "figures").iterdir())
    paths = ["path-3d", "path-plan", "path-side"]
    over_time = ["attitude", "clearance", "position", "rates", "separation", "speed"]
    assert files == sorted([*paths, *over_time])
    assert run.page.count("data:image/png;base64,") == len(files)


@pytest.mark.parametrize("draw", DRAWINGS)
def test_no_panel_is_empty(run: Run, draw) -> None:
    """Every pair of axes has a line a vehicle or a pair, which breaks only where an angle jumps."""
    for axes in drawn(draw, run.flights).axes:
        long = [values_of(line) for line in axes.lines]
        long = [values for values in long if len(values) == len(run.flights.records[0].time)]
        assert len(long) >= 3
        assert all(np.isfinite(values).mean() > 0.95 for values in long)


def test_rates_are_drawn_once(run: Run) -> None:
    """What is commanded is what is flown: there are no two lines to tell apart."""
    assert [len(axes.lines) for axes in drawn(draw_rates, run.flights).axes] == [3, 3, 3]


def test_speed_is_the_way_over_the_time(run: Run) -> None:
    (axes,) = drawn(draw_speed, run.flights).axes
    for line, record in zip(axes.lines, run.flights.records, strict=True):
        step = np.diff(record.time)
        straight_way = np.linalg.norm(np.diff(record.p_n, axis=0), axis=1)
        nearly_straight = np.linalg.norm(record.omega_b[1:, 1:], axis=1) * step < 0.2
        shown = values_of(line)[1:]
        assert nearly_straight.mean() > 0.9
        assert shown[nearly_straight] == pytest.approx((straight_way / step)[nearly_straight], 0.01)
        assert (shown > 0.999 * straight_way / step).all()


def test_the_plan_shows_every_obstacle_where_it_is(run: Run) -> None:
    (axes,) = drawn(draw_plan, run.flights).axes
    assert len(axes.patches) == len(OBSTACLES) + SHOWN_TIMES - 1
    assert {text.get_text() for text in axes.texts if text.get_text()} == {
        name for name, *_ in OBSTACLES
    }
    (west, east), (south, north) = axes.get_xlim(), axes.get_ylim()
    for patch in axes.patches:
        corners = patch.get_xy()
        assert ((corners >= (west, south)) & (corners <= (east, north))).all()
    ball = axes.patches[0].get_xy()
    assert np.hypot(*(ball - (-60.0, 0.0)).T) == pytest.approx(8.0, rel=0.01)
    tower = axes.patches[3].get_xy()
    assert np.hypot(*(tower - (30.0, 0.0)).T) == pytest.approx(6.0, rel=0.01)


def test_a_moving_obstacle_is_drawn_at_several_times(run: Run) -> None:
    (axes,) = drawn(draw_plan, run.flights).axes
    before, *_, after = shown = axes.patches[-SHOWN_TIMES:]
    seconds = run.flights.records[0].time[-1]
    way = np.array([-3.0, 2.0]) * seconds
    assert after.get_xy() - before.get_xy() == pytest.approx(
        np.broadcast_to(way, before.get_xy().shape)
    )
    eastward = [patch.get_xy()[0, 0] for patch in shown]
    assert np.diff(eastward) == pytest.approx(np.full(SHOWN_TIMES - 1, way[0] / (SHOWN_TIMES - 1)))
    assert before.get_facecolor()[3] < 0.5 * after.get_facecolor()[3]
    (track,) = [line for line in axes.lines if len(line.get_xdata()) == 2]
    assert track.get_xydata() == pytest.approx(
        np.array([[10.0, 60.0], [10.0 + way[0], 60.0 + way[1]]])
    )


def test_figures_of_paths_say_what_is_an_obstacle(run: Run, tmp_path: Path) -> None:
    (legend,) = drawn(draw_plan, run.flights).legends
    labels = [text.get_text() for text in legend.get_texts()]
    assert labels[:3] == ["Vehicle 1", "Vehicle 2", "Vehicle 3"]
    assert labels[-3:] == ["Obstacle, at the end", "Obstacle, before", "Path of its centre"]
    (legend,) = drawn(draw_space, flown(tmp_path, scenario_text(1, OBSTACLES[:1]))).legends
    assert [text.get_text() for text in legend.get_texts()][-1] == "Obstacle"


def test_an_obstacle_far_away_does_not_make_the_view_wider(tmp_path: Path) -> None:
    far = obstacle_text("far", "sphere", [0, 9000, -20], "radius_m = 50", STILL)
    alone = flown(tmp_path, scenario_text(1, ()))
    beside = flown(tmp_path, scenario_text(1, ()) + far)
    for draw in (draw_plan, draw_space):
        assert drawn(draw, beside).axes[0].get_xlim() == drawn(draw, alone).axes[0].get_xlim()


def test_a_huge_obstacle_is_cut_off(tmp_path: Path) -> None:
    huge = obstacle_text("moon", "sphere", [0, 5060, -20], "radius_m = 5000", STILL)
    flights = flown(tmp_path, scenario_text(1, ()) + huge)
    for draw in (draw_plan, draw_side, draw_space):
        (axes,) = drawn(draw, flights).axes
        assert np.ptp(axes.get_xlim()) < 1000.0
        assert np.ptp(axes.get_ylim()) < 1000.0


def test_goals_and_their_arrows_are_in_view(run: Run) -> None:
    (axes,) = drawn(draw_plan, run.flights).axes
    (west, east), (south, north) = axes.get_xlim(), axes.get_ylim()
    arrows = [text for text in axes.texts if getattr(text, "arrow_patch", None)]
    assert len(arrows) == 3
    for arrow in arrows:
        x, y = arrow.xy
        assert west < x < east
        assert south < y < north


def test_clearances_over_time(run: Run) -> None:
    grid = drawn(draw_clearance, run.flights).axes
    assert [axes.get_ylabel() for axes in grid] == [f"{name} [m]" for name, *_ in OBSTACLES]
    rows = rows_of(run.flights.loaded.scenario.obstacles)
    for which, axes in enumerate(grid):
        assert values_of(axes.lines[0]).tolist() == [0.0, 0.0]
        low, high = axes.get_ylim()
        for line, record in zip(axes.lines[1:], run.flights.records, strict=True):
            wanted = clearances(record, rows)[:, which]
            assert values_of(line) == pytest.approx(wanted)
            assert low < min(0.0, wanted.min()) <= wanted.max() < high


def test_clearances_of_one_vehicle_share_a_panel(tmp_path: Path) -> None:
    figure = drawn(draw_clearance, flown(tmp_path, scenario_text(1)))
    (axes,) = figure.axes
    assert len(axes.lines) == 1 + len(OBSTACLES)
    (legend,) = figure.legends
    names = [text.get_text() for text in legend.get_texts()]
    assert names == [*(name for name, *_ in OBSTACLES), "Surface"]
    looks = {(line.get_color(), line.get_linestyle()) for line in axes.lines[1:]}
    assert len(looks) == len(OBSTACLES)


def test_of_many_obstacles_the_nearest_are_drawn(tmp_path: Path) -> None:
    many = tuple(
        (f"post {k}", "sphere", [0, 20 * k - 70, -80 - 3 * k], "radius_m = 4", STILL)
        for k in range(MAX_OBSTACLES + 4)
    )
    flights = flown(tmp_path, scenario_text(1, many))
    rows = rows_of(flights.loaded.scenario.obstacles)
    measured = clearances(flights.records[0], rows)
    shown = nearest(measured[None])
    left = set(range(len(many))) - set(shown)
    assert len(shown) == MAX_OBSTACLES
    assert measured[:, shown].min(axis=0).max() <= measured[:, sorted(left)].min()
    title = drawn(draw_clearance, flights).axes[0].get_title()
    assert title == "Clearance from the nearest 8 of 12 obstacles"


def test_numbers_on_the_axis_of_distances_do_not_run_into_each_other(run: Run) -> None:
    for draw in (draw_clearance, draw_separation):
        for axes in drawn(draw, run.flights).axes:
            boxes = [
                label.get_window_extent()
                for label, at in zip(axes.get_yticklabels(), axes.get_yticks(), strict=True)
                if axes.get_ylim()[0] <= at <= axes.get_ylim()[1]
            ]
            assert len(boxes) >= 2
            assert all(one.y1 <= two.y0 for one, two in pairwise(boxes))


def test_the_axis_of_distances_has_room_for_a_flight_that_left(tmp_path: Path) -> None:
    flights = flown(tmp_path, scenario_text(1))
    away = [
        replace(its, p_n=its.p_n * np.linspace(1.0, 1e5, 401)[:, None] ** 1.2)
        for its in flights.records
    ]
    (axes,) = drawn(draw_clearance, Flights(flights.loaded, away)).axes
    assert axes.get_ylim()[1] > 1e6
    low, *others = [label.get_window_extent() for label in axes.get_yticklabels()][-9:]
    assert all(one.y1 <= two.y0 for one, two in pairwise([low, *others]))


def test_distances_between_vehicles(run: Run) -> None:
    figure = drawn(draw_separation, run.flights)
    (axes,) = figure.axes
    keep, *pairs = axes.lines
    assert values_of(keep).tolist() == [20.0, 20.0]
    one, two, three = (record.p_n for record in run.flights.records)
    for line, apart in zip(pairs, (one - two, one - three, two - three), strict=True):
        assert values_of(line) == pytest.approx(np.linalg.norm(apart, axis=1))
    (legend,) = figure.legends
    assert [text.get_text() for text in legend.get_texts()] == [
        "1 and 2",
        "1 and 3",
        "2 and 3",
        "To keep: 20 m",
    ]


def test_nothing_is_to_be_kept_where_vehicles_heed_nobody(tmp_path: Path) -> None:
    head = HEAD + "avoidance.between_vehicles = false\n"
    figure = drawn(draw_separation, flown(tmp_path, scenario_text(2, (), head)))
    assert len(figure.axes[0].lines) == 1
    assert [text.get_text() for text in figure.legends[0].get_texts()] == ["1 and 2"]


def test_of_many_pairs_the_nearest_stands_out(tmp_path: Path) -> None:
    flights = flown(tmp_path, scenario_text(5, ()))
    figure = drawn(draw_separation, flights)
    (axes,) = figure.axes
    _, *pairs, least = axes.lines
    assert len(pairs) == 10
    assert values_of(least) == pytest.approx(np.min([values_of(its) for its in pairs], axis=0))
    assert len({line.get_color() for line in pairs}) == 1
    assert least.get_color() != pairs[0].get_color()


def test_aeroplanes_among_obstacles(tmp_path: Path) -> None:
    """What is drawn of obstacles does not depend on the plant."""
    tower = obstacle_text(
        "tower", "cylinder", [0, 100, -80], "radius_m = 20\nheight_m = 160", STILL
    )
    loaded = replace(
        loaded_from(tmp_path, MINIMAL + SECOND),
        scenario=loaded_from(
            tmp_path, HEAD + MINIMAL.split("\n", 1)[1] + SECOND + tower
        ).scenario.model_copy(update={"plant": "jsbsim", "law": "flight"}),
    )
    paths = (straight, moved(spiral, (0.0, 300.0, 0.0)))
    vehicles = loaded.scenario.vehicles
    records = [record_of(its, path, 25.0) for its, path in zip(vehicles, paths, strict=True)]
    names = [picture.name for picture in draw_figures(Flights(loaded, records))]
    assert {"clearance", "separation", "envelope"} <= set(names)
    assert "speed" not in names


def test_positions_that_are_no_numbers(run: Run) -> None:
    first, *others = run.flights.records
    p_n = first.p_n.copy()
    p_n[100:] = np.nan
    broken_off = Flights(run.flights.loaded, [replace(first, p_n=p_n), *others])
    for draw in DRAWINGS:
        assert to_png(draw, broken_off).startswith(b"\x89PNG")


def test_the_report_tells_of_every_obstacle(run: Run) -> None:
    for name, shape, *_ in OBSTACLES:
        assert run.page.count(f"<td>{name}</td>") == 3
        assert shape in run.page
    assert "<td>moving sphere</td>" in run.page
    for vehicle in run.result.vehicles:
        for its in vehicle.obstacles:
            assert f">{its.min_clearance_m:.2f}</td>" in run.page
            assert f"<td>{its.min_level:.4g}</td>" in run.page


def test_the_report_tells_nothing_that_rigid_bodies_do_not_have(run: Run) -> None:
    text = re.sub(r"(?s)<style>.*?</style>|<pre>.*?</pre>|<[^>]+>", " ", run.page)
    assert "rigid bodies, law paper" in text
    assert "there is no ground, air or gravity" in text
    for word in ("Wind", "Load factor", "airspeed", "aerosonde", "nan", "None", "- to -"):
        assert word not in text


def test_names_are_shown_as_they_are_written(tmp_path: Path) -> None:
    names = ("a$b$ <i>", "塔", "a very long name of an obstacle indeed")
    obstacles = tuple((name, *its[1:]) for name, its in zip(names, OBSTACLES, strict=False))
    flights = flown(tmp_path, scenario_text(1, obstacles))
    for draw in (draw_plan, draw_clearance):
        assert to_png(draw, flights).startswith(b"\x89PNG")
    (axes,) = drawn(draw_plan, flown(tmp_path, scenario_text(1, obstacles[:1]))).axes
    assert axes.texts[-1].get_text() == r"a\$b\$ <i>"
    assert len(shortened(names[2])) == LONGEST_NAME
    long = tuple((f"obstacle named {k} MM", *its[1:]) for k, its in enumerate(OBSTACLES))
    figure = drawn(draw_clearance, flown(tmp_path, scenario_text(1, long)))
    assert figure.legends[0].get_window_extent().width < figure.bbox.width
    result = judge(flights.loaded.scenario, flights.records, 8.0, 0.1)
    page = render(flights.loaded, result, [], "vfguide run x.toml")
    assert "a$b$ &lt;i&gt;</td>" in page
    assert names[2] in page


def test_the_least_clearance_is_named(run: Run) -> None:
    least = closest(run.result)
    assert least is not None
    vehicle = next(its for its in run.result.vehicles if its.id == least.vehicle)
    (its,) = [its for its in vehicle.obstacles if its.name == least.obstacle]
    assert its.min_clearance_m == least.clearance
    every = [its.min_clearance_m for vehicle in run.result.vehicles for its in vehicle.obstacles]
    assert least.clearance == min(every)


def test_the_terminal_shows_how_near_it_was(
    run: Run, tmp_path: Path, capsys: pytest.CaptureFixture[str]
) -> None:
    flight_display.print_result(run.result, tmp_path)
    least = closest(run.result)
    assert least is not None
    assert (
        f"least clearance {least.clearance:.2f} m (vehicle {least.vehicle}, {least.obstacle}), "
        f"separation {run.result.min_separation_m:.2f} m\n" in capsys.readouterr().out
    )


def test_the_terminal_says_nothing_of_distances_that_there_are_not(
    tmp_path: Path, capsys: pytest.CaptureFixture[str]
) -> None:
    loaded = loaded_from(tmp_path)
    record = record_of(loaded.scenario.vehicles[0], straight, 25.0)
    result = judge(loaded.scenario, [record], 25.0, 0.1)
    assert closest(result) is None
    flight_display.print_result(result, tmp_path)
    assert "least" not in capsys.readouterr().out


def test_a_range_without_numbers_is_a_dash() -> None:
    assert span((None, None)) == "-"
