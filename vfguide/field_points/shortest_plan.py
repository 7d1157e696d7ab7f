"""The shortest plan from a point: the course on which law `flight` would leave it.

A plan depends on the course that the vehicle has already, and a point gives none. So plans are made
from courses all round, and the shortest is taken. Next, a plan is made from the course to which its
first turn leads, and so on until it begins without a turn: that is the direction of the field.
Where the turn does not vanish, as beside a goal nearer than a turn, the plan begins with it.
"""

import math
from dataclasses import replace
from typing import NamedTuple

from vfguide.aircraft.air_density import in_air
from vfguide.aircraft.state import FlightState
from vfguide.airspace.detection import Airspace, in_sight
from vfguide.companion.guided_flight import ASSUMED_GUST
from vfguide.companion.plan import Plan
from vfguide.earth.atmosphere import isa_density
from vfguide.estimation.estimation import Inputs
from vfguide.field.obstacle import obstacle_distance
from vfguide.field_points.field_point import Point
from vfguide.geometry.angles import FULL_TURN, wrap
from vfguide.geometry.se2 import composed
from vfguide.geometry.so3 import from_euler
from vfguide.geometry.vector import ZERO, Vec3
from vfguide.guidance.flight_law import wanted_course
from vfguide.guidance.laws import FLIGHT
from vfguide.guidance.wind_triangle import heading_for_course
from vfguide.loop.legs import target_of
from vfguide.loop.state import fresh_state
from vfguide.loop.step import step
from vfguide.paths.course_laws import Course
from vfguide.paths.edge import Edge
from vfguide.paths.leg import FIELD, OUTBOUND
from vfguide.planning.objective import Objective, objective_at
from vfguide.planning.route import Route
from vfguide.planning.route_ahead import entry_of
from vfguide.planning.route_following import edge_at, is_on_route

COURSES = 24
"""Number of courses all round from which plans are made; chosen, 15 degrees apart."""
NO_TURN = 1e-6
"""Length of a first turn below which a plan begins straight on [rad]; chosen."""
LONGER = 0.1
"""Length by which a plan that begins straight on, or on the field, may be longer than one with a
short turn before [turn radii]; chosen, since near the goal's line the field is a little longer."""
DIRECTION_REFINEMENTS = 40
"""Largest number of plans by which the direction is refined; chosen, so that the last interval of
a golden section is below 1e-8 of the first."""
GOLDEN = 0.5 * (math.sqrt(5.0) - 1.0)
"""Ratio of two intervals of a golden section, dimensionless."""


class NoPlanError(Exception):
    """There is no plan from a point; the message says why."""


class Start(NamedTuple):
    """The plan from a point on one course."""

    course: float
    """The course [rad]."""
    length: float
    """Length of the path to the goal [m]; infinite where it leads away from it first."""
    turn: float
    """Side of the first turn: +1 right, -1 left, 0 where it begins straight on or on the field."""
    onward: float
    """Course to which the first turn leads, or that the field has here [rad]."""
    course_rate: float
    """Rate of the course along the plan [rad/s]."""
    objective: Objective
    route: Route
    wanted: Course


class Surroundings(NamedTuple):
    """What a plan from a point depends on besides the course."""

    plan: Plan
    airspace: Airspace | None
    p_n: Vec3
    """The point, NED [m]."""
    time: float
    """Time on the clock of the obstacles [s]."""
    wind_n: Vec3
    """The wind, NED [m/s]."""


def plan_in_air(plan: Plan, down: float) -> Plan:
    """The plan in the standard air at a place of the scenario, `down` being its z of NED [m].

    Raises:
        NoPlanError: there is none.
    """
    density = isa_density(plan.origin[2] - down)
    if density <= 0.0:
        raise NoPlanError("there is no air at its height")
    return replace(plan, aircraft=in_air(plan.aircraft, density, plan.gains.airspeed))


def surroundings_at(plan: Plan, point: Point, wind_n: Vec3) -> Surroundings:
    """What is known at a point, to a vehicle that has been nowhere else.

    Raises:
        NoPlanError: the point is inside an obstacle.
    """
    airspace = None
    if plan.hazards is not None:
        obstacles = plan.hazards.obstacles
        for i in range(len(obstacles)):
            if obstacle_distance(obstacles, i, point.p_n, point.time) <= 0.0:
                raise NoPlanError(f"it is inside {plan.hazard_names[i]}")
        known = fresh_state(len(plan.hazards.obstacles)).detection.known
        hazards = in_sight(plan.hazards, known, point.p_n, point.time)
        airspace = Airspace(hazards, plan.fence, point.time, ASSUMED_GUST)
    return Surroundings(plan, airspace, point.p_n, point.time, wind_n)


def best_start(around: Surroundings, course: float) -> Start:
    """The start of the shortest plan; of equal ones that nearest to `course` [rad]."""
    step_size = FULL_TURN / COURSES
    turns = sorted((k * step_size for k in range(-COURSES // 2, COURSES // 2)), key=abs)
    best = min((start_on(around, course + turn) for turn in turns), key=lambda each: each.length)
    best = straightened(around, best)
    return best if best.turn == 0.0 else shortest_between(around, best, step_size)


def straightened(around: Surroundings, start: Start) -> Start:
    """The plan that is left when a plan is made again and again from the end of its first turn.

    It begins straight on, unless the turn never vanishes.
    """
    found = start
    for _ in range(DIRECTION_REFINEMENTS):
        onward = start_on(around, found.onward)
        if onward.length > found.length + LONGER * turn_radius(found.route):
            return found
        found = onward
        if found.turn == 0.0 and abs(wrap(found.onward - found.course)) < NO_TURN:
            return found
    return found


def shortest_between(around: Surroundings, start: Start, width: float) -> Start:
    """The shortest plan from courses within `width` [rad] of that of `start`: golden section."""
    low, high, best = start.course - width, start.course + width, start
    for _ in range(DIRECTION_REFINEMENTS):
        left, right = (
            start_on(around, high - GOLDEN * (high - low)),
            start_on(around, low + GOLDEN * (high - low)),
        )
        low, high = (low, right.course) if left.length < right.length else (left.course, high)
        best = min(best, left, right, key=lambda each: each.length)
    return best


def start_on(around: Surroundings, course: float) -> Start:
    """The plan from a course [rad] over ground."""
    plan, state = around.plan, state_on(around, course)
    before = fresh_state(0 if plan.hazards is None else len(plan.hazards.obstacles))
    inputs = Inputs(state, state, ZERO, True, 0.0)
    _, after, _ = step(inputs, before, plan.legs, around.airspace, FLIGHT, plan.vehicle)
    objective, route = objective_at(target_of(plan.legs, 0), state), after.planning
    wanted = wanted_course(objective, route, plan.vehicle)
    bearing = objective.target.course
    if not is_on_route(route.following) and route.leg.phase in (FIELD, OUTBOUND):
        away = route.leg.phase == OUTBOUND
        length, rate = (math.inf, 0.0) if away else (wanted.remaining, wanted.chi_rate)
        onward = bearing + (route.leg.outbound if away else wanted.chi)
        return Start(course, length, 0.0, onward, rate, objective, route, wanted)
    (begin, path), radius = first_edge(objective, route), turn_radius(route)
    length = wanted.remaining + math.hypot(begin.x - around.p_n[0], begin.y - around.p_n[1])
    side = path.first if path.arc > NO_TURN else 0.0
    onward, rate = course + path.first * path.arc, side * math.hypot(*state.v_n) / radius
    return Start(course, length, side, onward, rate, objective, route, wanted)


def first_edge(objective: Objective, route: Route) -> Edge:
    """The edge with which a route begins, NED; it begins where the vehicle has rolled in."""
    leg, following = route.leg, route.following
    if is_on_route(following):
        return edge_at(following, 0)
    begin, path = leg.progress.edge
    return Edge(composed(entry_of(objective.target, leg.final_approach), begin), path)


def turn_radius(route: Route) -> float:
    """Radius of the turns of the first edge [m]."""
    return route.following.radius if is_on_route(route.following) else route.leg.radius


def state_on(around: Surroundings, course: float) -> FlightState:
    """The state of level flight on a course over ground [rad]."""
    airspeed = around.plan.vehicle.gains.airspeed
    wind = around.wind_n[0], around.wind_n[1]
    heading = heading_for_course(course, 0.0, wind, airspeed)
    speed = heading.groundspeed
    v_n = (speed * math.cos(course), speed * math.sin(course), 0.0)
    level = from_euler(0.0, 0.0, heading.psi)
    return FlightState(around.time, around.p_n, v_n, level, airspeed, around.wind_n)
