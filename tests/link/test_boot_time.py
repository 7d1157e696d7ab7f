"""Times of an autopilot since it booted, which roll over."""

import pytest

from vfguide.link.boot_time import ROLLOVER, elapsed


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
