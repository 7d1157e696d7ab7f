"""The clearance along a manoeuvre, or a command, that is flown from now on in the model."""

from typing import NamedTuple

from vfguide.aircraft.point_mass import Dynamics, PointMass, advance
from vfguide.airspace.hazards import Hazards
from vfguide.assurance.backup_manoeuvre import HORIZON, TRAJECTORY_STEP, Manoeuvre, fly_out
from vfguide.assurance.trajectory_clearance import Clearance, clearance_along
from vfguide.geometry.vector import Vec3, Vectors, norm
from vfguide.kernels.compiled import compiled

TRAJECTORY_POINTS = round(HORIZON / TRAJECTORY_STEP) + 1
"""Number of points of a predicted trajectory."""
CONTACT = 1.0
"""Clearance below which a hazard counts as hit [m]; chosen."""
Command = tuple[float, float]
"""Bank, right wing down positive, and path angle over ground, up positive [rad]."""
Limits = tuple[float, float]
"""A clearance that is enough, and one that is too little [m]."""


class World(NamedTuple):
    """Everything on which the clearance depends but the motion itself."""

    hazards: Hazards
    """The known hazards."""
    wind_n: Vec3
    """Wind, NED, blowing toward [m/s]."""
    uncertainty_rate: float
    """Growth of the uncertainty of the own position [m/s]."""
    limits: Dynamics
    """Limits and lags of the aircraft's motion."""
    scale: float
    """Factor of all times of manoeuvres, from `time_scale`, dimensionless."""
    trajectory: Vectors
    """Memory for one trajectory (TRAJECTORY_POINTS, 3), NED [m]."""


@compiled
def follow(
    world: World,
    point_mass: PointMass,
    plan: Manoeuvre,
    t: float,
    least: Limits,
    suspect: int,
) -> Clearance:
    """Clearance along a manoeuvre that begins at time `t` [s].

    Args:
        world: hazards, wind and limits.
        point_mass: the aircraft at that time.
        plan: the manoeuvre.
        t: time on the clock of the obstacles [s].
        least: clearance that is enough, and one that is too little [m].
        suspect: number of the hazard to look at first.
    """
    dt = TRAJECTORY_STEP * world.scale
    fly_out(point_mass, plan, world.wind_n, world.limits, dt, world.trajectory)
    return clear(world, point_mass, t, 0, least, suspect)


@compiled
def clear(
    world: World, point_mass: PointMass, t: float, first: int, least: Limits, suspect: int
) -> Clearance:
    """Clearance along the trajectory in `world.trajectory`; its `lost` counts from point `first`.

    Args:
        world: hazards, wind and trajectory.
        point_mass: the aircraft; its airspeed and the wind bound the speed over ground.
        t: time of point 0 on the clock of the obstacles [s].
        first: index of the first point that counts.
        least: clearance that is enough, and one that is too little [m].
        suspect: number of the hazard to look at first.
    """
    dt, speed = TRAJECTORY_STEP * world.scale, point_mass.airspeed + norm(world.wind_n)
    trajectory, t = world.trajectory[first:], t + first * dt
    return clearance_along(
        world.hazards, trajectory, t, dt, speed, world.uncertainty_rate, least[0], least[1], suspect
    )


@compiled
def time_to_conflict(world: World, point_mass: PointMass, t: float, command: Command) -> Clearance:
    """Clearance if `command` [rad] were held from time `t` [s] on: time of contact, and hazard."""
    dt = TRAJECTORY_STEP * world.scale
    for k in range(TRAJECTORY_POINTS):
        world.trajectory[k, 0], world.trajectory[k, 1], world.trajectory[k, 2] = point_mass.p_n
        point_mass = advance(point_mass, command[0], command[1], world.wind_n, world.limits, dt)
    return clear(world, point_mass, t, 0, (2.0 * CONTACT, CONTACT), 0)
