"""Hazards as barriers of law `field`: their transition, normal, velocity and clearance."""

from typing import NamedTuple

import numpy as np

from vfguide.aircraft.performance import Gains, turn_length
from vfguide.aircraft.state import FlightState
from vfguide.airspace.detection import Airspace
from vfguide.airspace.hazard_normal import outward_normal
from vfguide.airspace.hazards import Hazards, hazard_count, hazard_distance, hazard_velocity
from vfguide.field.obstacle import obstacle_surface, read_obstacle
from vfguide.field.transition import smooth_step, transition
from vfguide.geometry.dual import Dual3
from vfguide.geometry.vector import Vec3, dot, norm, sub, unit
from vfguide.guidance.flown_avoidance import AircraftMotion, MovingBarrier
from vfguide.guidance.paper_law import DETECTION_RANGE
from vfguide.guidance.remedies import Remedies
from vfguide.kernels.compiled import compiled
from vfguide.kernels.rows import replacing
from vfguide.planning.objective import GuidanceTarget

FIELD_MARGIN = 0.24
"""Clearance at which the field is tangential [turn lengths], 15 m at 25 m/s; chosen above the
margin of the assurance, which then has nothing to do."""
REACTION_TIME = 1.5
"""Part of the reactive range that grows with the closing speed [s]; chosen."""
REACTION_RADII = 1.5
"""Part of the reactive range that a turn away takes [turn radii]; chosen."""

SHORT_TIME = 0.1
"""Time beyond the response lag by which the field is asked for ahead, at most [s]; chosen above all
times over which it is differenced."""

with_obstacles = replacing(Hazards, "obstacles")
with_hazards = replacing(Airspace, "hazards")


class FieldTask(NamedTuple):
    """What the field is asked for at one step."""

    remedies: Remedies
    target: GuidanceTarget
    slope: float
    """Slope dh/ds over ground of the free field."""
    motion: AircraftMotion
    radius: float
    """Turn radius over ground [m]."""
    climb: float
    """Tangent of the steepest path."""


@compiled
def with_near_obstacles(
    remedies: Remedies, airspace: Airspace | None, state: FlightState, radius: float, gains: Gains
) -> Airspace | None:
    """The airspace without the obstacles that do not act on the field about a position.

    Most obstacles of a world are far away, and the field is asked for several times a step.

    Args:
        remedies: which range an obstacle has.
        airspace: the known hazards; None: there are none.
        state: state of the vehicle.
        radius: of a turn [m].
        gains: the airspeed, and the time by which the field is asked for ahead.
    """
    if airspace is None:
        return None
    hazards = airspace.hazards
    obstacles = hazards.obstacles
    acts = np.empty(len(obstacles), np.bool_)
    speed, margin = gains.airspeed + norm(state.wind_n), FIELD_MARGIN * turn_length(gains.airspeed)
    ahead = gains.response_lag + SHORT_TIME
    for i in range(len(obstacles)):
        closing = speed + norm(hazard_velocity(hazards, i))
        reach = margin + reactive_range(closing, radius)
        reach = reach if remedies.reactive_range else written_range(hazards, i)
        near = reach + closing * ahead
        acts[i] = hazard_distance(hazards, i, state.p_n, airspace.time) < near
    return with_hazards(airspace, with_obstacles(hazards, obstacles[acts]))


@compiled
def barrier_of(
    hazards: Hazards, i: int, p_n: Vec3, t: float, g: Vec3, task: FieldTask
) -> MovingBarrier:
    """Hazard `i` as the field meets it; chi is 1 beyond its range.

    Args:
        hazards: the known hazards.
        i: number of the hazard.
        p_n: position, NED [m].
        t: time on the clock of the obstacles [s].
        g: wanted velocity over ground, NED [m/s].
        task: what the field is asked for.
    """
    remedies = task.remedies
    v_n = hazard_velocity(hazards, i) if remedies.relative_velocity else (0.0, 0.0, 0.0)
    margin = FIELD_MARGIN * turn_length(task.motion.airspeed)
    distance = hazard_distance(hazards, i, p_n, t)
    most = margin + reactive_range(norm(g) + norm(v_n), task.radius)
    if distance >= (most if remedies.reactive_range else written_range(hazards, i)):
        return MovingBarrier(1.0, (0.0, 0.0, 0.0), v_n, distance - margin)
    n = flattened(outward_normal(hazards, i, p_n, t), task.climb)
    if remedies.reactive_range:
        reach = reactive_range(-dot(sub(g, v_n), n), task.radius)
        chi, _ = smooth_step((distance - margin) / reach)
    else:
        chi = written_transition(hazards, i, p_n, t, distance)
    return MovingBarrier(chi, n, v_n, distance - margin)


@compiled
def reactive_range(closing: float, radius: float) -> float:
    """Distance beyond the margin within which a hazard acts on the field [m].

    `closing` is the speed at which it is approached [m/s], `radius` that of a turn [m].
    """
    return REACTION_TIME * max(0.0, closing) + REACTION_RADII * radius


@compiled
def written_range(hazards: Hazards, i: int) -> float:
    """Distance beyond which hazard `i` does not act by what the scenario says of it [m]."""
    if i < len(hazards.obstacles):
        return read_obstacle(hazards.obstacles[i]).reach
    return DETECTION_RANGE if i >= hazard_count(hazards) - len(hazards.traffic) else 0.0


@compiled
def written_transition(hazards: Hazards, i: int, p_n: Vec3, t: float, distance: float) -> float:
    """Chi of hazard `i` by its reactive level, or by the detection range of the paper's robots.

    Args:
        hazards: the known hazards.
        i: number of the hazard.
        p_n: position, NED [m].
        t: time on the clock of the obstacles [s].
        distance: distance of the position from the hazard [m].
    """
    if i < len(hazards.obstacles):
        at = Dual3(p_n, (0.0, 0.0, 0.0))
        U = obstacle_surface(hazards.obstacles, i, at, t).U
        return transition(U, 1.0, read_obstacle(hazards.obstacles[i]).reactive_level).value
    return smooth_step(distance / DETECTION_RANGE)[0]


@compiled
def flattened(n: Vec3, climb: float) -> Vec3:
    """A normal for an aircraft whose steepest path has the tangent `climb`: it climbs so little.

    The level part counts in full and the upright one by the tangent, so that what stands is
    passed beside, and what is below by not descending.
    """
    flat = (n[0], n[1], climb * n[2])
    return unit(flat) if norm(flat) > 0.0 else n
