"""The field among obstacles and robots at many points."""

import math
from typing import Any, NamedTuple

import numpy as np

from vfguide.field.composite import Composite, composite_field
from vfguide.field.goal_frame import GoalFrame
from vfguide.field.obstacle import Rows
from vfguide.field.robots import Spacing
from vfguide.geometry.vector import Matrices, Series, Vectors, vec3
from vfguide.kernels.compiled import compiled


class CompositeArrays(NamedTuple):
    """`Composite` at many points, NED; the leading axes are those of the points."""

    F: Vectors
    """(..., 3)."""
    G: Vectors
    """(..., 3)."""
    H: Vectors
    """(..., 3)."""
    R_na: Matrices
    """(..., 3, 3)."""
    Omega_a: Vectors
    """(..., 3) [rad/s]."""
    chi: Vectors
    """(..., M)."""


def composite_fields(
    goal: GoalFrame, p_n: Any, v_n: Any, t: Any, obstacles: Rows, others: Any, spacing: Spacing
) -> CompositeArrays:
    """`composite_field` at positions (..., 3) moving with (..., 3) at times (...), broadcast.

    `others`, (K, 6) or (..., K, 6), are rows of `Robot`: those to give way to, each at the time of
    its point.
    """
    leading = np.broadcast_shapes(
        np.shape(p_n)[:-1], np.shape(v_n)[:-1], np.shape(t), np.shape(others)[:-2]
    )
    fields = empty_fields(math.prod(leading), len(obstacles))
    _at_points(
        goal,
        _flat(p_n, leading, (3,)),
        _flat(v_n, leading, (3,)),
        _flat(t, leading, ()),
        obstacles,
        _flat(others, leading, np.shape(others)[-2:]),
        spacing,
        fields,
    )
    return CompositeArrays(*(a.reshape(leading + a.shape[1:]) for a in fields))


def empty_fields(count: int, obstacles: int) -> CompositeArrays:
    """Uninitialised arrays for `count` points among `obstacles` obstacles."""
    F, G, H, Omega_a = np.empty((4, count, 3))
    return CompositeArrays(F, G, H, np.empty((count, 3, 3)), Omega_a, np.empty((count, obstacles)))


@compiled
def store(fields: CompositeArrays, i: int, here: Composite) -> None:
    """Write `here` into row `i` of the arrays, except chi."""
    for k in range(3):
        fields.F[i, k], fields.G[i, k], fields.H[i, k] = here.F[k], here.G[k], here.H[k]
        fields.Omega_a[i, k] = here.Omega_a[k]
        for j in range(3):
            fields.R_na[i, k, j] = here.R_na[k][j]


def _flat(a: Any, leading: tuple[int, ...], core: tuple[int, ...]) -> Rows:
    """`a` broadcast over the leading axes, which become one; contiguous."""
    full = np.broadcast_to(np.asarray(a, np.float64), leading + core)
    return np.ascontiguousarray(full).reshape((math.prod(leading), *core))


@compiled
def _at_points(
    goal: GoalFrame,
    p_n: Vectors,
    v_n: Vectors,
    t: Series,
    obstacles: Rows,
    others: Rows,
    spacing: Spacing,
    fields: CompositeArrays,
) -> None:
    for i in range(len(p_n)):
        p, v = vec3(p_n[i]), vec3(v_n[i])
        here = composite_field(goal, p, v, t[i], obstacles, others[i], spacing)
        fields.chi[i] = here.chi
        store(fields, i, here)
