"""What the terminal says of the assurance after a run."""

from types import SimpleNamespace

import pytest

from vfguide.results.interventions import AssuranceResult, Intervention
from vfguide.results.result import Result
from vfguide.terminal import flight_display
from vfguide.terminal.console import Printer
from vfguide.terminal.flight_display import assurance_lines


@pytest.mark.parametrize(
    ("unclear", "interventions", "said"),
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
def test_setpoints_that_nothing_was_clear_for_are_no_escapes(unclear, interventions, said):
    each = Intervention(1.0, 2.0, "escape", "tower")
    acted = AssuranceResult(1000, 20 - unclear, unclear, 0.02, 1.0, (each,) * interventions)
    result = SimpleNamespace(vehicles=[SimpleNamespace(id=1, assurance=acted)])
    assert assurance_lines(result) == [said]


def test_the_terminal_says_in_words_why_a_verdict_is_bad(capsys, monkeypatch, tmp_path):
    monkeypatch.setattr(flight_display, "out", Printer())
    result = Result(
        "x", "0", 1, "bad", ("time", "goal 1 of vehicle 1 not reached"), *(1.0,) * 3, None, ()
    )
    flight_display.print_result(result, tmp_path)
    said = capsys.readouterr().out
    assert "  time: duration_s was over first\n  goal 1 of vehicle 1 not reached\n" in said
