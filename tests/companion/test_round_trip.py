"""The delay of a link, from questions that come back."""

import pytest
from conversations import SECOND, TICK, Conversation, heartbeat, modes_asked, setpoints, state
from hypothesis import given
from hypothesis import strategies as st

from vfguide.autopilots.engagement import Phase
from vfguide.autopilots.px4 import Px4Mode
from vfguide.link.messages import Timesync
from vfguide.telemetry.round_trip import (
    KEPT_ANSWERS,
    LONGEST_ROUND_TRIP,
    QUESTION_INTERVAL,
    SLOW_LINK,
    TOO_SLOW_LINK,
    RoundTrip,
)

NOW = 1_767_225_600_000_000
OFFBOARD, HOLD = Px4Mode.OFFBOARD, Px4Mode.HOLD


class Link:
    """Questions that go out in time, and their answers."""

    def __init__(self):
        self.trip = RoundTrip()
        self.now = NOW

    def answered(self, took):
        """The next question is answered after so long [us]."""
        self.now += QUESTION_INTERVAL
        (question,) = self.trip.due(self.now)
        self.trip.hear(self.now + took, Timesync(5, question.ts1))


def test_it_asks_five_times_a_second_with_its_own_clock():
    trip = RoundTrip()
    asked = [trip.due(NOW + tick * 20_000) for tick in range(50)]
    assert asked[0] == [Timesync(0, 1000 * NOW)]
    assert sum(map(len, asked)) == 1_000_000 // QUESTION_INTERVAL


def test_the_delay_is_the_median_of_the_latest_answers():
    link = Link()
    assert link.trip.delay == 0.0
    for took in (60_000, 900_000, 80_000, 80_000, 70_000):
        link.answered(took)
    assert link.trip.delay == pytest.approx(0.08)
    for _ in range(KEPT_ANSWERS):
        link.answered(10_000)
    assert link.trip.delay == pytest.approx(0.01)


@given(
    st.lists(st.integers(0, 150_000), min_size=1, max_size=20),
    st.integers(0, 20),
    st.integers(150_000, LONGEST_ROUND_TRIP),
)
def test_no_single_measurement_moves_the_delay_out_of_what_the_others_say(honest, place, late):
    link = Link()
    for took in [*honest[:place], late, *honest[place:]]:
        link.answered(took)
        assert link.trip.delay <= max(honest) * 1e-6
    assert not link.trip.is_too_slow


@given(st.integers(-(2**63), 2**63 - 1), st.integers(-(2**63), 2**63 - 1))
def test_answers_to_questions_of_others_change_nothing(tc1, ts1):
    link = Link()
    for _ in range(KEPT_ANSWERS):
        link.answered(50_000)
    asked = {1000 * (NOW + k * QUESTION_INTERVAL) for k in range(KEPT_ANSWERS + 1)}
    for stamp in {ts1, 1000 * (link.now - 1_600_000), 1000 * link.now + 1} - asked:
        for _ in range(2 * KEPT_ANSWERS):
            link.trip.hear(link.now, Timesync(tc1, stamp))
    assert link.trip.delay == pytest.approx(0.05)


def test_an_answer_counts_once():
    trip = RoundTrip()
    for k in range(2):
        (question,) = trip.due(NOW + k * QUESTION_INTERVAL)
        trip.hear(NOW + k * QUESTION_INTERVAL + 30_000, Timesync(5, question.ts1))
    for late in range(1, 40):
        trip.hear(NOW + QUESTION_INTERVAL + 30_000 * late, Timesync(5, question.ts1))
    assert trip.delay == pytest.approx(0.03)


@pytest.mark.parametrize(("tc1", "took"), [(0, 50_000), (-5, 50_000), (5, LONGEST_ROUND_TRIP + 1)])
def test_what_cannot_be_an_answer_is_none(tc1, took):
    trip = RoundTrip()
    for k in range(3):
        (question,) = trip.due(NOW + k * QUESTION_INTERVAL)
        trip.hear(NOW + k * QUESTION_INTERVAL + took, Timesync(tc1, question.ts1))
    assert trip.delay == 0.0


@pytest.mark.parametrize(
    ("took", "is_slow"), [(0.15, False), (0.21, True), (0.19, True), (0.11, True), (0.09, False)]
)
def test_a_slow_link_is_one_until_it_is_much_faster(took, is_slow):
    link = Link()
    for before in (0.05, *((0.4,) if took in (0.19, 0.11, 0.09) else ()), took):
        for _ in range(KEPT_ANSWERS):
            link.answered(round(before * SECOND))
    assert link.trip.is_slow is is_slow


def test_a_link_whose_delay_goes_up_and_down_about_slow_is_told_once():
    talk = flying(SlowConversation())
    for turn in range(6):
        talk.delay = 240_000 if turn % 2 == 0 else 160_000
        talk.fly_in(OFFBOARD, 3.0)
    assert sum("slow link: a setpoint acts" in note for note in talk.told) == 1


def test_a_link_that_was_too_slow_has_to_become_fast_again():
    link = Link()
    for took, too_slow in ((600_000, True), (300_000, True), (100_000, False), (300_000, False)):
        for _ in range(KEPT_ANSWERS):
            link.answered(took)
        assert link.trip.is_too_slow is too_slow


class SlowConversation(Conversation):
    """The autopilot answers after a delay, and somebody else's question 1.6 s late as well."""

    delay = 0
    others = False

    def __init__(self, **options):
        super().__init__(**options)
        self.answers = []

    def fly_in(self, mode, seconds):
        out = []
        for tick in range(round(seconds * SECOND / TICK)):
            self.now += TICK
            self.boot_ms += TICK // 1000
            due = [m for when, m in self.answers if when <= self.now]
            self.answers = [(when, m) for when, m in self.answers if when > self.now]
            if self.others:
                due.append(Timesync(self.now * 1000, (self.now - 1_600_000) * 1000))
            beat = [heartbeat(mode)] if tick % 50 == 0 else []
            said = self.hear(*due, *beat, *state(self.boot_ms, 0.025 * self.boot_ms))
            self.answers += [
                (self.now + self.delay, Timesync(7 + self.now * 1000, m.ts1))
                for m in said
                if isinstance(m, Timesync)
            ]
            out += said
        return out


def flying(talk):
    talk.fly_in(HOLD, 1.0)
    talk.fly_in(OFFBOARD, 2.0)
    assert talk.companion.phase is Phase.FLYING
    return talk


def test_the_flight_is_the_same_while_somebody_else_compares_clocks():
    quiet, noisy = SlowConversation(engage=False), SlowConversation(engage=False)
    noisy.others = True
    assert setpoints(flying(quiet).said) == setpoints(flying(noisy).said)
    assert not any("slow" in note for note in noisy.told)


def test_a_delay_that_rises_is_told_then_hold_is_asked_and_nothing_is_sent_until_it_falls():
    talk = flying(SlowConversation())
    talk.delay = round(1e6 * 0.5 * (SLOW_LINK + TOO_SLOW_LINK))
    assert setpoints(talk.fly_in(OFFBOARD, 2.0))
    assert sum("slow link" in note for note in talk.told) == 1
    talk.delay = 1_500_000
    said = talk.fly_in(OFFBOARD, 4.0)
    assert talk.companion.phase is Phase.YIELDING
    assert modes_asked(said)[0] == HOLD
    assert not setpoints(talk.fly_in(HOLD, 2.0))
    assert sum("the link is too slow" in note for note in talk.told) == 1
    talk.delay = 20_000
    assert setpoints(talk.fly_in(HOLD, 4.0))
    assert talk.companion.phase is Phase.OFFERING
    assert not modes_asked(talk.fly_in(HOLD, 2.0))
    talk.fly_in(OFFBOARD, 1.0)
    assert talk.companion.phase is Phase.FLYING


def test_nothing_is_offered_over_a_link_that_was_too_slow_from_the_beginning():
    talk = SlowConversation(engage=False)
    talk.delay = 800_000
    talk.fly_in(HOLD, 2.0)
    said = talk.fly_in(HOLD, 5.0)
    assert not setpoints(said)
    assert not modes_asked(said)
    assert sum("no setpoints: the link is too slow" in note for note in talk.told) == 1


def test_the_companion_asks_an_autopilot_that_it_has_found():
    talk = Conversation()
    assert not any(isinstance(m, Timesync) for m in talk.poll())
    (asked,) = (m for m in talk.hear(heartbeat()) if isinstance(m, Timesync))
    assert asked.ts1 == 1000 * talk.now
