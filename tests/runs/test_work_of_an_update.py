"""How much the program does for one update of a run, counted and not timed.

Times depend on the machine and on who else uses it. The number of functions that Python calls does
not: it grows with each layer that a message passes through, and the time of a run with it.
"""

import sys
from collections import Counter

import pytest

from vfguide.preflight.load import load_scenario
from vfguide.runs.lockstep import fly_scenario

pytestmark = pytest.mark.slow

MOST_CALLS = 435
"""Largest number of calls for each update of `first-flight`, chosen a little above what it is;
it was 506 before calls were saved, and 385 before what the autopilot tells was checked."""


@pytest.fixture(scope="module")
def calls(tmp_path_factory):
    """Functions called in the loop of one flight, by their names, for each update."""
    loaded, count, updates = load_scenario("first-flight", ["duration_s=12"]), Counter(), [0]
    fly_scenario(loaded, tmp_path_factory.mktemp("warm"))

    def note(frame, event, called):
        if event == "call":
            count[frame.f_code.co_qualname] += 1
        elif event == "c_call":
            count[called.__qualname__] += 1

    def begin(_, __):
        updates[0] += 1
        sys.setprofile(note)

    try:
        fly_scenario(loaded, tmp_path_factory.mktemp("counted"), begin)
    finally:
        sys.setprofile(None)
    return {name: number / updates[0] for name, number in count.items()}


def test_an_update_takes_few_calls(calls):
    most = sorted(calls, key=calls.__getitem__, reverse=True)[:10]
    assert sum(calls.values()) < MOST_CALLS, [(name, calls[name]) for name in most]


def test_the_frames_of_an_update_go_to_the_logs_together(calls):
    """Each log takes the frames of an update in one or two pieces, and one of the truth."""
    assert calls["TlogWriter.append"] < 5.5


def test_a_position_is_looked_at_now_and_then_and_a_density_where_the_altitude_is_new(calls):
    assert calls["PlaceWatch._look"] < 0.2
    assert calls["isa_density"] < 0.5
