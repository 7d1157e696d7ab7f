"""Law `flight`: along the planned route, in the wind, up and down within the envelope."""

import math

from vfguide.airspace.detection import Airspace
from vfguide.estimation.estimation import NavState
from vfguide.flight.approach import Course
from vfguide.flight.detour_leg import is_on_route, route_course
from vfguide.flight.horizontal import plan_turn, soon, target_course, usable_bank, wider_by
from vfguide.flight.leg import AWAY
from vfguide.flight.memory import Wish
from vfguide.flight.motion_angles import azimuth_of, path_of
from vfguide.flight.passing import aim_at
from vfguide.flight.performance import turn_length
from vfguide.flight.state import FlightState
from vfguide.flight.vehicle import Vehicle
from vfguide.flight.vertical import (
    allowed_path,
    blended,
    floor_share,
    path_angle,
    path_limits,
    plan_slope,
)
from vfguide.flight.wind import Heading, heading_for_course
from vfguide.geometry.compiled import compiled
from vfguide.geometry.vector import norm, sub
from vfguide.guidance.guidance_state import GuidanceState, step_time
from vfguide.planning.objective import Objective
from vfguide.planning.planning import Route

SPARING, SHORT = 0.05, 0.05
"""No bank is larger than the first where the climb near the floor is the second short [rad]."""


@compiled
def update(
    nav: NavState,
    goal: Objective,
    route: Route,
    airspace: Airspace | None,
    s: GuidanceState,
    vehicle: Vehicle,
) -> tuple[Wish, GuidanceState]:
    """Bank, load factor and path angle that fly the route."""
    state, (aircraft, gains, _) = goal.state, vehicle
    air = sub(state.v_n, state.wind_n)
    speed = max(state.airspeed, 0.5 * aircraft.airspeed_min)
    above = height_above_floor(state, airspace)
    course = wanted_course(goal, route, vehicle)
    flown = path_of(air, speed)
    heading = heading_for_course(
        goal.target.course + course.chi,
        course.chi_rate,
        (state.wind_n[0], state.wind_n[1]),
        speed * math.cos(flown),
    )
    slope = wanted_slope(nav, goal, route, course, heading, s, vehicle)
    limits = path_limits(norm(air), gains.airspeed, above, aircraft)
    asked = path_angle(slope, heading.groundspeed, state.wind_n[2], speed)
    gamma, climb = allowed_path(asked, limits)
    bank_max = usable_bank(aircraft, gains, speed)
    last = floor_share(above, turn_length(gains.airspeed))
    bank_max = sparing_bank(bank_max, last * min(asked - gamma, state.wind_n[2] / speed))
    lift, turning = plan_turn(
        heading, azimuth_of(air), flown, speed, bank_max, aircraft, gains, s.turning
    )
    wish = Wish(
        goal.target.course + course.chi,
        heading.psi,
        gamma,
        climb,
        lift.bank,
        lift.load,
        course.remaining,
        route.leg.phase,
        route.leg.radius,
    )
    return wish, GuidanceState(slope, turning)


@compiled
def height_above_floor(state: FlightState, airspace: Airspace | None) -> float:
    """Height above the lowest that is allowed, infinite where there is none [m]."""
    return math.inf if airspace is None else -state.p_n[2] - airspace.hazards.floor


@compiled
def wanted_course(goal: Objective, route: Route, vehicle: Vehicle) -> Course:
    """The course over ground relative to the target's; a circle is flown before any detour."""
    target, (aircraft, gains, _) = goal.target, vehicle
    ahead = soon(goal.state, gains)
    if is_on_route(route.detour) and target.circle == 0.0:
        return route_course(route.detour, ahead, route.leg, target.course)
    return target_course(ahead, target, aircraft, gains, route.leg)


@compiled
def wanted_slope(
    nav: NavState,
    goal: Objective,
    route: Route,
    course: Course,
    heading: Heading,
    s: GuidanceState,
    vehicle: Vehicle,
) -> float:
    """Slope dh/ds over ground of the altitude profile, its rate limited."""
    state, leg, detour, (aircraft, gains, _) = goal.state, route.leg, route.detour, vehicle
    remaining = math.inf if leg.phase == AWAY else course.remaining
    return plan_slope(
        state,
        aim_at(detour.level, detour.fall, goal.target, remaining),
        aircraft,
        gains.airspeed,
        course.remaining,
        heading.groundspeed,
        wider_by(leg, state, aircraft, gains),
        s.slope,
        step_time(nav),
    )


@compiled
def sparing_bank(bank: float, missing: float) -> float:
    """The largest bank where the path near the floor is less steep than is asked for [rad].

    Air that sinks faster than the aircraft climbs is flown out of with wings level: a turn takes
    thrust, and may end where another has to follow.

    Args:
        bank: the largest one elsewhere.
        missing: of the path angle through air that sinks, less where the floor is farther below.
    """
    return blended(bank, min(bank, SPARING), max(0.0, min(1.0, missing / SHORT)))
