"""What became of a flight in a random world, as the tools that judge it are told."""

import dataclasses
import math

from measure_avoidance import Outcome

OUTCOME = Outcome(
    number=0,
    reached=True,
    miss_m=1.0,
    angle_deg=1.0,
    clearance_m=3.0,
    time_s=40.0,
    wall_s=1.0,
    acting=0.1,
    length_m=1100.0,
    reference_m=math.nan,
    free_m=1000.0,
    best_m=math.nan,
    reasons=(),
)


def flight(**changes):
    return dataclasses.replace(OUTCOME, **changes)
