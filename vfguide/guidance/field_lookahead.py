"""The path along the field, predicted, to tell where it leads into a dead end.

A field looks at what is near. It leads into a pocket that is too narrow to turn in, and there no
escape is left. So the path that follows the field is predicted now and then by an aircraft that
turns no faster than it can.
"""

import math

from vfguide.aircraft.coordinated_turn import turn_rate
from vfguide.aircraft.envelope import usable_bank
from vfguide.aircraft.performance import turn_length
from vfguide.aircraft.state import FlightState
from vfguide.aircraft.vehicle import Vehicle
from vfguide.airspace.detection import Airspace
from vfguide.airspace.hazards import hazard_count, hazard_distance
from vfguide.geometry.angles import wrap
from vfguide.geometry.vector import Vec3, add, dot, scale, sub
from vfguide.geometry.velocity import azimuth_of, horizontal_norm, velocity_along
from vfguide.guidance.field_barriers import FieldTask
from vfguide.guidance.field_direction import field_velocity, free_velocity, slope_of, task_of
from vfguide.guidance.field_progress import APPROACH_RADII
from vfguide.guidance.flown_avoidance import AircraftMotion
from vfguide.guidance.guidance_state import FieldProgress, Leader
from vfguide.guidance.remedies import Remedies
from vfguide.guidance.wind_triangle import heading_for_course
from vfguide.kernels.compiled import compiled
from vfguide.planning.objective import GuidanceTarget, Objective

PREDICTION_INTERVAL = 2.5
"""Time between two predictions of the path along the field [s]; chosen, since one takes as long as
several steps."""
PREDICTION_TIME = 6.0
"""Time for which the path is predicted [turn lengths over airspeed]; chosen, 15 s at 25 m/s, longer
than a full turn."""
PREDICTION_STEPS = 40
"""Steps of the prediction, a number; chosen, 10 m each at 25 m/s."""
PREDICTED_TURN_STEPS = 26
"""Steps after which the first turn is over, a number; chosen, 10 s at 25 m/s."""
ROOM_AHEAD = 0.19
"""Clearance below which the path is blocked [turn lengths]; chosen, 12 m at 25 m/s, what the
assurance keeps."""


@compiled
def is_blocked(
    remedies: Remedies,
    state: FlightState,
    target: GuidanceTarget,
    airspace: Airspace | None,
    vehicle: Vehicle,
) -> bool:
    """Whether the path along the field comes to a hazard, or is led back; arguments as of `led`.

    It is led back where it flies against the free field long after the first turn.
    """
    if airspace is None:
        return False
    aircraft, gains, _ = vehicle
    task, airspeed, wind_n = (
        task_of(remedies, state, target, vehicle),
        gains.airspeed,
        state.wind_n,
    )
    dt = PREDICTION_TIME / PREDICTION_STEPS * turn_length(airspeed) / airspeed
    turn = dt * turn_rate(usable_bank(aircraft, gains, airspeed), airspeed)
    azimuth, p_n, v_n, t = azimuth_of(sub(state.v_n, wind_n)), state.p_n, state.v_n, airspace.time
    least = ROOM_AHEAD * turn_length(airspeed)
    for k in range(PREDICTION_STEPS):
        F = field_velocity(p_n, t, moving_at(v_n, task), airspace)
        heading = heading_for_course(azimuth_of(F), 0.0, (wind_n[0], wind_n[1]), airspeed)
        azimuth += max(-turn, min(turn, wrap(heading.psi - azimuth)))
        path = math.atan(max(-task.climb, min(task.climb, slope_of(F))))
        v_n = add(velocity_along(azimuth, path, airspeed), wind_n)
        p_n, t = add(p_n, scale(dt, v_n)), t + dt
        for i in range(hazard_count(airspace.hazards)):
            if hazard_distance(airspace.hazards, i, p_n, t) < least:
                return True
        if horizontal_norm(sub(p_n, target.p_n)) < APPROACH_RADII * task.radius:
            return False
        if k >= PREDICTED_TURN_STEPS and dot(v_n, free_velocity(p_n, task)) < 0.0:
            return True
    return False


@compiled
def moving_at(v_n: Vec3, task: FieldTask) -> FieldTask:
    """The task of an aircraft with another velocity over ground, NED [m/s]."""
    remedies, target, slope, motion, radius, climb = task
    _, wind_n, airspeed, keeps_side, has_airspeed = motion
    motion = AircraftMotion(v_n, wind_n, airspeed, keeps_side, has_airspeed)
    return FieldTask(remedies, target, slope, motion, radius, climb)


@compiled
def looking_ahead(
    remedies: Remedies,
    time: float,
    goal: Objective,
    airspace: Airspace | None,
    s: FieldProgress,
    vehicle: Vehicle,
) -> FieldProgress:
    """Who leads at the next step once the path along the field was predicted, where that is due.

    A route is asked for where that path is blocked.
    """
    if (
        s.leader != Leader.FIELD.value
        or not remedies.search
        or time - s.looked < PREDICTION_INTERVAL
    ):
        return s
    if is_blocked(remedies, goal.state, goal.target, airspace, vehicle):
        return FieldProgress(Leader.ROUTE.value, s.length, s.length, time, time)
    return FieldProgress(s.leader, s.length, s.nearest, s.since, time)
