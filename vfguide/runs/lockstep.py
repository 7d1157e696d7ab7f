"""A scenario flown in lockstep: all vehicles on one simulated clock."""

import time
from collections.abc import Callable, Sequence
from contextlib import ExitStack, nullcontext
from dataclasses import dataclass
from pathlib import Path
from types import TracebackType
from typing import Protocol

from vfguide.results.judge import judge
from vfguide.results.record import FlightRecord
from vfguide.results.result import Result
from vfguide.runs.aeroplanes import Aeroplanes
from vfguide.runs.fleet import Ending, Fleet, Flown
from vfguide.runs.logs import Logs
from vfguide.runs.rigid_bodies import RigidBodies
from vfguide.runs.steps import STEPS, Steps
from vfguide.runs.warm_up import Tell, tell_nobody, warm_up
from vfguide.scenario.loaded import LoadedScenario
from vfguide.sim.traffic import TIME_TOLERANCE

AFTERWARDS = 5.0
"""Time for which a run goes on after the last goal [s]; chosen, so that the flight behind it is
seen."""

EARLY = frozenset({Ending.TIME, Ending.STOPPED})
"""Endings that make a verdict bad by themselves."""

Progress = Callable[[float, Sequence[Flown]], None]
"""Called with the simulated time [s] and the vehicles after every update."""


@dataclass(frozen=True)
class Flight:
    """A scenario that was flown."""

    records: tuple[FlightRecord, ...]
    sim_s: float
    """Simulated time [s]."""
    wall_s: float
    """Real time of the loop alone [s]."""
    ending: Ending


def ignore_progress(_: float, __: Sequence[Flown]) -> None:
    """A progress that does nothing."""


class Requests(Protocol):
    """The user's requests to end; entered while a loop looks for them."""

    def wanted(self) -> bool:
        """Whether the user wants an end."""
        ...

    def __enter__(self) -> object: ...

    def __exit__(
        self,
        kind: type[BaseException] | None,
        error: BaseException | None,
        trace: TracebackType | None,
        /,
    ) -> None: ...


class NoRequests(nullcontext[None]):
    """Of a flight that nobody stops."""

    def wanted(self) -> bool:
        """Never."""
        return False


def fly_scenario(
    loaded: LoadedScenario,
    folder: Path,
    progress: Progress = ignore_progress,
    requests: Requests | None = None,
    tell: Tell = tell_nobody,
    *,
    realtime: bool = False,
    steps: Steps = STEPS,
) -> Flight:
    """Fly a scenario to its end; the logs go to `folder`.

    Args:
        loaded: the scenario.
        folder: where the logs go.
        progress: called after every update.
        requests: to end, looked for before every update; None: nobody asks.
        tell: told what is compiled.
        realtime: whether to fly no faster than real time.
        steps: the compiled steps of each update.

    Raises:
        InputError: an aircraft's model cannot be flown.
        TlogError: a log cannot be written.
    """
    warm_up(loaded, tell)
    requests = requests or NoRequests()
    with ExitStack() as stack:
        fleet = fleet_of(loaded, Logs(folder, stack), steps)
        lockstep = Lockstep(fleet, loaded.scenario.duration_s)
        stack.enter_context(requests)
        started = time.perf_counter()
        while (ending := Ending.STOPPED if requests.wanted() else lockstep.ending) is None:
            lockstep.advance()
            progress(lockstep.sim_s, fleet.members)
            if realtime:
                time.sleep(max(0.0, started + lockstep.sim_s - time.perf_counter()))
        wall_s = time.perf_counter() - started
        records = fleet.records()
    return Flight(records, lockstep.sim_s, wall_s, ending)


def judged(loaded: LoadedScenario, flight: Flight) -> Result:
    """The result of a flight of a scenario, by the truth."""
    early = (flight.ending.value,) if flight.ending in EARLY else ()
    return judge(loaded.scenario, flight.records, flight.sim_s, flight.wall_s, early)


def fleet_of(loaded: LoadedScenario, logs: Logs, steps: Steps = STEPS) -> Fleet:
    """The vehicles of a scenario at their starts.

    Raises:
        InputError: an aircraft's model cannot be flown.
        TlogError: a log cannot be written.
    """
    if loaded.scenario.plant == "jsbsim":
        return Aeroplanes(loaded, logs, steps)
    return RigidBodies(loaded, logs.write_all, steps)


class Lockstep:
    """The vehicles of a run and their common clock."""

    def __init__(self, fleet: Fleet, duration: float) -> None:
        """All at their starts; `duration` [s] is the longest flight."""
        self._fleet = fleet
        self._duration = duration
        self._period = fleet.period
        self._updates = 0
        self.sim_s = 0.0
        """Simulated time [s]."""
        self._finished_at: float | None = None

    @property
    def ending(self) -> Ending | None:
        """Why the flight is over, if it is."""
        if (
            self._finished_at is not None
            and self.sim_s + TIME_TOLERANCE >= self._finished_at + AFTERWARDS
        ):
            return Ending.REACHED
        if (ending := self._fleet.ending) is not None:
            return ending
        return Ending.TIME if self.sim_s + TIME_TOLERANCE >= self._duration else None

    def advance(self) -> None:
        """Every vehicle flies on to the next update."""
        self._updates += 1
        self.sim_s = self._updates * self._period
        self._fleet.advance()
        if self._finished_at is None and all(each.legs.finished for each in self._fleet.members):
            self._finished_at = self.sim_s
