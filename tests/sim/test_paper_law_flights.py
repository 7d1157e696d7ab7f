"""Law paper flown by the kinematic plant: errors decay, goals are reached, obstacles passed."""

import math

import numpy as np
import pytest
from continuous_law import GOAL as ITS_GOAL
from continuous_law import K_V, K_W, move, rows
from obstacle_samples import NOTHING
from scipy.spatial.transform import Rotation
from swarm_samples import (
    GAINS,
    GOAL,
    angle_between,
    goals_of,
    random_attitudes,
    random_swarm,
    swarm_of,
)

from vfguide.field.attitude import attitude
from vfguide.field.goal_frame import goal_frame
from vfguide.field.obstacle import Obstacle, obstacle_rows
from vfguide.field.obstacle_arrays import levels
from vfguide.field.robots import Spacing
from vfguide.field.swarm import goal_rows
from vfguide.field.swarm_control import PaperGains, Swarm, fly_paper_law
from vfguide.geometry.shapes import shape
from vfguide.geometry.vector import mat3
from vfguide.sim import kinematic
from vfguide.sim.kinematic import Bodies, Commands, advance

ARRIVED = 0.05


def fly(goals, swarm, seconds, gains=GAINS, obstacles=NOTHING, spacing=None):
    """States (n + 1) of a swarm that stands where it has arrived."""
    bodies = Bodies(swarm.p_n, swarm.R_nb)
    path, arrived = [bodies], np.zeros(len(goals), bool)
    for k in range(round(seconds / gains.dt)):
        arrived |= np.linalg.norm(bodies.p_n - goals[:, :3], axis=1) <= ARRIVED
        here = Swarm(*bodies, ~arrived)
        commands = fly_paper_law(goals, here, k * gains.dt, obstacles, spacing, gains)
        bodies = advance(bodies, Commands(*commands), gains.dt)
        path.append(bodies)
    return path


@pytest.mark.parametrize("dt", [0.02, 0.2])
def test_the_attitude_error_decays_as_lemma_4_says(dt):
    """Where the speed is nil the reference stands, and a step is exact however long."""
    rng = np.random.default_rng(2)
    swarm = random_swarm(rng, 30)
    goals = np.repeat(goals_of(GOAL), 30, axis=0)
    path = fly(goals, swarm, 2.0, PaperGains(1e-12, 3.5, dt))
    for i in range(30):
        R_a, _ = attitude(GOAL, tuple(swarm.p_n[i].tolist()), (0.0, 0.0, 0.0))
        at_first, at_last = (angle_between(R_a, path[k].R_nb[i]) for k in (0, -1))
        assert at_last == pytest.approx(at_first * math.exp(-3.5 * 2.0), rel=1e-5)


def test_the_attitude_error_decays_on_the_way_too():
    rng = np.random.default_rng(3)
    p_n = np.array(GOAL.p_n) + 100.0 * np.array(GOAL.R_ng) @ (-0.8, 0.5, 0.3)
    swarm = swarm_of([p_n], random_attitudes(rng, 1))
    for dt, tolerance in ((0.01, 0.02), (0.001, 0.002)):
        path = fly(goals_of(GOAL), swarm, 1.0, PaperGains(0.2, 3.5, dt))
        errors = [
            angle_between(attitude(GOAL, tuple(b.p_n[0].tolist()), (0.0,) * 3)[0], b.R_nb[0])
            for b in (path[0], path[-1])
        ]
        assert errors[1] == pytest.approx(errors[0] * math.exp(-3.5), rel=tolerance)


def test_on_the_field_the_rates_are_those_of_the_field():
    """With no error left a robot turns with R_a: the next step finds it there again."""
    p_n = np.array(GOAL.p_n) + np.array(GOAL.R_ng) @ (-80.0, 30.0, -20.0)
    R_a, _ = attitude(GOAL, tuple(p_n.tolist()), (0.0, 0.0, 0.0))
    gains = PaperGains(0.3, 3.5, 0.001)
    path = fly(goals_of(GOAL), swarm_of([p_n], [R_a]), 2.0, gains)
    last = path[-1]
    now, _ = attitude(GOAL, tuple(last.p_n[0].tolist()), (0.0, 0.0, 0.0))
    assert angle_between(R_a, now) > 0.3
    assert angle_between(last.R_nb[0], now) < 1e-3


def test_a_robot_keeps_out_of_an_obstacle_in_its_way():
    goal = goal_frame((0.0, 0.0, 0.0), 0.0, 0.0)
    start = swarm_of([(-100.0, 2.0, 1.0)])
    ball = obstacle_rows([Obstacle(shape.sphere(12.0), (-50.0, 0.0, 0.0))])
    often = GAINS._replace(dt=0.005)  # almost head-on it has to turn sharply
    through = np.array([b.p_n[0] for b in fly(goals_of(goal), start, 25.0, often)])
    around = np.array([b.p_n[0] for b in fly(goals_of(goal), start, 25.0, often, ball)])
    assert levels(through, 0.0, ball).min() < 0.1
    assert levels(around, 0.0, ball).min() > 1.0
    assert np.linalg.norm(around[-1]) <= ARRIVED


def test_a_robot_gives_way_to_one_that_stands_at_its_goal():
    standing = goal_frame((0.0, 0.0, 0.0), 1.0, 0.0)
    beyond = goal_frame((60.0, 0.0, 0.0), 0.0, 0.0)
    goals = goals_of(standing, beyond)
    swarm = swarm_of([(0.0, 0.0, 0.0), (-60.0, 0.0, 1.0)])
    free = np.array([b.p_n for b in fly(goals, swarm, 25.0)])
    kept = np.array([b.p_n for b in fly(goals, swarm, 25.0, spacing=Spacing(5.0, 40.0))])
    assert np.linalg.norm(free[:, 1], axis=1).min() < 2.0
    assert np.linalg.norm(kept[:, 1], axis=1).min() > 10.0
    assert not kept[:, 0].any()
    assert np.linalg.norm(kept[-1] - goals[:, :3], axis=1).max() <= ARRIVED


def test_200_random_starts_arrive_in_the_pose_of_the_goal():
    """Theorem 2: from all starts but those straight ahead of the goal."""
    rng = np.random.default_rng(6)
    swarm = random_swarm(rng, 200, reach=100.0)
    goals = np.repeat(goals_of(GOAL), 200, axis=0)
    last = fly(goals, swarm, 60.0, PaperGains(0.4, 3.5, 0.02))[-1]
    assert np.linalg.norm(last.p_n - GOAL.p_n, axis=1).max() <= ARRIVED
    ahead = last.R_nb[:, :, 0] @ np.array(mat3(np.array(GOAL.R_ng)))[:, 0]
    assert np.degrees(np.arccos(np.clip(ahead, -1.0, 1.0))).max() < 1.0


@pytest.mark.parametrize("seed", range(5))
def test_the_law_in_steps_flies_the_path_of_the_continuous_law(seed):
    rng = np.random.default_rng([44, seed])
    p_n = tuple(map(float, rng.uniform(-100.0, 100.0, 3)))
    R_nb = rows(Rotation.random(rng=rng).as_matrix())
    gains = PaperGains(K_V, K_W, 0.002)
    bodies = kinematic.Bodies(np.array([p_n]), np.array([R_nb]))
    for _ in range(2000):
        swarm = Swarm(bodies.p_n, bodies.R_nb, np.array([True]))
        speed, omega_b = fly_paper_law(goal_rows([ITS_GOAL]), swarm, 0.0, NOTHING, None, gains)
        bodies = kinematic.advance(bodies, kinematic.Commands(speed, omega_b), gains.dt)
    R_nb, p_n = move(ITS_GOAL, R_nb, p_n, 4.0)
    np.testing.assert_allclose(bodies.p_n[0], p_n, atol=0.05)
    np.testing.assert_allclose(bodies.R_nb[0], R_nb, atol=1e-3)
