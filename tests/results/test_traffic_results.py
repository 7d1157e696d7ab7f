"""How near other aircraft came."""

import numpy as np
import pytest
from flight_samples import record_of, straight
from scenario_samples import loaded_from
from scenario_texts import MINIMAL

from vfguide.results.traffic_results import finely, traffic_results

TRAFFIC = """
[[traffic]]
name = "AHEAD"
position_m = [0, 30, -140]
velocity_mps = [0, 0, 0]
[[traffic]]
name = "ACROSS"
position_m = [-400, -400, -100]
velocity_mps = [0, 25, 0]
"""


def test_the_closest_approach_is_of_the_centres(tmp_path):
    """North at 25 m/s, through (0, 0, -100) after 20 s; the other crosses 100 m before it."""
    scenario = loaded_from(tmp_path, MINIMAL + TRAFFIC).scenario
    ahead, across = traffic_results(scenario, record_of(scenario.vehicles[0], straight, 25.0))
    assert (ahead.closest_m, ahead.closest_s) == pytest.approx((50.0, 20.0), abs=1e-3)
    assert across.closest_m == pytest.approx(300.0 / np.sqrt(2.0), abs=1e-3)
    assert across.closest_s == pytest.approx(10.0, abs=0.02)


def test_nothing_fast_is_overlooked():
    time, p_n = finely(np.arange(3) * 0.2, np.arange(9.0).reshape(3, 3))
    assert np.diff(time) == pytest.approx(np.full(20, 0.02))
    assert p_n[10] == pytest.approx([3.0, 4.0, 5.0])
