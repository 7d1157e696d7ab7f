"""Commands that must be answered: one at a time, repeated, given up, refused."""

from dataclasses import replace

import pytest
from conversations import SECOND, Conversation, heartbeat, state

from vfguide.autopilots.autopilot import Stream
from vfguide.autopilots.px4 import PX4, Px4Mode
from vfguide.companion.data_requests import request_origin, requested_streams
from vfguide.companion.requests import (
    MAX_ATTEMPTS,
    MODE_RETRY,
    MODE_TIMEOUT,
    RETRY,
    ModeRequest,
    Requests,
    command,
    result_name,
    set_mode,
)
from vfguide.link.enums import MavCmd, MavResult
from vfguide.link.messages import (
    AttitudeQuaternion,
    CommandAck,
    CommandLong,
    GpsGlobalOrigin,
    LocalPositionNed,
    VfrHud,
    WindCov,
)

REFUSALS = [MavResult.DENIED, MavResult.UNSUPPORTED, MavResult.FAILED]
NOT_YET = [MavResult.IN_PROGRESS, MavResult.TEMPORARILY_REJECTED]


def asked(*numbers):
    requests = Requests()
    requests.ask([command(7, number) for number in numbers])
    return requests


def test_commands_go_to_the_autopilot_of_the_system():
    for each in (
        request_origin(42),
        set_mode(42, PX4, Px4Mode.HOLD),
        *requested_streams(42, PX4, 50.0),
    ):
        assert (each.target_system, each.target_component) == (42, 1)


def test_all_that_is_flown_on_is_asked_for_at_its_rate():
    asked_for = requested_streams(1, PX4, 50.0)
    assert {each.command for each in asked_for} == {MavCmd.SET_MESSAGE_INTERVAL}
    assert {each.param1: each.param2 for each in asked_for} == {
        AttitudeQuaternion.MSGID: 20_000.0,
        LocalPositionNed.MSGID: 20_000.0,
        VfrHud.MSGID: 100_000.0,
        WindCov.MSGID: 200_000.0,
    }


@pytest.mark.parametrize("rate", [1.0, 4.0, 10.0, 200.0])
def test_no_stream_is_asked_for_faster_than_the_guidance_runs(rate):
    assert all(each.param2 >= 1e6 / rate for each in requested_streams(1, PX4, rate))


def test_an_autopilot_is_asked_for_its_own_streams_and_no_faster_than_it_can():
    slow = replace(PX4, streams=(Stream(AttitudeQuaternion.MSGID, 25.0),))
    (only,) = requested_streams(1, slow, 50.0)
    assert (only.param1, only.param2) == (AttitudeQuaternion.MSGID, 40_000.0)


def test_a_mode_is_asked_for_by_its_main_and_sub_number():
    asked_for = set_mode(1, PX4, Px4Mode.HOLD)
    assert asked_for.command == MavCmd.DO_SET_MODE
    assert (asked_for.param1, asked_for.param2, asked_for.param3) == (1.0, 4.0, 3.0)


def test_one_command_is_out_at_a_time_in_the_order_of_asking():
    requests = asked(MavCmd.REQUEST_MESSAGE, MavCmd.SET_MESSAGE_INTERVAL)
    assert requests.due(0).command == MavCmd.REQUEST_MESSAGE
    assert requests.due(RETRY - 1) is None
    assert requests.answer(CommandAck(MavCmd.REQUEST_MESSAGE, MavResult.ACCEPTED)) is None
    assert requests.due(RETRY - 1).command == MavCmd.SET_MESSAGE_INTERVAL
    assert requests.answer(CommandAck(MavCmd.SET_MESSAGE_INTERVAL, MavResult.ACCEPTED)) is None
    assert requests.due(10 * SECOND) is None


def test_what_is_not_answered_is_repeated_counted_and_given_up():
    requests = asked(MavCmd.REQUEST_MESSAGE, MavCmd.SET_MESSAGE_INTERVAL)
    sent = [requests.due(now) for now in range(0, (MAX_ATTEMPTS + 1) * RETRY, RETRY // 10)]
    sent = [each for each in sent if each]
    assert [each.confirmation for each in sent[:MAX_ATTEMPTS]] == list(range(MAX_ATTEMPTS))
    assert {each.command for each in sent[:MAX_ATTEMPTS]} == {MavCmd.REQUEST_MESSAGE}
    assert sent[MAX_ATTEMPTS].command == MavCmd.SET_MESSAGE_INTERVAL
    assert sent[MAX_ATTEMPTS].confirmation == 0


@pytest.mark.parametrize("result", NOT_YET)
def test_an_autopilot_that_is_not_ready_is_asked_again(result):
    requests = asked(MavCmd.REQUEST_MESSAGE)
    requests.due(0)
    assert requests.answer(CommandAck(MavCmd.REQUEST_MESSAGE, result)) is None
    assert requests.due(RETRY).confirmation == 1


@pytest.mark.parametrize("result", REFUSALS)
def test_a_refusal_is_told_and_not_repeated(result):
    requests = asked(MavCmd.SET_MESSAGE_INTERVAL)
    requests.due(0)
    complaint = requests.answer(CommandAck(MavCmd.SET_MESSAGE_INTERVAL, result))
    assert result.name.lower() in complaint
    assert str(int(MavCmd.SET_MESSAGE_INTERVAL)) in complaint
    assert requests.due(10 * SECOND) is None


def test_answers_to_other_commands_are_no_answers():
    requests = asked(MavCmd.REQUEST_MESSAGE)
    assert requests.answer(CommandAck(MavCmd.REQUEST_MESSAGE, MavResult.DENIED)) is None
    requests.due(0)
    assert requests.answer(CommandAck(MavCmd.DO_SET_MODE, MavResult.DENIED)) is None
    assert requests.due(RETRY).confirmation == 1


def test_a_mode_is_insisted_on_until_it_is_accepted():
    request = ModeRequest(1, PX4, Px4Mode.OFFBOARD)
    assert request.due(0) is not None
    assert request.due(MODE_RETRY - 1) is None
    assert request.due(MODE_RETRY) is not None
    request.answer(CommandAck(MavCmd.DO_SET_MODE, MavResult.ACCEPTED))
    assert request.due(100 * SECOND) is None


def test_an_accepted_mode_that_is_not_seen_was_asked_for_in_vain():
    request = ModeRequest(1, PX4, Px4Mode.OFFBOARD)
    request.due(0)
    assert not request.in_vain(100 * SECOND)
    request.answer(CommandAck(MavCmd.DO_SET_MODE, MavResult.ACCEPTED))
    assert not request.in_vain(MODE_TIMEOUT)
    assert request.in_vain(MODE_TIMEOUT + 1)


def test_a_refused_mode_is_told_once_for_each_reason_and_asked_for_again():
    request = ModeRequest(1, PX4, Px4Mode.OFFBOARD)
    assert request.answer(CommandAck(MavCmd.DO_SET_MODE, MavResult.DENIED)) is None  # not asked
    request.due(0)
    told = [
        request.answer(CommandAck(MavCmd.DO_SET_MODE, result))
        for result in (MavResult.DENIED, MavResult.DENIED, MavResult.FAILED)
    ]
    assert [bool(each) for each in told] == [True, False, True]
    assert "OFFBOARD" in told[0]
    assert "denied" in told[0]
    assert request.due(MODE_RETRY) is not None


def test_the_last_of_two_answers_counts():
    request = ModeRequest(1, PX4, Px4Mode.OFFBOARD)
    request.due(0)
    request.answer(CommandAck(MavCmd.DO_SET_MODE, MavResult.ACCEPTED))
    request.answer(CommandAck(MavCmd.DO_SET_MODE, MavResult.TEMPORARILY_REJECTED))
    assert request.due(MODE_RETRY) is not None


def test_every_result_has_a_name():
    assert result_name(MavResult.TEMPORARILY_REJECTED) == "temporarily rejected"
    assert result_name(200) == "result 200"


def answered(talk, seconds):
    """Every command of so many seconds, each accepted at once."""
    found = []
    for tick in range(round(50 * seconds)):
        talk.now += 20_000
        out = talk.hear(heartbeat()) if tick % 50 == 0 else talk.poll()
        while sent := [m for m in out if isinstance(m, CommandLong)]:
            found += sent
            accepted = [CommandAck(m.command, MavResult.ACCEPTED) for m in sent]
            out = talk.hear(*accepted)
    return found


def of(messages, number):
    return [m.param1 for m in messages if isinstance(m, CommandLong) and m.command == number]


def test_a_new_autopilot_is_asked_for_every_stream_once_if_it_accepts():
    asked_for = of(answered(Conversation(engage=False), 10.0), MavCmd.SET_MESSAGE_INTERVAL)
    assert sorted(asked_for) == sorted(stream.msgid for stream in PX4.streams)


def test_the_origin_is_asked_for_every_second_until_it_is_known():
    talk = Conversation(engage=False)
    asked_for = of(answered(talk, 10.0), MavCmd.REQUEST_MESSAGE)
    assert set(asked_for) == {GpsGlobalOrigin.MSGID}
    assert len(asked_for) == pytest.approx(10, abs=1)
    talk.hear(state(5000)[0])
    assert not of(answered(talk, 10.0), MavCmd.REQUEST_MESSAGE)


def test_an_autopilot_that_is_heard_anew_is_asked_again():
    talk = Conversation(engage=False)
    answered(talk, 2.0)
    for _ in range(50):  # it is silent, while this program runs
        talk.now += SECOND // 10
        talk.poll()
    asked_for = of(answered(talk, 2.0), MavCmd.SET_MESSAGE_INTERVAL)
    assert sorted(asked_for) == sorted(stream.msgid for stream in PX4.streams)


def test_questions_for_the_origin_that_nobody_answered_do_not_pile_up():
    talk = Conversation(engage=False)
    talk.fly(60.0, flying=False)
    talk.hear(state(5000)[0])
    assert len(of(answered(talk, 30.0), MavCmd.REQUEST_MESSAGE)) <= 1
