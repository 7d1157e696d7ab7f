"""The messages of the software autopilot's streams, made from its estimate."""

import math
from collections.abc import Callable
from typing import NamedTuple

from vfguide.earth.atmosphere import LAPSE, TEMPERATURE_0
from vfguide.earth.pressure_altitude import isa_pressure
from vfguide.geometry.so3 import quaternion_from_euler
from vfguide.geometry.units import CDEG, CM_S, DEG, DEG_E7, HPA, MM, PERCENT
from vfguide.link.enums import (
    AttitudeTypeMask,
    GpsFixType,
    LandedState,
    MavAutopilot,
    MavState,
    MavType,
    MissionState,
    ModeFlag,
    SysStatusSensor,
    VtolState,
)
from vfguide.link.messages import (
    Attitude,
    AttitudeQuaternion,
    AttitudeTarget,
    CurrentMode,
    ExtendedSysState,
    GlobalPositionInt,
    GpsGlobalOrigin,
    GpsRawInt,
    Heartbeat,
    HomePosition,
    LocalPositionNed,
    Message,
    MissionCurrent,
    ScaledPressure,
    SetAttitudeTarget,
    SysStatus,
    SystemTime,
    VfrHud,
    WindCov,
)
from vfguide.sim.autopilot.estimate import Estimate, Origin
from vfguide.sim.autopilot.flight_mode import FAILSAFE_MODES, INTENDED, REPORTED, Mode

ALL_HEALTHY = (
    SysStatusSensor.SENSOR_3D_GYRO
    | SysStatusSensor.SENSOR_3D_ACCEL
    | SysStatusSensor.SENSOR_3D_MAG
    | SysStatusSensor.SENSOR_ABSOLUTE_PRESSURE
    | SysStatusSensor.SENSOR_DIFFERENTIAL_PRESSURE
    | SysStatusSensor.SENSOR_GPS
    | SysStatusSensor.AHRS
    | SysStatusSensor.SENSOR_BATTERY
    | SysStatusSensor.PREARM_CHECK
)
"""Flags of all sensors of SYS_STATUS as present, enabled and healthy."""
BATTERY_VOLTAGE = 44_400
"""Voltage of the simulated battery [mV]; chosen, 12 cells."""
BATTERY_LEFT = 100
"""Charge that is left in the simulated battery [%]; chosen, it is not used up."""
LOOP_LOAD = 200
"""Load of the simulated autopilot's main loop [0.1 %]; chosen."""
HDOP = 80
"""Horizontal dilution of precision of the simulated receiver times 100, a number; chosen, that of a
good fix."""
VDOP = 120
"""Vertical dilution of precision of the simulated receiver times 100, a number; chosen, that of a
good fix."""
SATELLITES = 12
"""Number of satellites of the simulated receiver; chosen, enough for a good fix."""
ZERO_CELSIUS = 273.15
"""Temperature of 0 degrees Celsius [K] (International System of Units)."""
WIND_CHANGE = 0.25
"""Standard deviation in time of the wind in WIND_COV [m/s]; chosen."""
WIND_ACCURACY = 0.5
"""Standard deviation of the estimate of the wind in WIND_COV [m/s]; chosen."""


class Report(NamedTuple):
    """Everything that the streams tell."""

    now: int
    """Date [us since 1970]."""
    time_boot_ms: int
    """Time since the start [ms]."""
    estimate: Estimate
    """What the autopilot believes of its aircraft."""
    origin: Origin
    """Origin of its local frame."""
    home: Origin
    """Where it started."""
    mode: Mode
    """What it is flying."""
    armed: bool
    """Whether it is armed."""
    setpoint: SetAttitudeTarget | None
    """The setpoint that is flown; None: it flies by itself."""
    throttle: float
    """Throttle that the motor gets, 0 to 1."""
    pressure_altitude: float
    """Height at which the standard atmosphere has the pressure of the air around it [m]."""
    undulation: float
    """Height of mean sea level above the ellipsoid [m]."""


def heartbeat(report: Report) -> Heartbeat:
    """HEARTBEAT with PX4's encoding of the mode."""
    flags = ModeFlag.CUSTOM_MODE_ENABLED
    if report.mode is not Mode.OFFBOARD:
        flags |= ModeFlag.AUTO_ENABLED | ModeFlag.GUIDED_ENABLED | ModeFlag.STABILIZE_ENABLED
    if report.armed:
        flags |= ModeFlag.SAFETY_ARMED
    status = MavState.CRITICAL if report.mode in FAILSAFE_MODES else MavState.ACTIVE
    mode = REPORTED[report.mode]
    return Heartbeat(MavType.FIXED_WING, MavAutopilot.PX4, flags, mode, status)


def attitude(report: Report) -> Attitude:
    """ATTITUDE: Euler angles [rad] and body rates [rad/s]."""
    return Attitude(report.time_boot_ms, *report.estimate.euler, *report.estimate.omega_b)


def attitude_quaternion(report: Report) -> AttitudeQuaternion:
    """ATTITUDE_QUATERNION: body FRD to NED, and body rates [rad/s]."""
    w, x, y, z = quaternion_from_euler(*report.estimate.euler)
    return AttitudeQuaternion(report.time_boot_ms, w, x, y, z, *report.estimate.omega_b)


def local_position(report: Report) -> LocalPositionNed:
    """LOCAL_POSITION_NED about the origin of the local frame [m], with the velocity [m/s]."""
    return LocalPositionNed(report.time_boot_ms, *report.estimate.p_l, *report.estimate.v_n)


def global_position(report: Report) -> GlobalPositionInt:
    """GLOBAL_POSITION_INT; its relative altitude is that above home."""
    estimate = report.estimate
    north, east, down = estimate.v_n
    return GlobalPositionInt(
        report.time_boot_ms,
        round(estimate.latitude / DEG_E7),
        round(estimate.longitude / DEG_E7),
        round(estimate.altitude / MM),
        round((estimate.altitude - report.home.altitude) / MM),
        round(north / CM_S),
        round(east / CM_S),
        round(down / CM_S),
        compass(estimate.euler[2]),
    )


def compass(angle: float) -> int:
    """An angle [rad] as 0 to 35999 hundredths of a degree."""
    return round(angle / CDEG) % 36000


def vfr_hud(report: Report) -> VfrHud:
    """VFR_HUD; the airspeed is calibrated, as PX4's is."""
    north, east, down = report.estimate.v_n
    return VfrHud(
        report.estimate.calibrated_airspeed,
        math.hypot(north, east),
        round(report.estimate.euler[2] / DEG) % 360,
        round(report.throttle / PERCENT),
        report.estimate.altitude,
        -down,
    )


def wind_cov(report: Report) -> WindCov:
    """WIND_COV: the direction it blows toward [m/s]. As on PX4 no vertical wind is estimated."""
    north, east, _ = report.estimate.wind_n
    altitude = report.estimate.altitude
    change, accuracy = WIND_CHANGE, WIND_ACCURACY
    return WindCov(report.now, north, east, 0.0, change, change, altitude, accuracy, accuracy)


def gps_raw(report: Report) -> GpsRawInt:
    """GPS_RAW_INT of a receiver with a 3-D fix."""
    estimate = report.estimate
    north, east, _ = estimate.v_n
    return GpsRawInt(
        report.now,
        GpsFixType.GPS_FIX_TYPE_3D_FIX,
        round(estimate.latitude / DEG_E7),
        round(estimate.longitude / DEG_E7),
        round(estimate.altitude / MM),
        HDOP,
        VDOP,
        round(math.hypot(north, east) / CM_S),
        compass(math.atan2(east, north)),
        SATELLITES,
        round((estimate.altitude + report.undulation) / MM),
    )


def scaled_pressure(report: Report) -> ScaledPressure:
    """SCALED_PRESSURE of a sensor at the temperature of the standard atmosphere."""
    height = report.pressure_altitude
    temperature = TEMPERATURE_0 - LAPSE * height - ZERO_CELSIUS
    return ScaledPressure(
        report.time_boot_ms, isa_pressure(height) / HPA, 0.0, round(temperature / PERCENT)
    )


def home_position(report: Report) -> HomePosition:
    """HOME_POSITION: where the vehicle started."""
    lat, lon, alt = origin_on_the_wire(report.home)
    return HomePosition(lat, lon, alt, 0.0, 0.0, 0.0, (1.0, 0.0, 0.0, 0.0), 0.0, 0.0, 0.0)


def global_origin(report: Report) -> GpsGlobalOrigin:
    """GPS_GLOBAL_ORIGIN of the local frame."""
    lat, lon, alt = origin_on_the_wire(report.origin)
    return GpsGlobalOrigin(lat, lon, alt, report.now)


def origin_on_the_wire(origin: Origin) -> tuple[int, int, int]:
    """Latitude, longitude [1e-7 deg] and altitude [mm] of an origin, as messages have them."""
    return (
        round(origin.latitude / DEG_E7),
        round(origin.longitude / DEG_E7),
        round(origin.altitude / MM),
    )


def sys_status(_: Report) -> SysStatus:
    """SYS_STATUS: all well."""
    sensors, battery = (ALL_HEALTHY, ALL_HEALTHY, ALL_HEALTHY), (BATTERY_VOLTAGE, -1, BATTERY_LEFT)
    return SysStatus(*sensors, LOOP_LOAD, *battery, 0, 0, 0, 0, 0, 0)


def extended_sys_state(report: Report) -> ExtendedSysState:
    """EXTENDED_SYS_STATE: in the air."""
    landed = LandedState.IN_AIR if report.armed else LandedState.UNDEFINED
    return ExtendedSysState(VtolState.UNDEFINED, landed)


def system_time(report: Report) -> SystemTime:
    """SYSTEM_TIME: the date of the simulation."""
    return SystemTime(report.now, report.time_boot_ms)


def current_mode(report: Report) -> CurrentMode:
    """CURRENT_MODE: the mode that is flown, told as the intended one too."""
    mode = REPORTED[report.mode]
    return CurrentMode(0, mode, INTENDED[report.mode])


def attitude_target(report: Report) -> AttitudeTarget:
    """ATTITUDE_TARGET: the setpoint that is flown, level flight without one."""
    sp = report.setpoint
    if sp is None:
        ignore = AttitudeTypeMask.ATTITUDE_IGNORE
        return AttitudeTarget(report.time_boot_ms, ignore, (1.0, 0.0, 0.0, 0.0), 0.0, 0.0, 0.0, 0.0)
    rates = (sp.body_roll_rate, sp.body_pitch_rate, sp.body_yaw_rate)
    return AttitudeTarget(report.time_boot_ms, sp.type_mask, sp.q, *rates, sp.thrust)


def mission_current(_: Report) -> MissionCurrent:
    """MISSION_CURRENT: there is none."""
    return MissionCurrent(0, 0, MissionState.NO_MISSION)


MAKERS: dict[int, Callable[[Report], Message]] = {
    Heartbeat.MSGID: heartbeat,
    SysStatus.MSGID: sys_status,
    SystemTime.MSGID: system_time,
    GpsRawInt.MSGID: gps_raw,
    ScaledPressure.MSGID: scaled_pressure,
    Attitude.MSGID: attitude,
    AttitudeQuaternion.MSGID: attitude_quaternion,
    LocalPositionNed.MSGID: local_position,
    GlobalPositionInt.MSGID: global_position,
    MissionCurrent.MSGID: mission_current,
    GpsGlobalOrigin.MSGID: global_origin,
    VfrHud.MSGID: vfr_hud,
    AttitudeTarget.MSGID: attitude_target,
    WindCov.MSGID: wind_cov,
    HomePosition.MSGID: home_position,
    ExtendedSysState.MSGID: extended_sys_state,
    CurrentMode.MSGID: current_mode,
}
"""The function that makes each message that can be streamed or requested, by its id."""
