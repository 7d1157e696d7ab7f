"""What depends on the shape of an obstacle: for each question one choice by its kind.

Points are in the body's own axes, its centre at the origin, z down [m].
"""

from collections.abc import Callable

from vfguide.geometry.shapes.base import Kind, Level, Section, Shape, stretched
from vfguide.geometry.shapes.cone import (
    WIDEST_CONE,
    cone,
    cone_bound,
    cone_level,
    cone_rays,
    cone_section,
)
from vfguide.geometry.shapes.cylinder import (
    cylinder,
    cylinder_bound,
    cylinder_level,
    cylinder_rays,
    cylinder_section,
)
from vfguide.geometry.shapes.rays import Array, Rays
from vfguide.geometry.shapes.superquadric import (
    box,
    ellipsoid,
    sphere,
    superquadric,
    superquadric_bound,
    superquadric_level,
    superquadric_rays,
    superquadric_section,
)
from vfguide.geometry.vector import Vec3
from vfguide.kernels.compiled import compiled

SHAPES: dict[str, Callable[..., Shape]] = {
    "sphere": sphere,
    "ellipsoid": ellipsoid,
    "superquadric": superquadric,
    "cylinder": cylinder,
    "box": box,
    "cone": cone,
}
"""The constructors by the names that the shapes have in scenario files."""

NO_BRANCH = "no branch for this kind of shape"
"""Message of a choice that a new kind of shape was left out of."""


@compiled
def shape_level(shape: Shape, x: Vec3) -> Level:
    """U, its gradient and its Hessian at `x`.

    Raises:
        ValueError: the kind has no branch here, as in the functions below.
    """
    a, b, c = shape.semi_axes
    w = (x[0] / a, x[1] / b, x[2] / c)
    if shape.kind == Kind.SUPERQUADRIC:
        level = superquadric_level(w, shape.exponents)
    elif shape.kind == Kind.CYLINDER:
        level = cylinder_level(w)
    elif shape.kind == Kind.CONE:
        level = cone_level(w)
    else:
        raise ValueError(NO_BRANCH)
    return stretched(level, (1.0 / a, 1.0 / b, 1.0 / c))


@compiled
def shape_bound(shape: Shape, x: Vec3) -> float:
    """Lower bound of the distance of `x` from the surface [m]; negative inside."""
    a, _, c = shape.semi_axes
    if shape.kind == Kind.CYLINDER:
        return cylinder_bound(x[0], x[1], x[2], a, c)
    if shape.kind == Kind.CONE:
        return cone_bound(x[0], x[1], x[2], a, c)
    if shape.kind == Kind.SUPERQUADRIC:
        return superquadric_bound(x, shape.semi_axes, shape.exponents)
    raise ValueError(NO_BRANCH)


@compiled
def section_at(shape: Shape, w: float) -> Section:
    """The horizontal section `w` half heights below the centre."""
    if shape.kind == Kind.CONE:
        return cone_section(shape, w)
    if shape.kind == Kind.CYLINDER:
        return cylinder_section(shape, w)
    if shape.kind == Kind.SUPERQUADRIC:
        return superquadric_section(shape, w)
    raise ValueError(NO_BRANCH)


@compiled
def widest_at(shape: Shape) -> float:
    """Height of the widest section below the centre, in half heights."""
    if shape.kind == Kind.CONE:
        return WIDEST_CONE
    if shape.kind == Kind.SUPERQUADRIC:
        return 0.0
    if shape.kind == Kind.CYLINDER:
        return 0.0
    raise ValueError(NO_BRANCH)


def surface_rays(shape: Shape, latitude: Array, longitude: Array) -> Rays:
    """Directions for a mesh of the surface, in semi-axes; the angles as in `shapes.rays`."""
    if shape.kind == Kind.SUPERQUADRIC:
        return superquadric_rays(shape, latitude, longitude)
    if shape.kind == Kind.CYLINDER:
        return cylinder_rays(latitude, longitude)
    if shape.kind == Kind.CONE:
        return cone_rays(latitude, longitude)
    raise ValueError(NO_BRANCH)
