"""States of one aircraft, and what every setpoint for it must keep to."""

import math

from aeroplanes import AEROSONDE

from vfguide.aircraft.performance import Gains
from vfguide.aircraft.point_mass import PointMass
from vfguide.aircraft.state import FlightState
from vfguide.aircraft.vehicle import Vehicle
from vfguide.geometry.so3 import from_euler
from vfguide.geometry.vector import matmul, matvec

GAINS = Gains(25.0)
VEHICLE = Vehicle(AEROSONDE, GAINS)
NORTH = FlightState(
    5.0, (0.0, 0.0, -150.0), (25.0, 0.0, 0.0), from_euler(0.0, 0.0, 0.0), 25.0, (math.nan,) * 3
)
"""Level flight to the north, in a wind that is not known."""


def state(p_n, yaw, roll=0.1, wind=(0.0, 0.0, 0.0), time=1.0):
    v_n = (25.0 * math.cos(yaw) + wind[0], 25.0 * math.sin(yaw) + wind[1], 0.5)
    return FlightState(time, p_n, v_n, from_euler(roll, 0.06, yaw), 25.0, wind)


def turned(R, each):
    return FlightState(
        each.time,
        matvec(R, each.p_n),
        matvec(R, each.v_n),
        matmul(R, each.R_nb),
        each.airspeed,
        matvec(R, each.wind_n),
    )


def is_within_limits(setpoint):
    rates = zip(setpoint.omega_b, AEROSONDE.rate_max, strict=True)
    return all(abs(rate) <= most for rate, most in rates) and 0.0 <= setpoint.thrust <= 1.0


def motion(p_n=(0.0, 0.0, -150.0), azimuth=0.0, bank=0.0, gamma=0.0, airspeed=25.0):
    return PointMass(p_n, azimuth, bank, gamma, airspeed)
