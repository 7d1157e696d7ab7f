"""What a companion is asked to do in tests, without the file of a scenario.

`tests/scenario/test_plans.py` compares it with the file.
"""

from dataclasses import replace

from aeroplanes import AEROSONDE
from hazard_samples import hazards

from vfguide.aircraft.performance import Gains, turn_length
from vfguide.companion.plan import Plan
from vfguide.field.obstacle import Obstacle
from vfguide.geometry.shapes import shape
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
    longest=120.0,
)
AMONG_TOWERS = replace(
    FIRST_FLIGHT,
    hazards=hazards(
        (
            Obstacle(shape.cylinder(25.0, 160.0), (-100.0, -100.0, -80.0)),
            Obstacle(shape.cylinder(40.0, 180.0), (120.0, 10.0, -90.0)),
            Obstacle(shape.box((60.0, 40.0, 150.0)), (380.0, 30.0, -75.0), 30.0 * DEG),
            Obstacle(shape.ellipsoid((700.0, 200.0, 160.0)), (150.0, -480.0, 0.0)),
            Obstacle(shape.ellipsoid((700.0, 200.0, 160.0)), (150.0, 520.0, 0.0)),
        )
    ),
    hazard_names=("south tower", "middle tower", "north tower", "west slope", "east slope", ""),
)
"""The first flight with the obstacles of the towers."""
TEST_FLIGHT = replace(
    FIRST_FLIGHT,
    goals=(Goal((0.0, 0.0, -150.0), 90.0 * DEG, 0.0, 1.0, 2.0 * DEG),),
    identify=True,
    longest=300.0,
)
