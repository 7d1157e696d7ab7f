"""Law `field`: an aeroplane led along the paper's avoidance field, with a remedy for what it lacks.

The direction of F_OA is made good over ground by the wind triangle, in a coordinated turn, within
the limits of the aircraft. The free field is the paper's in the horizontal plane of the goal, with
the altitude profile of law `flight` as its slope; hazards deflect both. What the print lacks on an
aeroplane has a remedy, each with its switch (`Remedies`). The last turn radii to the goal are
flown as by law `flight`, and so is a route around hazards where the field comes no nearer.
"""

import math
from typing import NamedTuple

from vfguide.aircraft.command import GuidanceCommand
from vfguide.aircraft.envelope import flyable_radius, usable_bank
from vfguide.aircraft.path_limits import allowed_path, path_angle, path_limits
from vfguide.aircraft.performance import Gains, turn_length
from vfguide.aircraft.state import FlightState
from vfguide.aircraft.vehicle import Vehicle
from vfguide.airspace.detection import Airspace
from vfguide.airspace.hazards import hazard_count
from vfguide.estimation.estimation import NavState, step_time
from vfguide.geometry.angles import wrap
from vfguide.geometry.vector import Vec3, add, norm, scale, sub
from vfguide.geometry.velocity import azimuth_of, horizontal_norm, path_of
from vfguide.guidance import flight_law
from vfguide.guidance.altitude_profile import limited_slope, plan_slope
from vfguide.guidance.field_barriers import FieldTask, barrier_of
from vfguide.guidance.flown_avoidance import (
    AircraftMotion,
    FlownField,
    flown_field,
    no_barriers,
    past_barrier,
)
from vfguide.guidance.free_line import free_course, line_length
from vfguide.guidance.guidance_state import GuidanceState
from vfguide.guidance.lateral import plan_turn
from vfguide.guidance.remedies import Remedies
from vfguide.guidance.wind_triangle import heading_for_course
from vfguide.kernels.compiled import compiled
from vfguide.planning.leg_planning import predicted_state
from vfguide.planning.objective import GuidanceTarget, Objective
from vfguide.planning.route import Route

APPROACH_RADII = 3.0
"""Distance from the goal within which the approach is that of law `flight` [turn radii]; chosen."""
DIFFERENCE_TIME = 0.02
"""Time over which the field is differenced along the motion [s]; chosen."""
PATIENCE = 12.0
"""Time without coming nearer after which a route is asked for [turn lengths over airspeed]; chosen,
nearly two full turns."""
PROGRESS = 1.0
"""By how much nearer counts as nearer [turn lengths]; chosen."""
RESUME = 4.0
"""By how much nearer a route has to come before the field leads again [turn radii]; chosen."""
LARGEST_TURN_RATE = 1.0
"""Largest rate of the course that is fed forward [rad/s]; chosen above every turn of the shipped
aircraft."""


@compiled
def update(
    remedies: Remedies,
    nav: NavState,
    goal: Objective,
    route: Route,
    airspace: Airspace | None,
    s: GuidanceState,
    vehicle: Vehicle,
) -> tuple[GuidanceCommand, GuidanceState]:
    """Bank, load factor and path angle that fly the field, and the next state of guidance."""
    if goal.begins:
        s = GuidanceState(s.slope, s.turning, True, math.inf, nav.state.time)
    state, (aircraft, gains, _) = goal.state, vehicle
    radius = flyable_radius(state, usable_bank(aircraft, gains, gains.airspeed), gains)
    away = sub(state.p_n, goal.target.p_n)
    is_near = remedies.approach and horizontal_norm(away) < APPROACH_RADII * radius
    if s.leads and not is_near and goal.target.circle == 0.0:
        return lead(remedies, nav, goal, route, airspace, s, vehicle)
    command, after = flight_law.update(nav, goal, route, airspace, s, vehicle)
    length = line_length(state.p_n, goal.target, radius, remedies.bounded_circles)
    leads = not is_near and length < s.nearest - RESUME * radius
    nearest = length if leads or is_near else s.nearest
    return command, GuidanceState(after.slope, after.turning, leads, nearest, nav.state.time)


class Led(NamedTuple):
    """Where the field leads from a state."""

    F: Vec3
    """F_OA as a velocity over ground, NED [m/s]; its length has no meaning."""
    turning: float
    """Rate of its course along the motion [rad/s]."""
    length: float
    """Length of the line of the free field to the goal [m]."""


@compiled
def lead(
    remedies: Remedies,
    nav: NavState,
    goal: Objective,
    route: Route,
    airspace: Airspace | None,
    s: GuidanceState,
    vehicle: Vehicle,
) -> tuple[GuidanceCommand, GuidanceState]:
    """The command that follows the field, and the next state; arguments as of `update`."""
    state, (aircraft, gains, _) = goal.state, vehicle
    air = sub(state.v_n, state.wind_n)
    speed = max(state.airspeed, 0.5 * aircraft.airspeed_min)
    flown = path_of(air, speed)
    F, turning, length = led(remedies, state, goal.target, airspace, vehicle)
    wind = (state.wind_n[0], state.wind_n[1])
    heading = heading_for_course(azimuth_of(F), turning, wind, speed * math.cos(flown))
    slope = limited_slope(slope_of(F), s.slope, gains.airspeed, step_time(nav))
    above = flight_law.height_above_floor(state, airspace)
    limits = path_limits(norm(air), gains.airspeed, above, aircraft)
    asked = path_angle(slope, heading.groundspeed, state.wind_n[2], speed)
    gamma, climb = allowed_path(asked, limits)
    bank_max = usable_bank(aircraft, gains, speed)
    lift, side = plan_turn(
        heading, azimuth_of(air), flown, speed, bank_max, aircraft, gains, s.turning
    )
    leg = route.leg
    command = GuidanceCommand(
        azimuth_of(F),
        heading.psi,
        gamma,
        climb,
        lift.bank,
        lift.load,
        length,
        leg.phase,
        leg.radius,
    )
    leads, nearest, since = follow_progress(length, nav.state.time, s, gains)
    leads |= not remedies.search
    return command, GuidanceState(slope, side, leads, nearest, since)


@compiled
def follow_progress(
    length: float, time: float, s: GuidanceState, gains: Gains
) -> tuple[bool, float, float]:
    """Whether the field still leads nearer; the least length of its line [m], and when [s].

    Args:
        length: of the line of the free field now [m].
        time: now [s].
        s: the state at the step before.
        gains: the airspeed, to which distances and times are scaled.
    """
    unit_length = turn_length(gains.airspeed)
    if length < s.nearest - PROGRESS * unit_length:
        return True, length, time
    if time - s.since < PATIENCE * unit_length / gains.airspeed:
        return True, s.nearest, s.since
    return False, length, s.since


@compiled
def slope_of(velocity: Vec3) -> float:
    """Slope dh/ds of a velocity, NED."""
    return -velocity[2] / max(1e-9, horizontal_norm(velocity))


@compiled
def led(
    remedies: Remedies,
    state: FlightState,
    target: GuidanceTarget,
    airspace: Airspace | None,
    vehicle: Vehicle,
) -> Led:
    """Where the field leads from a state; nothing before it matters.

    Args:
        remedies: what is done beyond the print.
        state: state of the vehicle, in the frame in which the target stands.
        target: the goal.
        airspace: the known hazards; None: there are none.
        vehicle: its aircraft and gains.
    """
    gains = vehicle.gains
    ahead = predicted_state(state, gains) if remedies.lead else state
    task = task_of(remedies, ahead, target, vehicle)
    t = 0.0 if airspace is None else airspace.time
    F = field_velocity(ahead.p_n, t, task, airspace)
    later = add(ahead.p_n, scale(DIFFERENCE_TIME, ahead.v_n))
    F_later = field_velocity(later, t + DIFFERENCE_TIME, task, airspace)
    turning = wrap(azimuth_of(F_later) - azimuth_of(F)) / DIFFERENCE_TIME
    most = LARGEST_TURN_RATE if remedies.lead else 0.0
    length = line_length(ahead.p_n, target, task.radius, remedies.bounded_circles)
    return Led(F, max(-most, min(most, turning)), length)


@compiled
def task_of(
    remedies: Remedies, ahead: FlightState, target: GuidanceTarget, vehicle: Vehicle
) -> FieldTask:
    """What the field is asked for; `ahead` is the state for which the turn is planned."""
    aircraft, gains, _ = vehicle
    radius = flyable_radius(ahead, usable_bank(aircraft, gains, gains.airspeed), gains)
    length = line_length(ahead.p_n, target, radius, remedies.bounded_circles)
    speed = max(1e-3, horizontal_norm(ahead.v_n))
    slope = plan_slope(ahead, target, aircraft, gains.airspeed, length, speed, 1.0, 0.0, math.inf)
    motion = AircraftMotion(
        ahead.v_n, ahead.wind_n, gains.airspeed, remedies.side, remedies.unit_sum
    )
    climb = math.tan(min(aircraft.climb_max, aircraft.descent_max))
    return FieldTask(remedies, target, slope, motion, radius, climb)


@compiled
def field_velocity(p_n: Vec3, t: float, task: FieldTask, airspace: Airspace | None) -> Vec3:
    """F_OA at a position, NED [m], and a time [s], as a velocity over ground, NED [m/s]."""
    g = free_velocity(p_n, task)
    if airspace is None:
        return g
    F = flown_field(deflected(p_n, t, g, task, airspace), g)
    return g if F[0] == 0.0 and F[1] == 0.0 else F


@compiled
def deflected(p_n: Vec3, t: float, g: Vec3, task: FieldTask, airspace: Airspace) -> FlownField:
    """The composite of all hazards, for a wanted velocity `g` over ground, NED [m/s]."""
    by = no_barriers()
    for i in range(hazard_count(airspace.hazards)):
        by = past_barrier(by, g, barrier_of(airspace.hazards, i, p_n, t, g, task), task.motion)
    return by


@compiled
def free_velocity(p_n: Vec3, task: FieldTask) -> Vec3:
    """The free field as the velocity over ground at the airspeed, NED [m/s]."""
    course = free_course(p_n, task.target, task.radius, task.remedies.bounded_circles)
    wind = (task.motion.wind_n[0], task.motion.wind_n[1])
    speed = max(1e-3, heading_for_course(course, 0.0, wind, task.motion.airspeed).groundspeed)
    return speed * math.cos(course), speed * math.sin(course), -speed * task.slope
