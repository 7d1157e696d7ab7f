"""The fence that the truth is held against."""

import numpy as np
import pytest
from scenario_samples import loaded_from
from scenario_texts import MINIMAL, SQUARE

from vfguide.results.fence_distance import fence_clearance


def test_the_truth_is_held_against_the_fence(tmp_path):
    text = f'[fence]\nfloor_m = 20\nceiling_m = 400\n[[fence.zone]]\nkind = "include"\n{SQUARE}'
    scenario = loaded_from(tmp_path, MINIMAL + text).scenario
    path = np.array([[0.0, 0.0, -100.0], [880.0, 0.0, -100.0]])
    assert fence_clearance(scenario, path) == pytest.approx(20.0)
    assert fence_clearance(scenario, np.add(path, (0.0, 0.0, 95.0))) == pytest.approx(-15.0)
    assert fence_clearance(scenario, np.add(path, (100.0, 0.0, 0.0))) == pytest.approx(-80.0)
    assert fence_clearance(scenario, np.add(path, (0.0, 0.0, -310.0))) == pytest.approx(-10.0)
