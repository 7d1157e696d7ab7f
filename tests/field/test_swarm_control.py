"""Law paper: eq. (2)'s inputs for a swarm, their gains when held, priorities, and convergence."""

import math

import numpy as np
import pytest
from obstacle_samples import NOTHING
from swarm_samples import GAINS, GOAL, goals_of, random_swarm

from vfguide.field.robots import Spacing
from vfguide.field.swarm_control import PaperGains, Swarm, fly_paper_law, held_gain


@pytest.mark.parametrize("rate", [5.0, 50.0, 200.0])
@pytest.mark.parametrize("k", [0.2, 3.5, 20.0])
def test_a_held_gain_does_in_a_step_what_the_continuous_one_does(k, rate):
    error = 1.0
    for _ in range(round(2.0 * rate)):
        error -= held_gain(k, 1.0 / rate) * error / rate
    assert error == pytest.approx(math.exp(-2.0 * k), rel=1e-9)


def test_the_speed_is_k_v_times_the_distance():
    swarm = random_swarm(np.random.default_rng(1), 50)
    goals = np.repeat(goals_of(GOAL), 50, axis=0)
    tiny = PaperGains(0.5, 3.5, 1e-9)
    speed, _ = fly_paper_law(goals, swarm, 0.0, NOTHING, None, tiny)
    distance = np.linalg.norm(swarm.p_n - GOAL.p_n, axis=1)
    assert speed == pytest.approx(0.5 * distance, rel=1e-6)
    held, _ = fly_paper_law(goals, swarm, 0.0, NOTHING, None, GAINS)
    assert held == pytest.approx(distance * -math.expm1(-0.5 * 0.02) / 0.02, rel=1e-12)


def test_robots_that_stand_stand():
    rng = np.random.default_rng(4)
    swarm = random_swarm(rng, 20)._replace(moving=np.arange(20) % 2 == 0)
    goals = np.repeat(goals_of(GOAL), 20, axis=0)
    speed, omega_b = fly_paper_law(goals, swarm, 0.0, NOTHING, Spacing(5.0, 60.0), GAINS)
    assert not speed[1::2].any()
    assert not omega_b[1::2].any()
    assert (speed[::2] > 0.0).all()
    assert omega_b[::2].any(axis=1).all()


def test_what_a_robot_does_does_not_depend_on_those_of_larger_ids():
    rng = np.random.default_rng(5)
    swarm = random_swarm(rng, 40, reach=60.0)
    goals = np.repeat(goals_of(GOAL), 40, axis=0)
    spacing = Spacing(4.0, 50.0)
    whole = fly_paper_law(goals, swarm, 0.0, NOTHING, spacing, GAINS)
    for count in (1, 2, 17, 39):
        first = Swarm(*(a[:count].copy() for a in swarm))
        part = fly_paper_law(goals[:count], first, 0.0, NOTHING, spacing, GAINS)
        np.testing.assert_array_equal(whole[0][:count], part[0])
        np.testing.assert_array_equal(whole[1][:count], part[1])
    alone = fly_paper_law(goals, swarm, 0.0, NOTHING, None, GAINS)
    np.testing.assert_array_equal(whole[1][0], alone[1][0])
    assert (whole[1] != alone[1]).any(axis=1).sum() > 20
