"""A second autopilot with the same address, as behind a router, begins to speak at any time."""

import pytest
from conversations import (
    SECOND,
    TICK,
    Conversation,
    heartbeat,
    modes_asked,
    plan,
    setpoints,
    state,
)
from hypothesis import given, settings
from hypothesis import strategies as st

from vfguide.autopilots.engagement import Phase
from vfguide.autopilots.px4 import Px4Mode
from vfguide.earth.geodesy import ned_to_geodetic, tangent_plane
from vfguide.geometry.units import DEG_E7, MM
from vfguide.link.boot_time import LATE_TIME, ROLLOVER
from vfguide.link.enums import MavAutopilot, MavState, MavType
from vfguide.link.messages import (
    AttitudeQuaternion,
    CurrentMode,
    GlobalPositionInt,
    Heartbeat,
)
from vfguide.telemetry.speakers import ALONE_AFTER

pytestmark = pytest.mark.slow

OFFBOARD, HOLD, RETURN = Px4Mode.OFFBOARD, Px4Mode.HOLD, Px4Mode.RETURN
SILENT_WITHIN = 0.3
"""Time after which nothing is sent any more [s]."""
APART = st.integers(LATE_TIME + 600, ROLLOVER - LATE_TIME - 600)


class Crowd(Conversation):
    """Two speak, each with states and a mode of its own."""

    def speak(self, seconds, mode, apart=None, other=HOLD, make=MavAutopilot.PX4):
        """So many seconds; `apart` is between the counters [ms], None: one speaks alone."""
        out = []
        for tick in range(round(seconds * SECOND / TICK)):
            self.now += TICK
            self.boot_ms += TICK // 1000
            beats = [heartbeat(mode)] if tick % 50 == 0 else []
            out += self.hear(*beats, *state(self.boot_ms, 0.025 * self.boot_ms))
            if apart is not None:
                theirs = (self.boot_ms + apart) % ROLLOVER
                if tick % 50 == 25:
                    beat = Heartbeat(MavType.FIXED_WING, make, 0, other, MavState.ACTIVE)
                    out += self.hear(beat, CurrentMode(0, other, other))
                out += self.hear(*state(theirs, 700.0 - 0.025 * self.boot_ms)[1:])
            out += self.poll()
        return out


def engaged():
    talk = Crowd()
    talk.speak(1.0, HOLD)
    talk.speak(1.0, OFFBOARD)
    assert talk.companion.phase is Phase.FLYING
    return talk


@settings(max_examples=12)
@given(
    APART,
    st.sampled_from([HOLD, RETURN, OFFBOARD, 10]),
    st.sampled_from([MavAutopilot.PX4, MavAutopilot.ARDUPILOTMEGA]),
)
def test_in_flight_it_falls_silent_asks_nobody_for_a_mode_and_is_not_released(apart, mode, make):
    talk = engaged()
    said = talk.speak(SILENT_WITHIN, OFFBOARD, apart, mode, make)
    said += talk.speak(8.0, OFFBOARD, apart, mode, make)
    assert len(setpoints(said)) <= SILENT_WITHIN * 50
    assert not modes_asked(said)
    assert talk.companion.phase is Phase.YIELDING
    assert sum("more than one autopilot speaks" in note for note in talk.told) == 1
    assert sum("clock has leapt" in note for note in talk.told) <= 1


@settings(max_examples=8)
@given(APART, st.sampled_from([HOLD, RETURN, OFFBOARD]))
def test_nothing_is_offered_while_two_speak_and_the_first_alone_is_flown_with(apart, mode):
    talk = Crowd()
    assert len(setpoints(talk.speak(SILENT_WITHIN, HOLD, apart, mode))) <= SILENT_WITHIN * 50
    said = talk.speak(5.0, HOLD, apart, mode)
    assert not setpoints(said)
    assert not modes_asked(said)
    assert sum("more than one autopilot speaks" in note for note in talk.told) == 1
    said = talk.speak(ALONE_AFTER / SECOND + 2.0, HOLD)
    assert setpoints(said)


def test_after_the_second_one_has_gone_the_operator_may_choose_again():
    talk = engaged()
    talk.speak(5.0, OFFBOARD, 5_000_000)
    assert not setpoints(talk.speak(ALONE_AFTER / SECOND - 0.5, HOLD))
    assert setpoints(talk.speak(2.0, HOLD))
    assert talk.companion.phase is Phase.OFFERING
    talk.speak(1.0, OFFBOARD)
    assert talk.companion.phase is Phase.FLYING


class Neighbours(Crowd):
    """They were switched on within two seconds, and tell their places ten times a second."""

    apart_ms = 0
    metres = 300.0

    def hear(self, *messages):
        return super().hear(*(told for m in messages for told in self.with_places(m)))

    def with_places(self, m):
        yield m
        if isinstance(m, AttitudeQuaternion) and self.boot_ms % 100 == 0:
            yield place(self.boot_ms, 0.025 * self.boot_ms)
            if self.metres:
                theirs = self.boot_ms + self.apart_ms
                yield place(theirs, 0.025 * theirs, self.metres)


def place(boot_ms, north, east=0.0):
    """Where the vehicle flies, level and to the north."""
    p_n = (north, -300.0 + east, -120.0)
    lat, lon, alt = ned_to_geodetic(tangent_plane(*plan().origin), p_n)
    at = (round(lat / DEG_E7), round(lon / DEG_E7), round(alt / MM))
    return GlobalPositionInt(boot_ms % ROLLOVER, *at, 120_000, 2500, 0, 0, 0)


@settings(max_examples=20)
@given(st.integers(-LATE_TIME, LATE_TIME), st.floats(80.0, 90_000.0))
def test_two_that_were_switched_on_together_are_known_by_their_places(apart, metres):
    talk = Neighbours()
    talk.metres = 0.0
    talk.speak(1.0, HOLD)
    talk.speak(1.0, OFFBOARD)
    talk.apart_ms, talk.metres = apart, metres
    talk.speak(1.0, OFFBOARD)
    said = talk.speak(20.0, OFFBOARD)
    assert not setpoints(said)
    assert not modes_asked(said)
    assert talk.companion.phase is Phase.YIELDING
    assert sum("their places differ" in note for note in talk.told) == 1


@pytest.mark.parametrize("metres", [0.0, 40.0])
@pytest.mark.parametrize("apart", [0, -300])
def test_places_that_are_told_twice_or_late_are_of_one(apart, metres):
    talk = Neighbours()
    talk.apart_ms, talk.metres = apart, metres
    talk.speak(1.0, HOLD)
    talk.speak(9.0, OFFBOARD)
    assert talk.companion.phase is Phase.FLYING


@pytest.mark.parametrize("wrong", [1, 2, 4])
def test_single_wrong_counters_are_no_second_autopilot(wrong):
    talk = engaged()
    for _ in range(wrong):
        talk.hear(state(4_000_000_000)[3])
        talk.speak(0.3, OFFBOARD)
    talk.speak(2.0, OFFBOARD)
    assert talk.companion.phase is Phase.FLYING
