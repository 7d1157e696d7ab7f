"""Gain scheduling: gains that suit how fast an aircraft follows its autopilot."""

from vfguide.aircraft.performance import Gains
from vfguide.geometry.units import G0

FAST_ROLL = 0.08
"""Longest roll response time with the full attitude gain [s]; the default gains are made for it.
Slower aircraft get less gain in proportion, since the inner loop has to be the faster one."""
PROMPT_ROLL = 0.2
"""Longest roll response time with the full azimuth gain [s]; chosen with flights of the shipped
aircraft."""
STEP_DELAY = 0.02
"""Roll response time (63 % of a fast step of the roll rate) less the first-order lag that a flight
shows [s], measured by `tools/measure_aircraft.py`: 0.01 to 0.03 for the shipped aircraft, 0 with
slow servos."""
ROLL_IN = 6.0
"""Longest time that a roll at the largest roll rate may take to the bank V psi' / g that an azimuth
error of one radian asks for [s]; chosen with flights of the Cessna 172, which rolled from side to
side with larger gains."""
AIRSPEED_BANDWIDTH = 0.8
"""Bandwidth of the airspeed control with a fast engine [1/s]; chosen."""
ENGINE_BANDWIDTH = 0.6
"""Largest ratio of the bandwidth of the airspeed control to that of the engine; chosen."""
INTEGRAL_RATIO = 0.24
"""Ratio of the bandwidth of the integral to that of the airspeed control; chosen."""


def suited(gains: Gains, roll_time: float, roll_rate: float) -> Gains:
    """Gains for a slower roll response than the one that the default gains are made for.

    Args:
        gains: for a roll response within FAST_ROLL.
        roll_time: time to 63 % of a step of the roll rate [s].
        roll_rate: the largest that is commanded [rad/s].
    """
    k_lateral = gains.k_lateral * min(1.0, PROMPT_ROLL / roll_time)
    return gains._replace(
        k_w=gains.k_w * min(1.0, FAST_ROLL / roll_time),
        k_lateral=min(k_lateral, ROLL_IN * roll_rate * G0 / gains.airspeed),
        k_elevation=gains.k_elevation * min(1.0, FAST_ROLL / roll_time),
        response_lag=max(0.0, roll_time - FAST_ROLL),
    )


def airspeed_gains(per_climb: float, thrust_time: float) -> tuple[float, float]:
    """Proportional [s/m] and integral gain [1/m] from the airspeed error to the thrust setpoint.

    Args:
        per_climb: ratio of the weight to the full thrust.
        thrust_time: time to 63 % of a step of the thrust [s].
    """
    bandwidth = min(AIRSPEED_BANDWIDTH, ENGINE_BANDWIDTH / max(thrust_time, 1e-6))
    per_airspeed = bandwidth * per_climb / G0
    return per_airspeed, INTEGRAL_RATIO * bandwidth * per_airspeed
