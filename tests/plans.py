"""What a companion is asked to do in tests, without the file of a scenario.

`tests/scenario/test_plans.py` compares it with the file.
"""

from aeroplanes import AEROSONDE

from vfguide.aircraft.performance import Gains, turn_length
from vfguide.companion.plan import Plan
from vfguide.geometry.units import DEG
from vfguide.loop.legs import Goal

FIRST_FLIGHT = Plan(
    origin=(47.397742 * DEG, 8.545594 * DEG, 488.0),
    goals=(Goal((0.0, 0.0, -130.0), 90.0 * DEG, 0.0, 5.0, 10.0 * DEG),),
    loiter_side=1.0,
    loiter_radius=1.57 * turn_length(25.0),
    rate=50.0,
    aircraft=AEROSONDE,
    gains=Gains(25.0, bank_max=50.0 * DEG),
    hazard_names=("",),
    epoch=1_767_225_600_000_000,
)
