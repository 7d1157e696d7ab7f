"""What is known after each message: one thing more, and nothing else."""

import math

import pytest
from conversations import heartbeat, state

from vfguide.link.enums import MavCmd, MavResult
from vfguide.link.messages import AttitudeQuaternion, CommandAck, VfrHud, WindCov
from vfguide.telemetry.knowledge import (
    STALE,
    WIND_STALE,
    Knowledge,
    lacking,
    measurement,
)
from vfguide.telemetry.knowledge import observe as observe_at

LATER = 3_600_000_000
"""An hour on our own clock [us]."""


def observe(known, message, now=LATER):
    """What is known after a message; an hour is longer than all that the counter may move."""
    return observe_at(known, message, now)


WIND = WindCov(0, 3.0, -2.0, 0.0, 0.0, 0.0, 0.0, 0.0, 0.0)


def known_at(time_boot_ms=5000):
    known = Knowledge()
    for message in (*state(time_boot_ms), WIND, *state(time_boot_ms)[2:3]):
        known = observe(known, message, 0)
    return known


def changed(before, after):
    return {name for name in Knowledge._fields if getattr(before, name) != getattr(after, name)}


@pytest.mark.parametrize(
    ("number", "fields"),
    [
        pytest.param(0, {"origin"}, id="origin"),
        pytest.param(1, {"position"}, id="position"),
        pytest.param(2, {"hud"}, id="airspeed"),
        pytest.param(3, {"attitude", "clock"}, id="attitude"),
    ],
)
def test_each_message_changes_one_thing(number, fields):
    known = known_at()
    message = state(5000)[number]
    later = message._replace(
        **{message._fields[-1]: message[-1] + 1} if number < 3 else {"time_boot_ms": 5020}
    )
    after = observe(known, later)
    assert changed(known, after) == fields
    assert getattr(after, min(fields)) == later


def test_the_airspeed_remembers_when_it_came_by_the_newest_attitude():
    known = known_at(5000)
    known = observe(known, AttitudeQuaternion(5200, 1.0, 0.0, 0.0, 0.0, 0.0, 0.0, 0.0))
    assert known.hud_time == 5000
    assert observe(known, known.hud).hud_time == 5200


@pytest.mark.parametrize("message", [heartbeat(), CommandAck(MavCmd.DO_SET_MODE, MavResult.DENIED)])
def test_other_messages_change_nothing(message):
    assert observe(known_at(), message) == known_at()


def test_the_same_message_again_is_no_news():
    known = known_at()
    for message in state(5000):
        assert observe(known, message) == known


def test_the_state_is_that_of_the_newest_messages_whatever_their_order():
    messages = [*state(5000)[:2], *state(5000)[3:], *state(5000)[2:3], WIND]
    known = Knowledge()
    for message in messages:
        known = observe(known, message)
    assert measurement(known) == measurement(known_at())


@pytest.mark.parametrize("age_ms", [0, 100, 499, 500, 501, 10_000])
@pytest.mark.parametrize("number", [1, 3])
def test_position_and_attitude_are_flown_on_together_up_to_half_a_second_apart(number, age_ms):
    later = state(5000 + age_ms)[number]
    known = observe(observe(known_at(), later), state(5000)[2])
    assert (measurement(known) is not None) == (age_ms <= 1000 * STALE)
    assert (lacking(known) is None) == (age_ms <= 1000 * STALE)


def test_what_lacks_is_named():
    assert "ATTITUDE_QUATERNION" in lacking(Knowledge())
    for field in ("attitude", "position", "hud", "origin"):
        without = known_at()._replace(**{field: None})
        assert lacking(without).startswith("not heard yet")
        assert measurement(without) is None
    assert lacking(known_at()) is None


def airspeed_in(known):
    return measurement(known)[6]


def test_an_airspeed_an_hour_before_any_attitude_is_taken_up_with_the_next_one():
    known = observe(Knowledge(), VfrHud(24.0, 25.0, 0, 30, 600.0, 0.0), 0)
    for message in state(90_000):
        if not isinstance(message, VfrHud):
            known = observe(known, message)
    assert math.isnan(airspeed_in(known))
    assert airspeed_in(observe(known, VfrHud(24.0, 25.0, 0, 30, 600.0, 0.0))) == 24.0


@pytest.mark.parametrize("age_ms", [0, 500, 4999, 5000, 5001, 60_000])
def test_a_wind_is_flown_on_for_five_seconds(age_ms):
    known = known_at(5000)
    for message in state(5000 + age_ms)[1:]:
        known = observe(known, message)
    assert math.isnan(measurement(known).wind_l[0]) == (age_ms > 1000 * WIND_STALE)


def test_no_airspeed_sensor_is_told_as_not_a_number_and_is_flown_on():
    known = observe(known_at(5000), VfrHud(math.nan, 25.0, 0, 30, 600.0, 0.0))
    assert math.isnan(airspeed_in(known))
    assert lacking(known) is None


def test_an_airspeed_from_before_the_autopilots_restart_is_old():
    known = known_at(5_000_000)
    for message in (state(1000)[1], state(1000)[3]):
        known = observe(known, message, LATER + 10_000_000)
    assert math.isnan(airspeed_in(known))


@pytest.mark.parametrize("boot_ms", [100, 3000, 10**6, 2**32 - 100])
@pytest.mark.parametrize(("before_s", "is_known"), [(0.1, True), (100.0, False)])
def test_what_was_heard_before_the_first_attitude_is_as_old_as_it_is(boot_ms, before_s, is_known):
    """It counted as of the time 0 of the counter, whatever that was at the first attitude."""
    known, now = Knowledge(), 10**9
    origin, position, hud, attitude = state(boot_ms)
    wind = WindCov(0, 3.0, 4.0, 0.0, 0.0, 0.0, 0.0, 0.0, 0.0)
    for message in (origin, hud, wind):
        known = observe(known, message, now - round(before_s * 1e6))
    for message in (position, attitude):
        known = observe(known, message, now)
    measured = measurement(known)
    assert math.isfinite(measured.calibrated) is is_known
    assert math.isfinite(measured.wind_l[0]) is is_known
