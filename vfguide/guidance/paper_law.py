"""Law `paper`: an aeroplane along the paper's composite field as printed, its errors corrected.

The direction of the field and its exact rate are flown at the aircraft's own speed, in the wind and
within its limits. Obstacles (F_OA) and traffic (F_CA, as robots with priority) act on the field.
After the last goal, where the paper defines nothing, the circle is flown as by law `flight`.
"""

import math

import numpy as np

from vfguide.aircraft.command import GuidanceCommand, unknown_rates
from vfguide.aircraft.envelope import usable_bank
from vfguide.aircraft.path_limits import allowed_path, path_angle, path_limits
from vfguide.aircraft.performance import nonzero_airspeed
from vfguide.aircraft.state import FlightState
from vfguide.aircraft.vehicle import Vehicle
from vfguide.airspace.detection import Airspace
from vfguide.airspace.hazards import Intruder, read_intruder
from vfguide.estimation.estimation import NavState
from vfguide.field.avoidance import avoidance_field, no_deflection
from vfguide.field.composite import deflect_by_obstacles, deflect_by_robot, free_field
from vfguide.field.goal_frame import goal_frame
from vfguide.field.robots import Robot, Spacing
from vfguide.geometry.dual import Dual3
from vfguide.geometry.vector import add, norm, scale, sub
from vfguide.geometry.velocity import azimuth_of, path_of
from vfguide.guidance import flight_law
from vfguide.guidance.guidance_state import GuidanceState
from vfguide.guidance.lateral import plan_turn
from vfguide.guidance.wind_triangle import heading_for_course
from vfguide.kernels.compiled import compiled
from vfguide.planning.objective import GuidanceTarget, Objective
from vfguide.planning.route import Route

DETECTION_RANGE = 300.0
"""Distance within which traffic acts on the field [m]: the paper's r_d, with the default value of a
scenario."""
MAX_FIELD_RATE = 1.0
"""Largest rate of the field's course that is fed forward [rad/s]; chosen above every turn of the
shipped aircraft."""
MAX_FIELD_CLIMB = 1.2
"""Largest angle of the field's direction to the horizon that is flown [rad]; chosen, so that the
slope stays finite."""


@compiled
def update(
    nav: NavState,
    goal: Objective,
    route: Route,
    airspace: Airspace | None,
    s: GuidanceState,
    vehicle: Vehicle,
) -> tuple[GuidanceCommand, GuidanceState]:
    """Bank, load factor and path angle that fly the field, and the next state of guidance."""
    if goal.target.circle != 0.0:
        return flight_law.update(nav, goal, route, airspace, s, vehicle)
    state, (aircraft, gains, _) = nav.state, vehicle
    course, turning, climb = field_direction(state, goal.target, airspace)
    air = sub(state.v_n, state.wind_n)
    speed = nonzero_airspeed(state.airspeed, aircraft)
    flown = path_of(air, speed)
    wind = (state.wind_n[0], state.wind_n[1])
    heading = heading_for_course(course, turning, wind, speed * math.cos(flown))
    bank_max = usable_bank(aircraft, gains, speed)
    lift, side = plan_turn(
        heading, azimuth_of(air), flown, speed, bank_max, aircraft, gains, s.turning
    )
    slope = math.tan(climb)
    limits = path_limits(norm(air), gains.airspeed, math.inf, aircraft)
    asked = path_angle(slope, heading.groundspeed, state.wind_n[2], speed)
    gamma, thrust_climb = allowed_path(asked, limits)
    command = GuidanceCommand(
        course,
        heading.psi,
        gamma,
        thrust_climb,
        lift.bank,
        lift.load,
        norm(sub(goal.target.p_n, state.p_n)),
        route.leg.phase,
        route.leg.radius,
        unknown_rates(),
    )
    return command, GuidanceState(slope, side, s.progress)


@compiled
def field_direction(
    state: FlightState, target: GuidanceTarget, airspace: Airspace | None
) -> tuple[float, float, float]:
    """Course of the composite field [rad], its rate [rad/s], and its climb [rad]."""
    F = composite_field(state, target, airspace)
    x, y, z = F.value
    flat = x * x + y * y
    if flat == 0.0:
        return azimuth_of(state.v_n), 0.0, 0.0
    turning = (x * F.rate[1] - y * F.rate[0]) / flat
    climb = max(-MAX_FIELD_CLIMB, min(MAX_FIELD_CLIMB, math.atan2(-z, math.sqrt(flat))))
    return math.atan2(y, x), max(-MAX_FIELD_RATE, min(MAX_FIELD_RATE, turning)), climb


@compiled
def composite_field(state: FlightState, target: GuidanceTarget, airspace: Airspace | None) -> Dual3:
    """F_OA or F_CA (Theorem 3, Algorithm 1) and its rate, NED."""
    goal = goal_frame(target.p_n, target.course, math.atan(target.slope))
    p = Dual3(state.p_n, state.v_n)
    free = free_field(goal, p)
    by = no_deflection()
    if airspace is not None:
        hazards, t = airspace.hazards, airspace.time
        chi = np.empty(len(hazards.obstacles))
        by = deflect_by_obstacles(by, free, p, t, hazards.obstacles, chi)
        for row in hazards.traffic:
            intruder = read_intruder(row)
            spacing = Spacing(0.5 * intruder.radius, DETECTION_RANGE)
            by = deflect_by_robot(by, free, p, robot_at(intruder, t), spacing)
    return avoidance_field(free, by)


@compiled
def robot_at(intruder: Intruder, t: float) -> Robot:
    """An intruder at time `t` [s] as a robot of the paper, NED."""
    progress = scale(t - intruder.time, intruder.v_n)
    return Robot(add(intruder.p_n, progress), intruder.v_n)
