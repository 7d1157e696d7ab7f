"""Law `flight` at points of a scenario: where the plan leads from there, and how that is flown."""

import math

from vfguide.aircraft.coordinated_turn import Lift, attitude_for_lift, lift_for_turn, turn_rate
from vfguide.aircraft.envelope import usable_bank
from vfguide.aircraft.path_limits import allowed_path, path_angle, path_limits
from vfguide.aircraft.performance import alpha_of_load
from vfguide.companion.plan import Plan
from vfguide.estimation.estimation import known_state
from vfguide.field_points.field_point import FieldPoint, Point
from vfguide.field_points.shortest_plan import (
    NoPlanError,
    Start,
    Surroundings,
    best_start,
    plan_in_air,
    surroundings_at,
)
from vfguide.geometry.so3 import from_euler
from vfguide.geometry.vector import Mat3, Vec3, matvec, transpose
from vfguide.geometry.velocity import azimuth_of
from vfguide.guidance.flight_law import height_above_floor, wanted_slope
from vfguide.guidance.guidance_state import fresh_guidance
from vfguide.guidance.wind_triangle import heading_for_course
from vfguide.planning.excess_wind import EXCESS_RATIO

SLOPE_STEPS = 2000
"""Largest number of steps in which the slope settles; chosen, 40 s of flight at 50 Hz."""


def flight_field(plan: Plan, point: Point, wind_n: Vec3) -> FieldPoint:
    """The direction of the plan to the first goal from a point, and the attitude that flies it.

    Args:
        plan: the plan of the vehicle.
        point: the point; of two equally short plans, the one nearer to its velocity is taken.
        wind_n: wind, blowing toward, NED [m/s].

    Raises:
        NoPlanError: there is none from there.
    """
    if math.hypot(*wind_n) > EXCESS_RATIO * plan.vehicle.gains.airspeed:
        raise NoPlanError("the wind is about as fast as the aircraft, no course can be planned")
    plan = plan_in_air(plan, point.p_n[2])
    around = surroundings_at(plan, point, wind_n)
    start = best_start(around, azimuth_of(point.v_n))
    if start.route.following.clearance < 0.0:
        raise NoPlanError("no route to the goal is found among the hazards known there")
    gamma = settled_path_angle(around, start)
    return settled(plan, start.course, start.course_rate, gamma, wind_n)


def settled(
    plan: Plan, course: float, course_rate: float, gamma: float, wind_n: Vec3
) -> FieldPoint:
    """The direction, attitude and body rates of a vehicle that has settled on a course.

    Args:
        plan: the plan of the vehicle.
        course: over ground [rad].
        course_rate: its rate [rad/s].
        gamma: path angle through the air [rad].
        wind_n: wind, blowing toward, NED [m/s].
    """
    aircraft, gains, _ = plan.vehicle
    airspeed = gains.airspeed
    level = airspeed * math.cos(gamma)
    heading = heading_for_course(course, course_rate, (wind_n[0], wind_n[1]), level)
    bank_max = usable_bank(aircraft, gains, airspeed)
    lift = lift_for_turn(level * heading.psi_rate, gamma, bank_max, aircraft.load_max)
    R_a = attitude_of(plan, heading.psi, gamma, lift)
    turn = (0.0, 0.0, turn_rate(lift.bank, airspeed))
    F = (
        math.cos(gamma) * math.cos(heading.psi),
        math.cos(gamma) * math.sin(heading.psi),
        -math.sin(gamma),
    )
    return FieldPoint(F, None, None, R_a, matvec(transpose(R_a), turn), ())


def attitude_of(plan: Plan, azimuth: float, gamma: float, lift: Lift) -> Mat3:
    """The attitude, body to NED, that flies along azimuth and path angle [rad] with a lift.

    A rigid body points where it flies.
    """
    aircraft, gains, is_rigid_body = plan.vehicle
    if is_rigid_body:
        return from_euler(lift.bank, gamma, azimuth)
    alpha = alpha_of_load(lift.load, gains.airspeed, aircraft)
    return attitude_for_lift(azimuth, gamma, lift.bank, alpha)


def settled_path_angle(around: Surroundings, start: Start) -> float:
    """The path angle through the air [rad] once the slope has followed the altitude profile."""
    aircraft, gains, _ = vehicle = around.plan.vehicle
    state, airspeed = start.objective.state, gains.airspeed
    wind, nav = (around.wind_n[0], around.wind_n[1]), known_state(state, -1.0)
    heading = heading_for_course(start.course, start.course_rate, wind, airspeed)
    s = fresh_guidance()
    for _ in range(SLOPE_STEPS):
        slope = wanted_slope(nav, start.objective, start.route, start.wanted, heading, s, vehicle)
        if slope == s.slope:
            break
        s = s._replace(slope=slope)
    above = height_above_floor(state, around.airspace)
    limits = path_limits(airspeed, airspeed, above, aircraft)
    asked = path_angle(s.slope, heading.groundspeed, around.wind_n[2], airspeed)
    gamma, _ = allowed_path(asked, limits)
    return gamma
