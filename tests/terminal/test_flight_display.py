"""What the terminal says of the assurance after a run."""

from types import SimpleNamespace

import pytest

from vfguide.results.interventions import AssuranceResult, Episode
from vfguide.terminal.flight_display import assurance_lines


@pytest.mark.parametrize(
    ("unclear", "episodes", "said"),
    [
        (0, 1, "assurance: vehicle 1 acted 1 time, in 2.0 % of its setpoints"),
        (
            3,
            2,
            "assurance: vehicle 1 acted 2 times, in 2.0 % of its setpoints; "
            "NOTHING WAS CLEAR in 3 setpoints",
        ),
    ],
)
def test_setpoints_that_nothing_was_clear_for_are_no_escapes(unclear, episodes, said):
    each = Episode(1.0, 2.0, "escape", "tower")
    acted = AssuranceResult(1000, 20 - unclear, unclear, 0.02, 1.0, (each,) * episodes)
    result = SimpleNamespace(vehicles=[SimpleNamespace(id=1, assurance=acted)])
    assert assurance_lines(result) == [said]
