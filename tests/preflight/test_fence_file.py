"""The fence of a scenario: what it may say, and what the truth is held against."""

import math
import re

import pytest
from scenario_samples import loaded_from
from scenario_texts import MINIMAL, SQUARE

from vfguide.files.errors import InputError
from vfguide.preflight.load import load_scenario
from vfguide.scenario.hazards import hazards_of, keep_out_zones_of


@pytest.mark.parametrize(
    ("text", "message"),
    [
        ('[[fence.zone]]\nkind = "include"', r"fence\.zone\[0\].*exactly one way: polygon_m, or"),
        ('[[fence.zone]]\nkind = "in"\n' + SQUARE, r'allowed "include", "exclude"'),
        ('[[fence.zone]]\nkind = "include"\npolygon_m = [[0, 0], [1, 1]]', "at least three"),
        ('[[fence.zone]]\nkind = "include"\npolygon_m = [[0, 0, 1]]', "list of two numbers"),
        ('[[fence.zone]]\nkind = "exclude"\ncentre_m = [0, 0]', "centre_m and radius_m"),
        ('[[fence.zone]]\nkind = "exclude"\nradius_m = 5\n' + SQUARE, "centre_m and radius_m"),
        (
            '[[fence.zone]]\nkind = "exclude"\ncentre_m = [5000, 0]\nradius_m = 50\n'
            "lowest_m = 100\nhighest_m = 90",
            r"highest_m.*not above lowest_m",
        ),
        (
            '[[fence.zone]]\nkind = "include"\n'
            "polygon_m = [[-900, -900], [900, 900], [900, -900], [-900, 900]]",
            "its sides 1 and 3 cross or touch",
        ),
        ("[fence]\nfloor_m = 100\nceiling_m = 50", "ceiling_m.*not above floor_m"),
        ("[fence]\nfloor_m = 5000", "below the fence, allowed above fence.floor_m = 5000"),
        ("[fence]\nceiling_m = 1", "above the fence, allowed below fence.ceiling_m = 1"),
        (
            '[[fence.zone]]\nkind = "include"\ncentre_m = [9000, 0]\nradius_m = 50',
            r"outside fence\.zone\[0\], allowed inside it",
        ),
    ],
)
def test_a_fence_that_makes_no_sense_is_refused(tmp_path, text, message):
    with pytest.raises(InputError) as error:
        loaded_from(tmp_path, MINIMAL + text)
    assert re.search(message, str(error.value)), str(error.value)


def test_a_fence_is_written_and_read_again(tmp_path):
    text = f'[fence]\nfloor_m = 20\n[[fence.zone]]\nkind = "include"\n{SQUARE}'
    scenario = loaded_from(tmp_path, MINIMAL + text).scenario
    again = tmp_path / "again.toml"
    again.write_text(scenario.to_toml())
    assert load_scenario(again).scenario == scenario
    hazards = hazards_of(scenario)
    assert (hazards.floor, hazards.ceiling) == (20.0, math.inf)
    assert len(keep_out_zones_of(scenario.fence).table) == 1


def test_without_obstacles_and_fence_there_is_nothing_to_keep_clear_of(tmp_path):
    assert hazards_of(loaded_from(tmp_path).scenario) is None
