"""What is told of the difference of two states of the loop, and how often."""

import pytest
from loop_rows import flown

from vfguide.annunciations.airspeed_notes import ESTIMATED
from vfguide.annunciations.step_notes import RESET_NOTE_INTERVAL, Briefing, StepAnnunciator
from vfguide.loop.state import LoopState, fresh_state, row_of_state

PLAN = Briefing(2, 25.0, ("tower",))


def calm() -> LoopState:
    """A state with a known air and nothing doubted."""
    s = fresh_state()
    air = s.estimation.air
    known = air._replace(time=1.0, sensor=air.sensor._replace(trusted=True))
    return s._replace(estimation=s.estimation._replace(air=known))


def after_reset(s: LoopState, number: int) -> LoopState:
    resets = s.estimation.resets._replace(number=number, offset_n=(9.0, 0.0, 0.0), size=9.0)
    return s._replace(estimation=s.estimation._replace(resets=resets))


def doubting(s: LoopState, **times: float) -> LoopState:
    consistency = s.estimation.consistency._replace(**times)
    return s._replace(estimation=s.estimation._replace(consistency=consistency))


def events(announcer, before, after, now_ms=0):
    rows = row_of_state(before), row_of_state(after)
    return announcer.doubts(*rows) + announcer.events(*rows, now_ms, 0.001 * now_ms, 25.0)


def test_a_step_without_news_is_not_told():
    announcer = StepAnnunciator(PLAN)
    assert events(announcer, calm(), calm()) == []
    assert not announcer.has_news
    assert announcer.unfit is None


@pytest.mark.parametrize("interval", [0, 1, RESET_NOTE_INTERVAL - 1, RESET_NOTE_INTERVAL])
def test_position_resets_are_told_once_in_a_while(interval):
    announcer, first = StepAnnunciator(PLAN), after_reset(calm(), 1)
    (note,) = events(announcer, calm(), first, 100)
    assert "jumped by 9 m" in note
    again = events(announcer, first, after_reset(calm(), 2), 100 + interval)
    assert again == ([note] if interval == RESET_NOTE_INTERVAL else [])


def test_an_airspeed_that_is_not_believed_any_more():
    announcer, trusting = StepAnnunciator(PLAN), calm()
    assert events(announcer, fresh_state(), trusting) == []
    air = trusting.estimation.air
    failed = air._replace(sensor=air.sensor._replace(trusted=False))
    after = trusting._replace(estimation=trusting.estimation._replace(air=failed))
    (note,) = events(announcer, trusting, after)
    assert note.endswith(ESTIMATED)


def test_doubts_are_told_and_say_whether_it_can_be_flown_on():
    announcer = StepAnnunciator(PLAN)
    (note,) = events(announcer, doubting(calm(), yaw_doubt=0.4), doubting(calm(), yaw_doubt=0.6))
    assert "yaw" in note
    assert announcer.unfit is None
    assert events(announcer, calm(), doubting(calm(), attitude_doubt=0.1)) == []
    assert announcer.unfit is not None
    events(announcer, calm(), calm())
    assert announcer.unfit is None


def test_a_plan_without_hazards_has_nothing_to_tell_of_them():
    numbered = row_of_state(flown())
    for names, is_told in ((None, False), (("tower",), True)):
        announcer = StepAnnunciator(Briefing(2, 25.0, names))
        announcer.doubts(numbered, numbered)
        assert bool(announcer.events(numbered, numbered, 0, 0.0, 25.0)) == is_told
