"""Goals that tests of the loop fly to, and their rows."""

import math

from vfguide.geometry.units import DEG
from vfguide.loop.legs import Goal, leg_rows

GOALS = (
    Goal((0.0, 0.0, -150.0), 0.0, 0.0, 5.0, 10.0 * DEG),
    Goal((500.0, 100.0, -160.0), 0.5 * math.pi, 3.0 * DEG, 5.0, 10.0 * DEG),
)
LEGS = leg_rows(GOALS, -1.0, 120.0)
FAR = leg_rows((Goal((3000.0, 0.0, -150.0), 0.0, 0.0, 5.0, 10.0 * DEG),), 1.0, 100.0)
"""One goal that no test comes to."""
