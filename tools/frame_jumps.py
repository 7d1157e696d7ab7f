"""Where R_a jumps along a flown path: turns that Omega_a does not account for.

A step of the path is suspect when R_a turns otherwise than Omega_a says. It is halved again and
again, towards the half that fits worse. A turn that is only fast fits in the end; a jump does not.
"""

from typing import NamedTuple

import numpy as np
from scipy.spatial.transform import Rotation

from vfguide.field.composite_arrays import CompositeArrays, composite_fields
from vfguide.field.goal_frame import GoalFrame
from vfguide.field.obstacle import Rows
from vfguide.field.robots import Spacing
from vfguide.geometry.vector import Vectors, transpose

SUSPECT = 0.02
"""Least difference between the turn over one step and the predicted one that is examined [rad]."""
JUMP = 0.1
"""Least difference that is left over a step of no length in a jump [rad]."""
HALVINGS = 45
CHI_ZERO = 1e-12
"""Largest chi that counts as zero, dimensionless: there G' is the normal n, turned over where n . G
changes its sign."""
ON_AXIS = 1e-3
"""Largest sine of the angle from the goal's axis that counts as on it, dimensionless."""
NOBODY = np.zeros((0, 6))
ALONE = Spacing(0.0, 1.0)


class FrameJumps(NamedTuple):
    """Numbers of jumps of R_a along one path, by their kinds."""

    suspect: int
    """Number of steps over which R_a turned otherwise than the rates at their ends predict."""
    at_chi_zero: int
    """Number of jumps where chi is zero to rounding, and n . G changes sign."""
    at_axis: int
    """Number of jumps on the goal's axis, where G changes its sign."""
    elsewhere: int
    """Number of all other jumps."""


def count_jumps(goal: GoalFrame, obstacles: Rows, p_n: Vectors, dt: float) -> FrameJumps:
    """The jumps of R_a along a path (T, 3) among static obstacles, steps of `dt` [s]."""
    v_n = np.diff(p_n, axis=0) / dt
    start = field(goal, obstacles, p_n[:-1], v_n)
    end = field(goal, obstacles, p_n[1:], v_n)
    suspects = np.flatnonzero(mismatch(start, end, dt) > SUSPECT)
    found = [locate(goal, obstacles, p_n[k], v_n[k], dt) for k in suspects]
    jumps = [each for each in found if each is not None]
    chi_zero = sum(jump == "chi" for jump in jumps)
    axis = sum(jump == "axis" for jump in jumps)
    return FrameJumps(len(suspects), chi_zero, axis, len(jumps) - chi_zero - axis)


def locate(goal: GoalFrame, obstacles: Rows, p: Rows, v: Rows, span: float) -> str | None:
    """The kind of the jump on the path from `p` at velocity `v` for `span` [s]; None: no jump."""
    begin = 0.0
    for _ in range(HALVINGS):
        span *= 0.5
        times = begin + span * np.arange(3.0)
        here = field(goal, obstacles, p + times[:, None] * v, np.tile(v, (3, 1)))
        halves = mismatch(part(here, slice(0, 2)), part(here, slice(1, 3)), span)
        begin += span * int(np.argmax(halves))
    if halves.max() < JUMP:
        return None
    q = p + begin * v - goal.p_n
    ahead, _, _ = transpose(goal.R_ng)
    away, aside = np.linalg.norm(q), np.linalg.norm(np.cross(q, ahead))
    if aside < ON_AXIS * away:
        return "axis"
    return "chi" if here.chi.min() < CHI_ZERO else "else"


def field(goal: GoalFrame, obstacles: Rows, p_n: Rows, v_n: Rows) -> CompositeArrays:
    """The composite field at points (N, 3) [m] that move with velocities (N, 3) [m/s]."""
    return composite_fields(goal, p_n, v_n, 0.0, obstacles, NOBODY, ALONE)


def part(fields: CompositeArrays, points: slice) -> CompositeArrays:
    """The fields at some of the points."""
    return CompositeArrays(*(array[points] for array in fields))


def mismatch(start: CompositeArrays, end: CompositeArrays, dt: float) -> Rows:
    """Angles between the turns of R_a and the mean of Omega_a times `dt`, (N,) [rad]."""
    turned = Rotation.from_matrix(np.swapaxes(start.R_na, -1, -2) @ end.R_na).as_rotvec()
    return np.linalg.norm(turned - 0.5 * dt * (start.Omega_a + end.Omega_a), axis=-1)
