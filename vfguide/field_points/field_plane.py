"""Law `field` in a horizontal plane: where it leads at many points, and what bends it there."""

import math
from typing import NamedTuple

import numpy as np

from vfguide.aircraft.state import FlightState
from vfguide.aircraft.vehicle import Vehicle
from vfguide.airspace.detection import Airspace
from vfguide.airspace.hazards import hazard_count, hazard_distance
from vfguide.companion.guided_flight import ASSUMED_GUST
from vfguide.companion.plan import Plan
from vfguide.field_points.field_law_points import remedies_of
from vfguide.field_points.shortest_plan import plan_in_air
from vfguide.geometry.so3 import from_euler
from vfguide.geometry.vector import ZERO, Series, Vec3, Vectors, vec3
from vfguide.guidance.field_direction import deflected, field_velocity, free_velocity, task_of
from vfguide.guidance.remedies import Remedies
from vfguide.kernels.compiled import compiled
from vfguide.loop.legs import target_of
from vfguide.planning.objective import GuidanceTarget


class FieldPlane(NamedTuple):
    """Law `field` at N points."""

    F: Vectors
    """(N, 3), F_OA as a velocity over ground, NED [m/s]; its length has no meaning."""
    chi: Series
    """(N,), product of chi_i over the hazards that are approached: 1 where the free field leads."""
    distance: Series
    """(N,), lower bound of the distance from the nearest hazard [m]; negative inside."""


def field_plane(plan: Plan, goal: int, p_n: Vectors, time: float, wind_n: Vec3) -> FieldPlane:
    """The field that leads to a goal of a plan, all hazards known.

    Args:
        plan: the plan of the vehicle, its law `field`.
        goal: number of the goal, from 0.
        p_n: the points (N, 3), NED [m], of one height.
        time: on the clock of the obstacles [s].
        wind_n: wind, blowing toward, NED [m/s].
    """
    field = FieldPlane(np.empty((len(p_n), 3)), *np.empty((2, len(p_n))))
    vehicle, target = plan_in_air(plan, p_n[0, 2]).vehicle, target_of(plan.legs, goal)
    _at_points(remedies_of(plan), p_n, wind_n, target, airspace_at(plan, time), vehicle, field)
    return field


def airspace_at(plan: Plan, time: float) -> Airspace | None:
    """All hazards of a plan at a time on the clock of the obstacles [s]; None: there are none."""
    if plan.hazards is None:
        return None
    return Airspace(plan.hazards, plan.fence, time, ASSUMED_GUST)


@compiled
def _at_points(
    remedies: Remedies,
    p_n: Vectors,
    wind_n: Vec3,
    target: GuidanceTarget,
    airspace: Airspace | None,
    vehicle: Vehicle,
    field: FieldPlane,
) -> None:
    """Fill the field at every point; arguments as of `field_plane`."""
    for i in range(len(p_n)):
        state = led_freely(remedies, vec3(p_n[i]), wind_n, target, vehicle)
        task = task_of(remedies, state, target, vehicle)
        t = 0.0 if airspace is None else airspace.time
        field.F[i] = field_velocity(state.p_n, t, task, airspace)
        field.chi[i], field.distance[i] = 1.0, math.inf
        if airspace is not None:
            field.chi[i] = deflected(state.p_n, t, state.v_n, task, airspace).chi
            field.distance[i] = nearest_distance(airspace, state.p_n)


@compiled
def led_freely(
    remedies: Remedies, p_n: Vec3, wind_n: Vec3, target: GuidanceTarget, vehicle: Vehicle
) -> FlightState:
    """A state at a point, NED [m], that moves as the free field leads; arguments as of `led`."""
    airspeed, level = vehicle.gains.airspeed, from_euler(0.0, 0.0, 0.0)
    still = FlightState(0.0, p_n, ZERO, level, airspeed, wind_n)
    v_n = free_velocity(p_n, task_of(remedies, still, target, vehicle))
    return FlightState(0.0, p_n, v_n, level, airspeed, wind_n)


@compiled
def nearest_distance(airspace: Airspace, p_n: Vec3) -> float:
    """Lower bound of the distance of a point, NED [m], from all hazards [m]; negative inside."""
    least = math.inf
    for i in range(hazard_count(airspace.hazards)):
        least = min(least, hazard_distance(airspace.hazards, i, p_n, airspace.time))
    return least
