"""The circle after the last goal: its side and its radius, as asked for."""

import numpy as np
import pytest

from vfguide.preflight.load import load_scenario
from vfguide.runs.lockstep import fly_scenario
from vfguide.scenario.plans import plan_of

CALM = ("wind.speed_mps=0", 'wind.turbulence="none"')


def plan(*changes):
    loaded = load_scenario("first-flight", changes)
    return plan_of(loaded, loaded.scenario.vehicles[0])


def test_without_a_radius_it_is_the_aircraft_s_own():
    assert plan().loiter_radius == pytest.approx(1.57 * 25.0**2 / 9.80665)
    assert plan("guidance.loiter_radius_m=250").loiter_radius == 250.0


@pytest.mark.parametrize(("side", "sign"), [("right", 1.0), ("left", -1.0)])
@pytest.mark.parametrize(("radius", "flown"), [(180.0, 180.0), (10.0, 62.5)])
def test_it_is_flown_at_that_radius_if_the_bank_allows(side, sign, radius, flown, tmp_path):
    """In the last of the 5 s that a run goes on after the goal."""
    changes = (*CALM, f"guidance.loiter_radius_m={radius}", f'guidance.loiter="{side}"')
    loaded = load_scenario("first-flight", changes)
    record = fly_scenario(loaded, tmp_path).records[0]
    late = record.time > record.time[-1] - 2.0
    rates = np.gradient(np.unwrap(np.arctan2(*record.v_n[late, 1::-1].T)), record.time[late])
    turned = float(np.median(np.hypot(*record.v_n[late, :2].T) / rates))
    assert turned == pytest.approx(sign * flown, rel=0.1)
