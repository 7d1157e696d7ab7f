"""The notes of a flight as an operator reads them: what each says, and when it may be said.

A reader knows nothing but the lines, one after the other, and how many setpoints had gone out when
each was said. Whoever adds a note has to add it here.
"""

import re
from collections import Counter
from enum import Enum, auto
from typing import NamedTuple

UPDATE = 0.02
"""Time from one reading to the next [s]: what happens within one is said in any order."""
SILENCE = 1.2
"""Longest time without setpoints before the operator is told [s]."""


class State(Enum):
    """What the operator thinks is the case."""

    UNHEARD = auto()
    """No autopilot has been found, or it is not heard any more: none goes out."""
    FOUND = auto()
    """It is found; whether setpoints go out is not told yet."""
    OFFERED = auto()
    """Setpoints go out."""
    ASKED = auto()
    """They do, and it is asked to follow."""
    ENGAGED = auto()
    """It follows."""
    LOST = auto()
    """It followed, and is not heard: none goes out."""
    HELD = auto()
    """It was given up for now: none goes out."""
    TAKEN_OVER = auto()
    """Somebody else took over: none goes out."""
    RETURNING = auto()
    """It is being handed over."""
    ENDED = auto()


S = State
SENDING = {S.OFFERED, S.ASKED, S.ENGAGED}
"""States in which the operator counts on setpoints, unless he was told of a silence."""
SILENT = {S.UNHEARD, S.LOST, S.HELD, S.TAKEN_OVER, S.ENDED}
"""States in which he counts on none."""
HEARD = {S.FOUND, S.OFFERED, S.ASKED, S.ENGAGED, S.RETURNING}


class Said(NamedTuple):
    """What a note says."""

    text: str
    """Regular expression of the whole note."""
    states: set[State]
    """In which states it may be said."""
    then: State | None = None
    """The state that it tells; None: the same."""
    begins: str = ""
    """The condition that it says has begun."""
    ends: str = ""
    """The condition that it says is over: it has to have been told."""
    is_event: bool = False
    """Whether it tells of something that may happen again in the same state."""


MODE = r"(HOLD|RETURN|OFFBOARD|mode \d+)"
FLYING = {S.ENGAGED}
NOTES = (
    Said(rf"the autopilot is found, it flies {MODE}", {S.UNHEARD}, S.FOUND),
    Said(
        "setpoints go out(, OFFBOARD will be asked for)?"
        "(, waiting for the operator to choose OFFBOARD)?",
        {S.FOUND},
        S.OFFERED,
        ends="silence?",
    ),
    Said(
        "setpoints go out again(, waiting for the operator to choose OFFBOARD)?"
        "(, OFFBOARD will be asked for)?",
        {S.HELD, S.FOUND, *SENDING, S.RETURNING},
        ends="silence",
    ),
    Said("asking the autopilot for OFFBOARD", {S.OFFERED}, S.ASKED),
    Said("waiting for the operator to choose OFFBOARD", {S.ASKED}, S.OFFERED),
    Said("the mode was changed to .*: it is not asked again", {S.FOUND, S.OFFERED, S.ASKED}),
    Said("the autopilot accepted OFFBOARD and does not fly it: it is not asked again", {S.ASKED}),
    Said("the autopilot refuses OFFBOARD: .*; asking again", {S.ASKED}),
    Said("the autopilot refuses HOLD: .*; asking again", {S.RETURNING, S.HELD}),
    Said(r"the autopilot refuses command \d+ .*", HEARD | SILENT, is_event=True),
    Said("the autopilot follows", {S.FOUND, S.OFFERED, S.ASKED, S.LOST, S.HELD}, S.ENGAGED),
    Said("(?P<silence>no setpoints): .*", {S.FOUND, S.HELD, *SENDING}, begins="silence"),
    Said(
        "link lost, .*: no setpoints until the autopilot is heard again",
        {S.FOUND, S.OFFERED, S.ASKED, S.HELD},
        S.UNHEARD,
    ),
    Said(
        "link lost, .*: no setpoints until the autopilot is heard again",
        FLYING,
        S.LOST,
        begins="silence",
    ),
    Said(".*: no more setpoints for now", {S.ASKED, S.ENGAGED, S.LOST}, S.HELD, begins="silence"),
    Said(
        f"released: the mode was changed to {MODE}, no more setpoints",
        {S.ENGAGED, S.LOST},
        S.TAKEN_OVER,
    ),
    Said("handing over: asking the autopilot for HOLD", {S.ASKED, S.ENGAGED, S.HELD}, S.RETURNING),
    Said("ended: no autopilot was found", {S.UNHEARD}, S.ENDED),
    Said("ended: the autopilot is not heard any more", {S.UNHEARD, S.TAKEN_OVER}, S.ENDED),
    Said(
        f"ended: the autopilot flies {MODE}",
        {S.UNHEARD, S.FOUND, S.OFFERED, S.HELD, S.TAKEN_OVER, S.RETURNING},
        S.ENDED,
    ),
    Said("ended without a link: .*", {S.LOST, S.RETURNING}, S.ENDED),
    Said("the autopilot already follows somebody's setpoints: .*", {S.UNHEARD}),
    Said("slow link: a setpoint acts .*", {S.FOUND, *SENDING, S.HELD, S.RETURNING}, is_event=True),
    Said(r"the companion stood still for [\d.]+ s", HEARD | {S.HELD}, is_event=True),
    Said("flying to goal .*|loitering", FLYING),
    Said("goal .* (reached|missed).*", FLYING, is_event=True),
    Said("no progress to goal .*", FLYING),
    Said(r"the field does not lead to goal \d+: a route is flown", FLYING),
    Said(r"the approach leads away from goal \d+: a route is flown", FLYING),
    Said(r"the field leads again to goal \d+", FLYING),
    Said(
        "(no airspeed is heard|the airspeed sensor is not believed): .*", FLYING, begins="estimated"
    ),
    Said(
        "(no airspeed is heard any more|the airspeed sensor is not believed any more): .*",
        FLYING,
        begins="estimated",
    ),
    Said("the airspeed sensor is believed (again|from now on)", FLYING, ends="estimated"),
    Said("the position told by the autopilot has jumped by .*", FLYING, is_event=True),
    Said("the autopilot has moved the origin .*", HEARD | SILENT, is_event=True),
    Said(
        "the (?P<doubt>.*) told by the autopilot contradicts .*", HEARD | {S.HELD}, begins="doubt"
    ),
    Said(
        "the (?P<doubt>.*) told by the autopilot is believed again", HEARD | {S.HELD}, ends="doubt"
    ),
    Said("the autopilot's (clock|date) has leapt .*", HEARD | SILENT, is_event=True),
    Said("the autopilot's new date has lasted: followed", HEARD | SILENT, is_event=True),
    Said("a heartbeat of vehicle .*: ignored|vehicle .* nothing is sent to it", HEARD | SILENT),
    Said("(goal .* unreachable|no circle) now: .*", FLYING, begins="wind hold"),
    Said("the wind has fallen: .*", FLYING, ends="wind hold"),
    Said("escape: .*", FLYING, begins="escape"),
    Said("NOTHING IS CLEAR: .*", FLYING, begins="escape", is_event=True),
    Said("escape over: back to guidance", FLYING, ends="escape"),
    Said("new route: .*", FLYING, ends="no route?", is_event=True),
    Said(r"no route to goal \d+ found .*", FLYING, begins="no route"),
    Said(r"the route to goal \d+ is clear again", FLYING, ends="no route"),
    Said(r"traffic (?P<traffic>.*) in \d+ s, \d+ m", HEARD, begins="traffic"),
    Said("traffic (?P<traffic>.*) is no conflict any more", HEARD, ends="traffic"),
    Said("moving obstacles.*", HEARD),
    Said(".*: not followed unless it lasts .*", FLYING, begins="place"),
    Said("the place told by the autopilot is right again", FLYING, ends="place"),
    Said("test flight.*|measured: .*|not seen well .*|no room .*", FLYING, is_event=True),
)
FORGOTTEN = {S.UNHEARD, S.HELD, S.LOST, S.TAKEN_OVER}
"""States on entering which a condition of the flight, as an escape, is over without a word."""
OF_THE_FLIGHT = ("escape", "no route")


class Line(NamedTuple):
    """A note, when it was said, and how many setpoints had gone out by then."""

    time: float
    setpoints: int
    note: str


class Reader:
    """Reads a flight; `faults` is what an operator would have been told wrongly."""

    def __init__(self):
        self.state, self.faults = S.UNHEARD, []
        self._holds, self._said = set(), Counter()
        self._last = Line(0.0, 0, "")
        self._promised = None
        self._sent = 0
        """How many had gone out at the time of the line before."""

    def read(self, line: Line) -> None:
        """The next line."""
        self._count(line)
        fitting = [(each, m) for each in NOTES if (m := re.fullmatch(each.text, line.note))]
        if not fitting:
            self._complain(line, "nobody knows what it means")
            return
        here = [(each, m) for each, m in fitting if self.state in each.states]
        if not here:
            self._complain(line, f"cannot be said while {self.state.name}")
        said, match = (here or fitting)[0]
        self._weigh(line, said, match)
        self._last = line

    def end(self, line: Line) -> list[str]:
        """The end of the flight, whose setpoints count too; returns the faults."""
        self._count(line)
        return self.faults

    def _count(self, line: Line) -> None:
        """Hold what went out since the last line against what was told."""
        sent, elapsed = line.setpoints - self._last.setpoints, line.time - self._last.time
        silent = self.state in SILENT or "silence" in self._holds
        self._sent = self._last.setpoints if elapsed > 0.0 else self._sent
        if silent and sent > 1:
            self._complain(line, f"{sent} setpoints went out after: {self._last.note}")
        if self.state in SENDING and not silent and elapsed > SILENCE and not sent:
            self._complain(line, f"none went out for {elapsed:.1f} s after: {self._last.note}")
        if (
            self._promised
            and line.time - self._promised.time > SILENCE
            and "asking" not in line.note
        ):
            self._complain(line, f"did not come: {self._promised.note}")
        self._promised = None if elapsed > UPDATE else self._promised

    def _weigh(self, line: Line, said: Said, match: re.Match) -> None:
        """Hold a line against what was said before."""
        note = line.note
        if "go out again" in note and self._last.setpoints == 0 and line.setpoints <= 1:
            self._complain(line, "again, and none ever went out")
        if note.startswith("setpoints go out") and line.setpoints == self._sent:
            self._complain(line, "none has gone out")
        if (
            "again" in note
            and not said.ends
            and "until" not in note
            and "asked again" not in note
            and "asking again" not in note
        ):
            self._complain(line, "again, and nothing says that it was before")
        if not said.is_event and self._said[note]:
            self._complain(line, "is said twice")
        self._said[note] += 1
        self._conditions(line, said, match)
        if "will be asked for" in note:
            self._promised = line
        if said.then is not None and said.then is not self.state:
            self._enter(said.then)
        elif "go out again" in note and self.state is S.HELD:
            self._enter(S.OFFERED)

    def _conditions(self, line: Line, said: Said, match: re.Match) -> None:
        """Take what begins and what ends."""
        name = said.begins or said.ends.rstrip("?")
        if not name:
            return
        key = f"{name} {match.groupdict().get(name) or ''}".strip()
        key = "silence" if name == "silence" else key
        if said.begins:
            if key in self._holds and name not in ("silence", "escape"):
                self._complain(line, f"{key} has begun already")
            self._holds.add(key)
            return
        if key not in self._holds and not said.ends.endswith("?"):
            self._complain(line, f"{key} never began")
        self._holds.discard(key)
        self._said = Counter({k: v for k, v in self._said.items() if not self._is_of(k, name)})

    def _is_of(self, note: str, name: str) -> bool:
        """Whether a note begins or ends a condition: it may be said again then."""
        fits = [each for each in NOTES if re.fullmatch(each.text, note)]
        return any(name in (each.begins, each.ends.rstrip("?")) for each in fits)

    def _enter(self, state: State) -> None:
        self.state = state
        self._said.clear()
        if state in FORGOTTEN:
            self._holds -= {each for each in self._holds if each.startswith(OF_THE_FLIGHT)}
        if state in (S.UNHEARD, S.FOUND, S.ENGAGED, S.TAKEN_OVER, S.ENDED):
            self._holds.discard("silence")

    def _complain(self, line: Line, what: str) -> None:
        self.faults.append(f'{line.time:.2f} s, {self.state.name}: "{line.note}": {what}')


def faults_in(lines: list[Line], end: Line) -> list[str]:
    """What is wrong with the notes of a flight."""
    reader = Reader()
    for line in lines:
        reader.read(line)
    return reader.end(end)
