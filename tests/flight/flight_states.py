"""One aircraft, states for it, and what every setpoint must keep to."""

import math

from vfguide.flight.guidance import guide
from vfguide.flight.memory import Target, fresh_memory
from vfguide.flight.performance import Gains, Performance, packed
from vfguide.flight.state import FlightState
from vfguide.geometry.so3 import from_euler
from vfguide.geometry.units import DEG
from vfguide.geometry.vector import matmul, matvec

AEROSONDE = Performance(
    airspeed_min=18.0,
    airspeed_cruise=25.0,
    airspeed_max=32.0,
    bank_max=50.0 * DEG,
    load_max=1.7,
    load_min=0.3,
    climb_max=10.0 * DEG,
    descent_max=10.0 * DEG,
    rate_max=(80.0 * DEG, 35.0 * DEG, 29.0 * DEG),
    alpha_zero=-2.48 * DEG,
    alpha_load=3493.0 * DEG,
    thrust_trim=0.3,
    thrust_per_climb=3.0,
    thrust_per_load=0.04,
    thrust_per_airspeed=0.24,
    thrust_integral=0.046,
)
GAINS = Gains(25.0)
LAW = packed(AEROSONDE, GAINS)
GOAL = Target((0.0, 0.0, -150.0), 0.5, 0.0, 0.0, 0.0)


def state(p_n, yaw, roll=0.1, wind=(0.0, 0.0, 0.0), time=1.0):
    v_n = (25.0 * math.cos(yaw) + wind[0], 25.0 * math.sin(yaw) + wind[1], 0.5)
    return FlightState(time, p_n, v_n, from_euler(roll, 0.06, yaw), 25.0, wind)


def steps(states, target):
    memory = fresh_memory()
    for each in states:
        setpoint, memory, wish = guide(each, target, AEROSONDE, GAINS, memory)
    return setpoint, wish


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
