"""What `vfguide warm` leaves out of all that commands do with the shipped scenarios."""

import tomllib

from vfguide.files.data import find_scenario, shipped_scenarios
from vfguide.runs.warm_everything import DRAWN

SHOWN = ("obstacle", "fence", "traffic")
"""Tables of a scenario that figures show besides its vehicles."""


def things_in(name: str) -> set[str]:
    """What a figure of a shipped scenario shows, and on which plant it is flown."""
    table = tomllib.loads(find_scenario(name).read_text())
    return {f"{table.get('plant', 'jsbsim')} {key}" for key in (*SHOWN, "vehicle") if key in table}


def test_each_kind_of_thing_is_drawn_in_one_of_them():
    names = shipped_scenarios()
    assert set(DRAWN) < set(names)
    drawn = set().union(*map(things_in, DRAWN))
    assert len(drawn) > len(SHOWN)
    for name in names:
        assert things_in(name) <= drawn, name
