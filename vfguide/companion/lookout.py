"""What the operator should read of obstacles and the fence: each thing when it begins and ends."""

import math
from itertools import pairwise

import numpy as np

from vfguide.companion.plan import Plan
from vfguide.companion.route_memory import DETOUR, GUARD, PackedMemory, decision_in, goal_in
from vfguide.flight.detour_leg import (
    CLEARANCE,
    COUNT,
    INDEX,
    LEVEL,
    LOOKED,
    RADIUS,
    ROWS,
    SOUGHT,
)
from vfguide.flight.hop import HOP_COLUMNS, Hop
from vfguide.flight.shortest import Word
from vfguide.flight.way_round import LOOK, SEEK
from vfguide.geometry.rows import unflattener
from vfguide.safety.assurance import Reason

hop_of = unflattener(Hop)
QUIET = 1.0
"""Two notes of a kind are at least so far apart, and an escape is over after so long [s]."""
BACK = "back on the way"
NO_WAY = "no way to goal {goal} found among what is known: only the assurance keeps it clear"
WAY_AGAIN = "the way to goal {goal} is clear again"
NOTHING_CLEAR = "NOTHING IS CLEAR: {what}, the least bad is flown, take over if you can"


class Lookout:
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

    def notes(self, after: PackedMemory, now: float) -> list[str]:
        """What is new with a step, which left the memory `after` at `now`.

        Times are on the clock of the obstacles [s].
        """
        if self._plan.hazards is None:
            return []
        return [*self._assurance(after, now), *self._ways(after, now)]

    def _assurance(self, after: PackedMemory, now: float) -> list[str]:
        reason, _, conflict, hazard = decision_in(after)
        if reason == Reason.CLEAR:
            if self._acted is None or abs(now - self._acted) < QUIET:
                return []
            self._acted = None
            return [BACK]
        new, self._acted = self._acted is None, now
        what = conflict_note(conflict, int(hazard), self._plan.hazard_names)
        if reason == Reason.LEAST_BAD:
            return self._tell("nothing", NOTHING_CLEAR.format(what=what), now)
        return self._tell("escape", f"escape: {what}", now) if new else []

    def _ways(self, after: PackedMemory, now: float) -> list[str]:
        detour, goal = after[DETOUR:GUARD], goal_in(after)
        if self._lost is not None and self._lost != goal:
            self._lost = None
        sought = float(detour[SOUGHT])
        if sought != self._sought and math.isfinite(sought):
            self._sought = sought
            if detour[CLEARANCE] > 0.0:
                self._lost = None
                return self._tell("way", way_note(detour), now)
            if self._lost is None:
                self._lost = goal
                return self._tell("no way", NO_WAY.format(goal=goal + 1), now)
        elif self._lost is not None and detour[LOOKED] - sought > SEEK + LOOK:
            self._lost = None  # it was looked along without need to search
            return [WAY_AGAIN.format(goal=goal + 1)]
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


def way_note(detour: PackedMemory) -> str:
    """How the way round winds, and how long it is; or how high it is over what is in it."""
    if math.isfinite(detour[LEVEL]) and detour[COUNT] == 0.0:
        return f"over what is in the way, at {-detour[LEVEL]:.0f} m"
    hops = int(detour[COUNT]) or int(detour[INDEX]) + 1  # the last one flies as the leg's own
    rows = detour[ROWS : ROWS + hops * HOP_COLUMNS].reshape(hops, HOP_COLUMNS)
    words = [hop_of(row).word for row in rows.tolist()]
    sides = [side for word in words for side in sides_of(word)]
    turns = sum(one != other for one, other in pairwise((0.0, *sides)) if other != 0.0)
    lengths = np.array([(word.arc, word.reach, word.end) for word in words])
    length = float(detour[RADIUS] * lengths.sum())
    return f"a way round: {turns} turn{'s' if turns != 1 else ''}, {length:.0f} m"


def sides_of(word: Word) -> list[float]:
    """To which side each part of a word that is longer than a degree turns, 0 for a straight."""
    parts = ((word.first, word.arc), (word.middle, word.reach), (word.last, word.end))
    return [side for side, length in parts if length > 0.0175]
