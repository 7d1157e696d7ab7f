"""Angles on the circle."""

import math

from vfguide.kernels.compiled import compiled

FULL_TURN = 2.0 * math.pi
"""Angle of a full turn [rad]."""


@compiled
def wrap(angle: float) -> float:
    """The same direction in [-pi, pi) [rad]; an angle that is in there already is unchanged."""
    if -math.pi <= angle < math.pi:
        return angle
    wrapped = (angle + math.pi) % FULL_TURN - math.pi
    # The remainder of a tiny negative number rounds to a whole turn.
    return wrapped if wrapped < math.pi else -math.pi
