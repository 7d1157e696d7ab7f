"""Directional guidance of the software autopilot: the lateral acceleration that leads to a circle.

It flies a circle as PX4's NPFG does, in any wind:

1. Far from the circle the bearing points straight at it, on the circle along it, between the two
   it turns as a quadratic of the distance.
2. The wind triangle turns the bearing into an air velocity; where the wind allows no way along the
   bearing, into the one that drifts least away.
3. The lateral acceleration turns the air velocity to that one, and along with it on the circle.

T. Stastny and R. Siegwart, *On Flying Backwards: Preventing Run-away of Small, Low-speed,
Fixed-wing UAVs in Strong Winds*, IROS 2019; S. Park, J. Deyst and J. How, *A New Nonlinear Guidance
Logic for Trajectory Tracking*, AIAA 2004-4900. Nothing here is shared with the companion.
"""

import math

from vfguide.geometry.se2 import Vec2
from vfguide.geometry.units import G0
from vfguide.kernels.compiled import compiled

PERIOD_RATIO = 3.0
"""Ratio of the period of the guidance to V / g: 8 s at 25 m/s, where PX4's NPFG_PERIOD is 10 s;
chosen, with a shorter one a fast aircraft swings between its limits of bank."""
SHORTEST_PERIOD = 5.0
"""Least period of the guidance [s]; chosen, since attitude has to be the faster loop."""
GUIDANCE_DAMPING = 0.7
"""Damping ratio of the guidance, dimensionless: PX4's default of NPFG_DAMPING."""
GROUND_SPEED_SHARE = 0.3
"""Share of the airspeed below which the ground speed counts as that share; chosen, so that gains
stay finite."""
ALONG_SHARE = 0.3
"""Share of the airspeed below which the airspeed along the bearing counts as that share; chosen, so
that gains stay finite."""
INNER_SHARE = 0.5
"""Share of the radius within which the bearing counts as turning as fast as there; chosen."""


@compiled
def lateral_acceleration(
    place: Vec2, ground: Vec2, wind: Vec2, airspeed: float, radius: float
) -> float:
    """Lateral acceleration [m/s^2] that leads clockwise round a circle, to the right positive.

    Args:
        place: position from the centre, north and east [m].
        ground: velocity over ground, north and east [m/s].
        wind: the direction it blows toward, north and east [m/s].
        airspeed: true airspeed, above 0 [m/s].
        radius: of the circle, above 0 [m].
    """
    distance = math.hypot(place[0], place[1])
    outward = (place[0] / distance, place[1] / distance) if distance > 0.0 else (1.0, 0.0)
    along = (-outward[1], outward[0])
    ahead = look_ahead(distance - radius, ground, airspeed)
    inward = math.copysign(math.cos(ahead), distance - radius)
    bearing = (
        math.sin(ahead) * along[0] - inward * outward[0],
        math.sin(ahead) * along[1] - inward * outward[1],
    )
    air = (ground[0] - wind[0], ground[1] - wind[1])
    feedback = turn_toward(air, air_velocity(bearing, wind, airspeed), airspeed)
    rate = max(_dot(along, ground), 0.0) / max(distance, INNER_SHARE * radius)
    return feedback + math.sin(ahead) ** 2 * turn_along(rate, bearing, wind, airspeed)


@compiled
def look_ahead(error: float, ground: Vec2, airspeed: float) -> float:
    """Angle of the bearing to the way straight to the path: 0 far from it, pi/2 on it [rad].

    pi/2 (1 - |e| / e_max)^2, where e_max is flown over ground within the period times the damping
    ratio.

    Args:
        error: distance from the path [m].
        ground: velocity over ground, north and east [m/s].
        airspeed: true airspeed [m/s].
    """
    speed = max(math.hypot(ground[0], ground[1]), GROUND_SPEED_SHARE * airspeed)
    bound = period(airspeed) * GUIDANCE_DAMPING * speed
    near = 1.0 - min(abs(error) / bound, 1.0)
    return 0.5 * math.pi * near * near


@compiled
def period(airspeed: float) -> float:
    """Period of the guidance at an airspeed [m/s], in [s]."""
    return max(PERIOD_RATIO * airspeed / G0, SHORTEST_PERIOD)


@compiled
def air_velocity(bearing: Vec2, wind: Vec2, airspeed: float) -> Vec2:
    """Velocity through the air that leads along the bearing, or drifts least from it [m/s].

    All vectors are north and east; the bearing is a unit vector, wind and airspeed are in m/s.

    Where the airspeed cannot hold the bearing, |wind| > V, the velocity over ground points along
    bearing - wind / sqrt(w^2 - V^2), which goes over into the nose against the wind.
    """
    tail, cross = _dot(wind, bearing), _cross(bearing, wind)
    along = along_bearing(cross, airspeed)
    if along > 0.0 and along + tail > 0.0:
        return (along * bearing[0] + cross * bearing[1], along * bearing[1] - cross * bearing[0])
    excess = math.sqrt(max(_dot(wind, wind) - airspeed * airspeed, 0.0))
    north, east = excess * bearing[0] - wind[0], excess * bearing[1] - wind[1]
    size = airspeed / max(math.hypot(north, east), 1e-6)
    return (size * north, size * east)


@compiled
def along_bearing(cross: float, airspeed: float) -> float:
    """Airspeed along a bearing that is left when a wind across it is made up for [m/s each]."""
    return math.sqrt(max(airspeed * airspeed - cross * cross, 0.0))


@compiled
def turn_toward(air: Vec2, wanted: Vec2, airspeed: float) -> float:
    """Lateral acceleration [m/s^2], to the right positive, that turns an air velocity to another.

    It grows with the sine of the angle between them, and is largest beyond 90 degrees. The
    velocities are north and east [m/s].
    """
    gain = 4.0 * math.pi * GUIDANCE_DAMPING / period(airspeed)
    sizes = max(math.hypot(air[0], air[1]) * airspeed, 1e-6)
    sine = max(-1.0, min(1.0, _cross(air, wanted) / sizes))
    if _dot(air, wanted) < 0.0:
        sine = math.copysign(1.0, sine)
    return gain * airspeed * sine


@compiled
def turn_along(rate: float, bearing: Vec2, wind: Vec2, airspeed: float) -> float:
    """Lateral acceleration [m/s^2] that turns with a bearing at its rate [rad/s] in a wind [m/s].

    V psi' with psi' = chi' (1 + w_along / (V cos(psi - chi))); none where no course can be held.
    """
    tail, along = _dot(wind, bearing), along_bearing(_cross(bearing, wind), airspeed)
    if along + tail <= 0.0:
        return 0.0
    return airspeed * rate * (1.0 + tail / max(along, ALONG_SHARE * airspeed))


@compiled
def _dot(a: Vec2, b: Vec2) -> float:
    return a[0] * b[0] + a[1] * b[1]


@compiled
def _cross(a: Vec2, b: Vec2) -> float:
    """Positive where `b` is to the right of `a`."""
    return a[0] * b[1] - a[1] * b[0]
