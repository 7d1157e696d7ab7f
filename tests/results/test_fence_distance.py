"""The fence that the truth is held against."""

import numpy as np
import pytest
from scenario_samples import MINIMAL

from vfguide.results.fence_distance import fence_clearance
from vfguide.scenario.load import load_scenario

SQUARE = "polygon_m = [[-900, -900], [-900, 900], [900, 900], [900, -900]]"


def loaded(folder, text):
    file = folder / "x.toml"
    file.write_text(f"{MINIMAL}\n{text}\n")
    return load_scenario(file)


def test_the_truth_is_held_against_the_fence(tmp_path):
    text = f'[fence]\nfloor_m = 20\nceiling_m = 400\n[[fence.zone]]\nkind = "include"\n{SQUARE}'
    scenario = loaded(tmp_path, text).scenario
    path = np.array([[0.0, 0.0, -100.0], [880.0, 0.0, -100.0]])
    assert fence_clearance(scenario, path) == pytest.approx(20.0)
    assert fence_clearance(scenario, np.add(path, (0.0, 0.0, 95.0))) == pytest.approx(-15.0)
    assert fence_clearance(scenario, np.add(path, (100.0, 0.0, 0.0))) == pytest.approx(-80.0)
    assert fence_clearance(scenario, np.add(path, (0.0, 0.0, -310.0))) == pytest.approx(-10.0)
