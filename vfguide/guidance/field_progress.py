"""Who leads in law `field`: the field, the approach to the goal, or a route around the hazards."""

from vfguide.aircraft.envelope import flyable_radius, usable_bank
from vfguide.aircraft.performance import Gains, turn_length
from vfguide.aircraft.vehicle import Vehicle
from vfguide.geometry.vector import sub
from vfguide.geometry.velocity import horizontal_norm
from vfguide.guidance.free_line import line_length
from vfguide.guidance.guidance_state import FieldProgress, Leader
from vfguide.guidance.remedies import Remedies
from vfguide.kernels.compiled import compiled
from vfguide.planning.objective import Objective

APPROACH_RADII = 3.0
"""Distance from the goal within which the approach is that of law `flight` [turn radii]; chosen."""
PATIENCE = 12.0
"""Time without coming nearer after which a route is asked for [turn lengths over airspeed]; chosen,
nearly two full turns."""
PROGRESS = 1.0
"""By how much nearer counts as nearer [turn lengths]; chosen."""
RESUME = 4.0
"""By how much nearer a route has to come before the field leads again [turn radii]; chosen."""


@compiled
def next_progress(
    remedies: Remedies, s: FieldProgress, length: float, radius: float, time: float, gains: Gains
) -> FieldProgress:
    """The progress of a step outside the approach.

    Args:
        remedies: whether a route is asked for where the field comes no nearer.
        s: the progress of the step before.
        length: of the field's line to the goal now [m].
        radius: of a turn [m].
        time: now [s].
        gains: the airspeed, to which distances and times are scaled.
    """
    field, route = Leader.FIELD.value, Leader.ROUTE.value
    if s.leader == Leader.CIRCLE.value:
        return FieldProgress(field, length, length, time, s.looked)
    if s.leader == Leader.APPROACH.value and remedies.search:
        return FieldProgress(route, length, length, time, s.looked)
    if s.leader != field:
        if length < s.nearest - RESUME * radius or not remedies.search:
            return FieldProgress(field, length, length, time, s.looked)
        return FieldProgress(route, length, s.nearest, time, s.looked)
    unit_length = turn_length(gains.airspeed)
    if length < s.nearest - PROGRESS * unit_length:
        return FieldProgress(field, length, length, time, s.looked)
    is_patient = time - s.since < PATIENCE * unit_length / gains.airspeed
    leader = field if is_patient or not remedies.search else route
    return FieldProgress(leader, length, s.nearest, s.since, s.looked)


@compiled
def radius_of(goal: Objective, vehicle: Vehicle) -> float:
    """Radius of a turn over ground [m]."""
    aircraft, gains, _ = vehicle
    return flyable_radius(goal.state, usable_bank(aircraft, gains, gains.airspeed), gains)


@compiled
def leader_now(goal: Objective, s: FieldProgress) -> int:
    """The `Leader` of this step, as the step before has decided; a circle is flown at once."""
    if goal.target.circle != 0.0:
        return Leader.CIRCLE.value
    return Leader.FIELD.value if s.leader == Leader.CIRCLE.value else s.leader


@compiled
def progress_of(
    remedies: Remedies, time: float, goal: Objective, s: FieldProgress, radius: float, gains: Gains
) -> FieldProgress:
    """Who leads at the next step; `time` is now [s], `radius` that of a turn [m]."""
    state = goal.state
    if goal.target.circle != 0.0:
        return FieldProgress(Leader.CIRCLE.value, s.length, s.nearest, time, s.looked)
    length = line_length(state.p_n, goal.target, radius, remedies.bounded_circles)
    distance = horizontal_norm(sub(state.p_n, goal.target.p_n))
    if remedies.approach and distance < APPROACH_RADII * radius:
        return FieldProgress(Leader.APPROACH.value, length, length, time, s.looked)
    return next_progress(remedies, s, length, radius, time, gains)
