"""Why an escape was flown, found in its log alone."""

import json

import pytest
from commands import vfguide
from explain_step import explained
from world_tables import northward, world_file

from vfguide.cli.replay import open_log
from vfguide.preflight.load import load_scenario
from vfguide.scenario.plans import plan_of

pytestmark = pytest.mark.slow
BALLOON = {
    "name": "balloon",
    "shape": "sphere",
    "radius_m": 20.0,
    "position_m": [400.0, 0.0, -150.0],
    "visible_from_m": 50.0,
}
"""A balloon on the way that is seen so late that only an escape misses it."""


def test_an_escape_is_explained_by_what_the_command_would_have_come_to(tmp_path):
    world = world_file(northward("sudden", obstacle=[BALLOON]), tmp_path)
    vfguide("run", str(world), "--out", "flown", "--no-report", cwd=tmp_path)
    result = json.loads((tmp_path / "flown/result.json").read_text())
    (episode, *_) = result["vehicles"][0]["assurance"]["episodes"]
    loaded = load_scenario(tmp_path / "flown/scenario.toml")
    plan = plan_of(loaded, loaded.scenario.vehicles[0])

    def lines(at):
        return list(explained(open_log(tmp_path / "flown/vehicle-1.tlog"), 1, plan, at))

    before, during = lines(episode["from_s"] - 1.0), lines(episode["from_s"] + 0.1)
    assert any(line.startswith("decision: NOMINAL") for line in before)
    (decision,) = [line for line in during if line.startswith("decision: ")]
    assert "the command would come to balloon in" in decision
    assert decision.startswith(("decision: RECOVERY", "decision: BEST_EFFORT"))
    assert any("balloon in" in line for line in during if " s  " in line), during[:9]
    assert "      reason: 0" not in during
    assert lines(0.0) == ["no step until 0.0 s"] or lines(0.0)[-1].startswith("no step")
