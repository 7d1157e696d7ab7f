"""`vfguide field` with law flight: the direction of the plan, and how it is flown once settled."""

import json
import math
from functools import cache

import numpy as np
import pytest
from commands import vfguide
from point_mass import Body, fly

from vfguide.aircraft.envelope import usable_bank
from vfguide.field_points.field_point import Point
from vfguide.field_points.field_points import fields_at
from vfguide.field_points.flight_points import flight_field
from vfguide.field_points.shortest_plan import best_start, start_on, surroundings_at
from vfguide.files.errors import InputError
from vfguide.geometry.angles import wrap
from vfguide.geometry.units import DEG, G0
from vfguide.loop.state import fresh_state
from vfguide.paths.leg import FIELD
from vfguide.preflight.load import load_scenario
from vfguide.scenario.plans import plan_of, vehicle_of
from vfguide.scenario.wind import blowing

pytestmark = pytest.mark.slow

STILL = (0.0, 0.0, 0.0)


@cache
def plan(scenario="first-flight", *changes):
    loaded = load_scenario(scenario, changes)
    return plan_of(loaded, loaded.scenario.vehicles[0])


def drawn(number, most_wind=8.0):
    """A plan with a goal on any course, a point and a wind."""
    rng = np.random.default_rng(number)
    heading, climb = rng.uniform(0.0, 360.0), rng.uniform(-6.0, 6.0)
    its = plan(
        "first-flight",
        f"vehicle.0.goal.0.heading_deg={heading:.3f}",
        f"vehicle.0.goal.0.climb_deg={climb:.3f}",
    )
    p_n = (*map(float, rng.uniform(-700.0, 700.0, 2)), float(rng.uniform(-170.0, -90.0)))
    course = rng.uniform(0.0, 2.0 * math.pi)
    v_n = (25.0 * math.cos(course), 25.0 * math.sin(course), 0.0)
    return its, Point(p_n, v_n, 0.0), blowing(rng.uniform(0.0, most_wind), rng.uniform(0.0, 360.0))


def towers(number):
    rng = np.random.default_rng(number)
    p_n = (*map(float, rng.uniform((-500.0, -300.0), (650.0, 400.0))), -120.0)
    return plan("towers"), Point(p_n, (25.0, 0.0, 0.0), 0.0), STILL


FREE, AMONG_TOWERS = 60, 15
"""Numbers of cases that are drawn without hazards and among towers."""
CASES = range(FREE + AMONG_TOWERS)


@cache
def case(number):
    return drawn(number) if number < FREE else towers(number - FREE)


def air_velocity(its, at):
    return np.array(at.F) * its.gains.airspeed


@pytest.mark.parametrize("number", CASES)
def test_the_direction_is_that_in_which_the_plan_begins(number):
    its, point, wind_n = case(number)
    at = flight_field(its, point, wind_n)
    over_ground = air_velocity(its, at) + wind_n
    course = math.atan2(over_ground[1], over_ground[0])
    around = surroundings_at(its, point, wind_n)
    begun = start_on(around, course)
    assert math.hypot(*at.F) == pytest.approx(1.0)
    assert math.isfinite(begun.length) or begun.route.leg.phase != FIELD
    if begun.turn == 0.0:
        assert abs(wrap(begun.onward - course)) < 1e-4
    every = [start_on(around, k * 10.0 * DEG).length for k in range(36)]
    assert begun.length <= min(every) + 0.12 * begun.route.leg.radius


@pytest.mark.parametrize("number", CASES)
def test_the_attitude_is_that_of_a_coordinated_turn_at_the_rate_of_the_plan(number):
    its, point, wind_n = case(number)
    at = flight_field(its, point, wind_n)
    R, omega = np.array(at.R_a), np.array(at.Omega_a)
    assert pytest.approx(np.eye(3), abs=1e-9) == R @ R.T
    vertical = R @ omega
    assert vertical[:2] == pytest.approx((0.0, 0.0), abs=1e-12)
    bank_max = usable_bank(its.aircraft, its.vehicle.gains, its.gains.airspeed)
    assert abs(vertical[2]) <= G0 * math.tan(bank_max) / its.gains.airspeed + 1e-12
    air_b = R.T @ np.array(at.F)
    assert air_b[1] == pytest.approx(0.0, abs=1e-12)  # no sideslip
    bank = math.asin(R[2, 1] / math.cos(math.asin(-at.F[2])))
    assert vertical[2] == pytest.approx(G0 * math.tan(bank) / its.gains.airspeed, abs=1e-9)


@pytest.mark.parametrize("number", range(0, 60, 2))
def test_a_flight_that_starts_there_goes_on_as_it_says(number):
    its, point, wind_n = case(number)
    at = flight_field(its, point, wind_n)
    body = Body(0.0, point.p_n, tuple(air_velocity(its, at)), at.R_a, at.Omega_a)
    rate = (np.array(at.R_a) @ at.Omega_a)[2]
    north, east, down = air_velocity(its, at) + wind_n
    loop = fresh_state()
    settled = loop.guidance._replace(slope=-down / math.hypot(north, east))
    for moment in fly(body, its, wind_n, 0.7, loop=loop._replace(guidance=settled)):
        north, east, down = np.array(moment.state.v_n) - wind_n
        turned = math.atan2(east, north) - math.atan2(at.F[1], at.F[0])
        assert abs(wrap(turned - rate * moment.state.time)) < 4.0 * DEG
        assert math.asin(-down / its.gains.airspeed) == pytest.approx(
            math.asin(-at.F[2]), abs=2.0 * DEG
        )


@pytest.mark.parametrize("number", range(0, 60, 3))
def test_it_depends_on_the_place_and_not_on_the_velocity(number):
    its, point, wind_n = case(number)
    lengths = []
    for heading in range(0, 360, 45):
        course = math.radians(heading) + 0.1
        around = surroundings_at(its, point, wind_n)
        lengths.append(best_start(around, course).length)
    assert max(lengths) - min(lengths) < 0.2 * 62.5


def test_goals_all_round_are_led_to_from_all_sides():
    """It was the velocity, turned by 7.6 degrees, whatever the goal."""
    point, seen = Point((-500.0, -400.0, -120.0), (25.0, 0.0, 0.0), 0.0), set()
    for heading in range(0, 360, 30):
        at = flight_field(
            plan("first-flight", f"vehicle.0.goal.0.heading_deg={heading}"), point, STILL
        )
        seen.add(round(math.degrees(math.atan2(at.F[1], at.F[0]))))
        toward = np.array((500.0, 400.0)) / math.hypot(500.0, 400.0)
        assert np.array(at.F[:2]) @ toward > math.cos(math.radians(40.0))
    assert len(seen) >= 6


@pytest.mark.parametrize("beside", [-1e-3, -1e-9, 0.0, 1e-9, 1e-3])
def test_it_is_finite_on_switching_lines(beside):
    """Behind the goal left and right are equally long; Omega_a was -382 rad/s there."""
    its = plan()
    for x, y in ((beside, 300.0), (beside, -300.0), (200.0, beside), (beside, 62.5), (beside, 0.0)):
        at = flight_field(its, Point((x, y, -130.0), (0.0, 25.0, 0.0), 0.0), STILL)
        bank_max = usable_bank(its.aircraft, its.vehicle.gains, its.gains.airspeed)
        assert math.hypot(*at.Omega_a) <= G0 * math.tan(bank_max) / its.gains.airspeed + 1e-12


def test_a_gale_is_refused_with_one_reason(tmp_path):
    (tmp_path / "points.csv").write_text("x,y,z,vx,vy,vz,t\n0,0,-100,20,0,0,0\n")
    done = vfguide("field", "gale", "--vehicle", "1", "--points", "points.csv", cwd=tmp_path)
    assert done.returncode == 2
    assert done.stdout == ""
    assert "point 1: the wind is about as fast as the aircraft" in done.stderr
    assert "Traceback" not in done.stderr


def test_a_point_inside_an_obstacle_is_refused_with_one_reason():
    loaded = load_scenario("towers", ())
    vehicle = vehicle_of(loaded.scenario, 1)
    tower = next(each for each in loaded.scenario.obstacles)
    inside = (*tower.position_m, 25.0, 0.0, 0.0, 0.0)
    with pytest.raises(InputError, match=f"--points: point 1: it is inside {tower.name}"):
        fields_at(loaded, vehicle, np.array([inside]), "flight")


def test_the_command_prints_it(tmp_path):
    (tmp_path / "points.csv").write_text("x,y,z,vx,vy,vz,t\n-450,-350,-120,25,0,0,0\n")
    done = vfguide(
        "field", "first-flight", "--vehicle", "1", "--points", "points.csv", cwd=tmp_path
    )
    (printed,) = json.loads(done.stdout)
    loaded = load_scenario("first-flight")
    row = np.array([[-450.0, -350.0, -120.0, 25.0, 0.0, 0.0, 0.0]])
    (at,) = fields_at(loaded, vehicle_of(loaded.scenario, 1), row, "flight")
    assert printed == json.loads(json.dumps(at._asdict()))
