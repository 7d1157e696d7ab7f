"""Height and airspeed of the software autopilot by total energy: TECS, as PX4 flies.

Thrust sets the rate of the total energy, pitch how it is shared between height and airspeed. Both
rates are kept as angles, divided by g V:

    total      sin(climb) + V' / g       thrust
    balance    sin(climb) - V' / g       pitch

Where thrust cannot give what is wanted, airspeed and climb each go without a part; near the stall
the climb goes without all of it.

A. Lambregts, *Vertical Flight Path and Speed Control Autopilot Design Using Total Energy
Principles*, AIAA 83-2239. Nothing here is shared with the companion's control.
"""

import math
from typing import NamedTuple

from vfguide.aircraft.performance import Performance
from vfguide.geometry.units import G0
from vfguide.kernels.compiled import compiled

HEIGHT_TIME = 3.0
"""Time constant with which errors of height decay [s]; chosen, PX4's FW_T_ALT_TC is 5 s."""
AIRSPEED_TIME = 2.0
"""Time constant with which errors of airspeed decay [s]; chosen, PX4's FW_T_TAS_TC is 5 s."""
THRUST_TIME = 12.0
"""Time constant of the integral of thrust [s]; chosen as four times HEIGHT_TIME, so that the energy
does not swing."""
PITCH_TIME = 5.0
"""Time constant of the integral of pitch [s]; chosen."""
CLIMB_ERROR_MAX = 0.15
"""Largest error of the path angle that pitch answers to [rad]; chosen."""
PITCH_DAMPING = 1.0
"""Pitch for each radian of error of the path angle, dimensionless: the role of PX4's
FW_T_PTCH_DAMP."""
THRUST_INTEGRAL_MAX = 0.5
"""Largest integral of thrust, a share of full thrust; chosen."""
PITCH_INTEGRAL_MAX = 0.1
"""Largest integral of pitch [rad]; chosen."""
ACCELERATION_MAX = 0.2
"""Largest acceleration along the path that is asked for, a share of g; chosen."""
CLIMB_SHARE = 0.25
"""Share of the energy that thrust lacks which the climb goes without, the airspeed without the
rest; chosen: PX4's FW_T_SPDWEIGHT of 0.5, and of 2 near the stall."""
SLOW_RATIO = 1.25
"""Ratio of the airspeed to that of the stall in a turn below which the airspeed takes over from the
height; chosen."""
STALLING_RATIO = 1.1
"""Ratio of the airspeed to that of the stall in a turn at which only the airspeed counts;
chosen."""
TURN_LOAD_MAX = 2.0
"""Largest load factor for which thrust is made, that of 60 degrees of bank; chosen."""


class EnergyState(NamedTuple):
    """What one step leaves for the next."""

    thrust: float
    """Integral of the missing energy, as thrust setpoint, a share of full thrust."""
    pitch: float
    """Integral of the missing path angle [rad]."""


class Longitudinal(NamedTuple):
    """What is flown, and what is missing."""

    height_missing: float
    """Height to fly less the present one [m]."""
    airspeed_missing: float
    """True airspeed to fly less the present one [m/s]."""
    airspeed: float
    """True airspeed [m/s]."""
    climb: float
    """Sine of the path angle, up positive, dimensionless."""
    bank: float
    """Bank, right wing down positive [rad]."""


@compiled
def fresh_energy() -> EnergyState:
    """The state before the first step: both integrals are 0."""
    return EnergyState(0.0, 0.0)


@compiled
def pitch_and_thrust(
    now: Longitudinal, s: EnergyState, aircraft: Performance, dt: float
) -> tuple[float, float, EnergyState]:
    """Pitch [rad], thrust (0 to 1), and what the step after this one of `dt` [s] needs."""
    speed = max(now.airspeed, aircraft.airspeed_min)
    load = min(1.0 / max(math.cos(now.bank), 1e-6), TURN_LOAD_MAX)
    climb, acceleration = wanted_rates(now, speed, aircraft)
    thrust, lack = thrust_for(climb + acceleration, load, s.thrust, aircraft)
    stalling = nearness_of_stall(now.airspeed, load, aircraft)
    share = CLIMB_SHARE + (1.0 - CLIMB_SHARE) * stalling
    given = flyable_climb(climb - share * lack, aircraft)
    missing = missing_climb(given - now.climb, stalling)
    alpha = aircraft.alpha_zero * math.cos(now.bank) + aircraft.alpha_load / (speed * speed)
    pitch = math.asin(given) + alpha + PITCH_DAMPING * missing + s.pitch
    asked = aircraft.thrust_per_climb * (climb + acceleration)
    after = integrated_thrust(s.thrust, asked, lack, dt)
    return pitch, thrust, EnergyState(after, integrated_pitch(s.pitch, missing, dt))


@compiled
def wanted_rates(now: Longitudinal, speed: float, aircraft: Performance) -> tuple[float, float]:
    """Sine of the path angle, and acceleration over g, that take the errors back.

    `speed` is the true airspeed [m/s], not below the slowest of the aircraft.
    """
    climb = flyable_climb(now.height_missing / (HEIGHT_TIME * speed), aircraft)
    acceleration = now.airspeed_missing / (AIRSPEED_TIME * G0)
    return climb, max(-ACCELERATION_MAX, min(ACCELERATION_MAX, acceleration))


@compiled
def flyable_climb(climb: float, aircraft: Performance) -> float:
    """The sine `climb` of a path angle, within the limits of the aircraft."""
    return max(-math.sin(aircraft.descent_max), min(math.sin(aircraft.climb_max), climb))


@compiled
def thrust_for(
    energy: float, load: float, integral: float, aircraft: Performance
) -> tuple[float, float]:
    """Thrust (0 to 1) for a rate of the total energy at a load factor, and the rate it lacks.

    Both rates are over g V, dimensionless; `integral` is that of the thrust, as setpoint.
    """
    level = aircraft.thrust_trim + aircraft.thrust_per_load * (load * load - 1.0) + integral
    asked = level + aircraft.thrust_per_climb * energy
    thrust = max(0.0, min(1.0, asked))
    return thrust, (asked - thrust) / aircraft.thrust_per_climb


@compiled
def nearness_of_stall(airspeed: float, load: float, aircraft: Performance) -> float:
    """0 at an airspeed [m/s] well above the stall at a load factor, 1 where it comes near."""
    margin = airspeed / (aircraft.airspeed_min * math.sqrt(load))
    return max(0.0, min(1.0, (SLOW_RATIO - margin) / (SLOW_RATIO - STALLING_RATIO)))


@compiled
def missing_climb(missing: float, stalling: float) -> float:
    """What is missing of the path angle [rad], as far as pitch may answer to it.

    `missing` is the difference of the sines, which counts as the angle; `stalling` is 0 to 1.
    An aircraft that sinks because it stalls would stall the more with its nose higher.
    """
    return max(-CLIMB_ERROR_MAX, min(CLIMB_ERROR_MAX * (1.0 - stalling), missing))


@compiled
def integrated_thrust(integral: float, missing: float, lack: float, dt: float) -> float:
    """The integral of thrust, as setpoint, `dt` [s] later; it rests while thrust is at its stop.

    `missing` is the thrust setpoint for the missing energy, `lack` the rate that thrust lacks.
    """
    if lack * missing > 0.0:
        return integral
    grown = integral + missing / THRUST_TIME * dt
    return max(-THRUST_INTEGRAL_MAX, min(THRUST_INTEGRAL_MAX, grown))


@compiled
def integrated_pitch(integral: float, missing: float, dt: float) -> float:
    """The integral of the `missing` path angle [rad] as pitch [rad], `dt` [s] later."""
    grown = integral + missing / PITCH_TIME * dt
    return max(-PITCH_INTEGRAL_MAX, min(PITCH_INTEGRAL_MAX, grown))
