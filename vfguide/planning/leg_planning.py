"""Leg planning: the leg after one step, its turns, and the path that its height takes."""

import math

from vfguide.aircraft.envelope import flyable_radius, usable_bank
from vfguide.aircraft.path_limits import largest_radius_factor, steepest_descent
from vfguide.aircraft.performance import Gains, Performance, turn_length
from vfguide.aircraft.state import FlightState
from vfguide.aircraft.vehicle import Vehicle
from vfguide.geometry.se2 import unrotated
from vfguide.geometry.vector import Vec3, add, scale, sub
from vfguide.geometry.velocity import horizontal_norm
from vfguide.kernels.compiled import compiled
from vfguide.paths.course_laws import PlanarState, planar_from, planar_of
from vfguide.paths.distance_for_altitude import distance_for_altitude
from vfguide.paths.leg import Leg, keep_radius
from vfguide.paths.leg_phases import fly_leg
from vfguide.paths.leg_start import Paths
from vfguide.planning.objective import GuidanceTarget, Objective, pose_of_target
from vfguide.planning.route import Route
from vfguide.planning.route_following import is_on_route

LEG_SLOPE_SHARE = 0.95
"""Share of the steepest slope with which the length of a leg is planned; chosen below 1 as a
reserve."""


@compiled
def in_goal_plane(state: FlightState, target: GuidanceTarget) -> PlanarState:
    """Position and ground velocity in the horizontal plane of the target."""
    return planar_from(pose_of_target(target), planar_of(state))


@compiled
def predicted_state(state: FlightState, gains: Gains) -> FlightState:
    """The state half a response lag later, when a turn will have started."""
    p_n = add(state.p_n, scale(0.5 * gains.response_lag, state.v_n))
    return FlightState(state.time, p_n, state.v_n, state.R_nb, state.airspeed, state.wind_n)


@compiled
def radius_factor_of(leg: Leg, state: FlightState, aircraft: Performance, gains: Gains) -> float:
    """Factor by which the turns of the leg are wider than in level flight, at most the largest."""
    level = flyable_radius(state, usable_bank(aircraft, gains, gains.airspeed), gains)
    return max(1.0, min(largest_radius_factor(aircraft), leg.radius / level))


@compiled
def distance_for_goal_altitude(
    state: FlightState,
    target: GuidanceTarget,
    aircraft: Performance,
    gains: Gains,
    radius_factor: float,
    slope: float,
) -> float:
    """Path over ground that the rest of the change of height takes [m].

    Args:
        state: state of the vehicle.
        target: the goal.
        aircraft: its path angles.
        gains: gains of the guidance.
        radius_factor: factor by which turns are wider, see `steepest_descent`.
        slope: slope dh/ds that was wanted at the step before.
    """
    height = target.p_n[2] - state.p_n[2]
    descent = steepest_descent(aircraft, radius_factor, target.slope)
    steepest = math.tan(aircraft.climb_max if height < 0.0 else descent)
    tail, unit = wind_along(state.wind_n, target.course), turn_length(gains.airspeed)
    most = LEG_SLOPE_SHARE * steepest / (1.0 + max(0.0, tail) / max(gains.airspeed, 1e-3))
    distance = horizontal_norm(sub(state.p_n, target.p_n))
    return distance_for_altitude(height, distance, target.slope, max(most, 1e-6), unit, slope)


@compiled
def wind_along(wind_n: Vec3, course: float) -> float:
    """Tail wind on a course [rad], positive from behind [m/s]."""
    along, _ = unrotated(wind_n[0], wind_n[1], math.cos(course), math.sin(course))
    return along


@compiled
def advance_leg(goal: Objective, route: Route, slope: float, vehicle: Vehicle) -> Leg:
    """The leg after this step; it does not change while a route around hazards is flown."""
    state, target, (aircraft, gains, _) = goal.state, goal.target, vehicle
    if is_on_route(route.following) and target.circle == 0.0:
        return route.leg
    bank = usable_bank(aircraft, gains, gains.airspeed)
    leg = keep_radius(route.leg, flyable_radius(state, bank, gains))
    if target.circle != 0.0:
        return leg
    ahead = predicted_state(state, gains)
    now, most = radius_factor_of(leg, ahead, aircraft, gains), largest_radius_factor(aircraft)
    needed = distance_for_goal_altitude(ahead, target, aircraft, gains, now, slope)
    needed_wide = distance_for_goal_altitude(ahead, target, aircraft, gains, most, slope)
    paths = Paths(needed, most / now, needed_wide)
    return fly_leg(leg, in_goal_plane(ahead, target), paths, gains)
