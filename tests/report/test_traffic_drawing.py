"""What figures show of other aircraft."""

from dataclasses import replace
from pathlib import Path

import numpy as np
import pytest
from drawings import drawn
from flight_samples import record_of, straight
from matplotlib.figure import Figure
from scenario_samples import loaded_from
from scenario_texts import MINIMAL

from vfguide.report.assurance_figure import nearest_hazard
from vfguide.report.drawing import Flights
from vfguide.report.path_figures import draw_plan, draw_side, draw_space

TRAFFIC = """
[avoidance]
traffic_radius_m = 60.0
traffic_half_height_m = 20.0

[[traffic]]
name = "CROSS"
icao = "3C6545"
position_m = [{north}, 500.0, -{height}]
velocity_mps = [0.0, -20.0, 0.0]
"""
SECONDS = 25.0


@pytest.fixture
def flights(tmp_path: Path) -> Flights:
    """An aircraft that crosses 300 m ahead of the start from the right, 10 m higher."""
    vehicle = loaded_from(tmp_path).scenario.vehicles[0]
    north, height = 300.0 + vehicle.position_m[0], 10.0 - vehicle.position_m[2]
    (tmp_path / "crossing").mkdir()
    text = MINIMAL + TRAFFIC.format(north=north, height=height)
    loaded = loaded_from(tmp_path / "crossing", text)
    return Flights(loaded, [record_of(loaded.scenario.vehicles[0], straight, SECONDS)])


def apart(flights: Flights) -> np.ndarray:
    record, its = flights.records[0], flights.loaded.scenario.traffic[0]
    track = its.position_m + record.time[:, None] * np.array(its.velocity_mps)
    return track - record.p_n


def test_a_volume_is_shown_where_it_came_nearest(flights: Flights) -> None:
    (its,) = flights.traffic
    beside = np.hypot(*apart(flights)[:, :2].T)
    assert 0 < beside.argmin() < len(beside) - 1, "neither the start nor the end"
    assert its.nearest == pytest.approx(its.p_n[beside.argmin()])
    from_axis = its.volume - its.nearest
    assert np.hypot(from_axis[:, 0], from_axis[:, 1]) == pytest.approx(60.0)
    assert set(from_axis[:, 2].round(9)) == {-20.0, 20.0}


def test_where_the_vehicle_is_not_known_no_aircraft_is_near(flights: Flights) -> None:
    record = flights.records[0]
    p_n = record.p_n.copy()
    p_n[len(p_n) // 10 :] = np.nan
    (its,) = Flights(flights.loaded, [replace(record, p_n=p_n)]).traffic
    assert its.nearest == pytest.approx(its.p_n[len(p_n) // 10 - 1])


@pytest.mark.parametrize("draw", [draw_plan, draw_side, draw_space])
def test_the_figures_of_the_path_show_it(flights: Flights, draw) -> None:
    figure = drawn(draw, flights)
    texts = [text.get_text() for legend in figure.legends for text in legend.get_texts()]
    assert texts[-2:] == ["Other aircraft", "Its volume, when nearest"]
    names = [text.get_text() for text in figure.axes[0].texts]
    assert ("CROSS" in names) == (draw is draw_plan)


def test_its_volume_is_a_hazard_that_may_be_the_nearest(flights: Flights) -> None:
    beside, above = np.hypot(*apart(flights)[:, :2].T), np.abs(apart(flights)[:, 2])
    assert (above < 20.0).all()
    outside = beside > 60.0
    assert outside.any()
    nearest = nearest_hazard(flights, flights.records[0])
    assert nearest[outside] == pytest.approx(beside[outside] - 60.0)


def test_without_other_aircraft_there_is_nothing_of_them(tmp_path: Path) -> None:
    loaded = loaded_from(tmp_path)
    flights = Flights(loaded, [record_of(loaded.scenario.vehicles[0], straight, SECONDS)])
    figure = Figure()
    draw_plan(figure, flights)
    assert flights.traffic == ()
    assert "Other aircraft" not in str([its.texts for its in figure.legends])
