"""A counter of the autopilot that rolls over, restarts, repeats, comes late or leaps moves nothing.

All filters, clocks and limits of rate are in the row of the loop's state: it is compared whole.
"""

import numpy as np
import pytest
from conversations import TICK, Conversation, heartbeat, setpoints, state
from hypothesis import given, settings
from hypothesis import strategies as st

from vfguide.autopilots.engagement import Phase
from vfguide.autopilots.px4 import Px4Mode
from vfguide.link.boot_time import LATE_TIME, ROLLOVER
from vfguide.link.messages import WindCov

FIRST = 5000
TICKS = 150
HOURS = 2 * 3_600_000


def instant(k, boot_ms):
    """All that the autopilot tells at one instant: its wind falls, and so does its airspeed."""
    north = -3.0 + 0.01 * k
    origin, position, hud, attitude = state(boot_ms, 0.5 * k)
    return [
        WindCov(0, north, 0.0, 0.0, 0.0, 0.0, 0.0, 0.0, 0.0),
        origin,
        position,
        hud._replace(airspeed=28.0 - 0.01 * k),
        attitude,
    ]


def flown(told):
    """The flight in which the k-th instant is told with each of the counters `told(k, boot_ms)`."""
    talk = Conversation(engage=False)
    for k in range(TICKS):
        talk.now += TICK
        if k % 25 == 0:
            talk.hear(heartbeat(Px4Mode.HOLD if k < 25 else Px4Mode.OFFBOARD))
        for counter in told(k, FIRST + 20 * k):
            messages = instant(k, counter)
            # What comes before the first attitude has no time of its own.
            talk.hear(*(messages[::-1] if k == 0 else messages))
    return talk


def row(talk):
    return talk.companion.flight._state


def asked(talk):
    """What was asked for, whatever counter it answers."""
    return [each._replace(time_boot_ms=0) for each in setpoints(talk.said)]


@pytest.fixture(scope="module")
def honest():
    talk = flown(lambda _, boot_ms: [boot_ms])
    assert len(asked(talk)) == TICKS - 1
    assert talk.companion.phase is Phase.FLYING
    return talk


def told_with_leap(at, by):
    def told(k, boot_ms):
        return [(boot_ms + by) % ROLLOVER if k >= at else boot_ms]

    return told


def same(talk, honest):
    assert asked(talk) == asked(honest)
    np.testing.assert_array_equal(row(talk), row(honest))


@settings(max_examples=15, deadline=None)
@given(
    st.integers(1, TICKS - 1),
    st.one_of(st.integers(LATE_TIME + 100, HOURS), st.integers(HOURS, ROLLOVER - LATE_TIME - 100)),
)
def test_a_leap_or_a_restart_moves_no_filter(honest, at, by):
    """Forward by seconds or hours, or back: the difference is taken modulo the rollover."""
    same(flown(told_with_leap(at, by)), honest)


@pytest.mark.parametrize("at", [1, 30, 100])
def test_a_restart_at_zero_moves_no_filter(honest, at):
    talk = flown(lambda k, boot_ms: [boot_ms if k < at else 20 * (k - at)])
    if FIRST + 20 * at > LATE_TIME:
        same(talk, honest)
        assert sum("clock has leapt" in note for note in talk.told) == 1


@pytest.mark.parametrize("at", [1, 30, 100])
def test_the_rollover_moves_no_filter(honest, at):
    start = ROLLOVER - 20 * at
    talk = flown(lambda k, _: [(start + 20 * k) % ROLLOVER])
    rates = [(s.body_roll_rate, s.body_pitch_rate, s.body_yaw_rate, s.thrust) for s in asked(talk)]
    others = [
        (s.body_roll_rate, s.body_pitch_rate, s.body_yaw_rate, s.thrust) for s in asked(honest)
    ]
    np.testing.assert_allclose(rates, others, atol=1e-4)
    assert not any("leapt" in note for note in talk.told)
    assert not any("unreachable" in note for note in talk.told)


def test_what_is_told_twice_moves_no_filter(honest):
    same(flown(lambda _, boot_ms: [boot_ms, boot_ms]), honest)


@settings(max_examples=10, deadline=None)
@given(st.integers(1, 90))
def test_what_comes_late_moves_no_filter(honest, ticks):
    """Attitudes and positions of before, between the new ones."""
    talk = Conversation(engage=False)
    for k in range(TICKS):
        talk.now += TICK
        if k % 25 == 0:
            talk.hear(heartbeat(Px4Mode.HOLD if k < 25 else Px4Mode.OFFBOARD))
        wind, origin, position, hud, attitude = instant(k, FIRST + 20 * k)
        if k == 0:
            talk.hear(attitude)
        talk.hear(wind, origin, position)
        late = instant(k, max(FIRST, FIRST + 20 * (k - ticks)))
        if k > ticks:
            talk.hear(late[2], late[4])
        talk.hear(hud, attitude)
    same(talk, honest)


@settings(max_examples=15, deadline=None)
@given(st.lists(st.integers(0, ROLLOVER - 1), min_size=1, max_size=30), st.integers(0, 2**32))
def test_a_counter_at_random_is_survived(wild, seed):
    rng = np.random.default_rng(seed)
    talk = flown(
        lambda _, boot_ms: [wild[rng.integers(len(wild))] if rng.random() < 0.2 else boot_ms]
    )
    air = talk.companion.flight.air
    assert np.hypot(air.wind_north, air.wind_east) < 30.0
    assert not any("unreachable" in note for note in talk.told)
