"""PX4's numbers, against those that others wrote down."""

import pytest
from pymavlink import mavutil

from vfguide.autopilots.px4 import PX4, Px4Mode, main_and_sub, mode_parameters
from vfguide.link.messages import AttitudeQuaternion, LocalPositionNed, VfrHud, WindCov

PYMAVLINK = {
    Px4Mode.MANUAL: "MANUAL",
    Px4Mode.ALTCTL: "ALTCTL",
    Px4Mode.POSCTL: "POSCTL",
    Px4Mode.TAKEOFF: "TAKEOFF",
    Px4Mode.HOLD: "LOITER",
    Px4Mode.MISSION: "MISSION",
    Px4Mode.RETURN: "RTL",
    Px4Mode.LAND: "LAND",
    Px4Mode.ACRO: "ACRO",
    Px4Mode.OFFBOARD: "OFFBOARD",
    Px4Mode.STABILIZED: "STABILIZED",
}
"""What pymavlink calls the modes."""
LOGGED = {
    Px4Mode.OFFBOARD: 393216,
    Px4Mode.HOLD: 50593792,
    Px4Mode.RETURN: 84148224,
    Px4Mode.TAKEOFF: 33816576,
}
"""Numbers in heartbeats of PX4 1.17.0."""


def test_no_mode_is_left_out():
    assert set(PYMAVLINK) == set(Px4Mode)


@pytest.mark.parametrize("mode", Px4Mode, ids=lambda mode: mode.name)
def test_a_mode_has_the_main_and_sub_number_of_pymavlink(mode):
    _, main, sub = mavutil.px4_map[PYMAVLINK[mode]]
    assert main_and_sub(mode) == (main, sub)
    assert mode_parameters(mode) == (1, main, sub)


@pytest.mark.parametrize("mode", LOGGED, ids=lambda mode: mode.name)
def test_a_mode_is_what_px4_sends(mode):
    assert mode == LOGGED[mode]


@pytest.mark.parametrize("mode", Px4Mode, ids=lambda mode: mode.name)
def test_the_operator_reads_the_name_of_a_mode(mode):
    assert PX4.mode_name(int(mode)) == mode.name


def test_the_operator_reads_the_number_of_a_mode_without_a_name():
    assert PX4.mode_name(77) == "mode 77"


def test_it_follows_offboard_and_is_left_in_hold():
    assert (PX4.follow_mode, PX4.hold_mode) == (Px4Mode.OFFBOARD, Px4Mode.HOLD)


def test_its_setpoint_is_body_rates_and_thrust():
    assert PX4.type_mask == 0x80


def test_its_streams_are_asked_for_with_the_attitude_last():
    """What guides on the arrival of the attitude then has the rest of the same instant."""
    asked = [stream.msgid for stream in PX4.streams]
    kinds = (LocalPositionNed, VfrHud, WindCov, AttitudeQuaternion)
    assert asked == [kind.MSGID for kind in kinds]
