"""The delay of a link, from questions that come back."""

import pytest
from conversations import Conversation, heartbeat

from vfguide.companion.round_trip import (
    KEPT_ANSWERS,
    LONGEST_ROUND_TRIP,
    QUESTION_INTERVAL,
    RoundTrip,
)
from vfguide.link.messages import Timesync

NOW = 1_767_225_600_000_000


def answered(trip, took, now=NOW):
    """What is noted when an answer took so long [us]."""
    return trip.hear(now, Timesync(5, 1000 * (now - took)))


def test_it_asks_five_times_a_second_with_its_own_clock():
    trip = RoundTrip()
    asked = [trip.due(NOW + tick * 20_000) for tick in range(50)]
    assert asked[0] == [Timesync(0, 1000 * NOW)]
    assert sum(map(len, asked)) == 1_000_000 // QUESTION_INTERVAL


def test_the_delay_is_the_median_of_the_latest_answers():
    trip = RoundTrip()
    assert trip.delay == 0.0
    answered(trip, 60_000)
    assert trip.delay == pytest.approx(0.06)
    for took in (900_000, 80_000, 80_000, 70_000):
        answered(trip, took)
    assert trip.delay == pytest.approx(0.08)
    for _ in range(KEPT_ANSWERS):
        answered(trip, 10_000)
    assert trip.delay == pytest.approx(0.01)


@pytest.mark.parametrize(
    "message",
    [
        Timesync(0, 1000 * (NOW - 50_000)),  # a question
        Timesync(5, 1000 * (NOW - LONGEST_ROUND_TRIP - 1)),
        Timesync(5, 1000 * (NOW + 1)),
        Timesync(5, 123),  # somebody else's clock
    ],
)
def test_what_does_not_answer_its_questions_is_ignored(message):
    trip = RoundTrip()
    assert trip.hear(NOW, message) is None
    assert trip.delay == 0.0


def test_a_link_that_becomes_slow_is_told_once():
    trip = RoundTrip()
    assert answered(trip, 200_000) is None
    notes = [answered(trip, 400_000) for _ in range(KEPT_ANSWERS)]
    assert [note for note in notes if note] == [
        "slow link: a setpoint acts 0.3 s after the state it is made for"
    ]


def test_the_companion_asks_an_autopilot_that_it_has_found():
    talk = Conversation()
    assert not any(isinstance(its, Timesync) for its in talk.poll())
    (asked,) = (its for its in talk.hear(heartbeat()) if isinstance(its, Timesync))
    assert asked.ts1 == 1000 * talk.now
    talk.now += 300_000
    talk.hear(Timesync(7, asked.ts1))
    assert "slow link: a setpoint acts 0.3 s after the state it is made for" in talk.told
