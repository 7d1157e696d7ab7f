"""The newest messages of the autopilot, and the measurement that they make."""

import math
from typing import Any, NamedTuple

from vfguide.autopilots.makes import ASSUMED
from vfguide.estimation.local_frame import Measurement
from vfguide.geometry.units import DEG_E7, MM, MS, US
from vfguide.link.boot_time import elapsed
from vfguide.link.messages import (
    AttitudeQuaternion,
    GpsGlobalOrigin,
    LocalPositionNed,
    Message,
    SystemTime,
    VfrHud,
    WindCov,
)
from vfguide.link.plausibility import is_plausible

STALE = 0.5
"""Age above which a position, an attitude or an airspeed is not used [s]; chosen. The flight goes
on without an airspeed."""
WIND_STALE = 5.0
"""Age above which the autopilot's wind is not used, but estimated [s]; chosen."""
FIRST_DATE = 946_684_800_000_000
"""Earliest date that counts as one, the year 2000 [us since 1970]; chosen, since clocks that were
never set are earlier."""
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
    """time_boot_ms of the attitude that was newest when the airspeed arrived [ms]."""
    wind: WindCov | None = None
    """Wind as the autopilot estimates it."""
    wind_time: int = 0
    """time_boot_ms of the attitude that was newest when the wind arrived [ms]."""
    date: SystemTime | None = None
    """The date, and when it was so."""
    projection: int = int(ASSUMED.projection)
    """The `Projection` of the autopilot's local frame."""


_PLACES: dict[type[Message], int] = {
    GpsGlobalOrigin: Knowledge._fields.index("origin"),
    AttitudeQuaternion: Knowledge._fields.index("attitude"),
    LocalPositionNed: Knowledge._fields.index("position"),
    VfrHud: Knowledge._fields.index("hud"),
    WindCov: Knowledge._fields.index("wind"),
    SystemTime: Knowledge._fields.index("date"),
}
"""The number of the field of each kind of message."""
_TIMES: dict[type[Message], int] = {
    VfrHud: Knowledge._fields.index("hud_time"),
    WindCov: Knowledge._fields.index("wind_time"),
}
"""The number of the field with the time of a message that contains none."""
OBSERVED = tuple(_PLACES)
"""The kinds of messages from which a measurement is made."""


def observe(known: Knowledge, message: Message) -> Knowledge:
    """The knowledge after `message`; unchanged after an implausible one."""
    place = _PLACES.get(type(message))
    if place is None or not is_plausible(message):
        return known
    after: list[Any] = list(known)
    after[place] = message
    if known.attitude is not None and (time_place := _TIMES.get(type(message))):
        after[time_place] = known.attitude.time_boot_ms
    return Knowledge._make(after)


def heard(known: Knowledge, lead: float = 0.0) -> Measurement | None:
    """The measurement for `place_state`; None while anything is missing or too old.

    Airspeed and wind are not numbers where they are missing or too old. `lead` is the time after
    the attitude for which the state is predicted [s].
    """
    attitude, position, hud, origin = known.attitude, known.position, known.hud, known.origin
    if attitude is None or position is None or hud is None or origin is None:
        return None
    ahead = elapsed(position.time_boot_ms, attitude.time_boot_ms)
    if abs(ahead) > STALE:
        return None
    wind, now = known.wind, attitude.time_boot_ms
    if wind is not None and abs(elapsed(known.wind_time, now)) > WIND_STALE:
        wind = None
    return Measurement(
        attitude.time_boot_ms * MS,
        (origin.latitude * DEG_E7, origin.longitude * DEG_E7, origin.altitude * MM),
        (position.x, position.y, position.z),
        (position.vx, position.vy, position.vz),
        ahead,
        (attitude.q1, attitude.q2, attitude.q3, attitude.q4),
        hud.airspeed if abs(elapsed(known.hud_time, now)) <= STALE else math.nan,
        hud.alt,
        UNKNOWN if wind is None else (wind.wind_x, wind.wind_y, wind.wind_z),
        (attitude.rollspeed, attitude.pitchspeed, attitude.yawspeed),
        lead,
        known.projection,
    )


def obstacle_time(known: Knowledge, epoch: int, began_ms: int) -> float:
    """Time on the clock of the obstacles at the newest attitude [s].

    It counts from `epoch` [us since 1970] where the autopilot knows the date, else from its time
    `began_ms` since boot, when the companion began.
    """
    now = 0 if known.attitude is None else known.attitude.time_boot_ms
    date = known.date
    if date is None or date.time_unix_usec < FIRST_DATE:
        return elapsed(began_ms, now)
    return (date.time_unix_usec - epoch) * US + elapsed(date.time_boot_ms, now)


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
    if abs(elapsed(position.time_boot_ms, attitude.time_boot_ms)) > STALE:
        return "the position is too old (LOCAL_POSITION_NED)"
    return None
