"""Lower bounds of the distance from an obstacle: cheap, and never too large.

Two bounds are good in different places, and the larger one is taken. Near the surface it is that of
the gauge, see `vfguide.geometry.shapes.base`. Far away, and inside, it is the distance from a body
with sharp edges that contains the obstacle: the box, the upright cylinder or the cone's frustum.
"""

from vfguide.field.obstacle import Rows, into_axes, read_obstacle, shape_of
from vfguide.geometry.shapes.shape import shape_bound
from vfguide.geometry.vector import Vec3, scale, sub
from vfguide.kernels.compiled import compiled


@compiled
def distance_bound(obstacles: Rows, i: int, p_n: Vec3, t: float) -> float:
    """Lower bound of the distance of `p_n` (NED) from the surface of row `i` at time `t` [m].

    Exact for spheres from outside, within a few per cent of the size for the other shapes, and
    tight at the surface from outside; negative inside, and there at most a size too low.
    """
    body = read_obstacle(obstacles[i])
    beside = sub(sub(p_n, body.p_n), scale(t, body.v_n))
    return shape_bound(shape_of(body), into_axes(body, beside))
