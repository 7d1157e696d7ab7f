"""`vfguide field`: the field of a scenario at points in a file."""

import json
import math

import numpy as np
import pytest
from commands import vfguide

from vfguide.field_points.field_points import fields_at
from vfguide.preflight.load import load_scenario
from vfguide.scenario.plans import vehicle_of

pytestmark = pytest.mark.slow

WORLD = """
name = "points"
plant = "kinematic"
law = "paper"

[guidance]
k_v = 0.5

[avoidance]
safety_radius_m = 5.0
detection_range_m = 60.0

[[vehicle]]
id = 7
position_m = [-200.0, 0.0, -100.0]
[[vehicle.goal]]
position_m = [30.0, 40.0, -120.0]
heading_deg = 90.0
climb_deg = 20.0

[[vehicle]]
id = 2
position_m = [-100.0, 10.0, -100.0]
attitude_deg = [10.0, 20.0, 30.0]
[[vehicle.goal]]
position_m = [0.0, 10.0, -100.0]
heading_deg = 0.0

[[obstacle]]
shape = "sphere"
position_m = [-60.0, 200.0, -100.0]
velocity_mps = [1.0, -2.0, 0.5]
radius_m = 20.0
"""


@pytest.fixture
def world(tmp_path):
    path = tmp_path / "world.toml"
    path.write_text(WORLD)
    return path


def points_file(folder, rows, header="x,y,z,vx,vy,vz,t"):
    path = folder / "points.csv"
    path.write_text("\n".join([header, *(",".join(map(str, row)) for row in rows)]) + "\n")
    return path


def field_of(world, rows, law="paper", sysid=7):
    loaded = load_scenario(world)
    return fields_at(loaded, vehicle_of(loaded.scenario, sysid), np.array(rows, float), law)


def test_far_from_everything_it_is_the_navigation_field_of_corollary_1(world):
    p = np.array([500.0, -300.0, 50.0])
    (at,) = field_of(world, [[*p, 3.0, 1.0, 2.0, 4.0]])
    heading, climb = math.radians(90.0), math.radians(20.0)
    e_d = np.array(
        [
            math.cos(climb) * math.cos(heading),
            math.cos(climb) * math.sin(heading),
            -math.sin(climb),
        ]
    )
    away = p - (30.0, 40.0, -120.0)
    x, square = away @ e_d, away @ away
    expected = 2.0 * x * away - square * e_d  # F = (x^2 - r^2) e_x + 2 x r e_r
    assert pytest.approx(expected, rel=1e-12) == at.F
    assert at.chi == (1.0,)
    R = np.array(at.R_a)
    assert R[:, 0] == pytest.approx(expected / np.linalg.norm(expected), abs=1e-12)
    assert pytest.approx(np.eye(3), abs=1e-12) == R @ R.T
    assert R[:, 2] == pytest.approx(np.array(at.G) / np.linalg.norm(at.G), abs=1e-12)
    assert R[:, 1] == pytest.approx(np.array(at.H) / np.linalg.norm(at.H), abs=1e-12)


@pytest.mark.parametrize(
    "where", [(-50.0, 170.0, -95.0), (-75.0, 25.0, -112.0)], ids=["obstacle", "vehicle"]
)
def test_omega_a_is_how_r_a_turns_while_all_moves_on(world, where):
    v, t, h = np.array([4.0, -3.0, 2.0]), 1.0, 1e-5
    rows = [[*(np.array(where) + s * h * v), *v, t + s * h] for s in (-1, 0, 1)]
    before, here, after = field_of(world, rows)
    turned = (np.array(after.R_a) - np.array(before.R_a)) / (2.0 * h)
    skew = np.array(here.R_a).T @ turned
    assert here.Omega_a == pytest.approx((skew[2, 1], skew[0, 2], skew[1, 0]), rel=1e-5, abs=1e-6)


def test_obstacles_move_on_with_time(world):
    ahead = [-60.0 + 21.0, 200.0 - 2.0 * 21.0, -100.0]
    on_surface = [-60.0 + 10.0 + 20.0, 200.0 - 20.0, -95.0, 0.0, 0.0, 0.0, 10.0]
    near, far = field_of(world, [on_surface, [*ahead, 0.0, 0.0, 0.0, 100.0]])
    assert near.chi[0] == pytest.approx(0.0, abs=1e-9)
    assert far.chi == (1.0,)


def test_vehicles_of_smaller_ids_fly_straight_on_at_the_speed_of_their_starts(world):
    heading, pitch = math.radians(30.0), math.radians(20.0)
    nose = (
        math.cos(pitch) * math.cos(heading),
        math.cos(pitch) * math.sin(heading),
        -math.sin(pitch),
    )
    there = np.array((-100.0, 10.0, -100.0)) + 2.0 * 0.5 * 100.0 * np.array(nose)
    off = np.array((0.0, 0.0, -10.0))  # two safety radii above it: chi = 0
    (at,) = field_of(world, [[*(there + off), 0.0, 0.0, 0.0, 2.0]])
    assert abs(np.dot(at.F, off)) <= 1e-9 * np.linalg.norm(at.F) * 10.0
    (free,) = field_of(world, [[*(there + off), 0.0, 0.0, 0.0, 4.0]])
    assert abs(np.dot(free.F, off)) > 1e-3 * np.linalg.norm(free.F) * 10.0
    (leader,) = field_of(world, [[*(there + off), 0.0, 0.0, 0.0, 2.0]], sysid=2)
    assert leader.G is not None


def test_the_command_prints_the_same_as_json(world, tmp_path):
    row = [-50.0, 170.0, -95.0, 4.0, -3.0, 2.0, 1.0]
    path = points_file(tmp_path, [row, row])
    done = vfguide("field", world, "--vehicle", "7", "--points", path, cwd=tmp_path)
    assert done.returncode == 0, done.stderr
    printed = json.loads(done.stdout)
    (expected,) = field_of(world, [row])
    assert len(printed) == 2
    for its in printed:
        assert set(its) == {"F", "G", "H", "R_a", "Omega_a", "chi"}
        assert its["F"] == list(expected.F)
        assert its["R_a"] == [list(line) for line in expected.R_a]


@pytest.mark.parametrize(
    ("arguments", "complaint"),
    [
        (("--vehicle", "3", "--points", "none.csv"), "--vehicle 3: no such vehicle"),
        (("--vehicle", "7", "--points", "none.csv"), "--points none.csv: No such file"),
    ],
)
def test_the_command_refuses_bad_input_with_one_line(world, arguments, complaint):
    done = vfguide("field", world, *arguments, cwd=world.parent)
    assert done.returncode == 2
    assert complaint in done.stderr
    assert "Traceback" not in done.stderr
    assert done.stdout == ""
