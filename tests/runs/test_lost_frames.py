"""Frames that are lost or come twice or in another order between autopilot and companion."""

from random import Random

import pytest
from altered import fly_altered

pytestmark = pytest.mark.slow


def lossy(share, seed):
    """A share of all frames is lost."""
    rng = Random(seed)
    return lambda _, message: [] if rng.random() < share else [message]


def shuffled(seed):
    """Some frames come twice, some change places with a later one."""
    rng, kept = Random(seed), []

    def alter(_, message):
        if rng.random() < 0.2:
            kept.append(message)
            return []
        out = [message] * (2 if rng.random() < 0.2 else 1)
        if kept and rng.random() < 0.3:
            out += kept
            kept.clear()
        return out

    return alter


def bursts(seed):
    """Nothing arrives for up to 0.9 s, every few seconds."""
    rng = Random(seed)
    gap = [2.0, 2.5]

    def alter(t, message):
        if t > gap[1]:
            gap[0] = t + rng.uniform(1.0, 3.0)
            gap[1] = gap[0] + rng.uniform(0.2, 0.9)
        return [] if gap[0] <= t < gap[1] else [message]

    return alter


def bursty(share, length, seed):
    """A share of the time nothing arrives, for gaps of a mean length [s] (Gilbert, 1960)."""
    rng, state = Random(seed), [False, 2.0]

    def alter(t, message):
        while t >= state[1]:
            state[0] = not state[0]
            mean = length if state[0] else length * (1.0 - share) / share
            state[1] += rng.expovariate(1.0 / mean)
        return [] if state[0] else [message]

    return alter


def is_flown_as_it_should(flight):
    goal = flight.result.vehicles[0].goals[0]
    assert goal.reached
    assert flight.bank <= 55.0
    assert flight.lost <= 50.0
    assert not flight.notes("released")
    assert not flight.notes("no more setpoints")


@pytest.mark.parametrize("seed", range(3))
@pytest.mark.parametrize("share", [0.1, 0.3, 0.5])
def test_a_lossy_link(tmp_path, share, seed):
    is_flown_as_it_should(fly_altered(tmp_path, lossy(share, seed)))


@pytest.mark.parametrize("seed", range(3))
@pytest.mark.parametrize("length", [0.03, 0.1])
def test_a_link_that_loses_a_third_in_bursts(tmp_path, length, seed):
    is_flown_as_it_should(fly_altered(tmp_path, bursty(0.3, length, seed)))


@pytest.mark.parametrize("seed", range(3))
def test_frames_twice_and_out_of_order(tmp_path, seed):
    is_flown_as_it_should(fly_altered(tmp_path, shuffled(seed)))


@pytest.mark.parametrize("seed", range(6))
def test_a_link_that_is_gone_for_most_of_a_second(tmp_path, seed):
    """The roll that is held meanwhile is ended, so that no gap takes the bank beyond its limit."""
    is_flown_as_it_should(fly_altered(tmp_path, bursts(seed)))
