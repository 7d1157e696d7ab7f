"""Annunciations of hazards to the operator: each at its start and its end."""

import math
from itertools import pairwise

from vfguide.assurance.decision import Reason
from vfguide.kernels.rows import Row
from vfguide.loop.loop_report import (
    decision_of_row,
    goal_of_row,
    looked_of_row,
    reason_of_row,
    route_of_row,
    sought_of_row,
)
from vfguide.paths.dubins import DubinsPath, length_of
from vfguide.paths.edge import edge_in
from vfguide.planning.replanning import CHECK_INTERVAL, SEARCH_INTERVAL
from vfguide.planning.route_following import RouteFollowing

NOTE_INTERVAL = 1.0
"""Least time between two notes of a kind, and after the last action of an escape until it is over
[s]; chosen."""
ESCAPE_OVER = "escape over: back to guidance"
"""Note at the end of an escape."""
NO_ROUTE = (
    "no route to goal {goal} found among the known hazards: only the assurance keeps it clear"
)
"""Note where the search finds no route to a goal."""
ROUTE_AGAIN = "the route to goal {goal} is clear again"
"""Note where the route to a goal is clear again."""
NOTHING_CLEAR = "NOTHING IS CLEAR"
"""Beginning of the note where no escape stays clear."""
TAKE_OVER = "best effort is flown, take over if you can"
"""End of the note where no escape stays clear."""
NO_ESCAPE_LEFT = "else no escape would be left"
"""Reason of an escape where the command itself would hit nothing."""
TOLD_LENGTH = 0.0175
"""Length of a segment above which a note counts it [turn radii]; chosen, a turn by one degree."""


class HazardAnnunciator:
    """Makes notes of what a companion does among hazards, and remembers those it made."""

    def __init__(self, names: tuple[str, ...]) -> None:
        """No note was made yet; the `names` are those of the hazards, by their numbers."""
        self._names = names
        self._told: dict[str, float] = {}
        """Time of the last note of each kind [s]."""
        self._acted: float | None = None
        """Time of the last action of the assurance during an escape [s]."""
        self._sought = -math.inf
        self._goal = 0
        self._lost: int | None = None
        """The goal to which no route was found."""
        self._route: str | None = None
        """The route that was told last."""
        self._unclear: set[int] = set()
        """Hazards of which the operator was told in this escape that nothing is clear of them."""

    def notes(self, after: Row, now: float) -> list[str]:
        """The notes of a step that left the state `after` at `now`.

        The time is that on the clock of the obstacles [s].
        """
        return [*self._assurance(after, now), *self._routes(after, now)]

    def _assurance(self, after: Row, now: float) -> list[str]:
        if reason_of_row(after) == Reason.NOMINAL:
            if self._acted is None or abs(now - self._acted) < NOTE_INTERVAL:
                return []
            self._acted = None
            self._unclear.clear()
            return [ESCAPE_OVER]
        decision = decision_of_row(after)
        new, self._acted = self._acted is None, now
        what = conflict_note(decision.conflict, decision.hazard, self._names)
        if decision.reason == Reason.BEST_EFFORT:
            return self._nothing_clear(decision.hazard, what, now)
        return self._tell("escape", f"escape: {what or NO_ESCAPE_LEFT}", now) if new else []

    def _nothing_clear(self, hazard: int, what: str, now: float) -> list[str]:
        """The note that nothing stays clear of a hazard, each once in an escape."""
        if hazard in self._unclear:
            return []
        note = f"{NOTHING_CLEAR}: {what}, {TAKE_OVER}" if what else f"{NOTHING_CLEAR}: {TAKE_OVER}"
        if told := self._tell("nothing", note, now):
            self._unclear.add(hazard)
        return told

    def _routes(self, after: Row, now: float) -> list[str]:
        sought, goal = sought_of_row(after), goal_of_row(after)
        if goal != self._goal:
            self._goal, self._lost, self._route = goal, None, None
        if sought != self._sought and math.isfinite(sought):
            self._sought, route = sought, route_of_row(after)
            if route.clearance > 0.0:
                return self._found(route_summary(route), now)
            if self._lost is None and (
                told := self._tell("no route", NO_ROUTE.format(goal=goal + 1), now)
            ):
                self._lost, self._route = goal, None
                return told
        elif (
            self._lost is not None
            and looked_of_row(after) > sought + SEARCH_INTERVAL + CHECK_INTERVAL
        ):
            self._lost = None  # it was checked, and no search was needed
            return [ROUTE_AGAIN.format(goal=goal + 1)]
        return []

    def _found(self, route: str, now: float) -> list[str]:
        """The note of a route that was found, if it is another one than was told last."""
        self._lost = None
        if route == self._route:
            return []
        if told := self._tell("route", route, now):
            self._route = route
        return told

    def _tell(self, kind: str, note: str, now: float) -> list[str]:
        """The note, unless there was one of its kind within NOTE_INTERVAL."""
        if abs(now - self._told.get(kind, -math.inf)) < NOTE_INTERVAL:
            return []
        self._told[kind] = now
        return [note]


def conflict_note(conflict: float, hazard: int, names: tuple[str, ...]) -> str:
    """The hazard of a conflict by its name, and the time until it, `conflict` [s]; empty: none."""
    if hazard < 0 or not math.isfinite(conflict):
        return ""
    return f"{names[hazard] if hazard < len(names) else 'traffic'} in {conflict:.1f} s"


def route_summary(route: RouteFollowing) -> str:
    """The turns and the length of a route, or the level of an overflight."""
    if math.isfinite(route.level) and route.length == 0:
        return f"new route: over the obstacles, at {-route.level:.0f} m"
    route_edges = route.length or route.present + 1  # the last one becomes the path of the leg
    paths = [edge_in(route.route_edges, i).path for i in range(route_edges)]
    sides = [side for path in paths for side in sides_of(path)]
    turns = sum(one != other for one, other in pairwise((0.0, *sides)) if other != 0.0)
    length = route.radius * sum(length_of(path) for path in paths)
    return f"new route: {turns} turn{'s' if turns != 1 else ''}, {length:.0f} m"


def sides_of(path: DubinsPath) -> list[float]:
    """Sides of the segments of a Dubins path longer than TOLD_LENGTH, 0 for a straight."""
    parts = ((path.first, path.arc), (path.middle, path.reach), (path.last, path.end))
    return [side for side, length in parts if length > TOLD_LENGTH]
