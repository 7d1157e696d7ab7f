"""An aircraft in the plane, as the tests of paths place it."""

import math

from vfguide.paths.course_laws import PlanarState

SPEED = 25.0


def at(x, y, course=0.0):
    return PlanarState(x, y, SPEED * math.cos(course), SPEED * math.sin(course))
