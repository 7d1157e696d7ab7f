"""Where law `field` leads from a state: the direction of F_OA, and its turn rate.

The free field is the paper's in the horizontal plane of the goal, with the altitude profile of law
`flight` as its slope; hazards deflect both.
"""

import math
from typing import NamedTuple

from vfguide.aircraft.envelope import flyable_radius, usable_bank
from vfguide.aircraft.state import FlightState
from vfguide.aircraft.vehicle import Vehicle
from vfguide.airspace.detection import Airspace
from vfguide.airspace.hazards import hazard_count
from vfguide.geometry.angles import wrap
from vfguide.geometry.vector import Vec3, add, scale
from vfguide.geometry.velocity import azimuth_of, horizontal_norm
from vfguide.guidance.altitude_profile import plan_slope
from vfguide.guidance.field_barriers import FieldTask, barrier_of
from vfguide.guidance.flown_avoidance import (
    AircraftMotion,
    FlownField,
    flown_field,
    no_barriers,
    past_barrier,
)
from vfguide.guidance.free_line import free_course, line_length
from vfguide.guidance.remedies import Remedies
from vfguide.guidance.wind_triangle import heading_for_course
from vfguide.kernels.compiled import compiled
from vfguide.planning.leg_planning import predicted_state
from vfguide.planning.objective import GuidanceTarget

DIFFERENCE_TIME = 0.02
"""Time over which the field is differenced along the motion [s]; chosen."""
LARGEST_TURN_RATE = 1.0
"""Largest rate of the course that is fed forward [rad/s]; chosen above every turn of the shipped
aircraft."""


class Led(NamedTuple):
    """Where the field leads from a state."""

    F: Vec3
    """F_OA as a velocity over ground, NED [m/s]; its length has no meaning."""
    turning: float
    """Rate of its course along the motion [rad/s]."""


@compiled
def slope_of(velocity: Vec3) -> float:
    """Slope dh/ds of a velocity, NED."""
    return -velocity[2] / max(1e-9, horizontal_norm(velocity))


@compiled
def led(
    remedies: Remedies,
    state: FlightState,
    target: GuidanceTarget,
    airspace: Airspace | None,
    vehicle: Vehicle,
) -> Led:
    """Where the field leads from a state; nothing before it matters.

    Args:
        remedies: what is done beyond the print.
        state: state of the vehicle, in the frame in which the target stands.
        target: the goal.
        airspace: the known hazards; None: there are none.
        vehicle: its aircraft and gains.
    """
    gains = vehicle.gains
    ahead = predicted_state(state, gains) if remedies.lead else state
    task = task_of(remedies, ahead, target, vehicle)
    t = 0.0 if airspace is None else airspace.time
    F = field_velocity(ahead.p_n, t, task, airspace)
    later = add(ahead.p_n, scale(DIFFERENCE_TIME, ahead.v_n))
    F_later = field_velocity(later, t + DIFFERENCE_TIME, task, airspace)
    turning = wrap(azimuth_of(F_later) - azimuth_of(F)) / DIFFERENCE_TIME
    most = LARGEST_TURN_RATE if remedies.lead else 0.0
    return Led(F, max(-most, min(most, turning)))


@compiled
def task_of(
    remedies: Remedies, ahead: FlightState, target: GuidanceTarget, vehicle: Vehicle
) -> FieldTask:
    """What the field is asked for; `ahead` is the state for which the turn is planned."""
    aircraft, gains, _ = vehicle
    radius = flyable_radius(ahead, usable_bank(aircraft, gains, gains.airspeed), gains)
    length = line_length(ahead.p_n, target, radius, remedies.bounded_circles)
    speed = max(1e-3, horizontal_norm(ahead.v_n))
    slope = plan_slope(ahead, target, aircraft, gains.airspeed, length, speed, 1.0, 0.0, math.inf)
    motion = AircraftMotion(
        ahead.v_n, ahead.wind_n, gains.airspeed, remedies.side, remedies.unit_sum
    )
    climb = math.tan(min(aircraft.climb_max, aircraft.descent_max))
    return FieldTask(remedies, target, slope, motion, radius, climb)


@compiled
def field_velocity(p_n: Vec3, t: float, task: FieldTask, airspace: Airspace | None) -> Vec3:
    """F_OA at a position, NED [m], and a time [s], as a velocity over ground, NED [m/s]."""
    g = free_velocity(p_n, task)
    if airspace is None:
        return g
    F = flown_field(deflected(p_n, t, g, task, airspace), g)
    return g if F[0] == 0.0 and F[1] == 0.0 else F


@compiled
def deflected(p_n: Vec3, t: float, g: Vec3, task: FieldTask, airspace: Airspace) -> FlownField:
    """The composite of all hazards, for a wanted velocity `g` over ground, NED [m/s]."""
    by = no_barriers()
    for i in range(hazard_count(airspace.hazards)):
        by = past_barrier(by, g, barrier_of(airspace.hazards, i, p_n, t, g, task), task.motion)
    return by


@compiled
def free_velocity(p_n: Vec3, task: FieldTask) -> Vec3:
    """The free field as the velocity over ground at the airspeed, NED [m/s]."""
    course = free_course(p_n, task.target, task.radius, task.remedies.bounded_circles)
    wind = (task.motion.wind_n[0], task.motion.wind_n[1])
    speed = max(1e-3, heading_for_course(course, 0.0, wind, task.motion.airspeed).groundspeed)
    return speed * math.cos(course), speed * math.sin(course), -speed * task.slope
