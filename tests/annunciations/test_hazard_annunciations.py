"""Notes about obstacles and the fence: once at the beginning, once at the end, never a flood."""

import math

import pytest

from vfguide.annunciations.hazard_notes import BACK_ON_ROUTE, HazardAnnunciator, route_summary
from vfguide.assurance.decision import Reason
from vfguide.geometry.se2 import Pose
from vfguide.kernels.rows import Row
from vfguide.loop.state import fresh_state, row_of_state
from vfguide.paths.dubins import DubinsPath
from vfguide.paths.edge import Edge, edge_row
from vfguide.planning.route import fresh_route
from vfguide.planning.route_following import RouteFollowing, fresh_following

CLEAR, ESCAPE, BEST_EFFORT = Reason.NOMINAL, Reason.RECOVERY, Reason.BEST_EFFORT
HERE = Pose(0.0, 0.0, 0.0)
STEP = 0.02
NAMES = ("south tower", "middle tower", "north tower")


def decided(reason: Reason, conflict: float = math.inf, hazard: int = -1) -> Row:
    s = fresh_state(5)
    decision = s.assurance.decision._replace(reason=reason, conflict=conflict, hazard=hazard)
    return row_of_state(s._replace(assurance=s.assurance._replace(decision=decision)))


def on(route: RouteFollowing) -> Row:
    """The row of a state with a route round hazards."""
    return row_of_state(fresh_state(5)._replace(planning=fresh_route()._replace(following=route)))


def searched(clearance: float, at: float, looked: float | None = None) -> RouteFollowing:
    looked = at if looked is None else looked
    return fresh_following()._replace(clearance=clearance, sought=at, looked=looked)


def sought(clearance: float, at: float, looked: float | None = None) -> Row:
    return on(searched(clearance, at, looked))


def with_edges(route: RouteFollowing, radius: float, *paths: DubinsPath) -> RouteFollowing:
    edges = route.route_edges.copy()
    edges[: len(paths)] = [edge_row(Edge(HERE, path)) for path in paths]
    return route._replace(length=len(paths), radius=radius, route_edges=edges)


def told(*stretches: tuple[float, Row]) -> list[tuple[float, str]]:
    """Times and notes of stretches of so many seconds with the same row."""
    annunciator, notes, now = HazardAnnunciator(NAMES), [], 0.0
    for seconds, row in stretches:
        for _ in range(round(seconds / STEP)):
            now = round(now + STEP, 6)
            notes += [(now, note) for note in annunciator.notes(row, now)]
    return notes


def test_an_escape_is_told_when_it_begins_and_when_it_is_over() -> None:
    notes = told(
        (1.0, decided(CLEAR)),
        (2.0, decided(ESCAPE, 4.21, 1)),
        (3.0, decided(CLEAR)),
    )
    assert notes == [(1.02, "escape: middle tower in 4.2 s"), (4.0, BACK_ON_ROUTE)]


def test_an_escape_without_a_conflict_says_so() -> None:
    ((_, note),) = told((1.0, decided(ESCAPE)))
    assert note == "escape: else no way out would be left"


def test_where_nothing_is_clear_is_said_loudly_and_once_of_each_hazard() -> None:
    south, middle = (decided(BEST_EFFORT, 1.5, tower) for tower in (0, 1))
    free = decided(CLEAR)
    notes = told((2.5, south), (2.0, middle), (2.0, south), (2.0, free), (1.0, south))
    assert [time for time, _ in notes] == pytest.approx([0.02, 2.52, 7.5, 8.52])
    names = ("south tower", "middle tower", "south tower")
    texts = [note for _, note in notes if note != BACK_ON_ROUTE]
    assert len(texts) == len(names)
    for name, text in zip(names, texts, strict=True):
        assert text.startswith(f"NOTHING IS CLEAR: {name} in 1.5 s, ")
    ((_, nameless),) = told((1.0, decided(BEST_EFFORT)))
    assert nameless == "NOTHING IS CLEAR: the least bad is flown, take over if you can"


def test_a_way_that_is_found_again_is_told_once() -> None:
    path = DubinsPath(1.0, 0.5, 0.0, 2.0, -1.0, 0.5)
    found = [on(with_edges(searched(12.0, at), 80.0, path)) for at in (0.5, 1.5, 2.5)]
    notes = told(*((1.5, each) for each in found))
    assert [note for _, note in notes] == ["a way round: 2 turns, 240 m"]


def test_a_decision_that_chatters_does_not_flood() -> None:
    chatter = [(0.04, decided(reason, 3.0, 0)) for _ in range(200) for reason in (ESCAPE, CLEAR)]
    assert len(told(*chatter)) == 1


def test_a_way_that_is_not_found_is_told_once_and_when_there_is_one_again() -> None:
    searches = [(1.0, sought(-1.0, at)) for at in (0.5, 1.5, 2.5, 3.5)]
    found = on(with_edges(searched(12.0, 4.5), 80.0, DubinsPath(1.0, 0.5, 0.0, 2.0, -1.0, 0.5)))
    notes = [note for _, note in told(*searches, (2.0, found))]
    assert notes[0].startswith("no way to goal 1 found")
    assert notes[1:] == ["a way round: 2 turns, 240 m"]


def test_a_way_that_became_clear_by_itself() -> None:
    notes = told((1.0, sought(-1.0, 0.5)), (1.0, sought(-1.0, 0.5, looked=1.9)))
    assert notes[1:] == [(1.02, "the way to goal 1 is clear again")]


def test_turns_of_edges_that_join_in_one_are_one() -> None:
    first, second = (
        DubinsPath(1.0, 0.4, 0.0, 1.0, 1.0, 0.3),
        DubinsPath(1.0, 0.2, 0.0, 1.0, -1.0, 0.6),
    )
    route = with_edges(searched(12.0, 0.0), 100.0, first, second)
    assert route_summary(route) == "a way round: 3 turns, 350 m"


def test_a_way_over_is_told_by_its_height() -> None:
    route = fresh_following()._replace(level=-184.6)
    assert route_summary(route) == "over what is in the way, at 185 m"
