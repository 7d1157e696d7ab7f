"""The numbers of MAVLink that have names; members are named as there, without the prefix.

Fields of records hold plain integers, since a peer may send a value that has no name.
"""

from enum import IntEnum, IntFlag


class MavComponent(IntEnum):
    """MAV_COMP_ID: parts of a system."""

    ALL = 0
    AUTOPILOT1 = 1
    ADSB = 156
    FLARM = 160
    MISSIONPLANNER = 190
    ONBOARD_COMPUTER = 191
    PATHPLANNER = 195
    OBSTACLE_AVOIDANCE = 196


class MavType(IntEnum):
    """MAV_TYPE: kinds of vehicles and of parts."""

    GENERIC = 0
    FIXED_WING = 1
    QUADROTOR = 2
    HELICOPTER = 4
    GCS = 6
    HEXAROTOR = 13
    OCTOROTOR = 14
    ONBOARD_CONTROLLER = 18
    VTOL_DUOROTOR = 19
    VTOL_QUADROTOR = 20
    VTOL_TILTROTOR = 21
    VTOL_RESERVED2 = 22
    VTOL_RESERVED3 = 23
    VTOL_RESERVED4 = 24
    VTOL_RESERVED5 = 25
    GIMBAL = 26
    ADSB = 27
    CAMERA = 30
    FLARM = 32


class MavAutopilot(IntEnum):
    """MAV_AUTOPILOT: makes of autopilots."""

    GENERIC = 0
    ARDUPILOTMEGA = 3
    INVALID = 8
    """Not an autopilot."""
    PX4 = 12


class MavState(IntEnum):
    """MAV_STATE: how a system is."""

    UNINIT = 0
    BOOT = 1
    CALIBRATING = 2
    STANDBY = 3
    ACTIVE = 4
    CRITICAL = 5
    """Lost something, still navigates: a failsafe."""
    EMERGENCY = 6
    POWEROFF = 7
    FLIGHT_TERMINATION = 8


class ModeFlag(IntFlag):
    """MAV_MODE_FLAG: bits of `base_mode`."""

    CUSTOM_MODE_ENABLED = 1
    TEST_ENABLED = 2
    AUTO_ENABLED = 4
    GUIDED_ENABLED = 8
    STABILIZE_ENABLED = 16
    HIL_ENABLED = 32
    MANUAL_INPUT_ENABLED = 64
    SAFETY_ARMED = 128


class AttitudeTypeMask(IntFlag):
    """ATTITUDE_TARGET_TYPEMASK: what a setpoint asks to ignore."""

    BODY_ROLL_RATE_IGNORE = 1
    BODY_PITCH_RATE_IGNORE = 2
    BODY_YAW_RATE_IGNORE = 4
    THROTTLE_IGNORE = 64
    ATTITUDE_IGNORE = 128


class MavCmd(IntEnum):
    """MAV_CMD: commands, and items of missions, fences and rally points."""

    NAV_WAYPOINT = 16
    NAV_LOITER_UNLIM = 17
    NAV_LOITER_TURNS = 18
    NAV_LOITER_TIME = 19
    NAV_RETURN_TO_LAUNCH = 20
    NAV_LAND = 21
    NAV_TAKEOFF = 22
    NAV_LOITER_TO_ALT = 31
    DO_SET_MODE = 176
    DO_JUMP = 177
    DO_CHANGE_SPEED = 178
    DO_SET_HOME = 179
    DO_FLIGHTTERMINATION = 185
    DO_LAND_START = 189
    DO_REPOSITION = 192
    DO_FENCE_ENABLE = 207
    DO_SET_STANDARD_MODE = 262
    MISSION_START = 300
    COMPONENT_ARM_DISARM = 400
    GET_HOME_POSITION = 410
    GET_MESSAGE_INTERVAL = 510
    SET_MESSAGE_INTERVAL = 511
    REQUEST_MESSAGE = 512
    REQUEST_PROTOCOL_VERSION = 519
    REQUEST_AUTOPILOT_CAPABILITIES = 520
    NAV_FENCE_RETURN_POINT = 5000
    NAV_FENCE_POLYGON_VERTEX_INCLUSION = 5001
    NAV_FENCE_POLYGON_VERTEX_EXCLUSION = 5002
    NAV_FENCE_CIRCLE_INCLUSION = 5003
    NAV_FENCE_CIRCLE_EXCLUSION = 5004
    NAV_RALLY_POINT = 5100


class MavResult(IntEnum):
    """MAV_RESULT: answers to commands."""

    ACCEPTED = 0
    TEMPORARILY_REJECTED = 1
    DENIED = 2
    UNSUPPORTED = 3
    FAILED = 4
    IN_PROGRESS = 5
    COMMAND_LONG_ONLY = 7
    COMMAND_INT_ONLY = 8


class MavFrame(IntEnum):
    """MAV_FRAME: frames of positions; "relative" is to home."""

    GLOBAL = 0
    LOCAL_NED = 1
    MISSION = 2
    GLOBAL_RELATIVE_ALT = 3
    GLOBAL_INT = 5
    GLOBAL_RELATIVE_ALT_INT = 6
    GLOBAL_TERRAIN_ALT = 10
    GLOBAL_TERRAIN_ALT_INT = 11


class MavMissionType(IntEnum):
    """MAV_MISSION_TYPE: lists of items."""

    MISSION = 0
    FENCE = 1
    RALLY = 2
    ALL = 255


class MavMissionResult(IntEnum):
    """MAV_MISSION_RESULT: how a transfer of items ended."""

    ACCEPTED = 0
    ERROR = 1
    UNSUPPORTED_FRAME = 2
    UNSUPPORTED = 3
    NO_SPACE = 4
    INVALID = 5
    INVALID_SEQUENCE = 13
    DENIED = 14
    OPERATION_CANCELLED = 15


class MissionState(IntEnum):
    """MISSION_STATE: how far the mission is."""

    UNKNOWN = 0
    NO_MISSION = 1
    NOT_STARTED = 2
    ACTIVE = 3
    PAUSED = 4
    COMPLETE = 5


class MavParamType(IntEnum):
    """MAV_PARAM_TYPE: types of parameters."""

    UINT8 = 1
    INT8 = 2
    UINT16 = 3
    INT16 = 4
    UINT32 = 5
    INT32 = 6
    UINT64 = 7
    INT64 = 8
    REAL32 = 9
    REAL64 = 10


class LandedState(IntEnum):
    """MAV_LANDED_STATE: on the ground or not."""

    UNDEFINED = 0
    ON_GROUND = 1
    IN_AIR = 2
    TAKEOFF = 3
    LANDING = 4


class VtolState(IntEnum):
    """MAV_VTOL_STATE: UNDEFINED for what is not a VTOL."""

    UNDEFINED = 0
    TRANSITION_TO_FW = 1
    TRANSITION_TO_MC = 2
    MC = 3
    FW = 4


class MavSeverity(IntEnum):
    """MAV_SEVERITY: as in syslog."""

    EMERGENCY = 0
    ALERT = 1
    CRITICAL = 2
    ERROR = 3
    WARNING = 4
    NOTICE = 5
    INFO = 6
    DEBUG = 7


class GpsFixType(IntEnum):
    """GPS_FIX_TYPE; "2D_FIX" and "3D_FIX" keep the prefix, to be names in Python."""

    NO_GPS = 0
    NO_FIX = 1
    GPS_FIX_TYPE_2D_FIX = 2
    GPS_FIX_TYPE_3D_FIX = 3
    DGPS = 4
    RTK_FLOAT = 5
    RTK_FIXED = 6
    STATIC = 7
    PPP = 8


class SysStatusSensor(IntFlag):
    """MAV_SYS_STATUS_SENSOR: parts that SYS_STATUS reports."""

    SENSOR_3D_GYRO = 1 << 0
    SENSOR_3D_ACCEL = 1 << 1
    SENSOR_3D_MAG = 1 << 2
    SENSOR_ABSOLUTE_PRESSURE = 1 << 3
    SENSOR_DIFFERENTIAL_PRESSURE = 1 << 4
    SENSOR_GPS = 1 << 5
    SENSOR_ANGULAR_RATE_CONTROL = 1 << 10
    SENSOR_ATTITUDE_STABILIZATION = 1 << 11
    SENSOR_YAW_POSITION = 1 << 12
    SENSOR_Z_ALTITUDE_CONTROL = 1 << 13
    SENSOR_XY_POSITION_CONTROL = 1 << 14
    SENSOR_MOTOR_OUTPUTS = 1 << 15
    SENSOR_RC_RECEIVER = 1 << 16
    GEOFENCE = 1 << 20
    AHRS = 1 << 21
    TERRAIN = 1 << 22
    LOGGING = 1 << 24
    SENSOR_BATTERY = 1 << 25
    PREARM_CHECK = 1 << 28
    OBSTACLE_AVOIDANCE = 1 << 29


class ProtocolCapability(IntFlag):
    """MAV_PROTOCOL_CAPABILITY: what an autopilot understands."""

    MISSION_FLOAT = 1
    PARAM_FLOAT = 2
    """Not used any more; now PARAM_ENCODE_C_CAST."""
    MISSION_INT = 4
    COMMAND_INT = 8
    PARAM_ENCODE_BYTEWISE = 16
    FTP = 32
    SET_ATTITUDE_TARGET = 64
    SET_POSITION_TARGET_LOCAL_NED = 128
    SET_POSITION_TARGET_GLOBAL_INT = 256
    TERRAIN = 512
    FLIGHT_TERMINATION = 2048
    COMPASS_CALIBRATION = 4096
    MAVLINK2 = 8192
    MISSION_FENCE = 16384
    MISSION_RALLY = 32768
    PARAM_ENCODE_C_CAST = 131072


class StandardMode(IntEnum):
    """MAV_STANDARD_MODE: modes that mean the same at every autopilot."""

    NON_STANDARD = 0
    POSITION_HOLD = 1
    ORBIT = 2
    CRUISE = 3
    ALTITUDE_HOLD = 4
    SAFE_RECOVERY = 5
    MISSION = 6
    LAND = 7
    TAKEOFF = 8


class ModeProperty(IntFlag):
    """MAV_MODE_PROPERTY: what a ground station should know of a mode."""

    ADVANCED = 1
    NOT_USER_SELECTABLE = 2


class AdsbAltitudeType(IntEnum):
    """ADSB_ALTITUDE_TYPE: where an altitude comes from."""

    PRESSURE_QNH = 0
    GEOMETRIC = 1


class AdsbFlags(IntFlag):
    """ADSB_FLAGS: which fields of ADSB_VEHICLE hold."""

    VALID_COORDS = 1
    VALID_ALTITUDE = 2
    VALID_HEADING = 4
    VALID_VELOCITY = 8
    VALID_CALLSIGN = 16
    VALID_SQUAWK = 32
    SIMULATED = 64
    VERTICAL_VELOCITY_VALID = 128
    BARO_VALID = 256
    SOURCE_UAT = 32768
