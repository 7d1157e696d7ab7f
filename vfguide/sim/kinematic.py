"""The paper's rigid body: position and attitude driven by a speed and body rates, eq_kine_UVA.

It moves along its own x axis, p' = v_x R e_x, and turns as R' = R Omega^. There is no gravity,
air or ground. Speed and body rates are held over a step, and the step is exact: the path is an
arc of a helix, whatever its length.
"""

import math
from typing import NamedTuple

import numpy as np

from vfguide.earth.geodesy import R_level, ned_to_geodetic, tangent_plane
from vfguide.field.obstacle import Rows
from vfguide.geometry.so3 import exp, from_quaternion, to_quaternion
from vfguide.geometry.vector import (
    Mat3,
    Matrices,
    Series,
    Vec3,
    Vectors,
    add,
    cross,
    mat3,
    matmul,
    matvec,
    norm,
    scale,
    transpose,
    vec3,
)
from vfguide.kernels.compiled import compiled
from vfguide.kernels.rows import width, writer

FORWARD: Vec3 = (1.0, 0.0, 0.0)
"""Unit vector along body x, dimensionless."""


class Bodies(NamedTuple):
    """The states of N bodies."""

    p_n: Vectors
    """(N, 3) positions, NED [m]."""
    R_nb: Matrices
    """(N, 3, 3) attitudes, body FRD to NED."""


class Sighting(NamedTuple):
    """A body as it is seen on the earth."""

    latitude: float
    """Geodetic latitude [rad]."""
    longitude: float
    """Longitude [rad]."""
    altitude: float
    """Altitude above mean sea level [m]."""
    v_l: Vec3
    """Velocity v_x R e_x, north-east-down where the body is [m/s]."""
    q_lb: tuple[float, float, float, float]
    """Attitude w, x, y, z, body to north-east-down where the body is."""


SIGHTING_WIDTH = width(Sighting)
"""Number of floats in the row of a `Sighting`."""
write_sighting = writer(Sighting)


class Commands(NamedTuple):
    """What drives N bodies: the four inputs of eq_kine_UVA that are free."""

    speed: Series
    """(N,) along body x [m/s]."""
    omega_b: Vectors
    """(N, 3) body rates [rad/s]."""


@compiled
def mean_direction(w: Vec3) -> Vec3:
    """Mean of exp(s w) e_x over s from 0 to 1: the left Jacobian of SO(3) at `w` times e_x.

    With the angle |w| and the axis a = w / |w| it is
    (sin |w| / |w|) e_x + (1 - sin |w| / |w|) (a . e_x) a + ((1 - cos |w|) / |w|) a x e_x.
    """
    angle = norm(w)
    if angle == 0.0:
        return FORWARD
    axis = scale(1.0 / angle, w)
    along = math.sin(angle) / angle
    aside = 2.0 * math.sin(0.5 * angle) ** 2 / angle
    straight = add(scale(along, FORWARD), scale((1.0 - along) * axis[0], axis))
    return add(straight, scale(aside, cross(axis, FORWARD)))


@compiled
def move(R_nb: Mat3, p_n: Vec3, speed: float, omega_b: Vec3, dt: float) -> tuple[Mat3, Vec3]:
    """Attitude and position after `dt` [s] at constant speed [m/s] and body rates [rad/s].

    The attitude is R exp(Omega dt), normalised through its quaternion: over a million steps,
    products alone would leave SO(3) by rounding.
    """
    w = scale(dt, omega_b)
    moved = matvec(R_nb, scale(speed * dt, mean_direction(w)))
    return from_quaternion(to_quaternion(matmul(R_nb, exp(w)))), add(p_n, moved)


@compiled
def sightings(bodies: Bodies, commands: Commands, origin: Vec3) -> Rows:
    """The bodies as seen on the earth, one `Sighting` a row, from the tangent plane at `origin`.

    The origin is latitude, longitude [rad] and altitude [m].
    """
    plane = tangent_plane(origin[0], origin[1], origin[2])
    seen = np.empty((len(bodies.p_n), SIGHTING_WIDTH))
    for i in range(len(seen)):
        R_nb = mat3(bodies.R_nb[i])
        lat, lon, alt = ned_to_geodetic(plane, vec3(bodies.p_n[i]))
        R_lb = matmul(transpose(R_level(plane, lat, lon)), R_nb)
        v_l = matvec(R_lb, (commands.speed[i], 0.0, 0.0))
        write_sighting(Sighting(lat, lon, alt, v_l, to_quaternion(R_lb)), seen[i])
    return seen


@compiled
def advance(bodies: Bodies, commands: Commands, dt: float) -> Bodies:
    """All bodies after a step of `dt` [s]."""
    after = Bodies(np.empty_like(bodies.p_n), np.empty_like(bodies.R_nb))
    for i in range(len(bodies.p_n)):
        p_n, omega_b = vec3(bodies.p_n[i]), vec3(commands.omega_b[i])
        R_nb, p_n = move(mat3(bodies.R_nb[i]), p_n, commands.speed[i], omega_b, dt)
        for k in range(3):
            after.p_n[i, k] = p_n[k]
            for j in range(3):
                after.R_nb[i, k, j] = R_nb[k][j]
    return after
