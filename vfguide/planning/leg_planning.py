"""The leg to a goal after one step: its turns, and the path that its height takes."""

import math

from vfguide.aircraft.envelope import flyable_radius, usable_bank
from vfguide.aircraft.path_limits import steepest_descent, widest
from vfguide.aircraft.performance import Gains, Performance, turn_length
from vfguide.aircraft.state import FlightState
from vfguide.aircraft.vehicle import Vehicle
from vfguide.geometry.compiled import compiled
from vfguide.geometry.vector import Vec3, add, scale
from vfguide.paths.course_laws import Planar
from vfguide.paths.distance_for_altitude import path_needed
from vfguide.paths.leg import Leg, keep_radius
from vfguide.paths.leg_phases import fly_leg
from vfguide.paths.leg_start import Paths
from vfguide.planning.objective import Objective, Target
from vfguide.planning.route import Route
from vfguide.planning.route_following import is_on_route

PLANNED = 0.95
"""Part of the steepest slope that ways are planned with."""


@compiled
def in_goal_plane(state: FlightState, target: Target) -> Planar:
    """Position and ground velocity in the horizontal plane of the target."""
    c, s = math.cos(target.course), math.sin(target.course)
    dx, dy = state.p_n[0] - target.p_n[0], state.p_n[1] - target.p_n[1]
    vx, vy = state.v_n[0], state.v_n[1]
    return Planar(c * dx + s * dy, c * dy - s * dx, c * vx + s * vy, c * vy - s * vx)


@compiled
def soon(state: FlightState, gains: Gains) -> FlightState:
    """The state with the position half a roll response later, when a turn will have begun."""
    p_n = add(state.p_n, scale(0.5 * gains.sluggish, state.v_n))
    return FlightState(state.time, p_n, state.v_n, state.R_nb, state.airspeed, state.wind_n)


@compiled
def wider_by(leg: Leg, state: FlightState, aircraft: Performance, gains: Gains) -> float:
    """By which the turns of the leg are wider than those of level flight, as far as it helps."""
    level = flyable_radius(state, usable_bank(aircraft, gains, gains.airspeed), gains)
    return max(1.0, min(widest(aircraft), leg.radius / level))


@compiled
def path_for_height(
    state: FlightState,
    target: Target,
    aircraft: Performance,
    gains: Gains,
    wider: float,
    slope: float,
) -> float:
    """Path over ground that the rest of the change of height takes [m].

    `wider` is that of `steepest_descent`, `slope` the one that was wanted at the step before.
    """
    height = target.p_n[2] - state.p_n[2]
    descent = steepest_descent(aircraft, wider, target.slope)
    steepest = math.tan(aircraft.climb_max if height < 0.0 else descent)
    tail, unit = wind_along(state.wind_n, target.course), turn_length(gains.airspeed)
    most = PLANNED * steepest / (1.0 + max(0.0, tail) / max(gains.airspeed, 1e-3))
    distance = math.hypot(state.p_n[0] - target.p_n[0], state.p_n[1] - target.p_n[1])
    return path_needed(height, distance, target.slope, max(most, 1e-6), unit, slope)


@compiled
def wind_along(wind_n: Vec3, course: float) -> float:
    """Wind from behind on a course [m/s]."""
    return wind_n[0] * math.cos(course) + wind_n[1] * math.sin(course)


@compiled
def advance_leg(goal: Objective, route: Route, slope: float, vehicle: Vehicle) -> Leg:
    """The leg after this step; it waits while a detour is flown."""
    state, target, (aircraft, gains, _) = goal.state, goal.target, vehicle
    if is_on_route(route.detour) and target.circle == 0.0:
        return route.leg
    bank = usable_bank(aircraft, gains, gains.airspeed)
    leg = keep_radius(route.leg, flyable_radius(state, bank, gains))
    if target.circle != 0.0:
        return leg
    ahead = soon(state, gains)
    now, most = wider_by(leg, ahead, aircraft, gains), widest(aircraft)
    needed = path_for_height(ahead, target, aircraft, gains, now, slope)
    needed_wide = path_for_height(ahead, target, aircraft, gains, most, slope)
    paths = Paths(needed, most / now, needed_wide)
    return fly_leg(leg, in_goal_plane(ahead, target), paths, gains)
