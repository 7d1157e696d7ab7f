"""Law field in a plane: the flown field, with chi and distances of the hazards."""

import math

import numpy as np
import pytest
from scenario_samples import loaded_from
from scenario_texts import MINIMAL

from vfguide.aircraft.state import FlightState
from vfguide.airspace.detection import Airspace
from vfguide.field_points.field_plane import field_plane
from vfguide.geometry.so3 import from_euler
from vfguide.guidance.field_direction import led
from vfguide.guidance.remedies import Remedies
from vfguide.loop.legs import target_of
from vfguide.scenario.plans import plan_of

pytestmark = pytest.mark.slow

TOWER = """
[[obstacle]]
name = "tower"
shape = "cylinder"
position_m = [-200, 5, -100]
radius_m = 40
height_m = 400
"""
WIND = (3.0, -2.0, 0.0)
FLOWN = Remedies(lead=False)
"""Without looking ahead, so that a point is where the field is evaluated."""


def plan_from(folder, text):
    law = ("law=field", "guidance.remedies.lead=false")
    loaded = loaded_from(folder, text, law)
    return plan_of(loaded, loaded.scenario.vehicles[0])


def points(seed=3):
    p_n = np.random.default_rng(seed).uniform((-500, -200, -100), (100, 200, -100), (200, 3))
    return np.ascontiguousarray(p_n)


def test_directions_are_those_that_are_flown(tmp_path):
    plan, p_n = plan_from(tmp_path, MINIMAL + TOWER), points()
    plane = field_plane(plan, 0, p_n, 0.0, WIND)
    airspace = Airspace(plan.hazards, plan.fence, 0.0, 0.0)
    free = plan_from(tmp_path, MINIMAL)
    led_freely = field_plane(free, 0, p_n, 0.0, WIND).F
    for p, F, v_n in zip(p_n.tolist(), plane.F, led_freely.tolist(), strict=True):
        state = FlightState(0.0, tuple(p), tuple(v_n), from_euler(0.0, 0.0, 0.0), 25.0, WIND)
        flown = led(FLOWN, state, target_of(plan.legs, 0), airspace, plan.vehicle).F
        across = F[0] * flown[1] - F[1] * flown[0]
        assert math.atan2(across, np.dot(F[:2], flown[:2])) == pytest.approx(0.0, abs=1e-3)


def test_a_hazard_bends_it_where_it_is_approached_and_near(tmp_path):
    p_n = points()
    plane = field_plane(plan_from(tmp_path, MINIMAL + TOWER), 0, p_n, 0.0, WIND)
    free = field_plane(plan_from(tmp_path, MINIMAL), 0, p_n, 0.0, WIND)
    from_axis = np.hypot(p_n[:, 0] + 200.0, p_n[:, 1] - 5.0)
    outside = from_axis > 40.0
    assert plane.distance[outside] == pytest.approx(from_axis[outside] - 40.0, abs=3.0)
    assert (plane.distance[from_axis < 38.0] < 0.0).all()
    assert np.isinf(free.distance).all()
    assert (free.chi == 1.0).all()
    bent = np.linalg.norm(plane.F - free.F, axis=1) > 1e-9
    assert 10 < bent.sum() < 150
    assert (bent <= (plane.chi < 1.0)).all()
    leaving = np.einsum("ij,ij->i", free.F[:, :2], p_n[:, :2] - (-200.0, 5.0)) > 0.0
    assert (plane.chi[leaving & outside] > 0.99).all()
    touching = outside & ~leaving & (from_axis < 50.0)
    assert touching.any()
    assert (plane.chi[touching] == 0.0).all()
