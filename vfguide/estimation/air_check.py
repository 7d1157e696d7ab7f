"""The wind triangle as a check: ground velocity = wind + airspeed along the nose.

Where the autopilot reports a wind, the triangle is overdetermined: ground velocity less wind must
be as long as the airspeed and point along the nose. A wrong length shows a wrong wind or airspeed,
whatever the yaw is, and the airspeed that pitch and thrust ask for shows which. A wrong direction
shows a wrong yaw, where the length is right.
"""

import math
from typing import NamedTuple

from vfguide.aircraft.flight_model import sideslip_about_vertical
from vfguide.geometry.blending import blended, low_pass_share
from vfguide.geometry.units import DEG
from vfguide.geometry.vector import ZERO, Vec3, add, scale, sub
from vfguide.geometry.velocity import horizontal_norm
from vfguide.kernels.compiled import compiled
from vfguide.kernels.rows import replacing

FAST_TIME = 0.7
"""Time constant with which large errors of the wind triangle are smoothed [s]; chosen, so that they
are found before they are flown on for long."""
SLOW_TIME = 10.0
"""Time constant with which small errors of the triangle's length are smoothed [s]; chosen longer
than gusts last."""
SIDESLIP_LIMIT = 12.0 * DEG
"""Sideslip in still air above which the direction of the triangle is wrong [rad]; chosen."""
GUST = 6.0
"""Gust that the wind of the autopilot does not contain [m/s]; chosen as three standard deviations
in moderate turbulence."""
LASTING_ERROR = 3.5
"""Error of the triangle's length that no gust sustains for SLOW_TIME [m/s]; chosen."""
REPORTED_WIND_TIME = 1.5
"""Time constant with which the reported wind is smoothed [s]; chosen, so that one that changes by
more than 2.7 m/s^2 counts as a jump."""
WIND_JUMP = 4.0
"""Difference of the reported wind from its smoothed value above which it has jumped: air does not
change so quickly [m/s]; chosen."""
WIND_AGREES = 3.0
"""Difference between the reported and the estimated wind below which they agree [m/s]; chosen."""
WIND_AGREEMENT = 5.0
"""Time for which a doubted wind has to agree before it is believed again [s]; chosen."""
AIRSPEED_AGREES = 2.0
"""Error of the triangle's length below which a doubted airspeed agrees [m/s]; chosen."""
AIRSPEED_AGREEMENT = 20.0
"""Time for which a doubted airspeed has to agree before it is believed again [s]; chosen long, so
that a wrong scale is not believed in turns."""

LEAST_DOUBT = 1e-3
"""Duration of a doubt at its first step [s]; chosen above 0, which means no doubt."""


class Triangle(NamedTuple):
    """The wind triangle as it is measured."""

    sideslip: float
    """Azimuth of the air velocity less that of the nose [rad]."""
    excess: float
    """Length of ground velocity less wind, less the airspeed, both horizontal [m/s]."""


class AirCheck(NamedTuple):
    """What the wind triangle has shown."""

    is_first: bool
    """Whether nothing was measured yet."""
    wind_n: Vec3
    """The reported wind, smoothed with REPORTED_WIND_TIME, NED [m/s]."""
    ahead: float
    """Cosine of the sideslip, smoothed."""
    right: float
    """Sine of the sideslip, smoothed."""
    excess: float
    """Excess of the `Triangle`, smoothed with FAST_TIME [m/s]."""
    lasting: float
    """Excess of the `Triangle`, smoothed with SLOW_TIME [m/s]."""
    wind_doubt: float
    """Time for which the reported wind has not been believed [s]; 0: it is believed."""
    wind_agrees: float
    """Time for which a doubted wind has agreed with the estimate [s]."""
    airspeed_doubt: float
    """Time for which the measured airspeed has not been believed [s]; 0: it is believed."""
    airspeed_agrees: float
    """Time for which a doubted airspeed has agreed with the triangle [s]."""


replaced_doubts = replacing(AirCheck, "wind_n", "wind_doubt", "airspeed_doubt", "airspeed_agrees")
with_smoothed_slip = replacing(AirCheck, "ahead", "right")
with_wind_doubt = replacing(AirCheck, "wind_n", "wind_doubt", "wind_agrees")
with_airspeed_doubt = replacing(AirCheck, "airspeed_doubt", "airspeed_agrees")


@compiled
def first_check() -> AirCheck:
    """The check before the first wind triangle."""
    return AirCheck(True, ZERO, 1.0, 0.0, 0.0, 0.0, 0.0, 0.0, 0.0, 0.0)


@compiled
def sideslip_limit(airspeed: float) -> float:
    """Sideslip above which a direction is wrong at an airspeed [m/s], gusts allowed for [rad]."""
    return SIDESLIP_LIMIT + math.asin(min(1.0, GUST / max(airspeed, 1.0)))


@compiled
def triangle(air_n: Vec3, nose_n: Vec3, airspeed: float) -> Triangle:
    """The triangle of an air velocity [m/s], a nose (unit vector), both NED, and an airspeed."""
    level = horizontal_norm(nose_n)
    slip = sideslip_about_vertical(air_n, nose_n)
    return Triangle(slip, horizontal_norm(air_n) - level * airspeed)


@compiled
def smoothed_triangle(s: AirCheck, seen: Triangle, wind_n: Vec3, dt: float) -> AirCheck:
    """The check with one more triangle, `dt` [s] later, and the reported wind, NED [m/s]."""
    ahead, right = math.cos(seen.sideslip), math.sin(seen.sideslip)
    fast = 1.0 if s.is_first else low_pass_share(FAST_TIME, dt)
    followed = 1.0 if s.is_first else low_pass_share(REPORTED_WIND_TIME, dt)
    return AirCheck(
        False,
        add(s.wind_n, scale(followed, sub(wind_n, s.wind_n))),
        blended(s.ahead, ahead, fast),
        blended(s.right, right, fast),
        blended(s.excess, seen.excess, fast),
        blended(s.lasting, seen.excess, low_pass_share(SLOW_TIME, dt)),
        s.wind_doubt,
        s.wind_agrees,
        s.airspeed_doubt,
        s.airspeed_agrees,
    )


@compiled
def is_wrong(s: AirCheck) -> bool:
    """Whether the length of the wind triangle is wrong: the wind or the airspeed."""
    return abs(s.excess) > GUST or abs(s.lasting) > LASTING_ERROR


@compiled
def has_jumped(s: AirCheck, wind_n: Vec3) -> bool:
    """Whether the reported wind, NED [m/s], has changed more quickly than the air does."""
    change = horizontal_norm(sub(wind_n, s.wind_n))
    return change > WIND_JUMP and not s.is_first


@compiled
def sideslip_of(s: AirCheck) -> float:
    """The smoothed sideslip [rad]."""
    return math.atan2(s.right, s.ahead)


@compiled
def doubting_wind(s: AirCheck, dt: float) -> AirCheck:
    """The check from which on the reported wind is not believed, at a step of `dt` [s]."""
    return replaced_doubts(first_check(), s.wind_n, max(dt, LEAST_DOUBT), s.airspeed_doubt, 0.0)


@compiled
def doubting_airspeed(s: AirCheck, dt: float) -> AirCheck:
    """The check from which on the airspeed sensor is not believed, at a step of `dt` [s]."""
    return replaced_doubts(first_check(), s.wind_n, s.wind_doubt, max(dt, LEAST_DOUBT), 0.0)


@compiled
def follow_wind_doubt(s: AirCheck, wind_n: Vec3, own_n: Vec3, dt: float) -> AirCheck:
    """The check of a doubted wind `dt` [s] later.

    It is believed again when it has agreed with our own estimate for WIND_AGREEMENT, NED [m/s].
    """
    off = horizontal_norm(sub(wind_n, own_n))
    agrees = s.wind_agrees + dt if off < WIND_AGREES else 0.0
    doubt = 0.0 if agrees > WIND_AGREEMENT else s.wind_doubt + dt
    return with_wind_doubt(s, wind_n, doubt, agrees)


@compiled
def follow_airspeed_doubt(s: AirCheck, excess: float, dt: float) -> AirCheck:
    """The check of the airspeed sensor `dt` [s] later; a doubted one may be believed again.

    `excess` is that of the wind triangle with the measured airspeed [m/s].
    """
    if s.airspeed_doubt == 0.0:
        return s
    agrees = s.airspeed_agrees + dt if abs(excess) < AIRSPEED_AGREES else 0.0
    doubt = 0.0 if agrees > AIRSPEED_AGREEMENT else s.airspeed_doubt + dt
    return with_airspeed_doubt(s, doubt, agrees)
