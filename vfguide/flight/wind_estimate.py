"""Wind and airspeed from ground velocity, attitude, thrust, and an airspeed sensor if there is one.

An extended Kalman filter after the wind triangle: ground velocity = wind + V d, where d is the
direction of flight through the air: that of the fuselage, less the angle of attack that carries the
aircraft, less the slip that the force from the side shows. Along d wind and airspeed cannot be told
apart; a turn does it, and between turns the sensor, or else the model:
V' = g ((thrust - drag) / weight - sin(path angle)), the path angle from pitch less the angle of
attack. This needs no vertical wind: gusts move pitch and path alike.

Errors that last, of slip in gusts and of velocity, count as white noise that carries as little.
"""

import math
from typing import NamedTuple

from vfguide.flight.air_state import (
    AIRSPEED,
    BEFORE,
    EAST,
    MODEL,
    NORTH,
    PUSH,
    SENSOR,
    SIDE,
    STATES,
    TIME,
    TOLD_BEFORE,
    YAW,
    AirState,
    P,
    X,
)
from vfguide.flight.performance import Performance
from vfguide.geometry.compiled import compiled
from vfguide.geometry.units import DEG, G0
from vfguide.geometry.vector import Mat3, Vec3, dot, scale, sub, unit

GROWTH = (0.3, 0.3, 0.4, (0.25 * DEG) ** 2, 1e-4, 1e-4)
"""Growth of the variances in a second: gusts carry wind and airspeed away."""
FIRST = (0.0, 0.0, 2.5, 3.0 * DEG, 1.0, 0.15)
"""Standard deviations before anything is measured; of the wind, what the others leave."""
ALONG, ACROSS = 0.8, 1.3
"""Errors of the wind triangle along and across the direction of flight [m/s], lasting a second."""
SENSED = 0.5
"""Noise of the airspeed sensor [m/s], lasting 0.1 s: it is told ten times a second."""
WIND_TOLD = 1.0
"""Error of the autopilot's wind [m/s], lasting 5 s."""
RECALL = 5.0
"""The airspeed of the model follows the estimate in this time [s]."""
STEEPEST = 60.0 * DEG
"""Banks beyond this count as this."""
SIDEWAYS = 0.12
"""Force from the side for each radian of slip, over lift for each radian of angle of attack: 0.15
for the Aerosonde of Beard and McLain (CY_beta -0.83, CL_alpha 5.61), 0.06 for a Cessna 172. Where
it is half of this, half of the slip goes unseen."""
MOST_SLIP = 15.0 * DEG
SIDE_TIME = 0.5
"""The force from the side is smoothed over this time [s]."""


class Flown(NamedTuple):
    """How the aircraft flies, as its attitude shows."""

    d_n: Vec3
    """Direction of flight through the air, NED."""
    push: float
    """Acceleration along it by the model [m/s^2]."""
    slope: float
    """Its change with airspeed [1/s]."""


@compiled
def flown(R_nb: Mat3, airspeed: float, thrust: float, side: float, aircraft: Performance) -> Flown:
    """Direction and acceleration of flight at this attitude, airspeed, thrust and side force."""
    cosine = max(math.cos(STEEPEST), R_nb[2][2] / math.hypot(R_nb[2][1], R_nb[2][2]))
    load, speed = 1.0 / cosine, max(airspeed, 0.5 * aircraft.airspeed_min)
    lift = aircraft.alpha_load * load / (speed * speed)
    c, s = math.cos(aircraft.alpha_zero + lift), math.sin(aircraft.alpha_zero + lift)
    b = slip(side, speed, aircraft)
    d_n = unit(
        (
            c * R_nb[0][0] + b * R_nb[0][1] + s * R_nb[0][2],
            c * R_nb[1][0] + b * R_nb[1][1] + s * R_nb[1][2],
            c * R_nb[2][0] + b * R_nb[2][1] + s * R_nb[2][2],
        )
    )
    ratio = speed / aircraft.airspeed_cruise
    induced = aircraft.thrust_per_load * load * load / (ratio * ratio)
    parasitic = (aircraft.thrust_trim - aircraft.thrust_per_load) * ratio * ratio
    push = G0 * ((thrust - parasitic - induced) / aircraft.thrust_per_climb + d_n[2])
    slope = 2.0 * G0 * (induced - parasitic) / (speed * aircraft.thrust_per_climb)
    return Flown(d_n, push, slope - 2.0 * G0 * lift * cosine / speed)


@compiled
def slip(side: float, airspeed: float, aircraft: Performance) -> float:
    """Sideslip [rad], positive with the air from the right, of a specific force `side` [m/s^2]."""
    stiffness = SIDEWAYS * G0 * airspeed * airspeed / aircraft.alpha_load
    return max(-MOST_SLIP, min(MOST_SLIP, -side / stiffness))


@compiled
def felt_force(air: AirState, v_n: Vec3, dt: float) -> Vec3:
    """The specific force v' - g since the velocity before, NED [m/s^2]; `v_n` is the next one."""
    before = (air[BEFORE], air[BEFORE + 1], air[BEFORE + 2])
    for k in range(3):
        air[BEFORE + k] = v_n[k]
    return sub(scale(1.0 / dt, sub(v_n, before)), (0.0, 0.0, G0))


@compiled
def feel_side(air: AirState, force_n: Vec3, R_nb: Mat3, dt: float) -> None:
    """The specific force across the fuselage, (v' - g) . y_b."""
    side = dot(force_n, (R_nb[0][1], R_nb[1][1], R_nb[2][1]))
    air[SIDE] += dt / (SIDE_TIME + dt) * (side - air[SIDE])


@compiled
def begin(air: AirState, time: float, v_n: Vec3, airspeed: float, d_n: Vec3) -> None:
    """The first estimate, from one look: fills `air`."""
    air[:] = 0.0
    air[TIME] = time
    for k in range(3):
        air[BEFORE + k] = air[TOLD_BEFORE + k] = v_n[k]
    air[X + NORTH] = v_n[0] - airspeed * d_n[0]
    air[X + EAST] = v_n[1] - airspeed * d_n[1]
    air[X + AIRSPEED] = air[MODEL] = airspeed
    for k in range(STATES):
        air[P + k * (STATES + 1)] = FIRST[k] ** 2
    for k in (NORTH, EAST):
        air[P + k * (STATES + 1)] = 400.0
    watch_triangle(air, v_n, d_n, 0.1)


@compiled
def predict(air: AirState, how: Flown, dt: float) -> None:
    """Move the estimate on by `dt` [s]."""
    air[X + AIRSPEED] += dt * (how.push + air[X + PUSH])
    # P = F P F^T + Q, where F is the identity but for the row of the airspeed.
    keep = 1.0 + dt * how.slope
    for _ in range(2):
        for k in range(STATES):
            at = P + AIRSPEED * STATES + k
            air[at] = keep * air[at] + dt * air[P + PUSH * STATES + k]
        transpose_covariance(air)
    for k in range(STATES):
        air[P + k * (STATES + 1)] += GROWTH[k] * dt


@compiled
def transpose_covariance(air: AirState) -> None:
    """The second factor of F P F^T is the first one on the transpose."""
    for i in range(STATES):
        for j in range(i):
            a, b = P + i * STATES + j, P + j * STATES + i
            air[a], air[b] = air[b], air[a]


Row = tuple[float, float, float, float, float, float]


@compiled
def observe(air: AirState, row: Row, innovation: float, variance: float) -> None:
    """Take one measurement that is `row` times the estimates, off by `innovation`."""
    ph = (
        _product(air, row, 0),
        _product(air, row, 1),
        _product(air, row, 2),
        _product(air, row, 3),
        _product(air, row, 4),
        _product(air, row, 5),
    )
    total = variance
    for k in range(STATES):
        total += row[k] * ph[k]
    for i in range(STATES):
        air[X + i] += ph[i] * innovation / total
        for j in range(STATES):
            air[P + i * STATES + j] -= ph[i] * ph[j] / total


@compiled
def _product(air: AirState, row: Row, i: int) -> float:
    """(P H^T)_i."""
    total = 0.0
    for j in range(STATES):
        total += air[P + i * STATES + j] * row[j]
    return total


@compiled
def watch_triangle(air: AirState, v_n: Vec3, d_n: Vec3, dt: float) -> None:
    """Wind, airspeed and azimuth from the ground velocity, along and across the flight."""
    level = max(math.hypot(d_n[0], d_n[1]), 0.1)
    turn = air[X + YAW]
    azimuth = math.atan2(d_n[1], d_n[0]) + turn
    c, s = math.cos(azimuth), math.sin(azimuth)
    north, east = v_n[0] - air[X + NORTH], v_n[1] - air[X + EAST]
    speed = level * air[X + AIRSPEED]
    along, across = c * north + s * east - speed, c * east - s * north
    observe(air, (-s, c, 0.0, speed, 0.0, 0.0), across, ACROSS * ACROSS / dt)
    observe(air, (c, s, level, 0.0, 0.0, 0.0), along, ALONG * ALONG / dt)


@compiled
def watch_sensor(air: AirState, told: float, dt: float) -> None:
    """Airspeed from its sensor, `told` [m/s]."""
    row = (0.0, 0.0, 1.0, 0.0, 1.0, 0.0)
    error = told - air[X + AIRSPEED] - air[X + SENSOR]
    observe(air, row, error, SENSED * SENSED * 0.1 / dt)


@compiled
def watch_wind(air: AirState, wind_n: Vec3, dt: float) -> None:
    """The autopilot's own estimate of the wind [m/s]."""
    variance = WIND_TOLD * WIND_TOLD * 5.0 / dt
    observe(air, (1.0, 0.0, 0.0, 0.0, 0.0, 0.0), wind_n[0] - air[X + NORTH], variance)
    observe(air, (0.0, 1.0, 0.0, 0.0, 0.0, 0.0), wind_n[1] - air[X + EAST], variance)


@compiled
def follow_model(air: AirState, how: Flown, dt: float) -> None:
    """The airspeed that pitch and thrust alone ask for: what the sensor is judged by.

    It forgets in RECALL, so that errors of the model do not add up, and is `how` at its own
    airspeed.
    """
    speed = air[MODEL]
    push = how.push + how.slope * (speed - air[X + AIRSPEED]) + air[X + PUSH]
    air[MODEL] = speed + dt * (push + (air[X + AIRSPEED] - speed) / RECALL)
