"""The newest messages of the autopilot, and the measurement that they make."""

import math
from collections.abc import Callable
from functools import lru_cache
from typing import Any, NamedTuple

from vfguide.autopilots.makes import ASSUMED
from vfguide.earth.atmosphere import isa_density
from vfguide.estimation.local_frame import Measurement
from vfguide.geometry.units import DEG_E7, HPA, MM, MS
from vfguide.kernels.written_functions import maker, replacer
from vfguide.link.boot_time import US_PER_MS, BootClock, elapsed, is_late, moved_on
from vfguide.link.messages import (
    AttitudeQuaternion,
    GlobalPositionInt,
    GpsGlobalOrigin,
    GpsRawInt,
    LocalPositionNed,
    Message,
    ScaledPressure,
    SystemTime,
    VfrHud,
    WindCov,
)
from vfguide.link.plausibility import is_plausible, undulation_of
from vfguide.surveillance.height_difference import HeightDifference, difference_after
from vfguide.surveillance.heights import HeightDatum, datum_of, pressure_offset
from vfguide.telemetry.date import Date, date_after

STALE = 0.5
"""Age above which a position, an attitude or an airspeed is not used [s]; chosen. The flight goes
on without an airspeed."""
WIND_STALE = 5.0
"""Age above which the autopilot's wind is not used, but estimated [s]; chosen."""
UNKNOWN = (math.nan, math.nan, math.nan)
"""A wind that was not measured, not a number [m/s]."""


class Knowledge(NamedTuple):
    """The newest message of each kind; None where there was none."""

    origin: GpsGlobalOrigin | None = None
    """Origin of the autopilot's local frame."""
    attitude: AttitudeQuaternion | None = None
    """Attitude and body rates."""
    position: LocalPositionNed | None = None
    """Position and velocity in the local frame."""
    hud: VfrHud | None = None
    """Calibrated airspeed and altitude."""
    hud_time: int = 0
    """Time of the attitude that was newest when the airspeed arrived [ms]."""
    wind: WindCov | None = None
    """Wind as the autopilot estimates it."""
    wind_time: int = 0
    """Time of the attitude that was newest when the wind arrived [ms]."""
    date: Date | None = None
    """The date, and when it was so."""
    clock: BootClock | None = None
    """The time of the autopilot, by its attitudes; all times here are this clock's."""
    projection: int = int(ASSUMED.projection)
    """The `Projection` of the autopilot's local frame."""
    place: GlobalPositionInt | None = None
    """Latitude and longitude of the vehicle."""
    undulation: HeightDifference | None = None
    """Height of mean sea level above the ellipsoid here [m]; None: it was not reported."""
    pressure_offset: HeightDifference | None = None
    """Pressure altitude less the altitude above mean sea level here [m]; None: the autopilot
    reports no pressure that weather can make."""

    @property
    def datum(self) -> HeightDatum:
        """How heights that others report relate to those above mean sea level."""
        return datum_of(self.pressure_offset, self.undulation)

    @property
    def time_ms(self) -> int:
        """Time of the newest attitude [ms], 0 before the first."""
        clock = self.clock
        return 0 if clock is None else clock.time_ms


_measurement = maker(Measurement)
_with_attitude = replacer(Knowledge, "attitude", "clock")
_with_times = replacer(Knowledge, "hud_time", "wind_time")
_with_position = replacer(Knowledge, "position")
_with_hud = replacer(Knowledge, "hud", "hud_time")
_with_wind = replacer(Knowledge, "wind", "wind_time")


def observe(known: Knowledge, message: Message, now: int) -> Knowledge:
    """The knowledge after `message`, which arrives at `now` [us].

    An implausible message changes nothing, nor does a late one, nor an attitude heard before.
    """
    take = _TAKERS.get(type(message))
    if take is None or not is_plausible(message):
        return known
    return take(known, message, now)


def with_attitude(known: Knowledge, said: AttitudeQuaternion, now: int) -> Knowledge:
    """The knowledge after an attitude, which moves the clock on."""
    clock = moved_on(known.clock, said.time_boot_ms, now)
    if clock is None:
        return known
    after = _with_attitude(known, said, clock)
    if known.clock is not None:
        return after
    offset = clock.time_ms - now // US_PER_MS
    return _with_times(after, known.hud_time + offset, known.wind_time + offset)


def with_position(known: Knowledge, said: LocalPositionNed, _: int) -> Knowledge:
    """The knowledge after a position, unless it is late."""
    before = known.position
    if before is not None and is_late(before.time_boot_ms, said.time_boot_ms):
        return known
    return _with_position(known, said)


def with_hud(known: Knowledge, said: VfrHud, now: int) -> Knowledge:
    """The knowledge after an airspeed, at the time of the newest attitude."""
    return _with_hud(known, said, time_of(known, now))


def with_wind(known: Knowledge, said: WindCov, now: int) -> Knowledge:
    """The knowledge after a wind, at the time of the newest attitude."""
    return _with_wind(known, said, time_of(known, now))


def time_of(known: Knowledge, now: int) -> int:
    """Time of a message that contains none [ms]: that of the newest attitude."""
    return now // US_PER_MS if known.clock is None else known.clock.time_ms


def with_origin(known: Knowledge, said: GpsGlobalOrigin, _: int) -> Knowledge:
    """The knowledge after an origin of the local frame."""
    return known._replace(origin=said)


def with_place(known: Knowledge, said: GlobalPositionInt, _: int) -> Knowledge:
    """The knowledge after a latitude and longitude."""
    return known._replace(place=said)


def with_date(known: Knowledge, said: SystemTime, _: int) -> Knowledge:
    """The knowledge after a date, of which only what follows from it is kept."""
    return known._replace(date=date_after(known.date, said, known.clock))


def with_undulation(known: Knowledge, said: GpsRawInt, _: int) -> Knowledge:
    """The knowledge after the heights of a satellite receiver above sea and ellipsoid."""
    height = undulation_of(said)
    return known._replace(undulation=difference_after(known.undulation, height, known.time_ms))


def with_pressure(known: Knowledge, message: ScaledPressure, _: int) -> Knowledge:
    """The knowledge after a pressure at the newest position; unchanged where there is none."""
    origin, position = known.origin, known.position
    if origin is None or position is None:
        return known
    altitude = origin.altitude * MM - position.z
    offset = pressure_offset(message.press_abs * HPA, altitude)
    if offset is None:
        return known._replace(pressure_offset=None)
    return known._replace(
        pressure_offset=difference_after(known.pressure_offset, offset, known.time_ms)
    )


_TAKERS: dict[type[Message], Callable[[Knowledge, Any, int], Knowledge]] = {
    AttitudeQuaternion: with_attitude,
    LocalPositionNed: with_position,
    VfrHud: with_hud,
    WindCov: with_wind,
    GpsGlobalOrigin: with_origin,
    SystemTime: with_date,
    GlobalPositionInt: with_place,
    GpsRawInt: with_undulation,
    ScaledPressure: with_pressure,
}
"""The function that takes each kind of message."""
OBSERVED = tuple(_TAKERS)
"""The kinds of messages from which a measurement is made."""


def measurement(known: Knowledge, lead: float = 0.0) -> Measurement | None:
    """The measurement for `place_state`; None while anything is missing or too old.

    Airspeed and wind are not numbers where they are missing or too old. `lead` is the time after
    the attitude for which the state is predicted [s].
    """
    # taken apart at once: the name of each field costs three times as much
    origin, attitude, position, hud, hud_time, wind, wind_time, _, _, projection, *_ = known
    if attitude is None or position is None or hud is None or origin is None:
        return None
    attitude_ms, q1, q2, q3, q4, p, q, r, _ = attitude
    position_ms, x, y, z, vx, vy, vz = position
    ahead = elapsed(position_ms, attitude_ms)
    if abs(ahead) > STALE:
        return None
    now, altitude = known.time_ms, hud.alt
    if wind is not None and (now - wind_time) * MS > WIND_STALE:
        wind = None
    return _measurement(
        (
            now * MS,
            (origin.latitude * DEG_E7, origin.longitude * DEG_E7, origin.altitude * MM),
            (x, y, z),
            (vx, vy, vz),
            ahead,
            (q1, q2, q3, q4),
            hud.airspeed if (now - hud_time) * MS <= STALE else math.nan,
            altitude,
            density_at(altitude),
            UNKNOWN if wind is None else (wind.wind_x, wind.wind_y, wind.wind_z),
            (p, q, r),
            lead,
            projection,
        )
    )


@lru_cache(maxsize=4)
def density_at(altitude: float) -> float:
    """Air density [kg/m^3] at an altitude [m]; kept, since altitudes come less often than steps."""
    return isa_density(altitude)


def lacking(known: Knowledge) -> str | None:
    """Why there is no flight state, in words; None: nothing is missing."""
    attitude, position = known.attitude, known.position
    heard = {
        "attitude (ATTITUDE_QUATERNION)": attitude,
        "position (LOCAL_POSITION_NED)": position,
        "airspeed (VFR_HUD)": known.hud,
        "origin of the local frame (GPS_GLOBAL_ORIGIN)": known.origin,
    }
    missing = [name for name, message in heard.items() if message is None]
    if missing:
        return f"not heard yet: {', '.join(missing)}"
    if attitude is None or position is None:
        return None
    age = elapsed(position.time_boot_ms, attitude.time_boot_ms)
    if age > STALE:
        return "the position is too old (LOCAL_POSITION_NED)"
    return "the attitude is too old (ATTITUDE_QUATERNION)" if age < -STALE else None
