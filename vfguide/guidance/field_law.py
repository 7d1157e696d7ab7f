"""Law `field`: an aeroplane led along the paper's avoidance field, with a remedy for what it lacks.

The direction of F_OA is made good over ground by the wind triangle, in a coordinated turn, within
the limits of the aircraft. What the print lacks on an aeroplane has a remedy, each with its switch
(`Remedies`). The last turn radii to the goal are flown as by law `flight`, and so is a route around
hazards where the field is blocked ahead or comes no nearer.

The rates of the command are its derivative along the motion of the point mass that follows it, so
that the angular velocity of the reference attitude is not smoothed out of noisy differences.
"""

import math
from typing import NamedTuple

from vfguide.aircraft.command import CommandRates, GuidanceCommand, unknown_rates
from vfguide.aircraft.envelope import usable_bank
from vfguide.aircraft.path_limits import allowed_path, path_angle, path_limits
from vfguide.aircraft.performance import nonzero_airspeed
from vfguide.aircraft.point_mass import PointMass, advance, dynamics
from vfguide.aircraft.state import FlightState
from vfguide.aircraft.vehicle import Vehicle
from vfguide.airspace.detection import Airspace
from vfguide.estimation.estimation import NavState, step_time
from vfguide.geometry.angles import wrap
from vfguide.geometry.so3 import bank_angle
from vfguide.geometry.vector import add, norm, sub
from vfguide.geometry.velocity import azimuth_of, path_of, velocity_along
from vfguide.guidance import flight_law
from vfguide.guidance.altitude_profile import limited_slope
from vfguide.guidance.field_barriers import with_near_obstacles
from vfguide.guidance.field_direction import led, slope_of
from vfguide.guidance.field_lookahead import looking_ahead
from vfguide.guidance.field_progress import leader_now, progress_of, radius_of
from vfguide.guidance.guidance_state import GuidanceState, Leader, leg_begins
from vfguide.guidance.lateral import plan_turn
from vfguide.guidance.remedies import Remedies
from vfguide.guidance.wind_triangle import heading_for_course
from vfguide.kernels.compiled import compiled
from vfguide.kernels.rows import replacing
from vfguide.paths.leg import FIELD
from vfguide.planning.objective import Objective
from vfguide.planning.route import Route

RATE_TIME = 2e-4
"""Half the time over which the command is differenced along the motion [s]; chosen, so that the
difference is its derivative to 1e-5 rad/s."""
LEAST_SPEED = 0.1
"""Least speed through the air with which the motion is predicted [m/s]; chosen, against 0."""

with_rates = replacing(GuidanceCommand, "rates")
with_elapsed = replacing(NavState, "elapsed")
with_time = replacing(Airspace, "time")


class Given(NamedTuple):
    """What the command of one step depends on."""

    leader: int
    """The `Leader` of the step."""
    remedies: Remedies
    nav: NavState
    goal: Objective
    route: Route
    airspace: Airspace | None
    """The known hazards that may act; None: there are none."""
    s: GuidanceState
    """The state of the step before, and the progress of this one."""
    vehicle: Vehicle


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
    time, gains = nav.state.time, vehicle.gains
    radius = radius_of(goal, vehicle)
    progress = leg_begins(time) if goal.begins else s.progress
    leader = leader_now(goal, progress)
    progress = progress_of(remedies, time, goal, progress, radius, gains)
    progress = looking_ahead(remedies, time, goal, airspace, progress, vehicle)
    s, near = GuidanceState(s.slope, s.turning, progress), airspace
    if leader == Leader.FIELD.value:
        near = with_near_obstacles(remedies, airspace, goal.state, radius, gains)
    given = Given(leader, remedies, nav, goal, route, near, s, vehicle)
    command, after = commanded(given)
    if not remedies.lead:
        return command, after
    before, later = shifted(given, command, -RATE_TIME), shifted(given, command, RATE_TIME)
    return with_rates(command, rates_between(before, later)), after


@compiled
def commanded(given: Given) -> tuple[GuidanceCommand, GuidanceState]:
    """The command of the leader, without its rates, and the next state of guidance."""
    leader, _, nav, goal, route, airspace, s, vehicle = given
    if leader == Leader.FIELD.value:
        return along_field(given)
    return flight_law.update(nav, goal, route, airspace, s, vehicle)


@compiled
def along_field(given: Given) -> tuple[GuidanceCommand, GuidanceState]:
    """The command that follows the field, and the next state of guidance."""
    _, remedies, nav, goal, _, airspace, s, vehicle = given
    state, (aircraft, gains, _) = goal.state, vehicle
    air = sub(state.v_n, state.wind_n)
    speed = nonzero_airspeed(state.airspeed, aircraft)
    flown = path_of(air, speed)
    F, turning = led(remedies, state, goal.target, airspace, vehicle)
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
    command = GuidanceCommand(
        azimuth_of(F),
        heading.psi,
        gamma,
        climb,
        lift.bank,
        lift.load,
        s.progress.length,
        FIELD,
        radius_of(goal, vehicle),
        unknown_rates(),
    )
    return command, GuidanceState(slope, side, s.progress)


class Commanded(NamedTuple):
    """What the reference attitude is made of."""

    azimuth: float
    """Azimuth of the air velocity [rad]."""
    path: float
    """Its path angle [rad]."""
    gamma: float
    """Commanded path angle [rad]."""
    bank: float
    """Commanded bank [rad]."""
    load: float
    """Commanded load factor."""


@compiled
def shifted(given: Given, command: GuidanceCommand, dt: float) -> Commanded:
    """What is commanded `dt` [s] later; `command` is the one now.

    The aircraft moves as a point mass that follows the command, and so do the hazards by their own
    velocities; what guidance keeps is that of the step before.
    """
    leader, remedies, nav, goal, route, airspace, s, vehicle = given
    state = moved(goal.state, command, vehicle, dt)
    then = with_elapsed(nav, nav.elapsed + dt)
    objective = Objective(goal.target, state, False, goal.is_goal)
    around = airspace_later(airspace, dt)
    there, _ = commanded(Given(leader, remedies, then, objective, route, around, s, vehicle))
    air, speed = sub(state.v_n, state.wind_n), nonzero_airspeed(state.airspeed, vehicle.aircraft)
    return Commanded(azimuth_of(air), path_of(air, speed), there.gamma, there.bank, there.load)


@compiled
def airspace_later(airspace: Airspace | None, dt: float) -> Airspace | None:
    """The hazards `dt` [s] later; None: there are none."""
    if airspace is None:
        return None
    return with_time(airspace, airspace.time + dt)


@compiled
def moved(state: FlightState, command: GuidanceCommand, vehicle: Vehicle, dt: float) -> FlightState:
    """The state of the point mass that follows the command, `dt` [s] later."""
    aircraft, gains, _ = vehicle
    air, wind_n = sub(state.v_n, state.wind_n), state.wind_n
    speed = max(norm(air), LEAST_SPEED)
    motion = PointMass(
        state.p_n, azimuth_of(air), bank_angle(state.R_nb), path_of(air, speed), speed
    )
    after = advance(motion, command.bank, command.gamma, wind_n, dynamics(aircraft, gains), dt)
    v_n = add(velocity_along(after.azimuth, after.gamma, speed), wind_n)
    return FlightState(state.time + dt, after.p_n, v_n, state.R_nb, state.airspeed, wind_n)


@compiled
def rates_between(before: Commanded, later: Commanded) -> CommandRates:
    """The rates of a command RATE_TIME after and before which it is that."""
    per = 0.5 / RATE_TIME
    return CommandRates(
        True,
        per * wrap(later.azimuth - before.azimuth),
        per * (later.path - before.path),
        per * (later.gamma - before.gamma),
        per * (later.bank - before.bank),
        per * (later.load - before.load),
    )
