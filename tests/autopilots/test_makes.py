"""What the companion relies on in every autopilot that it can fly with."""

import pytest
from pages import ROOT

from vfguide.autopilots.makes import AUTOPILOTS, BY_MAKE, MAVLINK_VERSION, autopilot_of
from vfguide.earth.projection import geodetic_of
from vfguide.link.enums import AttitudeTypeMask, MavAutopilot, MavState, MavType, ModeFlag
from vfguide.link.messages import AttitudeQuaternion, Heartbeat, LocalPositionNed, VfrHud

RATES = (
    AttitudeTypeMask.BODY_ROLL_RATE_IGNORE
    | AttitudeTypeMask.BODY_PITCH_RATE_IGNORE
    | AttitudeTypeMask.BODY_YAW_RATE_IGNORE
)
NEEDED = {AttitudeQuaternion.MSGID, LocalPositionNed.MSGID, VfrHud.MSGID}
"""Without one of these there is no setpoint."""

every = pytest.mark.parametrize("autopilot", AUTOPILOTS, ids=lambda each: each.make.name)


@pytest.mark.parametrize("make", range(256))
def test_only_a_known_make_on_a_kind_of_vehicle_that_it_is_for_is_an_autopilot(make):
    for kind in range(256):
        found = autopilot_of(Heartbeat(kind, make, 0, 0, MavState.ACTIVE))
        if make in BY_MAKE and kind in BY_MAKE[make].kinds:
            assert found is BY_MAKE[make]
        else:
            assert found is None


@pytest.mark.parametrize("version", range(256))
def test_another_protocol_is_no_autopilot(version):
    said = Heartbeat(MavType.FIXED_WING, MavAutopilot.PX4, 0, 0, MavState.ACTIVE, version)
    assert (autopilot_of(said) is not None) == (version == MAVLINK_VERSION)


def test_no_make_is_there_twice():
    assert len(BY_MAKE) == len(AUTOPILOTS) > 0


@every
def test_it_follows_in_one_of_its_modes_and_holds_in_another(autopilot):
    modes = set(autopilot.modes)
    assert {autopilot.follow_mode, autopilot.hold_mode} <= modes
    assert autopilot.follow_mode != autopilot.hold_mode


@every
def test_every_mode_is_asked_for_in_a_way_of_its_own(autopilot):
    asked = {autopilot.mode_parameters(mode) for mode in autopilot.modes}
    assert len(asked) == len(autopilot.modes)
    for first, *others in asked:
        assert first == ModeFlag.CUSTOM_MODE_ENABLED
        assert len(others) <= 6


@every
def test_names_of_modes_fit_into_the_notes_of_the_operator(autopilot):
    assert all(mode.name.isidentifier() for mode in autopilot.modes)


@every
def test_a_setpoint_leaves_thrust_and_either_attitude_or_rates(autopilot):
    mask = autopilot.type_mask
    assert not mask & AttitudeTypeMask.THROTTLE_IGNORE
    assert not mask & AttitudeTypeMask.ATTITUDE_IGNORE or not mask & RATES


@every
def test_it_is_asked_for_all_that_a_setpoint_needs(autopilot):
    assert {stream.msgid for stream in autopilot.streams} >= NEEDED
    assert all(stream.fastest > 0.0 for stream in autopilot.streams)


@every
def test_its_local_frame_has_an_origin_and_north_ahead(autopilot):
    projection = int(autopilot.projection)
    assert geodetic_of(projection, 0.8, 0.1, 0.0, 0.0) == pytest.approx((0.8, 0.1))
    latitude, longitude = geodetic_of(projection, 0.8, 0.1, 1000.0, 0.0)
    assert latitude - 0.8 == pytest.approx(1000.0 / 6.37e6, rel=0.01)
    assert longitude == pytest.approx(0.1)


KNOW_NO_MAKE = ("companion", "surveillance", "daemon", "replay", "loop", "estimation", "control")
FILES = sorted(file for room in KNOW_NO_MAKE for file in (ROOT / "vfguide" / room).rglob("*.py"))


@pytest.mark.parametrize("file", FILES, ids=lambda file: f"{file.parent.name}/{file.stem}")
def test_what_goes_on_with_any_autopilot_names_none(file):
    words = file.read_text().lower()
    assert not [name for name in ("px4", "ardu", "offboard") if name in words]
