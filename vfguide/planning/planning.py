"""The stage of planning: the leg to the goal, and a route that keeps clear of the hazards."""

import math

from vfguide.aircraft.vehicle import Vehicle
from vfguide.airspace.detection import Airspace
from vfguide.airspace.hazards import traffic_zones
from vfguide.airspace.keep_out import joined
from vfguide.estimation.estimation import NavState
from vfguide.kernels.compiled import compiled
from vfguide.planning.leg_planning import advance_leg
from vfguide.planning.objective import Objective
from vfguide.planning.overflight import band_of
from vfguide.planning.replanning import seek_route
from vfguide.planning.route import Route, fresh_route, is_on_field, route_on_field
from vfguide.planning.route_ahead import PlanningContext, Scene, altitude_plan_of
from vfguide.planning.route_following import with_shift
from vfguide.planning.route_search import CLEARANCES


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
        nav: state of the vehicle.
        goal: objective of the mission.
        airspace: the known hazards; None compiles to a stage without search.
        plans: whether the law follows a route; else only circles have one.
        s: the route of the step before.
        slope: slope dh/ds that was wanted at the step before.
        vehicle: its aircraft and gains.
    """
    if not plans and goal.target.circle == 0.0:
        return route_on_field()
    route = fresh_route() if goal.begins or is_on_field(s) else s
    route = clear_route(nav, goal, airspace, route, vehicle)
    leg = advance_leg(goal, route, slope, vehicle)
    was, following = route.leg, route.following
    if leg.phase != was.phase or leg.progress.edge.begin.x != was.progress.edge.begin.x:
        following = with_shift(following, True)
    return Route(leg, following)


@compiled
def clear_route(
    nav: NavState, goal: Objective, airspace: Airspace | None, route: Route, vehicle: Vehicle
) -> Route:
    """The route, planned anew where it is blocked; a circle is not changed."""
    if airspace is None:
        return route
    if goal.target.circle != 0.0:
        return route
    context = PlanningContext(nav.state, goal.target, vehicle.aircraft, vehicle.gains)
    scene = scene_of(airspace, context, route)
    leg, following = seek_route(context, route.leg, scene, route.following)
    return Route(leg, following)


@compiled
def scene_of(airspace: Airspace, context: PlanningContext, route: Route) -> Scene:
    """What may block the route; no overflight starts while there is traffic."""
    hazards, t = airspace.hazards, airspace.time
    zones, highest = airspace.zones, CLEARANCES[0] - hazards.ceiling
    if len(hazards.traffic) > 0:
        band = band_of(altitude_plan_of(context, route.following))
        moving = traffic_zones(hazards.traffic, band, CLEARANCES[0], t)
        zones, highest = joined(zones, moving), math.inf
    return Scene(hazards.obstacles, zones, highest, t)
