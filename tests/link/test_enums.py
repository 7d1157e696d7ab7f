import pytest
from pymavlink.dialects.v20 import all as dialect

from vfguide.link import enums

PREFIXES = {
    enums.MavComponent: "MAV_COMP_ID_",
    enums.MavType: "MAV_TYPE_",
    enums.MavAutopilot: "MAV_AUTOPILOT_",
    enums.MavState: "MAV_STATE_",
    enums.ModeFlag: "MAV_MODE_FLAG_",
    enums.AttitudeTypeMask: "ATTITUDE_TARGET_TYPEMASK_",
    enums.MavCmd: "MAV_CMD_",
    enums.MavResult: "MAV_RESULT_",
    enums.MavFrame: "MAV_FRAME_",
    enums.MavMissionType: "MAV_MISSION_TYPE_",
    enums.MavMissionResult: "MAV_MISSION_",
    enums.MissionState: "MISSION_STATE_",
    enums.MavParamType: "MAV_PARAM_TYPE_",
    enums.LandedState: "MAV_LANDED_STATE_",
    enums.VtolState: "MAV_VTOL_STATE_",
    enums.MavSeverity: "MAV_SEVERITY_",
    enums.GpsFixType: "GPS_FIX_TYPE_",
    enums.SysStatusSensor: "MAV_SYS_STATUS_",
    enums.ProtocolCapability: "MAV_PROTOCOL_CAPABILITY_",
    enums.StandardMode: "MAV_STANDARD_MODE_",
    enums.ModeProperty: "MAV_MODE_PROPERTY_",
    enums.AdsbAltitudeType: "ADSB_ALTITUDE_TYPE_",
    enums.AdsbFlags: "ADSB_FLAGS_",
}
MEMBERS = [member for enumeration in PREFIXES for member in enumeration]


def test_none_is_left_out():
    ours = {
        e for e in vars(enums).values() if isinstance(e, type) and e.__module__ == enums.__name__
    }
    assert ours == set(PREFIXES)


@pytest.mark.parametrize("member", MEMBERS, ids=str)
def test_value_is_that_of_pymavlink(member):
    prefix = PREFIXES[type(member)]
    assert getattr(dialect, prefix + member.name.removeprefix(prefix)) == member
