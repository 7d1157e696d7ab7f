"""States that should never be, in any mixture: no error, nothing beyond the limits."""

import math
from random import Random

import numpy as np
import pytest
from flight_states import (
    VEHICLE,
    fresh_memory,
    guide,
    guide_within_limits,
    is_within_limits,
    state,
    steps,
    turned,
)

from vfguide.aircraft.state import FlightState
from vfguide.geometry.so3 import from_euler, rot_z
from vfguide.geometry.units import DEG
from vfguide.geometry.vector import matvec
from vfguide.planning.objective import GuidanceTarget

pytestmark = pytest.mark.slow

PLACES = [0.0, 1e-300, 1e-12, 1e-3, 1.0, -1.0, 33.4, -33.4, 500.0, -500.0, 1e6, -1e9]
SPEEDS = [0.0, 1e-9, 12.5, -12.5, 25.0, -25.0, 40.0, -40.0]
AIRSPEEDS = [0.0, 1e-9, 5.0, 18.0, 25.0, 60.0, 1e3]
NO_NUMBERS = [math.nan, math.inf, -math.inf]


def strange(rng, places, speeds, airspeeds):
    """A state and a target to match, drawn from odd values."""
    p_n, v_n, wind_n = (
        tuple(rng.choice(each) for _ in range(3)) for each in (places, speeds, speeds)
    )
    if rng.random() < 0.3:
        v_n = rng.choice([wind_n, (0.0, 0.0, 0.0), (0.0, 0.0, -25.0)])
    attitude = from_euler(*(rng.choice([0.0, 0.5 * math.pi, math.pi, -1.0]) for _ in range(3)))
    here = FlightState(1.0, p_n, v_n, attitude, rng.choice(airspeeds), wind_n)
    at = tuple(rng.choice([own, 0.0, -150.0]) for own in p_n)
    circle = rng.choice([0.0, 0.0, 1.0, -1.0])
    course, slope = rng.choice([0.0, 1.0, math.pi, -3.0]), rng.choice([0.0, 0.176, -0.176])
    return here, GuidanceTarget(at, course, slope, circle, 100.0)


def flown(here, target, rng):
    """Setpoints of a few steps, with no time at all, too much and backwards between them."""
    memory, time = fresh_memory(), 1.0
    for _ in range(4):
        setpoint, memory, wish = guide_within_limits(
            here._replace(time=time), target, VEHICLE, memory
        )
        yield setpoint, memory, wish
        time += rng.choice([0.0, 0.02, 50.0, -1.0])


@pytest.mark.parametrize("seed", range(8))
def test_odd_states_give_finite_setpoints_within_the_limits(seed):
    rng = Random(seed)
    for _ in range(400):
        here, target = strange(rng, PLACES, SPEEDS, AIRSPEEDS)
        for setpoint, memory, wish in flown(here, target, rng):
            assert is_within_limits(setpoint), (here, target)
            numbers = (*setpoint.q_nb, wish.course, wish.azimuth, wish.gamma, wish.bank)
            slope, kept = memory.guidance.slope, memory.control
            learned = (*kept.omega_a, kept.thrust_integral, kept.alpha_bias)
            assert all(map(math.isfinite, (*numbers, slope, *learned))), (here, target)


@pytest.mark.parametrize("seed", range(4))
def test_what_is_no_number_never_leaves(seed):
    rng = Random(seed)
    for _ in range(300):
        here, target = strange(
            rng, PLACES + NO_NUMBERS, SPEEDS + NO_NUMBERS, AIRSPEEDS + NO_NUMBERS
        )
        for setpoint, _, _ in flown(here, target, rng):
            assert is_within_limits(setpoint), (here, target)


@pytest.mark.parametrize("circle", [0.0, 1.0])
def test_the_setpoint_turns_with_the_world_to_the_last_digits(circle):
    for number in range(300):
        rng = np.random.default_rng([7, number])
        p_n = (*rng.uniform(-900.0, 900.0, 2), rng.uniform(-250.0, -50.0))
        yaw, angle = rng.uniform(-math.pi, math.pi, 2)
        wind = (*rng.uniform(-8.0, 8.0, 2), 0.5)
        target = GuidanceTarget((30.0, -20.0, -150.0), 0.5, 0.1 * (1.0 - circle), circle, 120.0)
        states = [state(p_n, yaw + 0.005 * k, wind=wind, time=1.0 + 0.02 * k) for k in range(3)]
        here, wish = steps(states, target)
        R = rot_z(angle)
        there, other = steps(
            [turned(R, each) for each in states],
            target._replace(p_n=matvec(R, target.p_n), course=target.course + angle),
        )
        assert other.phase == wish.phase
        assert there.omega_b == pytest.approx(here.omega_b, abs=1e-9)
        assert there.thrust == pytest.approx(here.thrust, abs=1e-9)


@pytest.mark.parametrize("roll", [60.0, 120.0, 179.0, -100.0])
def test_from_upside_down_it_rolls_back_the_short_way(roll):
    here = state((-400.0, 0.0, -150.0), 0.0, roll=roll * DEG)
    level = GuidanceTarget((0.0, 0.0, -150.0), 0.0, 0.0, 0.0, 0.0)
    setpoint, _, _ = guide(here, level, VEHICLE, fresh_memory())
    assert setpoint.omega_b[0] * roll < 0.0
