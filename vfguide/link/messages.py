"""Records of MAVLink messages: the fields of the wire, in its units, in the declared order.

Every record carries its `MSGID` and `NAME`. Fields that came to a message later (the extensions)
have their default, zero. Times `time_boot_ms` count from the start of the sender and wrap after
49.7 days; `time_usec` counts from 1970 or, at senders without a date, from their start. The fields
`target_system` and `target_component` are whom a message is for; 0 is everybody.

Two records of different messages are equal as tuples if their values are: tell messages apart by
class, as `match` does, never by `==`.
"""

from typing import NamedTuple, get_args

Quaternion = tuple[float, float, float, float]
"""w, x, y, z; turns body FRD to NED unless a record says otherwise."""
Bytes8 = tuple[int, int, int, int, int, int, int, int]
"""Eight bytes, 0 to 255 each."""

_NO_OFFSET: Quaternion = (0.0, 0.0, 0.0, 0.0)


class Heartbeat(NamedTuple):
    """Who is there and in what mode; once a second."""

    MSGID = 0
    NAME = "HEARTBEAT"

    type: int
    """Kind of vehicle or station, a MavType."""
    autopilot: int
    """Make, a MavAutopilot."""
    base_mode: int
    """Flags of ModeFlag."""
    custom_mode: int
    """The mode in the autopilot's own encoding."""
    system_status: int
    """State, a MavState."""
    mavlink_version: int = 3
    """Version of the protocol that the sender says, a number."""


class SysStatus(NamedTuple):
    """Health of sensors, battery and link."""

    MSGID = 1
    NAME = "SYS_STATUS"

    onboard_control_sensors_present: int
    """Sensors that are there, flags of SysStatusSensor."""
    onboard_control_sensors_enabled: int
    """Sensors that are enabled, flags of SysStatusSensor."""
    onboard_control_sensors_health: int
    """Sensors that are healthy, flags of SysStatusSensor."""
    load: int
    """Load of the main loop [0.1 %]."""
    voltage_battery: int
    """Voltage of the battery [mV], 65535: unknown."""
    current_battery: int
    """Current of the battery [0.01 A], -1: unknown."""
    battery_remaining: int
    """Charge that is left [%], -1: unknown."""
    drop_rate_comm: int
    """Packets dropped [0.01 %]."""
    errors_comm: int
    """Number of packets that were received broken."""
    errors_count1: int
    """Number of errors, of a kind that the autopilot chooses."""
    errors_count2: int
    """Number of errors, of a kind that the autopilot chooses."""
    errors_count3: int
    """Number of errors, of a kind that the autopilot chooses."""
    errors_count4: int
    """Number of errors, of a kind that the autopilot chooses."""
    onboard_control_sensors_present_extended: int = 0
    """Further sensors that are there, flags."""
    onboard_control_sensors_enabled_extended: int = 0
    """Further sensors that are enabled, flags."""
    onboard_control_sensors_health_extended: int = 0
    """Further sensors that are healthy, flags."""


class SystemTime(NamedTuple):
    """The date, where the sender knows it."""

    MSGID = 2
    NAME = "SYSTEM_TIME"

    time_unix_usec: int
    """Time since 1970 [us], 0: unknown."""
    time_boot_ms: int
    """Time since the start of the sender [ms]."""


class Ping(NamedTuple):
    """Asks for an echo (targets 0) or is one."""

    MSGID = 4
    NAME = "PING"

    time_usec: int
    """Date, or time since the start of a sender without one [us]."""
    seq: int
    """Number of the question, which its echo repeats."""
    target_system: int
    target_component: int


class GpsRawInt(NamedTuple):
    """What the satellite receiver says, before any estimator."""

    MSGID = 24
    NAME = "GPS_RAW_INT"

    time_usec: int
    """Date, or time since the start of a sender without one [us]."""
    fix_type: int
    """Kind of fix, a GpsFixType."""
    lat: int
    """Latitude, WGS-84 [1e-7 deg]."""
    lon: int
    """Longitude, WGS-84 [1e-7 deg]."""
    alt: int
    """Altitude above mean sea level [mm]."""
    eph: int
    """Horizontal dilution of precision times 100, 65535: unknown."""
    epv: int
    """Vertical dilution of precision times 100, 65535: unknown."""
    vel: int
    """Speed over ground [cm/s], 65535: unknown."""
    cog: int
    """Course over ground, not heading [0.01 deg], 65535: unknown."""
    satellites_visible: int
    """Number of satellites, 255: unknown."""
    alt_ellipsoid: int = 0
    """Altitude above the WGS-84 ellipsoid [mm]."""
    h_acc: int = 0
    """Uncertainty of the position [mm]."""
    v_acc: int = 0
    """Uncertainty of the altitude [mm]."""
    vel_acc: int = 0
    """Uncertainty of speed [mm/s]."""
    hdg_acc: int = 0
    """Uncertainty of heading [1e-5 deg]."""
    yaw: int = 0
    """Yaw from north [0.01 deg], 0: not provided, 36000: north."""


class ScaledPressure(NamedTuple):
    """Pressure of the air where the autopilot is."""

    MSGID = 29
    NAME = "SCALED_PRESSURE"

    time_boot_ms: int
    """Time since the start [ms]."""
    press_abs: float
    """Absolute pressure [hPa]."""
    press_diff: float
    """Differential pressure [hPa]."""
    temperature: int
    """Temperature of the absolute pressure sensor [0.01 degC]."""
    temperature_press_diff: int = 0
    """Temperature of the differential pressure sensor [0.01 degC], 0: unknown."""


class Attitude(NamedTuple):
    """Attitude of FRD against NED, as Euler angles z-y-x."""

    MSGID = 30
    NAME = "ATTITUDE"

    time_boot_ms: int
    """Time since the start of the sender [ms]."""
    roll: float
    """Roll [rad]."""
    pitch: float
    """Pitch [rad]."""
    yaw: float
    """Yaw from north [rad]."""
    rollspeed: float
    """Body rate about x, FRD [rad/s]."""
    pitchspeed: float
    """Body rate about y, FRD [rad/s]."""
    yawspeed: float
    """Body rate about z, FRD [rad/s]."""


class AttitudeQuaternion(NamedTuple):
    """Attitude of FRD against NED."""

    MSGID = 31
    NAME = "ATTITUDE_QUATERNION"

    time_boot_ms: int
    """Time since the start of the sender [ms]."""
    q1: float
    """Quaternion of the attitude, w."""
    q2: float
    """Quaternion of the attitude, x."""
    q3: float
    """Quaternion of the attitude, y."""
    q4: float
    """Quaternion of the attitude, z."""
    rollspeed: float
    """Body rate about x, FRD [rad/s]."""
    pitchspeed: float
    """Body rate about y, FRD [rad/s]."""
    yawspeed: float
    """Body rate about z, FRD [rad/s]."""
    repr_offset_q: Quaternion = _NO_OFFSET
    """How to show the attitude of a tail sitter; zeros: as it is."""


class LocalPositionNed(NamedTuple):
    """Position and velocity in the autopilot's own local frame."""

    MSGID = 32
    NAME = "LOCAL_POSITION_NED"

    time_boot_ms: int
    """Time since the start of the sender [ms]."""
    x: float
    """North of the local origin [m]."""
    y: float
    """East of the local origin [m]."""
    z: float
    """Down from the local origin [m]."""
    vx: float
    """Velocity over ground to the north [m/s]."""
    vy: float
    """Velocity over ground to the east [m/s]."""
    vz: float
    """Velocity over ground downwards [m/s]."""


class GlobalPositionInt(NamedTuple):
    """The estimated position and velocity over ground."""

    MSGID = 33
    NAME = "GLOBAL_POSITION_INT"

    time_boot_ms: int
    """Time since the start of the sender [ms]."""
    lat: int
    """Latitude, WGS-84 [1e-7 deg]."""
    lon: int
    """Longitude, WGS-84 [1e-7 deg]."""
    alt: int
    """Altitude above mean sea level [mm]."""
    relative_alt: int
    """Altitude above home [mm]."""
    vx: int
    """Velocity over ground to the north [cm/s]."""
    vy: int
    """Velocity over ground to the east [cm/s]."""
    vz: int
    """Velocity over ground downwards [cm/s]."""
    hdg: int
    """Yaw from north [0.01 deg], 65535: unknown."""


class VfrHud(NamedTuple):
    """What a pilot's display shows."""

    MSGID = 74
    NAME = "VFR_HUD"

    airspeed: float
    """Calibrated or indicated airspeed, never the true one [m/s]."""
    groundspeed: float
    """Speed over ground [m/s]."""
    heading: int
    """Yaw from north [deg]."""
    throttle: int
    """Throttle [%]."""
    alt: float
    """Altitude above mean sea level [m]."""
    climb: float
    """Vertical speed, up positive [m/s]."""


class Wind(NamedTuple):
    """ArduPilot's estimate of the wind."""

    MSGID = 168
    NAME = "WIND"

    direction: float
    """Direction that the wind comes from [deg]."""
    speed: float
    """Speed in the horizontal plane [m/s]."""
    speed_z: float
    """Vertical speed [m/s]."""


class WindCov(NamedTuple):
    """PX4's estimate of the wind: where it blows to; NaN: unknown."""

    MSGID = 231
    NAME = "WIND_COV"

    time_usec: int
    """Date, or time since the start of a sender without one [us]."""
    wind_x: float
    """Wind to the north [m/s]."""
    wind_y: float
    """Wind to the east [m/s]."""
    wind_z: float
    """Wind downwards [m/s]."""
    var_horiz: float
    """Standard deviation of the horizontal wind in time [m/s]."""
    var_vert: float
    """Standard deviation of the vertical wind in time [m/s]."""
    wind_alt: float
    """Altitude of this measurement above mean sea level [m]."""
    horiz_accuracy: float
    """Standard deviation of the estimate of the horizontal wind [m/s], 0: unknown."""
    vert_accuracy: float
    """Standard deviation of the estimate of the vertical wind [m/s], 0: unknown."""


class SetAttitudeTarget(NamedTuple):
    """The setpoint: attitude, body rates and thrust, each as `type_mask` allows."""

    MSGID = 82
    NAME = "SET_ATTITUDE_TARGET"

    time_boot_ms: int
    """Time since the start of the sender [ms]."""
    target_system: int
    target_component: int
    type_mask: int
    """What to ignore, flags of AttitudeTypeMask."""
    q: Quaternion
    """Attitude."""
    body_roll_rate: float
    """Body rate about x, FRD [rad/s]."""
    body_pitch_rate: float
    """Body rate about y, FRD [rad/s]."""
    body_yaw_rate: float
    """Body rate about z, FRD [rad/s]."""
    thrust: float
    """Thrust, 0 to 1."""


class AttitudeTarget(NamedTuple):
    """The setpoint that the autopilot says it flies."""

    MSGID = 83
    NAME = "ATTITUDE_TARGET"

    time_boot_ms: int
    """Time since the start of the sender [ms]."""
    type_mask: int
    """What it ignores, flags of AttitudeTypeMask."""
    q: Quaternion
    """Attitude."""
    body_roll_rate: float
    """Body rate about x, FRD [rad/s]."""
    body_pitch_rate: float
    """Body rate about y, FRD [rad/s]."""
    body_yaw_rate: float
    """Body rate about z, FRD [rad/s]."""
    thrust: float
    """Thrust, 0 to 1."""


class CommandLong(NamedTuple):
    """A command with seven numbers, whose units depend on the command."""

    MSGID = 76
    NAME = "COMMAND_LONG"

    target_system: int
    target_component: int
    command: int
    """The command, a MavCmd."""
    confirmation: int
    """0 at first, then the number of the repetition."""
    param1: float
    param2: float
    param3: float
    param4: float
    param5: float
    param6: float
    param7: float


class CommandInt(NamedTuple):
    """A command with a place."""

    MSGID = 75
    NAME = "COMMAND_INT"

    target_system: int
    target_component: int
    frame: int
    """Frame of the place, a MavFrame."""
    command: int
    """The command, a MavCmd."""
    current: int
    """Not used."""
    autocontinue: int
    """Not used."""
    param1: float
    param2: float
    param3: float
    param4: float
    x: int
    """Latitude [1e-7 deg], or local x [1e-4 m]."""
    y: int
    """Longitude [1e-7 deg], or local y [1e-4 m]."""
    z: float
    """Altitude or local z, as `frame` has it [m]."""


class CommandAck(NamedTuple):
    """The answer to a command."""

    MSGID = 77
    NAME = "COMMAND_ACK"

    command: int
    """The command that is answered, a MavCmd."""
    result: int
    """What became of it, a MavResult."""
    progress: int = 0
    """Progress of a command that takes long [%], 255: unknown."""
    result_param2: int = 0
    """A number that depends on the command."""
    target_system: int = 0
    target_component: int = 0


class ParamValue(NamedTuple):
    """One parameter and how many there are."""

    MSGID = 22
    NAME = "PARAM_VALUE"

    param_id: str
    """Name, at most 16 characters."""
    param_value: float
    """PX4 puts the bytes of an integer here (PARAM_ENCODE_BYTEWISE), ArduPilot its value."""
    param_type: int
    """Type of the value, a MavParamType."""
    param_count: int
    """Number of all parameters."""
    param_index: int
    """Index of this one from 0, 65535: sent out of turn."""


class ParamSet(NamedTuple):
    """Asks for a parameter to be changed."""

    MSGID = 23
    NAME = "PARAM_SET"

    target_system: int
    target_component: int
    param_id: str
    """Name, at most 16 characters."""
    param_value: float
    """New value, as in ParamValue."""
    param_type: int
    """Type of the value, a MavParamType."""


class ParamRequestList(NamedTuple):
    """Asks for all parameters."""

    MSGID = 21
    NAME = "PARAM_REQUEST_LIST"

    target_system: int
    target_component: int


class ParamRequestRead(NamedTuple):
    """Asks for one parameter, by name or by index."""

    MSGID = 20
    NAME = "PARAM_REQUEST_READ"

    target_system: int
    target_component: int
    param_id: str
    """Name, at most 16 characters."""
    param_index: int
    """Index from 0, -1: by name."""


class MissionRequestList(NamedTuple):
    """Asks how many items there are."""

    MSGID = 43
    NAME = "MISSION_REQUEST_LIST"

    target_system: int
    target_component: int
    mission_type: int = 0
    """What the items are, a MavMissionType."""


class MissionCount(NamedTuple):
    """How many items there are, or will be sent."""

    MSGID = 44
    NAME = "MISSION_COUNT"

    target_system: int
    target_component: int
    count: int  # pyright: ignore[reportIncompatibleMethodOverride, reportAssignmentType]
    """Number of items."""
    mission_type: int = 0
    """What the items are, a MavMissionType."""


class MissionRequest(NamedTuple):
    """Asks for one item; the deprecated form, still sent by ground stations."""

    MSGID = 40
    NAME = "MISSION_REQUEST"

    target_system: int
    target_component: int
    seq: int
    """Number of the item from 0."""
    mission_type: int = 0
    """What the items are, a MavMissionType."""


class MissionRequestInt(NamedTuple):
    """Asks for one item."""

    MSGID = 51
    NAME = "MISSION_REQUEST_INT"

    target_system: int
    target_component: int
    seq: int
    """Number of the item from 0."""
    mission_type: int = 0
    """What the items are, a MavMissionType."""


class MissionItemInt(NamedTuple):
    """One item of a mission, fence or list of rally points."""

    MSGID = 73
    NAME = "MISSION_ITEM_INT"

    target_system: int
    target_component: int
    seq: int
    """Number of the item from 0."""
    frame: int
    """Frame of the place, a MavFrame."""
    command: int
    """What to do there, a MavCmd."""
    current: int
    """1: the item that is flown, 0: another."""
    autocontinue: int
    """1: the next item follows by itself, 0: it does not."""
    param1: float
    param2: float
    param3: float
    param4: float
    x: int
    """Latitude [1e-7 deg], or local x [1e-4 m]."""
    y: int
    """Longitude [1e-7 deg], or local y [1e-4 m]."""
    z: float
    """Altitude or local z, as `frame` has it [m]."""
    mission_type: int = 0
    """What the items are, a MavMissionType."""


class MissionAck(NamedTuple):
    """Ends a transfer of items."""

    MSGID = 47
    NAME = "MISSION_ACK"

    target_system: int
    target_component: int
    type: int
    """How it ended, a MavMissionResult."""
    mission_type: int = 0
    """What the items are, a MavMissionType."""


class MissionCurrent(NamedTuple):
    """The item being flown."""

    MSGID = 42
    NAME = "MISSION_CURRENT"

    seq: int
    """Number of the item from 0."""
    total: int = 0
    """Number of items; 65535: no mission, 0: unknown."""
    mission_state: int = 0
    """State of the mission, a MissionState."""
    mission_mode: int = 0
    """Whether it is in a mode that flies the mission; 0: unknown, 1: it is, 2: it is not."""


class MissionClearAll(NamedTuple):
    """Asks for all items to be deleted."""

    MSGID = 45
    NAME = "MISSION_CLEAR_ALL"

    target_system: int
    target_component: int
    mission_type: int = 0
    """What the items are, a MavMissionType."""


class HomePosition(NamedTuple):
    """Where the vehicle returns to; not the origin of the local frame."""

    MSGID = 242
    NAME = "HOME_POSITION"

    latitude: int
    """Latitude, WGS-84 [1e-7 deg]."""
    longitude: int
    """Longitude, WGS-84 [1e-7 deg]."""
    altitude: int
    """Altitude above mean sea level [mm]."""
    x: float
    """North of the local origin [m]."""
    y: float
    """East of the local origin [m]."""
    z: float
    """Down from the local origin [m]."""
    q: Quaternion
    """Attitude of the surface; NaN: unknown."""
    approach_x: float
    """Where to approach from, to the north [m]; NaN: unknown."""
    approach_y: float
    """Where to approach from, to the east [m]; NaN: unknown."""
    approach_z: float
    """Where to approach from, downwards [m]; NaN: unknown."""
    time_usec: int = 0
    """Date, or time since the start of a sender without one [us]."""


class GpsGlobalOrigin(NamedTuple):
    """The origin of the local frame."""

    MSGID = 49
    NAME = "GPS_GLOBAL_ORIGIN"

    latitude: int
    """Latitude, WGS-84 [1e-7 deg]."""
    longitude: int
    """Longitude, WGS-84 [1e-7 deg]."""
    altitude: int
    """Altitude above mean sea level [mm]."""
    time_usec: int = 0
    """Date, or time since the start of a sender without one [us]."""


class AutopilotVersion(NamedTuple):
    """What the autopilot is and can do."""

    MSGID = 148
    NAME = "AUTOPILOT_VERSION"

    capabilities: int
    """What it can do, flags of ProtocolCapability."""
    flight_sw_version: int
    """Version of the autopilot, bytes from the highest: major, minor, patch, type of release."""
    middleware_sw_version: int
    """Version of what it runs on, likewise."""
    os_sw_version: int
    """Version of its operating system, likewise."""
    board_version: int
    """Version of the board, as its maker counts."""
    flight_custom_version: Bytes8
    """First bytes of the hash of the autopilot's sources."""
    middleware_custom_version: Bytes8
    """First bytes of the hash of the sources of what it runs on."""
    os_custom_version: Bytes8
    """First bytes of the hash of the operating system's sources."""
    vendor_id: int
    """Number of the maker of the board."""
    product_id: int
    """Number of the board."""
    uid: int
    """Unique number of the board."""
    uid2: tuple[int, ...] = (0,) * 18
    """Longer unique number of the board; it counts where it is not 0."""


class ExtendedSysState(NamedTuple):
    """In the air or on the ground."""

    MSGID = 245
    NAME = "EXTENDED_SYS_STATE"

    vtol_state: int
    """State of a VTOL aircraft, a VtolState."""
    landed_state: int
    """In the air or on the ground, a LandedState."""


class Statustext(NamedTuple):
    """A message for people."""

    MSGID = 253
    NAME = "STATUSTEXT"

    severity: int
    """How grave it is, a MavSeverity."""
    text: str
    """The text, at most 50 bytes of UTF-8."""
    id: int = 0
    """Number of a longer text, the same in all its pieces, 0: this is all of it."""
    chunk_seq: int = 0
    """Number of the piece from 0."""


class Timesync(NamedTuple):
    """Two clocks compared: a question has tc1 = 0, the answer brings ts1 back."""

    MSGID = 111
    NAME = "TIMESYNC"

    tc1: int
    """Time on the clock of who answers [ns], 0 in a question."""
    ts1: int
    """Time on the clock of who asked [ns]."""


class CurrentMode(NamedTuple):
    """The mode, sooner than in the next heartbeat."""

    MSGID = 436
    NAME = "CURRENT_MODE"

    standard_mode: int
    """The mode in a common encoding, a StandardMode."""
    custom_mode: int
    """The mode in the autopilot's own encoding."""
    intended_custom_mode: int
    """The mode last asked for, 0: unknown."""


class AvailableModes(NamedTuple):
    """One mode that the autopilot has."""

    MSGID = 435
    NAME = "AVAILABLE_MODES"

    number_modes: int
    """Number of modes."""
    mode_index: int
    """Index of this one from 1."""
    standard_mode: int
    """The mode in a common encoding, a StandardMode."""
    custom_mode: int
    """The mode in the autopilot's own encoding."""
    properties: int
    """Properties, flags of ModeProperty."""
    mode_name: str
    """Name, at most 35 bytes of UTF-8."""


class HilStateQuaternion(NamedTuple):
    """The true state of a simulated vehicle."""

    MSGID = 115
    NAME = "HIL_STATE_QUATERNION"

    time_usec: int
    """Date, or time since the start of a sender without one [us]."""
    attitude_quaternion: Quaternion
    """Attitude."""
    rollspeed: float
    """Body rate about x, FRD [rad/s]."""
    pitchspeed: float
    """Body rate about y, FRD [rad/s]."""
    yawspeed: float
    """Body rate about z, FRD [rad/s]."""
    lat: int
    """Latitude, WGS-84 [1e-7 deg]."""
    lon: int
    """Longitude, WGS-84 [1e-7 deg]."""
    alt: int
    """Altitude [mm]."""
    vx: int
    """Velocity over ground to the north [cm/s]."""
    vy: int
    """Velocity over ground to the east [cm/s]."""
    vz: int
    """Velocity over ground downwards [cm/s]."""
    ind_airspeed: int
    """Indicated airspeed [cm/s]."""
    true_airspeed: int
    """True airspeed [cm/s]."""
    xacc: int
    """Acceleration along x, FRD [0.001 g]."""
    yacc: int
    """Acceleration along y, FRD [0.001 g]."""
    zacc: int
    """Acceleration along z, FRD [0.001 g]."""


class MessageInterval(NamedTuple):
    """How often a message is sent."""

    MSGID = 244
    NAME = "MESSAGE_INTERVAL"

    message_id: int
    """Id of the message."""
    interval_us: int
    """Time between two of them [us], -1: never, 0: not available."""


class BatteryStatus(NamedTuple):
    """One battery."""

    MSGID = 147
    NAME = "BATTERY_STATUS"

    id: int
    """Number of the battery."""
    battery_function: int
    """What it feeds, a number of MAV_BATTERY_FUNCTION."""
    type: int
    """Its chemistry, a number of MAV_BATTERY_TYPE."""
    temperature: int
    """Temperature [0.01 degC], 32767: unknown."""
    voltages: tuple[int, ...]
    """Voltages of cells 1 to 10 [mV], 65535: no such cell."""
    current_battery: int
    """Current [0.01 A], -1: unknown."""
    current_consumed: int
    """Charge consumed [mAh], -1: unknown."""
    energy_consumed: int
    """Energy consumed [100 J], -1: unknown."""
    battery_remaining: int
    """Charge that is left [%], -1: unknown."""
    time_remaining: int = 0
    """Time until it is empty [s], 0: unknown."""
    charge_state: int = 0
    """State of charge, a number of MAV_BATTERY_CHARGE_STATE."""
    voltages_ext: tuple[int, int, int, int] = (0, 0, 0, 0)
    """Voltages of cells 11 to 14 [mV], 0: no such cell."""
    mode: int = 0
    """Mode, a number of MAV_BATTERY_MODE."""
    fault_bitmask: int = 0
    """Faults, flags of MAV_BATTERY_FAULT."""


class AdsbVehicle(NamedTuple):
    """Another aircraft, as its transponder reports."""

    MSGID = 246
    NAME = "ADSB_VEHICLE"

    ICAO_address: int
    """ICAO address of the transponder, 24 bits."""
    lat: int
    """Latitude, WGS-84 [1e-7 deg]."""
    lon: int
    """Longitude, WGS-84 [1e-7 deg]."""
    altitude_type: int
    """What the altitude is measured from, an AdsbAltitudeType."""
    altitude: int
    """Altitude above mean sea level [mm]."""
    heading: int
    """Course over ground [0.01 deg]."""
    hor_velocity: int
    """Speed over ground [cm/s]."""
    ver_velocity: int
    """Vertical speed, up positive [cm/s]."""
    callsign: str
    """Callsign, at most 8 characters, 9 bytes on the wire."""
    emitter_type: int
    """Kind of aircraft, a number of ADSB_EMITTER_TYPE."""
    tslc: int
    """Time since its last word [s]."""
    flags: int
    """Which fields hold, flags of AdsbFlags."""
    squawk: int
    """Squawk code, a number."""


class Collision(NamedTuple):
    """A threat that the autopilot itself has found."""

    MSGID = 247
    NAME = "COLLISION"

    src: int
    """Where it is known from; 0: ADS-B, 1: GLOBAL_POSITION_INT of another vehicle."""
    id: int
    """Number of the other, its ICAO address or its system id."""
    action: int
    """What the autopilot does: 0 nothing, 1 only reports, 2.. avoids."""
    threat_level: int
    """Threat; 0: none, 1: low, 2: high."""
    time_to_minimum_delta: float
    """Time until the other is nearest [s]."""
    altitude_minimum_delta: float
    """Vertical distance then [m]."""
    horizontal_minimum_delta: float
    """Horizontal distance then [m]."""


Message = (
    Heartbeat
    | SysStatus
    | SystemTime
    | Ping
    | GpsRawInt
    | ScaledPressure
    | Attitude
    | AttitudeQuaternion
    | LocalPositionNed
    | GlobalPositionInt
    | VfrHud
    | Wind
    | WindCov
    | SetAttitudeTarget
    | AttitudeTarget
    | CommandLong
    | CommandInt
    | CommandAck
    | ParamValue
    | ParamSet
    | ParamRequestList
    | ParamRequestRead
    | MissionRequestList
    | MissionCount
    | MissionRequest
    | MissionRequestInt
    | MissionItemInt
    | MissionAck
    | MissionCurrent
    | MissionClearAll
    | HomePosition
    | GpsGlobalOrigin
    | AutopilotVersion
    | ExtendedSysState
    | Statustext
    | Timesync
    | CurrentMode
    | AvailableModes
    | HilStateQuaternion
    | MessageInterval
    | BatteryStatus
    | AdsbVehicle
    | Collision
)

RECORDS: tuple[type[Message], ...] = get_args(Message)
"""The class of every message that the codec reads and writes."""
