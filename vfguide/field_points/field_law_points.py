"""Law `field` at points of a scenario: where it leads from there, and how that is flown."""

from dataclasses import replace

from vfguide.aircraft.air_density import in_air
from vfguide.aircraft.path_limits import allowed_path, path_angle, path_limits
from vfguide.aircraft.state import FlightState
from vfguide.companion.plan import Plan
from vfguide.earth.atmosphere import isa_density
from vfguide.field_points.field_point import FieldPoint, Point
from vfguide.field_points.flight_points import settled
from vfguide.field_points.shortest_plan import Surroundings, surroundings_at
from vfguide.geometry.so3 import from_euler
from vfguide.geometry.vector import Vec3
from vfguide.geometry.velocity import azimuth_of
from vfguide.guidance.field_barriers import barrier_of
from vfguide.guidance.field_direction import (
    free_velocity,
    led,
    slope_of,
    task_of,
)
from vfguide.guidance.flight_law import height_above_floor
from vfguide.guidance.laws import FieldLaw
from vfguide.guidance.remedies import ALL_REMEDIES
from vfguide.guidance.wind_triangle import heading_for_course
from vfguide.loop.legs import target_of
from vfguide.planning.leg_planning import predicted_state


def led_field(plan: Plan, point: Point, wind_n: Vec3) -> FieldPoint:
    """The direction of F_OA to the first goal from a point, and the attitude that flies it.

    Args:
        plan: the plan of the vehicle.
        point: the point; its velocity says on which side something dead ahead is passed.
        wind_n: wind, blowing toward, NED [m/s].

    Raises:
        NoPlanError: it is inside an obstacle.
    """
    density = isa_density(plan.origin[2] - point.p_n[2])
    plan = replace(plan, aircraft=in_air(plan.aircraft, density, plan.gains.airspeed))
    around = surroundings_at(plan, point, wind_n)
    remedies = plan.law.remedies if isinstance(plan.law, FieldLaw) else ALL_REMEDIES
    airspeed = plan.vehicle.gains.airspeed
    level = from_euler(0.0, 0.0, azimuth_of(point.v_n))
    state = FlightState(point.time, point.p_n, point.v_n, level, airspeed, wind_n)
    target = target_of(plan.legs, 0)
    F, turning = led(remedies, state, target, around.airspace, plan.vehicle)
    gamma = path_angle_of(around, state, F)
    flown = settled(plan, azimuth_of(F), turning, gamma, wind_n)
    return flown._replace(F=F, chi=transitions(around, state))


def path_angle_of(around: Surroundings, state: FlightState, F: Vec3) -> float:
    """The path angle through the air that makes good the slope of the field [rad]."""
    aircraft, gains, _ = around.plan.vehicle
    wind, airspeed = (around.wind_n[0], around.wind_n[1]), gains.airspeed
    heading = heading_for_course(azimuth_of(F), 0.0, wind, airspeed)
    limits = path_limits(airspeed, airspeed, height_above_floor(state, around.airspace), aircraft)
    asked = path_angle(slope_of(F), heading.groundspeed, around.wind_n[2], airspeed)
    return allowed_path(asked, limits)[0]


def transitions(around: Surroundings, state: FlightState) -> tuple[float, ...]:
    """Chi of each obstacle."""
    airspace, plan = around.airspace, around.plan
    if airspace is None:
        return ()
    remedies = plan.law.remedies if isinstance(plan.law, FieldLaw) else ALL_REMEDIES
    ahead = predicted_state(state, plan.vehicle.gains) if remedies.lead else state
    task = task_of(remedies, ahead, target_of(plan.legs, 0), plan.vehicle)
    g = free_velocity(ahead.p_n, task)
    return tuple(
        barrier_of(airspace.hazards, i, ahead.p_n, airspace.time, g, task).chi
        for i in range(len(airspace.hazards.obstacles))
    )
