"""The lateral half of the flight law: from the state to a course, and from there to a turn.

The lateral acceleration is feed-forward of the course rate plus feedback of the azimuth:
a = V cos(gamma) psi' + k_lateral V (psi wanted - psi).
"""

import math

from vfguide.aircraft.coordinated_turn import Lift, lift_for_turn
from vfguide.aircraft.envelope import radius_in, usable_bank
from vfguide.aircraft.performance import Gains, Performance
from vfguide.aircraft.state import FlightState
from vfguide.geometry.angles import FULL_TURN, wrap
from vfguide.guidance.wind_triangle import Heading
from vfguide.kernels.compiled import compiled
from vfguide.paths.course_laws import Course, PlanarState, loiter_course
from vfguide.paths.leg import Leg
from vfguide.paths.leg_phases import leg_course
from vfguide.planning.leg_planning import in_goal_plane
from vfguide.planning.objective import GuidanceTarget

LATERAL_FEEDBACK = 12.0
"""Largest lateral acceleration that the feedback of the azimuth commands [m/s^2], about that of a
turn at 50 degrees of bank; chosen."""
OPPOSITE_ERROR = 2.5
"""Azimuth error above which a turn goes on to its present side [rad]; chosen, so that the turn to a
goal behind does not change sides again and again."""


@compiled
def target_course(
    state: FlightState, target: GuidanceTarget, aircraft: Performance, gains: Gains, leg: Leg
) -> Course:
    """Course over ground along a leg or around a circle, relative to the target's."""
    at = in_goal_plane(state, target)
    if target.circle != 0.0:
        return loiter(at, target, leg)
    core = gains.core * radius_in(0.0, usable_bank(aircraft, gains, gains.airspeed), gains)
    return leg_course(leg, at, core)


@compiled
def loiter(at: PlanarState, target: GuidanceTarget, leg: Leg) -> Course:
    """Course around the target's circle, which touches the target's pose."""
    radius = max(target.radius, leg.radius)
    about = PlanarState(at.x, at.y - target.circle * radius, at.vx, at.vy)
    return loiter_course(about, target.circle, radius)


@compiled
def plan_turn(
    heading: Heading,
    azimuth: float,
    gamma: float,
    speed: float,
    bank_max: float,
    aircraft: Performance,
    gains: Gains,
    turning: float,
) -> tuple[Lift, float]:
    """Lift that turns the air velocity onto the wanted azimuth, and the side (+1 right, -1 left).

    An error near 180 degrees is corrected to the side of the present turn.

    Args:
        heading: wanted azimuth of the air velocity and its rate.
        azimuth: azimuth of the air velocity [rad].
        gamma: path angle through the air [rad].
        speed: true airspeed [m/s].
        bank_max: largest bank [rad].
        aircraft: its load factor limits.
        gains: gains of the guidance.
        turning: side of the turn at the step before.
    """
    error = wrap(heading.psi - azimuth)
    if abs(error) > OPPOSITE_ERROR and error * turning < 0.0:
        error += FULL_TURN * turning
    feedback = gains.k_lateral * speed * error
    feedback = max(-LATERAL_FEEDBACK, min(LATERAL_FEEDBACK, feedback))
    lateral = speed * math.cos(gamma) * heading.psi_rate + feedback
    lift = lift_for_turn(lateral, gamma, bank_max, aircraft.load_max)
    return lift, 1.0 if lateral >= 0.0 else -1.0
