"""How fast an aircraft follows its autopilot, and the gains that go with it."""

from vfguide.aircraft.performance import Gains
from vfguide.geometry.units import G0

FAST, PROMPT = 0.08, 0.2
"""Roll responses [s] that are followed by the whole gain of attitude, and of the azimuth: slower
ones get less in proportion, since the inner loop has to be the faster one."""
BEGIN = 0.02
"""63 % of a fast step of the roll rate, for which those times stand, less the lag of first order
that a flight shows [s]: 0.01 to 0.03 for the shipped aircraft, nothing with slow servos."""
ROLL_IN = 6.0
"""The bank that an error of the azimuth asks for is rolled in within this time for each radian of
the error, at the largest roll rate [s]: a larger gain swings between the limits of that rate."""
AIRSPEED_BANDWIDTH = 0.8
"""Errors of the airspeed vanish at this rate [1/s], ..."""
ENGINE_BANDWIDTH = 0.6
"""... or, where the engine is the slower one, at this over its time."""
INTEGRAL = 0.24
"""Bandwidth of the integral, over that of the airspeed."""


def suited(gains: Gains, roll_time: float, roll_rate: float) -> Gains:
    """Gains for an aircraft that follows, of those for one that follows at once.

    Args:
        gains: for a roll response within FAST.
        roll_time: 63 % of a step of the roll rate [s].
        roll_rate: the largest that is asked for [rad/s].
    """
    k_lateral = gains.k_lateral * min(1.0, PROMPT / roll_time)
    return gains._replace(
        k_w=gains.k_w * min(1.0, FAST / roll_time),
        k_lateral=min(k_lateral, ROLL_IN * roll_rate * G0 / gains.airspeed),
        k_elevation=gains.k_elevation * min(1.0, FAST / roll_time),
        response_lag=max(0.0, roll_time - FAST),
    )


def airspeed_gains(per_climb: float, thrust_time: float) -> tuple[float, float]:
    """Thrust setpoint for each m/s of airspeed that is missing, and for each m/s during 1 s.

    Args:
        per_climb: weight over full thrust.
        thrust_time: 63 % of a step of thrust [s].
    """
    bandwidth = min(AIRSPEED_BANDWIDTH, ENGINE_BANDWIDTH / max(thrust_time, 1e-6))
    per_airspeed = bandwidth * per_climb / G0
    return per_airspeed, INTEGRAL * bandwidth * per_airspeed
