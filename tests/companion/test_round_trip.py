"""The delay of a link, from questions that come back."""

from random import Random

import pytest
from conversations import SECOND, TICK, Conversation, heartbeat, modes_asked, setpoints, state
from hypothesis import given, settings
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

    answers_timesync = False
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


class FarConversation(Conversation):
    """Everything takes its time to the companion and back, and answers may be lost.

    Whether it follows is the autopilot's own: it obeys the modes that it is asked for.
    """

    answers_timesync = False

    def __init__(self, **options):
        super().__init__(**options)
        self.down, self.up, self.is_answered = 10_000, 10_000, True
        self.mode = HOLD
        self._on_the_way: list = []
        self._sent = 0

    def pass_time(self, seconds):
        """What the companion says meanwhile, each with the age of the newest attitude it heard."""
        out = []
        for _ in range(round(seconds * SECOND / TICK)):
            self.now += TICK
            self.boot_ms += TICK // 1000
            beat = [heartbeat(self.mode)] if self._sent % 50 == 0 else []
            self._sent += 1
            self._send(*beat, *state(self.boot_ms, 0.025 * self.boot_ms))
            due = [m for when, m in self._on_the_way if when <= self.now]
            self._on_the_way = [(when, m) for when, m in self._on_the_way if when > self.now]
            said = [*self.hear(*due), *self.poll()]
            self._take(said)
            out += [(1e-3 * (self.boot_ms - m.time_boot_ms), m) for m in setpoints(said)]
        return out

    def _send(self, *messages):
        """In the order in which it was sent everything arrives."""
        last = self._on_the_way[-1][0] if self._on_the_way else 0
        arrives = max(last, self.now + self.down)
        self._on_the_way += [(arrives, m) for m in messages]

    def _take(self, said):
        for m in said:
            if isinstance(m, Timesync) and self.is_answered:
                last = self._on_the_way[-1][0] if self._on_the_way else 0
                arrives = max(last, self.now + self.up + self.down)
                self._on_the_way.append((arrives, m._replace(tc1=1000 * self.boot_ms)))
        for mode in modes_asked(said):
            self.mode = mode
            self.acknowledge()


def far_flying():
    talk = FarConversation()
    talk.pass_time(3.0)
    assert talk.companion.phase is Phase.FLYING
    return talk


@settings(max_examples=25)
@given(
    st.lists(
        st.tuples(st.integers(0, 2_500_000), st.booleans(), st.floats(0.3, 3.0)),
        min_size=1,
        max_size=5,
    )
)
def test_no_setpoint_is_made_for_a_state_that_is_older_than_half_a_second(turns):
    """The downlink changes at any time, by anything, with answers or without."""
    talk = far_flying()
    for down, is_answered, seconds in turns:
        talk.down, talk.is_answered = down, is_answered
        sent = talk.pass_time(seconds)
        assert max((age for age, _ in sent), default=0.0) <= TOO_SLOW_LINK + 0.08


@given(st.integers(0, 200_000), st.integers(0, 200_000))
@settings(max_examples=15)
def test_where_the_answers_stop_it_is_told_and_ends_in_hold_and_silence(down, up):
    talk = far_flying()
    talk.down, talk.up, talk.is_answered = down, up, False
    talk.pass_time(4.0)
    assert talk.companion.phase is Phase.YIELDING
    assert talk.mode is HOLD
    assert sum("does not answer TIMESYNC" in note for note in talk.told) == 1
    assert not talk.pass_time(5.0)
    talk.is_answered = True
    assert talk.pass_time(4.0)
    assert talk.companion.phase is Phase.OFFERING


@given(st.integers(0, 450_000), st.integers(0, 400_000))
@settings(max_examples=15)
def test_a_setpoint_is_made_for_the_time_when_it_acts_as_soon_as_states_come_later(later, down):
    """Before a single answer has come back over the slower link."""
    trip = RoundTrip()
    for k in range(20):
        trip.hear_state(NOW + 20_000 * k + down, 20 * k)
    assert trip.lateness == 0.0
    trip.hear_state(NOW + 20_000 * 20 + down + later, 400)
    assert trip.lead == pytest.approx(later * 1e-6)


@given(st.floats(-0.05, 0.05), st.integers(1000, 100_000))
@settings(max_examples=15)
def test_clocks_that_drift_apart_make_no_state_late(drift, took):
    """A simulation that is a little slower than real time, as recorded ones were by 1 %."""
    link = Link()
    for k in range(600):
        link.trip.hear_state(NOW + 20_000 * k, round(20 * k * (1.0 + drift)))
        link.now = max(link.now, NOW + 20_000 * k - QUESTION_INTERVAL)
        if k % 10 == 0:
            link.answered(took)
    assert link.trip.lateness <= 1e-6 * took + 0.2 * abs(drift) + 0.001


def test_nothing_is_offered_to_an_autopilot_that_never_answers_and_it_is_told_once():
    talk = FarConversation()
    talk.is_answered = False
    assert not talk.pass_time(6.0)
    assert sum("no setpoints: the autopilot does not answer TIMESYNC" in n for n in talk.told) == 1
    talk.is_answered = True
    assert talk.pass_time(2.0)
    assert not any("again" in note for note in talk.told)


def test_late_answers_between_new_ones_do_not_make_the_link_fast_and_slow_in_turns():
    """As where a link becomes fast again and what waited on it is still on the way."""
    trip, arrivals, turns = RoundTrip(), [], []
    for k in range(200):
        (question,) = trip.due(NOW + k * QUESTION_INTERVAL)
        late = 1_500_000 if 50 <= k < 100 or (100 <= k < 130 and k % 2) else 20_000
        arrivals.append((NOW + k * QUESTION_INTERVAL + late, question._replace(tc1=5)))
        due = [each for each in arrivals if each[0] <= NOW + (k + 1) * QUESTION_INTERVAL]
        arrivals = [each for each in arrivals if each not in due]
        for when, answer in sorted(due):
            before = trip.is_too_slow
            trip.hear(when, answer)
            turns += [k] if trip.is_too_slow is not before else []
    assert len(turns) == 2


@pytest.mark.parametrize("seed", range(5))
def test_a_link_that_loses_half_of_the_answers_is_no_unknown_one(seed):
    rng = Random(seed)
    talk = far_flying()
    for _ in range(300):
        talk.is_answered = rng.random() < 0.5
        talk.pass_time(0.2)
    assert talk.companion.phase is Phase.FLYING
