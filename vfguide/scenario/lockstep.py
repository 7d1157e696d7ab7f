"""A scenario flown in lockstep: plants, autopilots and companions on one simulated clock."""

import time
from collections.abc import Callable, Sequence
from contextlib import ExitStack
from dataclasses import dataclass
from enum import Enum
from functools import cache
from pathlib import Path

from vfguide.link.tlog import TlogWriter, tlog_record
from vfguide.scenario.load import LoadedScenario, load_scenario
from vfguide.scenario.member import Member
from vfguide.scenario.record import FlightRecord
from vfguide.scenario.resolved import Vehicle
from vfguide.sim.plant import STEP
from vfguide.sim.vehicle import steps_between_updates

WARM_UP_UPDATES = 100
"""Long enough for the companion to take over."""
AFTERWARDS = 5.0
"""A run goes on for this long after the last goal [s]."""
NEARLY = 1e-9
"""Times that differ by less are equal [s]."""

Progress = Callable[[float, Sequence[Member]], None]
"""Told the simulated time [s] and the vehicles, after every update."""


class Ending(Enum):
    """Why a flight ended."""

    REACHED = "reached"
    """5 s after every vehicle reached its last goal."""
    TIME = "time"
    """The time allowed is over."""
    GROUND = "ground"
    """A vehicle touched the ground."""
    STOPPED = "interrupted"
    """Somebody stopped it."""


@dataclass(frozen=True)
class Flight:
    """A scenario that was flown."""

    records: tuple[FlightRecord, ...]
    sim_s: float
    wall_s: float
    """Of the loop alone."""
    ending: Ending


class Logs:
    """`flight.tlog` with everything, `vehicle-ID.tlog` with one companion's part."""

    def __init__(self, folder: Path, stack: ExitStack) -> None:
        """Logs in `folder`, closed with `stack`."""
        self._folder = folder
        self._stack = stack
        self._all = stack.enter_context(TlogWriter(folder / "flight.tlog"))
        self.write_all = self._all.write

    def write_vehicle(self, vehicle: Vehicle) -> Callable[[int, bytes], None]:
        """What takes the frames between one companion and its autopilot."""
        path = self._folder / f"vehicle-{vehicle.id}.tlog"
        own = self._stack.enter_context(TlogWriter(path))

        def write(time_us: int, raw: bytes) -> None:
            record = tlog_record(time_us, raw)
            self._all.append(record)
            own.append(record)

        return write


def ignore_progress(_: float, __: Sequence[Member]) -> None:
    """Progress that nobody watches."""


def never() -> bool:
    """A flight that nobody stops."""
    return False


def fly_scenario(
    loaded: LoadedScenario,
    folder: Path,
    progress: Progress = ignore_progress,
    stopped: Callable[[], bool] = never,
    *,
    realtime: bool = False,
) -> Flight:
    """Fly a scenario to its end; the logs go to `folder`.

    Args:
        loaded: the scenario.
        folder: where the logs go.
        progress: told after every update.
        stopped: asked before every update; once true, what was flown until then is returned.
        realtime: fly no faster than the clock.

    Raises:
        InputError: an aircraft's model cannot be flown.
        TlogError: a log cannot be written.
    """
    scenario = loaded.scenario
    warm_up()
    with ExitStack() as stack:
        logs = Logs(folder, stack)
        members = [
            Member(loaded, vehicle, logs.write_vehicle(vehicle), logs.write_all)
            for vehicle in scenario.vehicles
        ]
        lockstep = Lockstep(members, scenario.duration_s, scenario.guidance.rate_hz)
        started = time.perf_counter()
        while (ending := Ending.STOPPED if stopped() else lockstep.ending) is None:
            lockstep.advance()
            progress(lockstep.sim_s, members)
            if realtime:
                time.sleep(max(0.0, started + lockstep.sim_s - time.perf_counter()))
        wall_s = time.perf_counter() - started
        records = tuple(member.record() for member in members)
    return Flight(records, lockstep.sim_s, wall_s, ending)


@cache
def warm_up() -> None:
    """Fly a moment for nothing: compiles or loads all compiled code, once in a process."""

    def ignore(_: int, __: bytes) -> None:
        pass

    loaded = load_scenario("first-flight")
    member = Member(loaded, loaded.scenario.vehicles[0], ignore, ignore)
    for _ in range(WARM_UP_UPDATES):
        member.fly(1)


class Lockstep:
    """The vehicles of a run and their common clock."""

    def __init__(self, members: Sequence[Member], duration: float, rate: float) -> None:
        """All at their starts; `duration` [s] is the longest flight, `rate` [Hz] the guidance's."""
        self._members = members
        self._duration = duration
        self._steps = steps_between_updates(rate)
        self._updates = 0
        self._finished_at: float | None = None

    @property
    def sim_s(self) -> float:
        """Simulated time [s]."""
        return self._updates * self._steps * STEP

    @property
    def ending(self) -> Ending | None:
        """Why the flight is over, if it is."""
        if self._finished_at is not None and self.sim_s + NEARLY >= self._finished_at + AFTERWARDS:
            return Ending.REACHED
        if any(member.grounded for member in self._members):
            return Ending.GROUND
        if self.sim_s + NEARLY >= self._duration:
            return Ending.TIME
        return None

    def advance(self) -> None:
        """Every vehicle flies on to the next update."""
        self._updates += 1
        for member in self._members:
            member.fly(self._steps)
        if self._finished_at is None and all(member.legs.finished for member in self._members):
            self._finished_at = self.sim_s
