"""Limits of the path angle: airspeed has priority over height, except near the floor."""

import math

from vfguide.aircraft.performance import Performance, turn_length
from vfguide.geometry.blending import blended
from vfguide.kernels.compiled import compiled

LEVEL_RATIO = 1.165
"""Ratio of the airspeed at which the path is level at full thrust to the slowest airspeed;
tuned with `tools/measure_poses.py` in moderate turbulence, where it keeps 1.10 of the slowest
airspeed."""
CLIMB_BAND = 0.12
"""Airspeed above that of `LEVEL_RATIO` at which the steepest climb is flown, as a share of the
airspeed to fly; chosen."""
ZOOM_RATIO = 1.4
"""Ratio of the steepest path through sinking air, while the airspeed lasts, to the steepest climb;
tuned with `tools/measure_poses.py` in moderate turbulence."""
FLOOR_LEVEL_RATIO = 1.12
"""Value of `LEVEL_RATIO` at the floor, where airspeed is spent for height, dimensionless; tuned
with `tools/measure_avoidance.py` in sinking air."""
FLOOR_CLIMB_BAND = 0.056
"""Value of `CLIMB_BAND` at the floor, as a share of the airspeed to fly; tuned with
`tools/measure_avoidance.py`."""
FLOOR_ZOOM_RATIO = 1.8
"""Value of `ZOOM_RATIO` at the floor, dimensionless; tuned with `tools/measure_avoidance.py`."""
NEAR_FLOOR = 1.2
"""Height above the floor below which level ratio, climb band and zoom ratio begin to change [turn
lengths]; 76 m at 25 m/s, tuned with `tools/measure_avoidance.py`."""
AT_FLOOR = 0.6
"""Height above the floor below which level ratio, climb band and zoom ratio have their values at
the floor [turn lengths]; 38 m at 25 m/s, tuned with `tools/measure_avoidance.py`."""
DESCENT_RATIO = 0.98
"""Ratio of the airspeed at which half of the steepest descent is allowed to the fastest airspeed;
chosen."""
AIRSPEED_BAND = 0.12
"""Airspeed above that of `DESCENT_RATIO` from which on no descent is allowed, as a share of the
cruise airspeed; chosen wide, since a narrow band answered every gust."""
TURN_GLIDE_RATIO = 1.2
"""Ratio of the sine of the descent in a turn to that of the straight glide without thrust: a turn
has more drag, and the descent is flown a little faster. Tuned with `tools/measure_poses.py`; with
1.36, aircraft ran wide of turns of the ordinary radius."""
MAX_RADIUS_FACTOR = 1.15
"""Largest factor by which turns are widened for a faster and steeper descent; tuned with
`tools/measure_poses.py --height 80`."""


@compiled
def descent_at_airspeed(aircraft: Performance, goal_slope: float) -> float:
    """Steepest angle of a descent that hardly gains airspeed, or that of the goal [rad], positive.

    Without thrust the aeroplane glides at the angle whose sine is trim / per_climb. In a turn, with
    more drag and a little faster, the sine is TURN_GLIDE_RATIO times that.
    """
    glide = TURN_GLIDE_RATIO * aircraft.thrust_trim / aircraft.thrust_per_climb
    angle = max(math.asin(min(glide, 1.0)), math.atan(-goal_slope))
    return min(aircraft.descent_max, angle)


@compiled
def steepest_descent(aircraft: Performance, radius_factor: float, goal_slope: float) -> float:
    """Steepest angle of a descent in turns that are wider by `radius_factor` [rad], positive.

    Wider turns are flown at a larger airspeed. Its square is in proportion to the radius, at the
    same bank, and to the drag.
    """
    faster = math.asin(min(radius_factor * math.sin(descent_at_airspeed(aircraft, 0.0)), 1.0))
    return min(aircraft.descent_max, max(faster, descent_at_airspeed(aircraft, goal_slope)))


@compiled
def largest_radius_factor(aircraft: Performance) -> float:
    """Factor by which turns are widened for a steeper descent, within the aircraft's limits."""
    angle = max(descent_at_airspeed(aircraft, 0.0), 1e-3)
    fastest = DESCENT_RATIO * aircraft.airspeed_max / max(aircraft.airspeed_cruise, 1e-3)
    most = min(
        math.sin(aircraft.descent_max) / math.sin(angle), fastest * fastest / TURN_GLIDE_RATIO
    )
    return max(1.0, min(MAX_RADIUS_FACTOR, most))


@compiled
def highest_path(airspeed: float, flown: float, above: float, aircraft: Performance) -> float:
    """Largest sine of the path angle that the airspeed allows: airspeed goes before height.

    The path is level at LEVEL_RATIO times the slowest airspeed. CLIMB_BAND faster it is the
    steepest climb, and its sine grows on to ZOOM_RATIO times as much, which `plan_slope` asks for
    only where the air sinks. CLIMB_BAND slower it is the glide without thrust. Near the floor,
    `above` it [m], the FLOOR values hold. The airspeed of level flight is never above 1 -
    CLIMB_BAND times the airspeed to fly, `flown` [m/s].
    """
    last = floor_share(above, turn_length(flown))
    room = blended(CLIMB_BAND, FLOOR_CLIMB_BAND, last) * flown
    safe = min(
        blended(LEVEL_RATIO, FLOOR_LEVEL_RATIO, last) * aircraft.airspeed_min,
        (1.0 - CLIMB_BAND) * flown,
    )
    part = max(-1.0, min(blended(ZOOM_RATIO, FLOOR_ZOOM_RATIO, last), (airspeed - safe) / room))
    steepest = aircraft.climb_max if part > 0.0 else descent_at_airspeed(aircraft, 0.0)
    return part * math.sin(steepest)


@compiled
def floor_share(above: float, unit: float) -> float:
    """Share of the values at the floor: 0 from NEAR_FLOOR above it on, 1 up to AT_FLOOR.

    `above` is the height above the floor [m], `unit` the turn length [m].
    """
    return max(0.0, min(1.0, (NEAR_FLOOR - above / unit) / (NEAR_FLOOR - AT_FLOOR)))


@compiled
def share(margin: float, band: float) -> float:
    """Share of the steepest descent that is allowed at an airspeed `margin` below its limit [m/s].

    It is 1 from `band` below the limit, 1/2 at the limit, and 0 from `band` above it [m/s].
    """
    return max(0.0, min(1.0, 0.5 + 0.5 * margin / band))


@compiled
def path_limits(
    airspeed: float, flown: float, above: float, aircraft: Performance
) -> tuple[float, float]:
    """Steepest path angles through the air, down and up [rad], at an airspeed without its gusts.

    The airspeed comes before the height, also where it is the air that sinks or rises.

    Args:
        airspeed: true airspeed [m/s].
        flown: true airspeed to fly [m/s].
        above: height above the floor, infinite where there is none [m].
        aircraft: its limits.
    """
    band = AIRSPEED_BAND * aircraft.airspeed_cruise
    down = share(DESCENT_RATIO * aircraft.airspeed_max - airspeed, band)
    return -down * aircraft.descent_max, math.asin(highest_path(airspeed, flown, above, aircraft))


@compiled
def path_angle(
    slope: float,
    groundspeed: float,
    wind_down: float,
    airspeed: float,
) -> float:
    """Path angle through the air that makes good the slope over ground [rad], not limited.

    Level over ground where the wind blows the vehicle back: no slope is made good there.

    Args:
        slope: slope dh/ds over ground.
        groundspeed: speed over ground along the course [m/s].
        wind_down: vertical wind, down positive [m/s].
        airspeed: true airspeed [m/s].
    """
    climb = slope * max(groundspeed, 0.0) + wind_down
    return math.asin(max(-1.0, min(1.0, climb / airspeed)))


@compiled
def allowed_path(asked: float, limits: tuple[float, float]) -> tuple[float, float]:
    """The path angle within the limits, and the one that thrust is set for, no smaller [rad].

    Thrust is set for the whole climb that is `asked` for, so that the airspeed soon allows more of
    it. The `limits` are those of `path_limits`.
    """
    gamma = max(limits[0], min(limits[1], asked))
    return gamma, max(gamma, asked)
