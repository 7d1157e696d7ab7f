"""What the operator should read of obstacles and the fence: each thing when it begins and ends."""

import math
from itertools import pairwise

from vfguide.assurance.decision import Reason
from vfguide.companion.loop_report import (
    decision_of_row,
    goal_of_row,
    looked_of_row,
    reason_of_row,
    route_of_row,
    sought_of_row,
)
from vfguide.companion.plan import Plan
from vfguide.geometry.rows import Row
from vfguide.paths.dubins import DubinsPath, length_of
from vfguide.paths.edge import edge_in
from vfguide.planning.replanning import CHECK_INTERVAL, SEARCH_INTERVAL
from vfguide.planning.route_following import RouteFollowing

QUIET = 1.0
"""Two notes of a kind are at least so far apart, and an escape is over after so long [s]."""
BACK = "back on the way"
NO_ROUTE = "no way to goal {goal} found among what is known: only the assurance keeps it clear"
ROUTE_AGAIN = "the way to goal {goal} is clear again"
NOTHING_CLEAR = "NOTHING IS CLEAR: {what}, the least bad is flown, take over if you can"


class HazardAnnunciator:
    """Tells what a companion does among hazards; it remembers what was told."""

    def __init__(self, plan: Plan) -> None:
        self._plan = plan
        self._told: dict[str, float] = {}
        """When a note of each kind was told [s]."""
        self._acted: float | None = None
        """When the assurance acted last, while its escape lasts [s]."""
        self._sought = -math.inf
        self._lost: int | None = None
        """The goal to which no way was found."""

    def notes(self, after: Row, now: float) -> list[str]:
        """What is new with a step, which left the memory `after` at `now`.

        Times are on the clock of the obstacles [s].
        """
        if self._plan.hazards is None:
            return []
        return [*self._assurance(after, now), *self._ways(after, now)]

    def _assurance(self, after: Row, now: float) -> list[str]:
        if reason_of_row(after) == Reason.NOMINAL:
            if self._acted is None or abs(now - self._acted) < QUIET:
                return []
            self._acted = None
            return [BACK]
        decision = decision_of_row(after)
        new, self._acted = self._acted is None, now
        what = conflict_note(decision.conflict, decision.hazard, self._plan.hazard_names)
        if decision.reason == Reason.BEST_EFFORT:
            return self._tell("nothing", NOTHING_CLEAR.format(what=what), now)
        return self._tell("escape", f"escape: {what}", now) if new else []

    def _ways(self, after: Row, now: float) -> list[str]:
        sought, goal = sought_of_row(after), goal_of_row(after)
        if self._lost is not None and self._lost != goal:
            self._lost = None
        if sought != self._sought and math.isfinite(sought):
            self._sought, route = sought, route_of_row(after)
            if route.clearance > 0.0:
                self._lost = None
                return self._tell("way", route_summary(route), now)
            if self._lost is None:
                self._lost = goal
                return self._tell("no way", NO_ROUTE.format(goal=goal + 1), now)
        elif (
            self._lost is not None
            and looked_of_row(after) - sought > SEARCH_INTERVAL + CHECK_INTERVAL
        ):
            self._lost = None  # it was looked along without need to search
            return [ROUTE_AGAIN.format(goal=goal + 1)]
        return []

    def _tell(self, kind: str, note: str, now: float) -> list[str]:
        """The note, unless one of its kind was told just now."""
        if abs(now - self._told.get(kind, -math.inf)) < QUIET:
            return []
        self._told[kind] = now
        return [note]


def conflict_note(conflict: float, hazard: int, names: tuple[str, ...]) -> str:
    """What would have been hit, and when."""
    if hazard < 0 or not math.isfinite(conflict):
        return "else no way out would be left"
    return f"{names[hazard] if hazard < len(names) else 'traffic'} in {conflict:.1f} s"


def route_summary(route: RouteFollowing) -> str:
    """How the way round winds, and how long it is; or how high it is over what is in it."""
    if math.isfinite(route.level) and route.length == 0:
        return f"over what is in the way, at {-route.level:.0f} m"
    route_edges = route.length or route.present + 1  # the last one flies as the leg's own
    paths = [edge_in(route.route_edges, i).path for i in range(route_edges)]
    sides = [side for path in paths for side in sides_of(path)]
    turns = sum(one != other for one, other in pairwise((0.0, *sides)) if other != 0.0)
    length = route.radius * sum(length_of(path) for path in paths)
    return f"a way round: {turns} turn{'s' if turns != 1 else ''}, {length:.0f} m"


def sides_of(path: DubinsPath) -> list[float]:
    """To which side each part of a word that is longer than a degree turns, 0 for a straight."""
    parts = ((path.first, path.arc), (path.middle, path.reach), (path.last, path.end))
    return [side for side, length in parts if length > 0.0175]
