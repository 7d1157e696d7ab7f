"""Random starts over MAVLink, judged by the truth: the issue's table on a smaller sample.

The whole table is printed by tools/measure_poses.py.
"""

import importlib.util
from argparse import Namespace
from pathlib import Path

import pytest

TOOL = Path(__file__).parents[2] / "tools" / "measure_poses.py"


@pytest.fixture(scope="module")
def tool():
    spec = importlib.util.spec_from_file_location("measure_poses", TOOL)
    module = importlib.util.module_from_spec(spec)
    spec.loader.exec_module(module)
    return module


def options(wind):
    return Namespace(
        aircraft="aerosonde",
        scenario="first-flight",
        seed=77,
        nearest=100.0,
        farthest=1000.0,
        height=30.0,
        wind=wind,
        turbulence="none",
        sensors=False,
        no_wind_message=False,
        no_airspeed=False,
        set=[],
    )


@pytest.mark.parametrize(("wind", "miss", "course"), [(0.0, 0.5, 1.0), (5.0, 1.0, 2.0)])
@pytest.mark.parametrize("number", range(10))
def test_random_start(tool, number, wind, miss, course):
    flown = tool.fly(number, options(wind))
    assert flown.reached, flown
    assert flown.miss_m <= miss
    assert flown.course_deg <= course
    assert flown.bank_deg <= 55.0
    assert flown.load[0] >= 0.3
    assert flown.load[1] <= 2.2
    assert flown.airspeed[0] >= 1.2 * tool.frame_of("aerosonde").stall
    assert flown.below_m <= 50.0
    assert flown.rate_hz >= 49.5
