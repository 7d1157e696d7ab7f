"""Times of an autopilot since it booted, which roll over, repeat, come late and leap."""

import random
from itertools import pairwise

import pytest
from hypothesis import given
from hypothesis import strategies as st

from vfguide.link.boot_time import AHEAD, LATE_TIME, ROLLOVER, BootClock, elapsed, moved_on

counters = st.integers(0, ROLLOVER - 1)


def test_it_rolls_over_after_so_many_days():
    assert pytest.approx(49.7, abs=0.05) == ROLLOVER * 1e-3 / 86_400


@pytest.mark.parametrize("before", [0, 1, 2**31, 2**32 - 1])
@pytest.mark.parametrize("step", [0, 20, 86_400_000])
def test_times_count_across_the_rollover_in_both_directions(before, step):
    after = (before + step) % 2**32
    assert elapsed(before, after) == pytest.approx(1e-3 * step)
    assert elapsed(after, before) == pytest.approx(-1e-3 * step)


def test_thirty_milliseconds_across_the_rollover():
    assert elapsed(2**32 - 20, 10) == pytest.approx(0.03)
    assert elapsed(10, 2**32 - 20) == pytest.approx(-0.03)


def clock_after(messages):
    """The clock after pairs of time_boot_ms [ms] and own time [us], and all its times [ms]."""
    clock, times = None, []
    for boot_ms, now in messages:
        clock = moved_on(clock, boot_ms, now) or clock
        times.append(clock.time_ms)
    return clock, times


@given(counters, st.lists(st.integers(1, 1000), max_size=50))
def test_an_honest_counter_is_the_time_whenever_it_rolls_over(start, steps):
    total, messages = 0, [(start, 0)]
    for step in steps:
        total += step
        messages.append(((start + total) % ROLLOVER, 1000 * total))
    clock, _ = clock_after(messages)
    assert clock == BootClock((start + total) % ROLLOVER, start + total, 1000 * total)


@given(counters, st.integers(100, 10**6), st.floats(0.0, 1.0))
def test_what_waited_and_what_was_lost_are_no_leap(start, stall, kept):
    """This program stands still for so many ms; the first of what came meanwhile waits for it."""
    waited = [20 * k for k in range(1, int(kept * stall) // 20 + 1)]
    told = [(0, 0), *((boot, stall) for boot in waited), (stall + 20, stall + 20)]
    clock, times = clock_after([((start + boot) % ROLLOVER, 1000 * now) for boot, now in told])
    assert clock.leaps == 0
    assert times[-1] - times[0] == stall + 20


@pytest.mark.parametrize("interval", [20, 100])
@pytest.mark.parametrize("drift", [-1e-3, 1e-3])
def test_clocks_that_drift_apart_are_not_taken_for_late_ones(drift, interval):
    """By a tenth of a per cent, ten times what a crystal does; messages are up to 9 ms late."""
    clock, rng = None, random.Random(1)
    for k in range(600_000 // interval):
        now = round(1000 * interval * k * (1.0 + drift)) + rng.randrange(9000)
        clock = moved_on(clock, interval * k, now)
        assert clock.behind <= 10
    assert clock.leaps == 0


@given(st.lists(st.tuples(counters, st.integers(0, 10_000_000)), min_size=1, max_size=50))
def test_whatever_is_told_the_time_never_goes_back_nor_ahead_of_our_own_clock(told):
    now, messages = 0, []
    for boot_ms, since in told:
        now += since
        messages.append((boot_ms, now))
    _, times = clock_after(messages)
    for (_, now), (was, is_now) in zip(messages[1:], pairwise(times), strict=True):
        assert is_now >= was
        assert is_now - times[0] <= now // 1000 + AHEAD * len(messages)


@given(counters, counters, st.integers(1, 2000))
def test_one_step_is_never_negative_and_never_longer_than_our_own(before, after, own_ms):
    clock = BootClock(before, 10**7, 0)
    stepped = moved_on(clock, after, 1000 * own_ms)
    if stepped is not None:
        assert 0 <= stepped.time_ms - clock.time_ms <= own_ms + AHEAD


@pytest.mark.parametrize("late", [0, 1, 20, LATE_TIME - 1])
def test_what_repeats_or_comes_late_is_ignored(late):
    assert moved_on(BootClock(5000, 5000, 0), 5000 - late, 1000) is None


@pytest.mark.parametrize("counter", [100, 5000 - LATE_TIME, 2**31, 5000 + 7_200_000, 2**32 - 1])
def test_after_a_leap_the_time_goes_on_by_our_own_clock_and_then_by_the_counter(counter):
    clock = moved_on(BootClock(5000, 5000, 0), counter, 30_000)
    assert (clock.time_ms, clock.leaps) == (5030, 1)
    later = moved_on(clock, (counter + 20) % ROLLOVER, 50_000)
    assert (later.time_ms, later.leaps) == (5050, 1)
