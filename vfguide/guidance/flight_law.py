"""Law `flight`: follows the planned route in the wind, within the envelope."""

import math

from vfguide.aircraft.command import GuidanceCommand, unknown_rates
from vfguide.aircraft.envelope import usable_bank
from vfguide.aircraft.path_limits import allowed_path, floor_share, path_angle, path_limits
from vfguide.aircraft.performance import nonzero_airspeed, turn_length
from vfguide.aircraft.state import FlightState
from vfguide.aircraft.vehicle import Vehicle
from vfguide.airspace.detection import Airspace
from vfguide.estimation.estimation import NavState, step_time
from vfguide.geometry.blending import blended
from vfguide.geometry.vector import norm, sub
from vfguide.geometry.velocity import azimuth_of, path_of
from vfguide.guidance.altitude_profile import plan_slope
from vfguide.guidance.guidance_state import GuidanceState
from vfguide.guidance.lateral import plan_turn, target_course
from vfguide.guidance.wind_triangle import Heading, heading_for_course
from vfguide.kernels.compiled import compiled
from vfguide.paths.course_laws import Course
from vfguide.paths.leg import OUTBOUND
from vfguide.planning.leg_planning import predicted_state, radius_factor_of
from vfguide.planning.objective import Objective
from vfguide.planning.overflight import aim_at
from vfguide.planning.route import Route
from vfguide.planning.route_following import is_on_route, route_course

LEVEL_BANK = 0.05
"""Largest bank near the floor where the climb falls short by CLIMB_SHORTFALL [rad]; tuned with
`tools/measure_avoidance.py` in sinking air."""
CLIMB_SHORTFALL = 0.05
"""Shortfall of the path angle in sinking air at which the bank is limited to LEVEL_BANK [rad];
tuned with `tools/measure_avoidance.py`."""


@compiled
def update(
    nav: NavState,
    goal: Objective,
    route: Route,
    airspace: Airspace | None,
    s: GuidanceState,
    vehicle: Vehicle,
) -> tuple[GuidanceCommand, GuidanceState]:
    """Bank, load factor and path angle that fly the route, and the next state of guidance."""
    state, (aircraft, gains, _) = goal.state, vehicle
    air = sub(state.v_n, state.wind_n)
    speed = nonzero_airspeed(state.airspeed, aircraft)
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
    command = GuidanceCommand(
        goal.target.course + course.chi,
        heading.psi,
        gamma,
        climb,
        lift.bank,
        lift.load,
        course.remaining,
        route.leg.phase,
        route.leg.radius,
        unknown_rates(),
    )
    return command, GuidanceState(slope, turning, s.progress)


@compiled
def height_above_floor(state: FlightState, airspace: Airspace | None) -> float:
    """Height above the floor of the fence [m], infinite where there is none."""
    return math.inf if airspace is None else -state.p_n[2] - airspace.hazards.floor


@compiled
def wanted_course(goal: Objective, route: Route, vehicle: Vehicle) -> Course:
    """The course over ground relative to the target's; a circle has priority over a route."""
    target, (aircraft, gains, _) = goal.target, vehicle
    ahead = predicted_state(goal.state, gains)
    if is_on_route(route.following) and target.circle == 0.0:
        return route_course(route.following, ahead, route.leg, target.course)
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
    state, leg, following, (aircraft, gains, _) = goal.state, route.leg, route.following, vehicle
    remaining = math.inf if leg.phase == OUTBOUND else course.remaining
    return plan_slope(
        state,
        aim_at(following.level, following.fall, goal.target, remaining),
        aircraft,
        gains.airspeed,
        course.remaining,
        heading.groundspeed,
        radius_factor_of(leg, state, aircraft, gains),
        s.slope,
        step_time(nav),
    )


@compiled
def sparing_bank(bank: float, missing: float) -> float:
    """The largest bank where the climb near the floor falls short [rad].

    The aircraft leaves air that sinks faster than it climbs with level wings: a turn takes thrust,
    and has to be turned back later.

    Args:
        bank: largest bank elsewhere [rad].
        missing: shortfall of the path angle in sinking air [rad], reduced with height above the
            floor.
    """
    return blended(bank, min(bank, LEVEL_BANK), max(0.0, min(1.0, missing / CLIMB_SHORTFALL)))
