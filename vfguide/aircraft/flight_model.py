"""Model of flight through the air: direction and acceleration from attitude, thrust and side force.

The direction of flight is that of the fuselage, less the angle of attack of the lift and the
sideslip that the side force shows. The acceleration along it is

    V' = g ((thrust - drag) / weight - sin(path angle))

with a parasitic drag in proportion to V^2 and an induced drag in proportion to n^2 / V^2 (Beard and
McLain, Small Unmanned Aircraft, 2012, chapter 4). The path angle is pitch less angle of attack. No
vertical wind enters, since gusts move pitch and path alike.
"""

import math
from typing import NamedTuple

from vfguide.aircraft.performance import Performance, nonzero_airspeed
from vfguide.geometry.angles import wrap
from vfguide.geometry.blending import blended, low_pass_share
from vfguide.geometry.units import DEG, G0
from vfguide.geometry.vector import Mat3, Vec3, dot, scale, sub, unit
from vfguide.geometry.velocity import azimuth_of
from vfguide.kernels.compiled import compiled

STEEPEST_BANK = 60.0 * DEG
"""Bank above which the load factor of a level turn is taken as that at this bank [rad]; chosen,
because 1 / cos grows without bound."""
SIDE_FORCE_RATIO = 0.12
"""Ratio of the side force per radian of sideslip to the lift per radian of angle of attack, chosen
between 0.15 of the Aerosonde in Beard and McLain (CY_beta -0.83, CL_alpha 5.61) and 0.06 of the
Cessna 172. For an aircraft with half of it, half of the sideslip goes unnoticed."""
SLIP_MAX = 15.0 * DEG
"""Largest sideslip that is derived from the side force [rad]; chosen."""
SIDE_FORCE_TIME = 0.5
"""Time constant with which the side force is smoothed [s]; chosen."""


class ModelledFlight(NamedTuple):
    """Flight through the air by the model of the aircraft."""

    d_n: Vec3
    """Direction of flight through the air, NED unit vector."""
    acceleration: float
    """Acceleration along it [m/s^2]."""
    slope: float
    """Derivative of the acceleration with respect to the airspeed [1/s]."""


@compiled
def modelled_flight(
    R_nb: Mat3, airspeed: float, thrust: float, side_force: float, aircraft: Performance
) -> ModelledFlight:
    """Direction and acceleration of flight.

    Args:
        R_nb: attitude, body FRD to NED.
        airspeed: true airspeed [m/s].
        thrust: setpoint, 0 to 1.
        side_force: specific force to the right across the fuselage [m/s^2].
        aircraft: its lift and drag.
    """
    cosine = max(math.cos(STEEPEST_BANK), R_nb[2][2] / math.hypot(R_nb[2][1], R_nb[2][2]))
    load, speed = 1.0 / cosine, nonzero_airspeed(airspeed, aircraft)
    alpha_of_load = aircraft.alpha_load * load / (speed * speed)
    alpha = aircraft.alpha_zero + alpha_of_load
    d_n = flight_direction(R_nb, alpha, slip(side_force, speed, aircraft))
    ratio = speed / aircraft.airspeed_cruise
    induced = aircraft.thrust_per_load * load * load / (ratio * ratio)
    parasitic = (aircraft.thrust_trim - aircraft.thrust_per_load) * ratio * ratio
    acceleration = G0 * ((thrust - parasitic - induced) / aircraft.thrust_per_climb + d_n[2])
    slope = 2.0 * G0 * (induced - parasitic) / (speed * aircraft.thrust_per_climb)
    return ModelledFlight(d_n, acceleration, slope - 2.0 * G0 * alpha_of_load * cosine / speed)


@compiled
def flight_direction(R_nb: Mat3, alpha: float, beta: float) -> Vec3:
    """Direction of flight, NED, at an angle of attack and a small sideslip [rad]."""
    c, s = math.cos(alpha), math.sin(alpha)
    return unit(
        (
            c * R_nb[0][0] + beta * R_nb[0][1] + s * R_nb[0][2],
            c * R_nb[1][0] + beta * R_nb[1][1] + s * R_nb[1][2],
            c * R_nb[2][0] + beta * R_nb[2][1] + s * R_nb[2][2],
        )
    )


@compiled
def sideslip_about_vertical(air_n: Vec3, nose_n: Vec3) -> float:
    """Azimuth of a velocity through the air less that of the nose, both NED [rad]."""
    return wrap(azimuth_of(air_n) - azimuth_of(nose_n))


@compiled
def slip(side_force: float, airspeed: float, aircraft: Performance) -> float:
    """Sideslip [rad], positive with the air from the right, of a specific side force [m/s^2]."""
    return max(-SLIP_MAX, min(SLIP_MAX, -side_force / side_force_slope(airspeed, aircraft)))


@compiled
def side_force_slope(airspeed: float, aircraft: Performance) -> float:
    """Specific force across the fuselage per sideslip [m/s^2/rad] at a true airspeed [m/s]."""
    return SIDE_FORCE_RATIO * G0 * airspeed * airspeed / aircraft.alpha_load


@compiled
def specific_force(before_n: Vec3, v_n: Vec3, dt: float) -> Vec3:
    """The specific force v' - g between two velocities over ground `dt` [s] apart, NED [m/s^2]."""
    return sub(scale(1.0 / dt, sub(v_n, before_n)), (0.0, 0.0, G0))


@compiled
def smoothed_side_force(side_force: float, force_n: Vec3, R_nb: Mat3, dt: float) -> float:
    """The smoothed side force [m/s^2] `dt` [s] later; its present value is (v' - g) . y_b."""
    across = dot(force_n, (R_nb[0][1], R_nb[1][1], R_nb[2][1]))
    return blended(side_force, across, low_pass_share(SIDE_FORCE_TIME, dt))
