"""The share of its thrust that a motor gives."""

import pytest

from vfguide.sim.autopilot.motor import SOUND, Motor


@pytest.mark.parametrize("time", [0.0, 60.0, 1e5])
def test_a_sound_motor_gives_all_for_ever(time):
    assert SOUND.share(time) == 1.0


def test_a_battery_runs_down_to_its_floor():
    motor = Motor(0.9, 0.2, 0.6)
    assert [motor.share(time) for time in (0.0, 30.0, 60.0, 90.0, 1e4)] == pytest.approx(
        [0.9, 0.8, 0.7, 0.6, 0.6]
    )


def test_a_floor_gives_nothing_back():
    assert Motor(0.3, 0.1, 0.5).share(60.0) == 0.3
