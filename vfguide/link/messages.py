"""Records of MAVLink messages: the fields of the wire, in its units, in the declared order.

Every record carries its `MSGID` and `NAME`. Fields that came to a message later (the extensions)
have their default, zero. Times `time_boot_ms` count from the start of the sender and wrap after
49.7 days; `time_usec` counts from 1970 or, at senders without a date, from their start.

Two records of different messages are equal as tuples if their values are: tell messages apart by
class, as `match` does, never by `==`.
"""

from typing import NamedTuple, get_args

Quaternion = tuple[float, float, float, float]
"""w, x, y, z; turns body FRD to NED unless a record says otherwise."""
Bytes8 = tuple[int, int, int, int, int, int, int, int]

_NO_OFFSET: Quaternion = (0.0, 0.0, 0.0, 0.0)


class Heartbeat(NamedTuple):
    """Who is there and in what mode; once a second."""

    MSGID = 0
    NAME = "HEARTBEAT"

    type: int
    """MavType."""
    autopilot: int
    """MavAutopilot."""
    base_mode: int
    """ModeFlag."""
    custom_mode: int
    """The mode in the autopilot's own encoding."""
    system_status: int
    """MavState."""
    mavlink_version: int = 3


class SysStatus(NamedTuple):
    """Health of sensors, battery and link."""

    MSGID = 1
    NAME = "SYS_STATUS"

    onboard_control_sensors_present: int
    onboard_control_sensors_enabled: int
    onboard_control_sensors_health: int
    """SysStatusSensor, all three."""
    load: int
    """Of the main loop [0.1 %]."""
    voltage_battery: int
    """[mV], 65535: unknown."""
    current_battery: int
    """[0.01 A], -1: unknown."""
    battery_remaining: int
    """[%], -1: unknown."""
    drop_rate_comm: int
    """Packets dropped [0.01 %]."""
    errors_comm: int
    errors_count1: int
    errors_count2: int
    errors_count3: int
    errors_count4: int
    onboard_control_sensors_present_extended: int = 0
    onboard_control_sensors_enabled_extended: int = 0
    onboard_control_sensors_health_extended: int = 0


class SystemTime(NamedTuple):
    """The date, where the sender knows it."""

    MSGID = 2
    NAME = "SYSTEM_TIME"

    time_unix_usec: int
    """Since 1970 [us], 0: unknown."""
    time_boot_ms: int
    """[ms]."""


class Ping(NamedTuple):
    """Asks for an echo (targets 0) or is one."""

    MSGID = 4
    NAME = "PING"

    time_usec: int
    """[us]."""
    seq: int
    target_system: int
    target_component: int


class GpsRawInt(NamedTuple):
    """What the satellite receiver says, before any estimator."""

    MSGID = 24
    NAME = "GPS_RAW_INT"

    time_usec: int
    """[us]."""
    fix_type: int
    """GpsFixType."""
    lat: int
    lon: int
    """WGS-84 [1e-7 deg]."""
    alt: int
    """Above mean sea level [mm]."""
    eph: int
    epv: int
    """Horizontal, vertical dilution of precision times 100, 65535: unknown."""
    vel: int
    """Over ground [cm/s], 65535: unknown."""
    cog: int
    """Course over ground, not heading [0.01 deg], 65535: unknown."""
    satellites_visible: int
    """255: unknown."""
    alt_ellipsoid: int = 0
    """Above the WGS-84 ellipsoid [mm]."""
    h_acc: int = 0
    v_acc: int = 0
    """Uncertainty of position and altitude [mm]."""
    vel_acc: int = 0
    """Uncertainty of speed [mm/s]."""
    hdg_acc: int = 0
    """Uncertainty of heading [1e-5 deg]."""
    yaw: int = 0
    """From north [0.01 deg], 0: not provided, 36000: north."""


class Attitude(NamedTuple):
    """Attitude of FRD against NED, as Euler angles z-y-x."""

    MSGID = 30
    NAME = "ATTITUDE"

    time_boot_ms: int
    """[ms]."""
    roll: float
    pitch: float
    yaw: float
    """[rad]."""
    rollspeed: float
    pitchspeed: float
    yawspeed: float
    """Body rates [rad/s]."""


class AttitudeQuaternion(NamedTuple):
    """Attitude of FRD against NED."""

    MSGID = 31
    NAME = "ATTITUDE_QUATERNION"

    time_boot_ms: int
    """[ms]."""
    q1: float
    q2: float
    q3: float
    q4: float
    """w, x, y, z."""
    rollspeed: float
    pitchspeed: float
    yawspeed: float
    """Body rates [rad/s]."""
    repr_offset_q: Quaternion = _NO_OFFSET
    """How to show the attitude of a tail sitter; zeros: as it is."""


class LocalPositionNed(NamedTuple):
    """Position and velocity in the autopilot's own local frame."""

    MSGID = 32
    NAME = "LOCAL_POSITION_NED"

    time_boot_ms: int
    """[ms]."""
    x: float
    y: float
    z: float
    """North, east, down of the local origin [m]."""
    vx: float
    vy: float
    vz: float
    """North, east, down [m/s]."""


class GlobalPositionInt(NamedTuple):
    """The estimated position and velocity over ground."""

    MSGID = 33
    NAME = "GLOBAL_POSITION_INT"

    time_boot_ms: int
    """[ms]."""
    lat: int
    lon: int
    """WGS-84 [1e-7 deg]."""
    alt: int
    """Above mean sea level [mm]."""
    relative_alt: int
    """Above home [mm]."""
    vx: int
    vy: int
    vz: int
    """North, east, down [cm/s]."""
    hdg: int
    """Yaw [0.01 deg], 65535: unknown."""


class VfrHud(NamedTuple):
    """What a pilot's display shows."""

    MSGID = 74
    NAME = "VFR_HUD"

    airspeed: float
    """Calibrated or indicated, never true [m/s]."""
    groundspeed: float
    """[m/s]."""
    heading: int
    """Yaw [deg]."""
    throttle: int
    """[%]."""
    alt: float
    """Above mean sea level [m]."""
    climb: float
    """[m/s]."""


class Wind(NamedTuple):
    """ArduPilot's estimate of the wind."""

    MSGID = 168
    NAME = "WIND"

    direction: float
    """Where it comes from [deg]."""
    speed: float
    """In the horizontal plane [m/s]."""
    speed_z: float
    """[m/s]."""


class WindCov(NamedTuple):
    """PX4's estimate of the wind: where it blows to; NaN: unknown."""

    MSGID = 231
    NAME = "WIND_COV"

    time_usec: int
    """[us]."""
    wind_x: float
    wind_y: float
    wind_z: float
    """North, east, down [m/s]."""
    var_horiz: float
    var_vert: float
    """Standard deviation in time [m/s]."""
    wind_alt: float
    """Above mean sea level, of this measurement [m]."""
    horiz_accuracy: float
    vert_accuracy: float
    """Standard deviation of the estimate [m/s], 0: unknown."""


class SetAttitudeTarget(NamedTuple):
    """The setpoint: attitude, body rates and thrust, each as `type_mask` allows."""

    MSGID = 82
    NAME = "SET_ATTITUDE_TARGET"

    time_boot_ms: int
    """[ms]."""
    target_system: int
    target_component: int
    type_mask: int
    """AttitudeTypeMask: what to ignore."""
    q: Quaternion
    body_roll_rate: float
    body_pitch_rate: float
    body_yaw_rate: float
    """[rad/s], FRD."""
    thrust: float
    """0 to 1."""


class AttitudeTarget(NamedTuple):
    """The setpoint that the autopilot says it flies."""

    MSGID = 83
    NAME = "ATTITUDE_TARGET"

    time_boot_ms: int
    """[ms]."""
    type_mask: int
    """AttitudeTypeMask."""
    q: Quaternion
    body_roll_rate: float
    body_pitch_rate: float
    body_yaw_rate: float
    """[rad/s], FRD."""
    thrust: float
    """0 to 1."""


class CommandLong(NamedTuple):
    """A command with seven numbers, whose units depend on the command."""

    MSGID = 76
    NAME = "COMMAND_LONG"

    target_system: int
    target_component: int
    command: int
    """MavCmd."""
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
    """MavFrame."""
    command: int
    """MavCmd."""
    current: int
    autocontinue: int
    param1: float
    param2: float
    param3: float
    param4: float
    x: int
    y: int
    """Latitude, longitude [1e-7 deg], or local [1e-4 m]."""
    z: float
    """[m]."""


class CommandAck(NamedTuple):
    """The answer to a command."""

    MSGID = 77
    NAME = "COMMAND_ACK"

    command: int
    """MavCmd."""
    result: int
    """MavResult."""
    progress: int = 0
    """[%], 255: unknown."""
    result_param2: int = 0
    target_system: int = 0
    target_component: int = 0


class ParamValue(NamedTuple):
    """One parameter and how many there are."""

    MSGID = 22
    NAME = "PARAM_VALUE"

    param_id: str
    """At most 16 characters."""
    param_value: float
    """PX4 puts the bytes of an integer here (PARAM_ENCODE_BYTEWISE), ArduPilot its value."""
    param_type: int
    """MavParamType."""
    param_count: int
    param_index: int
    """65535: sent out of turn."""


class ParamSet(NamedTuple):
    """Asks for a parameter to be changed."""

    MSGID = 23
    NAME = "PARAM_SET"

    target_system: int
    target_component: int
    param_id: str
    """At most 16 characters."""
    param_value: float
    """As in ParamValue."""
    param_type: int
    """MavParamType."""


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
    """At most 16 characters."""
    param_index: int
    """-1: by name."""


class MissionRequestList(NamedTuple):
    """Asks how many items there are."""

    MSGID = 43
    NAME = "MISSION_REQUEST_LIST"

    target_system: int
    target_component: int
    mission_type: int = 0
    """MavMissionType."""


class MissionCount(NamedTuple):
    """How many items there are, or will be sent."""

    MSGID = 44
    NAME = "MISSION_COUNT"

    target_system: int
    target_component: int
    count: int  # pyright: ignore[reportIncompatibleMethodOverride, reportAssignmentType]
    mission_type: int = 0
    """MavMissionType."""


class MissionRequest(NamedTuple):
    """Asks for one item; the deprecated form, still sent by ground stations."""

    MSGID = 40
    NAME = "MISSION_REQUEST"

    target_system: int
    target_component: int
    seq: int
    mission_type: int = 0
    """MavMissionType."""


class MissionRequestInt(NamedTuple):
    """Asks for one item."""

    MSGID = 51
    NAME = "MISSION_REQUEST_INT"

    target_system: int
    target_component: int
    seq: int
    mission_type: int = 0
    """MavMissionType."""


class MissionItemInt(NamedTuple):
    """One item of a mission, fence or list of rally points."""

    MSGID = 73
    NAME = "MISSION_ITEM_INT"

    target_system: int
    target_component: int
    seq: int
    frame: int
    """MavFrame."""
    command: int
    """MavCmd."""
    current: int
    autocontinue: int
    param1: float
    param2: float
    param3: float
    param4: float
    x: int
    y: int
    """Latitude, longitude [1e-7 deg], or local [1e-4 m]."""
    z: float
    """[m]."""
    mission_type: int = 0
    """MavMissionType."""


class MissionAck(NamedTuple):
    """Ends a transfer of items."""

    MSGID = 47
    NAME = "MISSION_ACK"

    target_system: int
    target_component: int
    type: int
    """MavMissionResult."""
    mission_type: int = 0
    """MavMissionType."""


class MissionCurrent(NamedTuple):
    """The item being flown."""

    MSGID = 42
    NAME = "MISSION_CURRENT"

    seq: int
    total: int = 0
    """65535: no mission, 0: unknown."""
    mission_state: int = 0
    """MissionState."""
    mission_mode: int = 0
    """0: unknown, 1: in a mode that flies the mission, 2: not."""


class MissionClearAll(NamedTuple):
    """Asks for all items to be deleted."""

    MSGID = 45
    NAME = "MISSION_CLEAR_ALL"

    target_system: int
    target_component: int
    mission_type: int = 0
    """MavMissionType."""


class HomePosition(NamedTuple):
    """Where the vehicle returns to; not the origin of the local frame."""

    MSGID = 242
    NAME = "HOME_POSITION"

    latitude: int
    longitude: int
    """WGS-84 [1e-7 deg]."""
    altitude: int
    """Above mean sea level [mm]."""
    x: float
    y: float
    z: float
    """In the local frame, NED [m]."""
    q: Quaternion
    """Of the surface; NaN: unknown."""
    approach_x: float
    approach_y: float
    approach_z: float
    """Where to approach from, NED [m]; NaN: unknown."""
    time_usec: int = 0
    """[us]."""


class GpsGlobalOrigin(NamedTuple):
    """The origin of the local frame."""

    MSGID = 49
    NAME = "GPS_GLOBAL_ORIGIN"

    latitude: int
    longitude: int
    """WGS-84 [1e-7 deg]."""
    altitude: int
    """Above mean sea level [mm]."""
    time_usec: int = 0
    """[us]."""


class AutopilotVersion(NamedTuple):
    """What the autopilot is and can do."""

    MSGID = 148
    NAME = "AUTOPILOT_VERSION"

    capabilities: int
    """ProtocolCapability."""
    flight_sw_version: int
    middleware_sw_version: int
    os_sw_version: int
    """Major, minor, patch, type of release: a byte each, major the highest."""
    board_version: int
    flight_custom_version: Bytes8
    middleware_custom_version: Bytes8
    os_custom_version: Bytes8
    """First bytes of the hash of the sources."""
    vendor_id: int
    product_id: int
    uid: int
    uid2: tuple[int, ...] = (0,) * 18


class ExtendedSysState(NamedTuple):
    """In the air or on the ground."""

    MSGID = 245
    NAME = "EXTENDED_SYS_STATE"

    vtol_state: int
    """VtolState."""
    landed_state: int
    """LandedState."""


class Statustext(NamedTuple):
    """A message for people."""

    MSGID = 253
    NAME = "STATUSTEXT"

    severity: int
    """MavSeverity."""
    text: str
    """At most 50 bytes of UTF-8."""
    id: int = 0
    """The same in all pieces of a longer text, 0: this is all of it."""
    chunk_seq: int = 0
    """Number of the piece."""


class Timesync(NamedTuple):
    """Two clocks compared: a question has tc1 = 0, the answer brings ts1 back."""

    MSGID = 111
    NAME = "TIMESYNC"

    tc1: int
    """The clock of who answers [ns]."""
    ts1: int
    """The clock of who asked [ns]."""


class CurrentMode(NamedTuple):
    """The mode, sooner than in the next heartbeat."""

    MSGID = 436
    NAME = "CURRENT_MODE"

    standard_mode: int
    """StandardMode."""
    custom_mode: int
    """The mode in the autopilot's own encoding."""
    intended_custom_mode: int
    """The mode last asked for, 0: unknown."""


class AvailableModes(NamedTuple):
    """One mode that the autopilot has."""

    MSGID = 435
    NAME = "AVAILABLE_MODES"

    number_modes: int
    mode_index: int
    """From 1."""
    standard_mode: int
    """StandardMode."""
    custom_mode: int
    """The mode in the autopilot's own encoding."""
    properties: int
    """ModeProperty."""
    mode_name: str
    """At most 35 bytes of UTF-8."""


class HilStateQuaternion(NamedTuple):
    """The true state of a simulated vehicle."""

    MSGID = 115
    NAME = "HIL_STATE_QUATERNION"

    time_usec: int
    """[us]."""
    attitude_quaternion: Quaternion
    rollspeed: float
    pitchspeed: float
    yawspeed: float
    """Body rates [rad/s]."""
    lat: int
    lon: int
    """WGS-84 [1e-7 deg]."""
    alt: int
    """[mm]."""
    vx: int
    vy: int
    vz: int
    """North, east, down [cm/s]."""
    ind_airspeed: int
    true_airspeed: int
    """[cm/s]."""
    xacc: int
    yacc: int
    zacc: int
    """Body FRD [0.001 g]."""


class MessageInterval(NamedTuple):
    """How often a message is sent."""

    MSGID = 244
    NAME = "MESSAGE_INTERVAL"

    message_id: int
    interval_us: int
    """[us], -1: never, 0: not available."""


class BatteryStatus(NamedTuple):
    """One battery."""

    MSGID = 147
    NAME = "BATTERY_STATUS"

    id: int
    battery_function: int
    type: int
    temperature: int
    """[0.01 degC], 32767: unknown."""
    voltages: tuple[int, ...]
    """Of cells 1 to 10 [mV], 65535: no such cell."""
    current_battery: int
    """[0.01 A], -1: unknown."""
    current_consumed: int
    """[mAh], -1: unknown."""
    energy_consumed: int
    """[100 J], -1: unknown."""
    battery_remaining: int
    """[%], -1: unknown."""
    time_remaining: int = 0
    """[s], 0: unknown."""
    charge_state: int = 0
    voltages_ext: tuple[int, int, int, int] = (0, 0, 0, 0)
    """Of cells 11 to 14 [mV], 0: no such cell."""
    mode: int = 0
    fault_bitmask: int = 0


class AdsbVehicle(NamedTuple):
    """Another aircraft, as its transponder reports."""

    MSGID = 246
    NAME = "ADSB_VEHICLE"

    ICAO_address: int
    lat: int
    lon: int
    """WGS-84 [1e-7 deg]."""
    altitude_type: int
    """AdsbAltitudeType."""
    altitude: int
    """Above mean sea level [mm]."""
    heading: int
    """Course over ground [0.01 deg]."""
    hor_velocity: int
    """[cm/s]."""
    ver_velocity: int
    """Positive up [cm/s]."""
    callsign: str
    """At most 8 characters, 9 bytes on the wire."""
    emitter_type: int
    tslc: int
    """Since the last word of it [s]."""
    flags: int
    """AdsbFlags: which fields hold."""
    squawk: int


class Collision(NamedTuple):
    """A threat that the autopilot itself has found."""

    MSGID = 247
    NAME = "COLLISION"

    src: int
    """0: ADS-B, 1: GLOBAL_POSITION_INT of another vehicle."""
    id: int
    """Of the other: its ICAO address or its system id."""
    action: int
    """What the autopilot does: 0 nothing, 1 only reports, 2.. avoids."""
    threat_level: int
    """0 none, 1 low, 2 high."""
    time_to_minimum_delta: float
    """[s]."""
    altitude_minimum_delta: float
    horizontal_minimum_delta: float
    """[m]."""


Message = (
    Heartbeat
    | SysStatus
    | SystemTime
    | Ping
    | GpsRawInt
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
