"""The stage of planning: the leg to the goal, on a route that keeps clear of what is known."""

import math
from typing import NamedTuple

from vfguide.airspace.detection import Airspace
from vfguide.estimation.estimation import NavState
from vfguide.flight.begin import Paths
from vfguide.flight.detour import CLEARANCES
from vfguide.flight.detour_leg import RouteState, fresh_route_state, is_on_route, with_shift
from vfguide.flight.horizontal import (
    flyable_radius,
    in_goal_plane,
    path_for_height,
    soon,
    usable_bank,
    wider_by,
)
from vfguide.flight.leg import Leg, keep_radius, new_leg
from vfguide.flight.outlines import joined
from vfguide.flight.passing import band_of
from vfguide.flight.planner import fly_leg
from vfguide.flight.vehicle import Vehicle
from vfguide.flight.vertical import widest
from vfguide.flight.way_round import Journey, Scene, heights_of, seek_way
from vfguide.geometry.compiled import compiled
from vfguide.geometry.rows import replacing
from vfguide.planning.objective import Objective
from vfguide.safety.hazards import traffic_outlines


class Route(NamedTuple):
    """How the goal is flown to; also what one step leaves for the next."""

    leg: Leg
    detour: RouteState
    """Round hazards, before the leg; and what is remembered of searches for it."""


with_detour = replacing(Route, "detour")


@compiled
def fresh_route() -> Route:
    """Nothing is planned yet."""
    return Route(new_leg(), fresh_route_state())


@compiled
def update(
    nav: NavState,
    goal: Objective,
    airspace: Airspace | None,
    plans: bool,
    s: Route,
    slope: float,
    vehicle: Vehicle,
) -> Route:
    """The route to fly now.

    Args:
        nav: the vehicle.
        goal: what is flown to.
        airspace: what is known to be in the way; None compiles to a stage without search.
        plans: whether the law wants a route; else only circles have a leg.
        s: the route of the step before.
        slope: of the path that was wanted at the step before, dh/ds.
        vehicle: its aircraft and gains.
    """
    route = fresh_route() if goal.begins else s
    if not plans and goal.target.circle == 0.0:
        return route
    route = clear_route(nav, goal, airspace, route, vehicle)
    leg = advance_leg(goal, route, slope, vehicle)
    was, detour = route.leg, route.detour
    if leg.phase != was.phase or leg.way.x != was.way.x:
        detour = with_shift(detour, True)
    return Route(leg, detour)


@compiled
def clear_route(
    nav: NavState, goal: Objective, airspace: Airspace | None, route: Route, vehicle: Vehicle
) -> Route:
    """The route round or over what is in its way; a circle is flown as it is."""
    if airspace is None:
        return route
    if goal.target.circle != 0.0:
        return route
    journey = Journey(nav.state, goal.target, vehicle.aircraft, vehicle.gains)
    scene = scene_of(airspace, journey, route)
    leg, detour = seek_way(journey, route.leg, scene, route.detour)
    return Route(leg, detour)


@compiled
def scene_of(airspace: Airspace, journey: Journey, route: Route) -> Scene:
    """What the search keeps clear of: traffic is never passed above."""
    hazards, t = airspace.hazards, airspace.time
    shut, highest = airspace.zones, CLEARANCES[0] - hazards.ceiling
    if len(hazards.traffic) > 0:
        band = band_of(heights_of(journey, route.detour))
        moving = traffic_outlines(hazards.traffic, band, CLEARANCES[0], t)
        shut, highest = joined(shut, moving), math.inf
    return Scene(hazards.obstacles, shut, highest, t)


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
