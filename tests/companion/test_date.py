"""The date of an autopilot, and what the obstacles make of it."""

from dataclasses import replace

import pytest
from conversations import SECOND, START, Conversation, heartbeat, plan, setpoints, state
from hazard_samples import hazards
from hypothesis import given
from hypothesis import strategies as st

from vfguide.autopilots.px4 import Px4Mode
from vfguide.companion.companion import Companion
from vfguide.companion.obstacle_clock import ObstacleClock
from vfguide.field.obstacle import Obstacle
from vfguide.geometry.shapes import shape
from vfguide.link.boot_time import BootClock, moved_on
from vfguide.link.messages import AttitudeQuaternion, SystemTime
from vfguide.telemetry.date import FIRST_DATE, LEAP_LASTS, TOLERANCE, date_after
from vfguide.telemetry.knowledge import Knowledge, observe

WEEK = 7 * 86_400 * SECOND
MOVING = replace(
    plan(),
    hazards=hazards((Obstacle(shape.sphere(20.0), (3000.0, 0.0, -120.0), 0.0, (-5.0, 0.0, 0.0)),)),
    hazard_names=("balloon", ""),
    epoch=START,
)


def dates(told):
    """What is believed after pairs of date [us] and counter [ms], each a second after the other."""
    date, out = None, []
    for unix, boot_ms in told:
        clock = BootClock(boot_ms, boot_ms, 0)
        date = date_after(date, SystemTime(unix, boot_ms), clock)
        out.append(date.unix - 1000 * date.time_ms if date else None)
    return out


@given(
    st.integers(-(10**15), 10**15).filter(lambda leap: abs(leap) > TOLERANCE),
    st.integers(1, LEAP_LASTS // 1000),
)
def test_a_leap_is_followed_only_when_it_has_lasted(leap, seconds):
    honest = [(START + k * SECOND, 1000 * k) for k in range(200)]
    told = [
        (unix + leap if 10 <= k < 10 + seconds else unix, boot)
        for k, (unix, boot) in enumerate(honest)
    ]
    assert set(dates(told)) == {START}
    lasting = [(unix + leap if k >= 10 else unix, boot) for k, (unix, boot) in enumerate(honest)]
    believed = dates(lasting)
    assert set(believed[: 10 + LEAP_LASTS // 1000]) == {START}
    if START + leap > FIRST_DATE:
        assert believed[-1] == START + leap


@given(st.lists(st.integers(0, 2**63), min_size=1, max_size=30))
def test_dates_at_random_are_not_followed(wild):
    told = [(START, 0), *((unix, 1000 * (k + 1)) for k, unix in enumerate(wild))]
    for offset in dates(told):
        assert abs(offset - START) <= TOLERANCE * (len(wild) + 1)


def test_date_and_counter_that_move_on_together_agree():
    """What waited was lost: the counter is ahead of our own clock, and the date says the same."""
    before = date_after(None, SystemTime(START, 5000), BootClock(5000, 5000, 0))
    clock = moved_on(BootClock(5000, 5000, 0), 17_000, 20_000)
    after = date_after(before, SystemTime(START + 12 * SECOND, 17_000), clock)
    assert (after.unix, after.leap) == (START + 12 * SECOND, 0)


def test_a_clock_that_was_never_set_tells_no_date():
    assert dates([(0, 0), (1000, 1000)]) == [None, None]


class DatedConversation(Conversation):
    """The autopilot tells the date once a second."""

    def __init__(self, asked=MOVING, engage=False):
        super().__init__()
        self.companion = Companion(1, asked, engage=engage)

    def fly_dated(self, mode, seconds, off=0):
        """So many seconds; `off` is added to the date [us], None: no date."""
        out = []
        for _ in range(seconds):
            if off is not None:
                self.hear(SystemTime(self.now + off, self.boot_ms))
            out += self.fly(1.0, mode)
        return out


def test_a_week_that_is_wrong_for_seconds_moves_no_obstacle():
    def flown(off):
        talk = DatedConversation()
        talk.fly_dated(Px4Mode.HOLD, 2)
        talk.fly_dated(Px4Mode.OFFBOARD, 2)
        talk.fly_dated(Px4Mode.OFFBOARD, 15, off)
        talk.fly_dated(Px4Mode.OFFBOARD, 3)
        return talk

    honest, wrong = flown(0), flown(-WEEK)
    assert setpoints(wrong.said) == setpoints(honest.said)
    (told,) = [note for note in wrong.told if "date" in note and "leapt" in note]
    assert "-604800 s" in told
    assert not any("leapt" in note for note in honest.told)


def test_a_date_that_becomes_known_in_flight_moves_no_obstacle():
    def flown(off):
        talk = DatedConversation()
        talk.fly_dated(Px4Mode.HOLD, 2, None)
        talk.fly_dated(Px4Mode.OFFBOARD, 4, None)
        talk.fly_dated(Px4Mode.OFFBOARD, 3, off)
        return talk

    assert setpoints(flown(300 * 86_400 * SECOND).said) == setpoints(flown(None).said)


def told_before(talk):
    return [note for note in talk.told if "moving obstacles" in note]


@pytest.mark.parametrize(
    ("off", "said"),
    [
        (0, "by the autopilot's date it is 0 s after start_time"),
        (None, "from when the autopilot follows: it tells no date"),
        (
            WEEK,
            "from when the autopilot follows: its date is 2026-01-08, start_time is farther away",
        ),
    ],
)
def test_what_depends_on_the_date_is_told_before_the_flight(off, said):
    talk = DatedConversation()
    talk.fly_dated(Px4Mode.HOLD, 3, off)
    (told,) = told_before(talk)
    assert said in told
    assert setpoints(talk.said)


def test_what_does_not_move_needs_no_date():
    talk = DatedConversation(plan())
    talk.fly_dated(Px4Mode.HOLD, 3, None)
    assert not told_before(talk)


@pytest.mark.parametrize(("off", "flies"), [(0, True), (None, False), (WEEK, False)])
def test_a_start_time_that_was_chosen_has_to_be_now(off, flies):
    talk = DatedConversation(replace(MOVING, has_start_time=True), engage=True)
    talk.fly_dated(Px4Mode.HOLD, 4, off)
    assert bool(setpoints(talk.said)) is flies
    if not flies:
        assert sum("no setpoints: moving obstacles need the date" in n for n in talk.told) == 1


def test_the_time_counts_from_the_engagement_where_there_is_no_date():
    clock, known = ObstacleClock(MOVING), Knowledge()
    for ms, now in ((5000, 0), (9000, 4 * SECOND), (10_000, 5 * SECOND)):
        attitude = AttitudeQuaternion(ms, 1.0, 0.0, 0.0, 0.0, 0.0, 0.0, 0.0)
        known = observe(known, attitude, now)
        if ms == 9000:
            clock.settle(known)
    assert clock.time(known) == pytest.approx(1.0)


def test_the_conversation_here_is_one_with_a_moving_obstacle():
    assert MOVING.moves
    assert not plan().moves
    talk = DatedConversation()
    talk.hear(heartbeat(), *state(5000))
    assert talk.companion.flight.plan is MOVING
