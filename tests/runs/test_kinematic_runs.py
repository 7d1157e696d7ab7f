"""Runs of the kinematic plant: verdicts, figures, the truth in the log, and who refuses them."""

import json
import math

import numpy as np
import pytest
from commands import vfguide
from flights import interrupted, messages
from scipy.spatial.transform import Rotation

from vfguide.earth.geodesy import place_in_plane
from vfguide.field.obstacle_arrays import distances, levels
from vfguide.files.data import shipped_scenarios
from vfguide.geometry.units import CM_S, DEG_E7, MM, US
from vfguide.link.messages import HilStateQuaternion
from vfguide.link.tlog import TlogReader
from vfguide.preflight.load import load_scenario
from vfguide.results.judge import judge
from vfguide.results.path import positions
from vfguide.runs.lockstep import Ending, fly_scenario
from vfguide.runs.truth_log import TRUTH_COMPONENT
from vfguide.runs.vehicle_setup import start_us
from vfguide.scenario.obstacles import rows_of
from vfguide.scenario.resolve import place_of

pytestmark = pytest.mark.slow

WORLD = """
name = "world"
plant = "kinematic"
law = "paper"
duration_s = 60.0

[guidance]
rate_hz = 40.0
k_v = 0.5

[avoidance]
safety_radius_m = 4.0
detection_range_m = 50.0

[[vehicle]]
id = 9
position_m = [-90.0, 4.0, 20.0]
attitude_deg = [20.0, -30.0, 40.0]
[[vehicle.goal]]
position_m = [0.0, 0.0, 0.0]
heading_deg = 0.0
[[vehicle.goal]]
position_m = [40.0, 30.0, -10.0]
heading_deg = 80.0
climb_deg = 10.0

[[vehicle]]
id = 2
position_m = [-30.0, -60.0, 5.0]
heading_deg = 90.0
[[vehicle.goal]]
position_m = [0.0, 60.0, 0.0]
heading_deg = 100.0

[[obstacle]]
name = "rock"
shape = "cylinder"
position_m = [-40.0, 3.0, 0.0]
radius_m = 6.0
height_m = 60.0
reactive_level = 1000.0

[[obstacle]]
shape = "sphere"
position_m = [0.0, -20.0, 30.0]
velocity_mps = [0.0, 2.0, -1.0]
radius_m = 5.0
"""
FLIGHT = """
name = "body"
plant = "kinematic"
[[vehicle]]
id = 3
position_m = [-400.0, 120.0, 10.0]
attitude_deg = [180.0, 0.0, 90.0]
[[vehicle.goal]]
position_m = [0.0, 0.0, 0.0]
heading_deg = 20.0
climb_deg = 4.0
"""
ONE = """
name = "one"
plant = "kinematic"
law = "paper"
duration_s = 20.0
[[vehicle]]
id = 1
position_m = [-60.0, 0.5, 0.0]
[[vehicle.goal]]
position_m = [0.0, 0.0, 0.0]
heading_deg = 0.0
"""
BALL = """
[[obstacle]]
name = "ball"
shape = "sphere"
position_m = [-30.0, 0.0, 0.0]
radius_m = 5.0
"""
PAPER = [name for name in shipped_scenarios() if name.startswith("paper/")]


def scenario_file(folder, text):
    path = folder / "scenario-file.toml"
    path.write_text(text)
    return path


def fly(folder, text, *changes):
    """The flight, its result as a table, and the folder of the logs."""
    loaded = load_scenario(scenario_file(folder, text), changes)
    flight = fly_scenario(loaded, folder)
    early = ("time",) if flight.ending is Ending.TIME else ()
    result = judge(loaded.scenario, flight.records, flight.sim_s, flight.wall_s, early)
    return flight, json.loads(result.to_json())


@pytest.fixture(scope="module")
def world(tmp_path_factory):
    folder = tmp_path_factory.mktemp("world")
    return folder, *fly(folder, WORLD)


def test_the_world_is_flown_well(world):
    _, flight, result = world
    assert result["reasons"] == []
    assert result["verdict"] == "good"
    assert result["min_separation_m"] > 8.0
    for vehicle in result["vehicles"]:
        for goal in vehicle["goals"]:
            assert goal["reached"]
            assert goal["miss_m"] == pytest.approx(0.05, abs=1e-6)
            assert max(goal["course_error_deg"], goal["climb_error_deg"]) < 1.0
        assert [its["name"] for its in vehicle["obstacles"]] == ["rock", "1"]
        assert vehicle["airspeed_mps"] == vehicle["load_factor"] == [None, None]
        assert vehicle["setpoint_rate_hz"] == pytest.approx(40.0)
    last = max(vehicle["goals"][-1]["time_s"] for vehicle in result["vehicles"])
    assert flight.sim_s == pytest.approx(last + 5.0, abs=1.0 / 40.0 + 1e-6)
    assert flight.ending is Ending.REACHED


def test_results_are_in_the_order_of_the_scenario(world):
    _, flight, result = world
    assert [vehicle["id"] for vehicle in result["vehicles"]] == [9, 2]
    starts = [record.p_n[0].tolist() for record in flight.records]
    assert starts == [[-90.0, 4.0, 20.0], [-30.0, -60.0, 5.0]]


def test_after_its_last_goal_a_vehicle_stands_still(world):
    _, flight, result = world
    for record, vehicle in zip(flight.records, result["vehicles"], strict=True):
        after = record.time > vehicle["goals"][-1]["time_s"] + 1.0 / 40.0
        assert after.sum() > 100
        assert np.ptp(record.p_n[after], axis=0).max() == 0.0
        assert np.ptp(record.euler[after], axis=0).max() == pytest.approx(0.0, abs=1e-12)


def test_figures_of_obstacles_are_those_of_the_true_path(world):
    folder, flight, result = world
    rows = rows_of(load_scenario(folder / "scenario-file.toml").scenario.obstacles)
    for record, vehicle in zip(flight.records, result["vehicles"], strict=True):
        fine = np.linspace(0.0, record.time[-1], 200_001)
        p_n = positions(record, fine)
        figures = vehicle["obstacles"]
        assert [its["min_level"] for its in figures] == pytest.approx(
            levels(p_n, fine, rows).min(axis=0), rel=0.01
        )
        assert [its["min_clearance_m"] for its in figures] == pytest.approx(
            distances(p_n, fine, rows).min(axis=0), abs=0.01
        )
        assert min(its["min_level"] for its in figures) > 1.0


def test_the_log_holds_the_truth_of_every_update_and_nothing_else(world):
    folder, flight, _ = world
    assert {path.name for path in folder.iterdir()} == {"scenario-file.toml", "flight.tlog"}
    scenario = load_scenario(folder / "scenario-file.toml").scenario
    plane, start = place_of(scenario.origin), start_us(scenario)
    logged = messages(folder / "flight.tlog")
    assert len(logged) == sum(len(record.time) for record in flight.records)
    for vehicle, record in zip(scenario.vehicles, flight.records, strict=True):
        own = [entry for entry in logged if entry[1].sysid == vehicle.id]
        assert [frame.seq for _, frame, _ in own] == [k % 256 for k in range(len(record.time))]
        for k, (time_us, frame, truth) in enumerate(own):
            assert isinstance(truth, HilStateQuaternion)
            assert frame.compid == TRUTH_COMPONENT
            assert time_us == truth.time_usec == start + round(record.time[k] / US)
            v_l = (truth.vx * CM_S, truth.vy * CM_S, truth.vz * CM_S)
            where = (truth.lat * DEG_E7, truth.lon * DEG_E7, truth.alt * MM)
            p_n, v_n = place_in_plane(plane, *where, v_l)
            assert p_n == pytest.approx(record.p_n[k], abs=0.012)
            assert v_n == pytest.approx(record.v_n[k], abs=0.006)
            w, x, y, z = truth.attitude_quaternion
            R_lb = Rotation.from_quat((x, y, z, w)).as_matrix()
            assert R_lb == pytest.approx(record.R_nb[k], abs=1e-4)  # 100 m turn "north" by 1e-5
            rates = (truth.rollspeed, truth.pitchspeed, truth.yawspeed)
            assert rates == pytest.approx(record.omega_b[k], rel=1e-6)


def test_same_bytes_in_another_process_and_from_the_resolved_scenario(world, tmp_path):
    folder, _, result = world
    path = folder / "scenario-file.toml"
    done = vfguide("run", path, "--out", "out", "--no-report", cwd=tmp_path)
    assert done.returncode == 0, done.stderr + done.stdout
    out = tmp_path / "out"
    assert {its.name for its in out.iterdir()} == {"flight.tlog", "result.json", "scenario.toml"}
    expected = (folder / "flight.tlog").read_bytes()
    assert (out / "flight.tlog").read_bytes() == expected
    (tmp_path / "again").mkdir()
    fly_scenario(load_scenario(out / "scenario.toml"), tmp_path / "again")
    assert (tmp_path / "again" / "flight.tlog").read_bytes() == expected
    written = json.loads((out / "result.json").read_text())
    assert written["vehicles"] == result["vehicles"]


def test_the_smaller_id_has_priority_wherever_it_stands_in_the_file(world, tmp_path):
    _, flight, _ = world
    text = WORLD[: WORLD.index("[[vehicle]]\nid = 9")] + WORLD[WORLD.index("[[vehicle]]\nid = 2") :]
    alone, _ = fly(tmp_path, text)
    n = len(alone.records[0].time)
    np.testing.assert_array_equal(flight.records[1].p_n[:n], alone.records[0].p_n)


@pytest.mark.parametrize("name", PAPER)
def test_the_examples_of_the_paper(name, tmp_path):
    loaded = load_scenario(name)
    flight = fly_scenario(loaded, tmp_path)
    result = judge(loaded.scenario, flight.records, flight.sim_s, flight.wall_s)
    assert (result.verdict, result.reasons) == ("good", ())
    assert flight.ending is Ending.REACHED
    for vehicle in result.vehicles:
        for goal in vehicle.goals:
            assert goal.miss_m <= 0.1
            assert max(goal.course_error_deg, goal.climb_error_deg) <= 1.0
        assert all(its.min_level > 1.0 and its.min_clearance_m > 0.0 for its in vehicle.obstacles)
    if loaded.scenario.avoidance.between_vehicles:
        assert result.min_separation_m > 2.0 * loaded.scenario.avoidance.safety_radius_m


def test_all_three_examples_are_shipped():
    assert PAPER == ["paper/example-1", "paper/example-2", "paper/example-3"]


def test_a_goal_passed_askew_leaves_the_vehicle_standing_until_the_end(tmp_path):
    slow_to_turn = ("guidance.k_w=0.05", "guidance.k_v=2.0", "vehicle.0.heading_deg=40")
    flight, result = fly(tmp_path, ONE.replace("0.5, 0.0", "30.0, 0.0"), *slow_to_turn)
    (goal,) = result["vehicles"][0]["goals"]
    assert goal["miss_m"] == pytest.approx(0.05, abs=1e-6)
    assert max(goal["course_error_deg"], goal["climb_error_deg"]) > 10.0
    assert result["reasons"] == ["time", "goal 1 of vehicle 1 not reached"]
    assert result["sim_s"] == 20.0
    after = flight.records[0].time > goal["time_s"] + 0.1
    assert after.sum() > 100
    assert np.ptp(flight.records[0].p_n[after], axis=0).max() == 0.0


def test_who_starts_at_the_goal_does_not_stir(tmp_path):
    flight, result = fly(
        tmp_path, ONE, "vehicle.0.position_m=[0, 0, 0.02]", "vehicle.0.heading_deg=5"
    )
    assert result["verdict"] == "good"
    assert result["sim_s"] == pytest.approx(5.0, abs=0.021)
    assert result["vehicles"][0]["goals"][0]["time_s"] == 0.0
    assert np.ptp(flight.records[0].euler, axis=0).max() == pytest.approx(0.0, abs=1e-12)
    assert not flight.records[0].v_n.any()


def test_a_start_straight_ahead_of_the_goal_leads_away_and_ends_the_flight(tmp_path):
    flight, result = fly(tmp_path, ONE, "vehicle.0.position_m=[50, 0, 0]", "guidance.k_v=2")
    assert flight.ending is Ending.FAR_AWAY
    assert result["verdict"] == "bad"
    missed, away = result["reasons"]
    assert missed == "goal 1 of vehicle 1 not reached"
    assert away == f"away: vehicle 1 after {result['sim_s']:.1f} s"
    *_, (_, _, truth) = messages(tmp_path / "flight.tlog")
    assert truth.alt == 2**31 - 1  # as high as the message can tell
    assert abs(truth.vx) == 2**15 - 1


def test_something_that_runs_over_a_vehicle_is_a_penetration(tmp_path):
    over = BALL + "velocity_mps = [8.0, 0.0, 0.0]\n"
    _, result = fly(tmp_path, ONE + over, "duration_s=30", "vehicle.0.position_m=[-4, 0.5, 0]")
    assert result["verdict"] == "bad"
    (its,) = result["vehicles"][0]["obstacles"]
    assert its["min_level"] < 1.0
    reason = f"penetration: vehicle 1 in ball, {its['min_clearance_m']:.2f} m"
    assert reason in result["reasons"]
    assert -5.0 < its["min_clearance_m"] < 0.0


SLOWLY = ("guidance.k_v=0.2", "guidance.k_w=10", "duration_s=60")
PAST_IT = "vehicle.0.position_m=[-60, 3, 0]"


def test_an_obstacle_acts_from_where_it_is_seen_on(tmp_path):
    paths = []
    for number, seen_from in enumerate((300.0, 2.0)):
        folder = tmp_path / str(number)
        folder.mkdir()
        changes = (f"obstacle.0.visible_from_m={seen_from}", *SLOWLY, PAST_IT)
        flight, result = fly(folder, ONE + BALL, *changes)
        assert result["verdict"] == "good"
        paths.append(flight.records[0])
    folder = tmp_path / "free"
    folder.mkdir()
    free = fly(folder, ONE, *SLOWLY, PAST_IT)[0].records[0]
    rows = rows_of(load_scenario(tmp_path / "0" / "scenario-file.toml").scenario.obstacles)
    for record, edge in zip(paths, (5.0, 2.0), strict=True):  # U < 4 within 5 m of the surface
        n = min(len(record.p_n), len(free.p_n))
        same = (record.p_n[:n] == free.p_n[:n]).all(axis=1)
        parted = int(np.flatnonzero(~same)[0])
        before = distances(record.p_n[:parted], record.time[:parted], rows)[:, 0]
        assert before[:-2].min() > edge - 1e-9
        assert before[-1] < edge + 1.5


STANDING = """
[[vehicle]]
id = 2
position_m = [-30.0, 0.0, 0.0]
[[vehicle.goal]]
position_m = [-30.0, 0.0, 0.0]
heading_deg = 0.0
"""


def test_robot_1_gives_way_to_nobody_and_too_close_is_bad(tmp_path):
    _, result = fly(tmp_path, ONE + STANDING)
    assert result["verdict"] == "bad"
    closest = result["min_separation_m"]
    assert closest < 1.0
    assert result["reasons"] == [f"separation: {closest:.1f} m, not more than 20 m"]
    free = fly(tmp_path, ONE + STANDING, "avoidance.between_vehicles=false")[1]
    assert (free["verdict"], free["min_separation_m"]) == ("good", closest)
    changes = (
        *("avoidance.safety_radius_m=4", "avoidance.detection_range_m=25"),
        *("vehicle.0.id=3", "vehicle.0.position_m=[-90, 2, 0]"),
    )
    polite = fly(tmp_path, ONE + STANDING, *changes, *SLOWLY)[1]
    assert polite["reasons"] == []
    assert polite["min_separation_m"] > 8.0


def test_law_flight_meets_the_pose_and_loiters(tmp_path):
    flight, result = fly(tmp_path, FLIGHT)
    assert result["verdict"] == "good"
    (goal,) = result["vehicles"][0]["goals"]
    assert goal["miss_m"] < 0.5
    assert goal["told_miss_m"] == pytest.approx(goal["miss_m"], abs=0.05)
    assert max(goal["course_error_deg"], goal["climb_error_deg"]) < 1.0
    (record,) = flight.records
    assert np.linalg.norm(record.v_n, axis=1) == pytest.approx(25.0, abs=1e-9)
    assert (record.p_n[record.time < 2.0, 2] > 5.0).all()  # below the origin there is no ground
    assert len(messages(tmp_path / "flight.tlog")) == len(record.time)


@pytest.mark.parametrize("change", ["guidance.airspeed_mps=20", "vehicle.0.airspeed_mps=20"])
def test_law_flight_flies_the_speed_that_is_asked_for(change, tmp_path):
    (record,) = fly(tmp_path, FLIGHT, change)[0].records
    assert np.linalg.norm(record.v_n, axis=1) == pytest.approx(20.0, abs=1e-9)


@pytest.mark.parametrize(
    "command",
    [
        ("sim", "scenario-file.toml"),
        ("fly", "scenario-file.toml", "--vehicle", "9", "--connect", "udpin:127.0.0.1:1"),
        ("replay", "flight.tlog", "--scenario", "scenario-file.toml"),
    ],
)
def test_what_needs_mavlink_refuses_the_kinematic_plant(world, command):
    folder, _, _ = world
    before = {path.name for path in folder.iterdir()}
    done = vfguide(*command, cwd=folder)
    assert done.returncode == 2
    assert done.stderr == (
        'vfguide: scenario-file.toml: plant = "kinematic": it has no autopilot and no MAVLink, '
        'only vfguide run flies it; allowed "jsbsim"\n'
    )
    assert {path.name for path in folder.iterdir()} == before


def test_check_and_set_on_the_command_line(world):
    folder, _, _ = world
    done = vfguide("check", "scenario-file.toml", cwd=folder)
    assert (done.returncode, done.stdout) == (0, "scenario-file.toml: fine\n")
    done = vfguide(
        *("run", "scenario-file.toml", "--set", "obstacle.0.radius_m=-1", "--out", "no"),
        cwd=folder,
    )
    assert done.returncode == 2
    assert done.stderr == (
        "vfguide: scenario-file.toml, --set obstacle.0.radius_m=-1: obstacle[0].radius_m = -1: "
        "too small, allowed above 0, up to 10000\n"
    )
    assert not (folder / "no").exists()


def test_ctrl_c_in_real_time_keeps_what_was_flown(tmp_path):
    result = interrupted(scenario_file(tmp_path, WORLD), "flight.tlog")
    assert 0.0 < result["sim_s"] < 30.0
    reader = TlogReader.open(tmp_path / "out" / "flight.tlog")
    assert sum(1 for _ in reader) == 2 * (round(result["sim_s"] * 40.0) + 1)
    assert reader.junk_bytes == 0


def test_in_real_time_it_is_no_faster_than_the_clock(tmp_path):
    loaded = load_scenario(scenario_file(tmp_path, ONE), ("duration_s=1.5",))
    flight = fly_scenario(loaded, tmp_path, realtime=True)
    assert 1.5 - 1e-3 <= flight.wall_s < 3.0
    assert math.isclose(flight.sim_s, 1.5)
