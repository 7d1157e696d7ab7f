"""Law `field` at points of a scenario: where it leads, and the attitude that flies it."""

from vfguide.aircraft.command import GuidanceCommand
from vfguide.aircraft.envelope import flyable_radius, usable_bank
from vfguide.aircraft.state import FlightState
from vfguide.companion.plan import Plan
from vfguide.control.control import commanded_rate, reference_of
from vfguide.estimation.estimation import known_state
from vfguide.field_points.field_point import FieldPoint, Point
from vfguide.field_points.flight_points import flight_field
from vfguide.field_points.shortest_plan import Surroundings, plan_in_air, surroundings_at
from vfguide.geometry.so3 import from_euler
from vfguide.geometry.vector import ZERO, Mat3, Vec3, norm, sub
from vfguide.geometry.velocity import azimuth_of
from vfguide.guidance import field_law
from vfguide.guidance.field_barriers import barrier_of
from vfguide.guidance.field_direction import free_velocity, led, slope_of, task_of
from vfguide.guidance.field_progress import progress_of
from vfguide.guidance.guidance_state import GuidanceState, Leader, leg_begins
from vfguide.guidance.laws import FieldLaw
from vfguide.guidance.remedies import ALL_REMEDIES, Remedies
from vfguide.loop.legs import target_of
from vfguide.planning.leg_planning import predicted_state
from vfguide.planning.objective import Objective, objective_at
from vfguide.planning.route import fresh_route


def led_field(plan: Plan, point: Point, wind_n: Vec3) -> FieldPoint:
    """The direction of F_OA to the first goal from a point, and the attitude that flies it.

    The approach to the goal is that of law `flight`, see `flight_field`. The slope is flown at
    once, not rate limited, and nothing was learned of the angle of attack.

    Args:
        plan: the plan of the vehicle.
        point: the point; its velocity is flown there.
        wind_n: wind, blowing toward, NED [m/s].

    Raises:
        NoPlanError: it is inside an obstacle, or there is no plan from there in the approach.
    """
    plan = plan_in_air(plan, point.p_n[2])
    around = surroundings_at(plan, point, wind_n)
    goal = objective_at(target_of(plan.legs, 0), flown_state(point, wind_n, 0.0))
    if leader_at(plan, goal) != Leader.FIELD:
        return flight_field(plan, point, wind_n)
    remedies = remedies_of(plan)
    F, _ = led(remedies, goal.state, goal.target, around.airspace, plan.vehicle)
    level = command_at(around, goal, slope_of(F))
    banked = goal._replace(state=flown_state(point, wind_n, level.bank))
    reference = reference_at(plan, banked, command_at(around, banked, slope_of(F)))
    return FieldPoint(F, None, None, *reference, transitions(around, goal.state))


def flown_state(point: Point, wind_n: Vec3, bank: float) -> FlightState:
    """The state of an aircraft that flies through the point with a bank [rad]."""
    air = sub(point.v_n, wind_n)
    R_nb = from_euler(bank, 0.0, azimuth_of(air))
    return FlightState(point.time, point.p_n, point.v_n, R_nb, norm(air), wind_n)


def leader_at(plan: Plan, goal: Objective) -> int:
    """The `Leader` of a vehicle that has just begun the leg."""
    aircraft, gains, _ = plan.vehicle
    radius = flyable_radius(goal.state, usable_bank(aircraft, gains, gains.airspeed), gains)
    start = leg_begins(goal.state.time)
    return progress_of(remedies_of(plan), goal.state.time, goal, start, radius, gains).leader


def command_at(around: Surroundings, goal: Objective, slope: float) -> GuidanceCommand:
    """The command of the field, where `slope` was wanted at the step before."""
    remedies, nav = remedies_of(around.plan), known_state(goal.state, -1.0)
    s = GuidanceState(slope, 1.0, leg_begins(goal.state.time))
    command, _ = field_law.update(
        remedies, nav, goal, fresh_route(), around.airspace, s, around.plan.vehicle
    )
    return command


def reference_at(plan: Plan, goal: Objective, command: GuidanceCommand) -> tuple[Mat3, Vec3]:
    """The reference attitude of a command, to NED, and its body rates [rad/s]."""
    reference = reference_of(goal.state, command, 0.0, plan.vehicle)
    if not command.rates.are_known:
        return reference.R_na, ZERO
    rates = commanded_rate(command, reference, goal.state.airspeed, plan.vehicle)
    return reference.R_na, rates


def remedies_of(plan: Plan) -> Remedies:
    """The remedies of the plan's law; all, where it is another one."""
    return plan.law.remedies if isinstance(plan.law, FieldLaw) else ALL_REMEDIES


def transitions(around: Surroundings, state: FlightState) -> tuple[float, ...]:
    """Chi of each obstacle."""
    airspace, plan = around.airspace, around.plan
    if airspace is None:
        return ()
    remedies = remedies_of(plan)
    ahead = predicted_state(state, plan.vehicle.gains) if remedies.lead else state
    task = task_of(remedies, ahead, target_of(plan.legs, 0), plan.vehicle)
    g = free_velocity(ahead.p_n, task)
    return tuple(
        barrier_of(airspace.hazards, i, ahead.p_n, airspace.time, g, task).chi
        for i in range(len(airspace.hazards.obstacles))
    )
