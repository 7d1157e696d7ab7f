"""The software autopilot on MAVLink: what PX4 does, it does."""

import math
from random import Random

import pytest
from conversations_with_autopilot import (
    ATTITUDES,
    RATES,
    UPDATE,
    Dialogue,
    new_vehicle,
    of,
    results,
    setpoint,
)

from vfguide.autopilots.px4 import Px4Mode
from vfguide.earth.pressure_altitude import pressure_altitude
from vfguide.geometry.so3 import from_euler, to_quaternion
from vfguide.geometry.units import DEG, HPA
from vfguide.link.codec import Encoder
from vfguide.link.enums import AttitudeTypeMask, MavCmd, MavResult, MavState
from vfguide.link.messages import (
    AttitudeTarget,
    AutopilotVersion,
    AvailableModes,
    CommandAck,
    CommandInt,
    CurrentMode,
    ExtendedSysState,
    GpsGlobalOrigin,
    Heartbeat,
    HomePosition,
    LocalPositionNed,
    MessageInterval,
    MissionAck,
    MissionClearAll,
    MissionCount,
    MissionRequestList,
    ParamRequestList,
    ParamRequestRead,
    ParamSet,
    ParamValue,
    Ping,
    ScaledPressure,
    Statustext,
    SysStatus,
    Timesync,
)
from vfguide.sim.autopilot.flight_mode import Mode
from vfguide.sim.autopilot.parameters import from_bytes, to_bytes

ACCEPTED, DENIED = MavResult.ACCEPTED, MavResult.DENIED
REJECTED, UNSUPPORTED = MavResult.TEMPORARILY_REJECTED, MavResult.UNSUPPORTED


@pytest.fixture
def talk():
    return Dialogue(new_vehicle())


def offboard(talk):
    talk.fly(0.2, setpoint())
    talk.set_mode(Px4Mode.OFFBOARD)
    assert talk.vehicle.autopilot.mode is Mode.OFFBOARD


def test_it_begins_airborne_armed_and_in_hold(talk):
    heard = talk.fly(1.1)
    beat = of(heard, Heartbeat)[0]
    assert (beat.custom_mode, beat.system_status) == (Px4Mode.HOLD, MavState.ACTIVE)
    assert beat.base_mode & 128
    assert of(heard, ExtendedSysState)[0].landed_state == 2
    assert of(heard, SysStatus)[0].onboard_control_sensors_health & (1 << 28)


def test_heartbeats_come_once_a_second(talk):
    assert len(of(talk.fly(0.02), Heartbeat)) == 1
    assert len(of(talk.fly(10.0), Heartbeat)) == 10


def test_streams_that_were_held_up_are_not_made_up_for_and_keep_their_beat(talk):
    talk.fly(0.02)
    talk.vehicle.advance(5 * UPDATE)
    times = [m.time_boot_ms for m in of(talk.fly(0.5), LocalPositionNed)]
    assert times[:4] == [140, 180, 200, 240]


# Modes


def test_offboard_is_rejected_without_a_stream_and_acknowledged_twice(talk):
    talk.fly(0.1)
    assert results(talk.set_mode(Px4Mode.OFFBOARD)) == [ACCEPTED]
    assert results(talk.fly(0.04)) == [REJECTED]
    assert talk.vehicle.autopilot.mode is Mode.HOLD


def test_offboard_is_taken_with_a_stream_and_acknowledged_twice(talk):
    talk.fly(0.2, setpoint())
    assert results(talk.set_mode(Px4Mode.OFFBOARD)) == [ACCEPTED]
    heard = talk.fly(0.04, setpoint())
    assert results(heard) == [ACCEPTED]
    assert of(heard, CurrentMode)[0].custom_mode == Px4Mode.OFFBOARD
    assert of(talk.fly(1.0, setpoint()), Heartbeat)[0].custom_mode == Px4Mode.OFFBOARD


def test_the_heartbeat_of_offboard_is_armed_without_the_flags_of_auto(talk):
    offboard(talk)
    assert of(talk.fly(1.0, setpoint()), Heartbeat)[0].base_mode == 0x81


def test_a_stream_that_is_too_old_does_not_open_offboard(talk):
    talk.fly(0.2, setpoint())
    talk.fly(1.1)
    talk.set_mode(Px4Mode.OFFBOARD)
    assert talk.vehicle.autopilot.mode is Mode.HOLD


def test_the_loss_of_the_stream_is_noted_after_its_time_and_not_before(talk):
    talk.greet_as_ground_station()
    offboard(talk)
    talk.fly(0.2, setpoint(0.1))
    talk.fly(0.98)
    assert talk.vehicle.autopilot.mode is Mode.OFFBOARD
    assert talk.vehicle.autopilot.setpoint.body_roll_rate == pytest.approx(0.1)
    heard = talk.fly(0.1)
    assert talk.vehicle.autopilot.mode is Mode.LOST_TO_HOLD
    assert of(heard, CurrentMode)[0].custom_mode == Px4Mode.HOLD
    assert "Failsafe" in of(heard, Statustext)[0].text
    beat = of(talk.fly(1.0), Heartbeat)[0]
    assert (beat.custom_mode, beat.system_status) == (Px4Mode.HOLD, MavState.CRITICAL)


def test_after_a_loss_the_stream_takes_over_again_by_itself(talk):
    offboard(talk)
    talk.fly(2.0)
    talk.send(setpoint())
    assert talk.vehicle.autopilot.mode is Mode.OFFBOARD


def test_an_explicit_hold_cancels_the_way_back(talk):
    offboard(talk)
    talk.fly(2.0)
    talk.set_mode(Px4Mode.HOLD)
    talk.fly(1.0, setpoint())
    assert talk.vehicle.autopilot.mode is Mode.HOLD
    assert of(talk.fly(1.0), Heartbeat)[0].system_status == MavState.ACTIVE


def test_the_time_of_loss_and_what_follows_are_parameters(talk):
    talk.send(ParamSet(1, 1, "COM_OF_LOSS_T", 0.3, 9))
    talk.send(ParamSet(1, 1, "NAV_RCL_ACT", to_bytes(2), 6))
    offboard(talk)
    talk.fly(0.4)
    assert talk.vehicle.autopilot.mode is Mode.LOST_TO_RETURN


@pytest.mark.parametrize(
    ("mode", "expected"),
    [
        (Px4Mode.HOLD, ACCEPTED),
        (Px4Mode.RETURN, ACCEPTED),
        (Px4Mode.LAND, DENIED),
        (Px4Mode.MANUAL, DENIED),
        (99 << 16, DENIED),
    ],
)
def test_only_what_it_can_fly_by_itself_is_taken(talk, mode, expected):
    talk.set_mode(mode)
    assert results(talk.fly(0.04)) == [expected]


@pytest.mark.parametrize(
    ("command", "mode"),
    [(MavCmd.NAV_RETURN_TO_LAUNCH, Mode.RETURN), (MavCmd.NAV_LOITER_UNLIM, Mode.HOLD)],
)
def test_modes_have_commands_of_their_own(talk, command, mode):
    offboard(talk)
    assert results(talk.command(command)) == [ACCEPTED]
    assert talk.vehicle.autopilot.mode is mode


def test_status_texts_are_for_ground_stations_only(talk):
    ground = Dialogue(talk.vehicle, speaker=(255, 190))
    ground.greet_as_ground_station()
    talk.command(MavCmd.NAV_RETURN_TO_LAUNCH)
    assert of(ground.fly(0.04), Statustext)
    assert not of(talk.fly(0.04), Statustext)


# Setpoints


def test_a_setpoint_is_flown_before_the_next_update(talk):
    offboard(talk)
    before = talk.vehicle.autopilot.control(talk.vehicle.plant.inner(), 0.0)
    talk.send(setpoint(1.0, 0.0, 0.0, 0.9))
    after = talk.vehicle.autopilot.control(talk.vehicle.plant.inner(), 0.0)
    assert abs(after[0] - before[0]) > 0.05
    assert after[3] > before[3] + 0.1


def test_body_rates_are_flown(talk):
    offboard(talk)
    talk.fly(1.0, setpoint(0.2, 0.05, 0.0, 0.4))
    p, q, _ = talk.vehicle.truth.omega_b
    assert (p, q) == pytest.approx((0.2, 0.05), abs=0.03)


def test_attitudes_are_flown_with_the_yaw_of_a_coordinated_turn(talk):
    offboard(talk)
    banked = to_quaternion(from_euler(30.0 * DEG, 3.0 * DEG, 2.0))
    talk.fly(8.0, setpoint(mask=ATTITUDES, attitude=banked, thrust=0.4))
    truth = talk.vehicle.truth
    assert truth.roll == pytest.approx(30.0 * DEG, abs=2.0 * DEG)
    assert truth.pitch == pytest.approx(3.0 * DEG, abs=2.0 * DEG)
    assert abs(truth.beta) < 2.0 * DEG


@pytest.mark.parametrize("place", range(4))
def test_what_is_no_number_sends_the_surfaces_to_trim_and_stops_the_motor(talk, place):
    offboard(talk)
    values = [0.1, 0.1, 0.1, 0.5]
    values[place] = math.nan
    talk.fly(0.1, setpoint(*values))
    inner = talk.vehicle.plant.inner()
    controls = talk.vehicle.autopilot.control(inner, 0.005)
    assert controls == talk.vehicle.autopilot.control(
        (*inner[:2], inner[2] + 1.0, *inner[3:]), 0.005
    )
    assert controls[3] == 0.0


def test_missing_thrust_is_no_thrust(talk):
    offboard(talk)
    throttles = []
    for mask in (RATES, RATES | AttitudeTypeMask.THROTTLE_IGNORE):
        talk.send(setpoint(thrust=0.0 if mask == RATES else 0.8, mask=mask))
        throttles.append(talk.vehicle.autopilot.control(talk.vehicle.plant.inner(), 0.0)[3])
    assert throttles[0] == throttles[1]


def test_the_target_tells_the_setpoint_that_is_flown(talk):
    offboard(talk)
    talk.fly(0.1, setpoint(0.1, 0.2, 0.3, 0.6))
    (told,) = of(talk.command(MavCmd.REQUEST_MESSAGE, AttitudeTarget.MSGID), AttitudeTarget)
    rates = (told.body_roll_rate, told.body_pitch_rate, told.body_yaw_rate, told.thrust)
    assert rates == pytest.approx((0.1, 0.2, 0.3, 0.6))


# Who is spoken to


def test_what_is_addressed_to_others_is_left_alone(talk):
    assert talk.command(MavCmd.NAV_RETURN_TO_LAUNCH, target=(2, 1)) == []
    assert talk.command(MavCmd.NAV_RETURN_TO_LAUNCH, target=(1, 195)) == []
    talk.send(setpoint(target=2))
    assert not talk.vehicle.autopilot.has_stream
    assert talk.vehicle.autopilot.mode is Mode.HOLD


@pytest.mark.parametrize("target", [(0, 0), (1, 0), (1, 1), (0, 1)])
def test_what_is_addressed_to_it_or_to_all_is_heard(talk, target):
    assert results(talk.command(MavCmd.NAV_LOITER_UNLIM, target=target)) == [ACCEPTED]


def test_every_unknown_command_is_refused_to_its_sender(talk):
    known = {
        MavCmd.DO_SET_MODE,
        MavCmd.NAV_RETURN_TO_LAUNCH,
        MavCmd.NAV_LOITER_UNLIM,
        MavCmd.COMPONENT_ARM_DISARM,
        MavCmd.SET_MESSAGE_INTERVAL,
        MavCmd.GET_MESSAGE_INTERVAL,
        MavCmd.REQUEST_MESSAGE,
        MavCmd.GET_HOME_POSITION,
        MavCmd.REQUEST_AUTOPILOT_CAPABILITIES,
    }
    peer = Dialogue(talk.vehicle, speaker=(255, 190))
    for number in {*MavCmd, 0, 5, 43000, 65535} - known:
        (ack,) = of(peer.command(number), CommandAck)
        assert ack.result == UNSUPPORTED, number
        assert (ack.command, ack.target_system, ack.target_component) == (number, 255, 190)


def test_commands_as_integers_are_answered_too(talk):
    heard = talk.send(
        CommandInt(1, 1, 0, MavCmd.NAV_LOITER_UNLIM, 0, 0, 0.0, 0.0, 0.0, 0.0, 0, 0, 0.0)
    )
    assert results(heard) == [ACCEPTED]


def test_it_does_not_disarm_in_the_air(talk):
    assert results(talk.command(MavCmd.COMPONENT_ARM_DISARM, 1.0)) == [ACCEPTED]
    assert results(talk.command(MavCmd.COMPONENT_ARM_DISARM, 0.0)) == [DENIED]


# Messages on request


def test_streams_can_be_set_asked_for_and_ended(talk):
    number = LocalPositionNed.MSGID
    assert results(talk.command(MavCmd.SET_MESSAGE_INTERVAL, number, 100_000)) == [ACCEPTED]
    (interval,) = of(talk.command(MavCmd.GET_MESSAGE_INTERVAL, number), MessageInterval)
    assert interval.interval_us == 100_000
    assert len(of(talk.fly(0.02), LocalPositionNed)) == 1
    assert len(of(talk.fly(2.0), LocalPositionNed)) == 20
    talk.command(MavCmd.SET_MESSAGE_INTERVAL, number, -1)
    assert not of(talk.fly(1.0), LocalPositionNed)
    talk.command(MavCmd.SET_MESSAGE_INTERVAL, number, 0)
    assert of(talk.fly(1.0), LocalPositionNed)


def test_the_pressure_comes_to_who_asks_for_it(talk):
    number = ScaledPressure.MSGID
    assert not of(talk.fly(2.0), ScaledPressure)
    talk.command(MavCmd.SET_MESSAGE_INTERVAL, number, 1_000_000)
    heard = of(talk.fly(3.0), ScaledPressure)
    assert len(heard) in (3, 4)
    height = pressure_altitude(heard[-1].press_abs * HPA)
    assert height == pytest.approx(talk.vehicle.truth.altitude, abs=1.0)


@pytest.mark.parametrize("number", [math.nan, math.inf, -1.0, 65_535.0, 300.0])
def test_streams_of_messages_that_it_does_not_have_are_refused(talk, number):
    (result,) = results(talk.command(MavCmd.SET_MESSAGE_INTERVAL, number, 1e5))
    assert result in (DENIED, UNSUPPORTED)
    assert results(talk.command(MavCmd.GET_MESSAGE_INTERVAL, number)) == [UNSUPPORTED]
    assert results(talk.command(MavCmd.REQUEST_MESSAGE, number)) == [UNSUPPORTED]


@pytest.mark.parametrize("kind", [AutopilotVersion, GpsGlobalOrigin, HomePosition, Heartbeat])
def test_messages_come_on_request(talk, kind):
    heard = talk.command(MavCmd.REQUEST_MESSAGE, kind.MSGID)
    assert results(heard) == [ACCEPTED]
    assert len(of(heard, kind)) == 1


def test_its_modes_are_listed_all_or_one_by_one(talk):
    modes = of(talk.command(MavCmd.REQUEST_MESSAGE, AvailableModes.MSGID, 0), AvailableModes)
    assert [mode.mode_index for mode in modes] == list(range(1, modes[0].number_modes + 1))
    (second,) = of(talk.command(MavCmd.REQUEST_MESSAGE, AvailableModes.MSGID, 2), AvailableModes)
    assert second == modes[1]


# Parameters, missions, time


def test_parameters_are_listed_with_count_and_index(talk):
    listed = of(talk.send(ParamRequestList(1, 1)), ParamValue)
    assert [p.param_index for p in listed] == list(range(len(listed)))
    assert {p.param_count for p in listed} == {len(listed)}
    for p in listed:
        (by_name,) = talk.send(ParamRequestRead(1, 1, p.param_id, -1))
        (by_index,) = talk.send(ParamRequestRead(1, 1, "", p.param_index))
        assert by_name == by_index == p


def test_parameters_that_it_does_not_have_are_not_answered(talk):
    assert talk.send(ParamRequestRead(1, 1, "NONE", -1)) == []
    assert talk.send(ParamRequestRead(1, 1, "", 99)) == []
    assert talk.send(ParamSet(1, 1, "NONE", 1.0, 9)) == []


def test_a_parameter_that_is_set_is_echoed(talk):
    (echo,) = talk.send(ParamSet(1, 1, "COM_OF_LOSS_T", 2.5, 9))
    assert (echo.param_id, echo.param_value) == ("COM_OF_LOSS_T", 2.5)
    (echo,) = talk.send(ParamSet(1, 1, "NAV_RCL_ACT", to_bytes(2), 6))
    assert from_bytes(echo.param_value) == 2


@pytest.mark.parametrize("value", [-1.0, 61.0, math.nan, math.inf])
def test_a_value_out_of_range_is_answered_with_the_one_that_holds(talk, value):
    (echo,) = talk.send(ParamSet(1, 1, "COM_OF_LOSS_T", value, 9))
    assert echo.param_value == 1.0


@pytest.mark.parametrize("kind", [0, 1, 2])
def test_missions_are_empty(talk, kind):
    (count,) = talk.send(MissionRequestList(1, 1, kind))
    expected = (0, kind, 1, 195)
    assert (
        count.count,
        count.mission_type,
        count.target_system,
        count.target_component,
    ) == expected


def test_missions_can_be_cleared_and_not_uploaded(talk):
    (cleared,) = talk.send(MissionClearAll(1, 1, 0))
    (refused,) = talk.send(MissionCount(1, 1, 3, 0))
    assert isinstance(cleared, MissionAck)
    assert (cleared.type, refused.type) == (0, 4)


def test_time_is_told(talk):
    talk.fly(0.5)
    (answer,) = talk.send(Timesync(0, 12345))
    assert (answer.tc1, answer.ts1) == (talk.vehicle.now * 1000, 12345)
    assert talk.send(Timesync(answer.tc1, 12345)) == []


def test_a_ping_comes_back_to_its_sender(talk):
    (answer,) = talk.send(Ping(1, 7, 0, 0))
    assert (answer.seq, answer.target_system, answer.target_component) == (7, 1, 195)


# Bytes


def test_garbage_is_not_answered_and_costs_no_true_frame(talk):
    rng = Random(5)
    whole = Encoder(1, 195).encode(Ping(1, 7, 0, 0))
    for size in range(300):
        head = rng.choice((b"", b"\xfd", b"\xfd\xff\x00", b"\xfe\xff"))
        assert talk.send_bytes(head + rng.randbytes(size)) == []
        assert len(talk.send_bytes(head + whole)) == 1
        assert talk.send_bytes(whole[: size % len(whole)]) == []


def test_flipped_bits_are_not_answered(talk):
    whole = Encoder(1, 195).encode(Ping(1, 7, 0, 0))
    for bit in range(8, 8 * len(whole)):
        data = bytearray(whole)
        data[bit // 8] ^= 1 << bit % 8
        assert talk.send_bytes(bytes(data)) == []
