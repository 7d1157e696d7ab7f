"""A scenario flown in lockstep: plants, autopilots and companions on one simulated clock."""

import time
from collections.abc import Callable, Sequence
from contextlib import ExitStack
from dataclasses import dataclass
from functools import cache
from pathlib import Path

from vfguide.link.tlog import TlogWriter
from vfguide.scenario.crew import start_us
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

Progress = Callable[[float, Sequence[Member]], None]
"""Told the simulated time [s] and the vehicles, at every update."""


@dataclass(frozen=True)
class Flight:
    """A scenario that was flown."""

    records: tuple[FlightRecord, ...]
    sim_s: float
    wall_s: float
    """Of the loop alone."""
    ended_early: tuple[str, ...]
    """Why it ended before 5 s after the last goal; empty if it did not."""
    interrupted: bool


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
            self._all.write(time_us, raw)
            own.write(time_us, raw)

        return write


@cache
def warm_up() -> None:
    """Fly a moment for nothing: compiles or loads all compiled code, once in a process."""

    def ignore(_: int, __: bytes) -> None:
        pass

    loaded = load_scenario("first-flight")
    member = Member(loaded, loaded.scenario.vehicles[0], ignore, ignore)
    for _ in range(WARM_UP_UPDATES):
        member.fly(1)


def fly_scenario(
    loaded: LoadedScenario, folder: Path, progress: Progress, realtime: bool = False
) -> Flight:
    """Fly a scenario to its end; the logs go to `folder`.

    Ctrl-C ends the flight; what was flown until then is noted and returned.

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
        steps = steps_between_updates(scenario.guidance.rate_hz)
        started = time.perf_counter()
        interrupted = False
        early: tuple[str, ...] = ()
        sim_s, done_s = 0.0, None
        try:
            while done_s is None or sim_s < done_s + AFTERWARDS:
                if sim_s + 1e-9 >= scenario.duration_s:
                    early = ("time",)
                    break
                sim_s = (round(sim_s / STEP) + steps) * STEP
                for member in members:
                    member.fly(steps)
                if any(member.grounded for member in members):
                    break
                if done_s is None and all(member.legs.finished for member in members):
                    done_s = sim_s
                progress(sim_s, members)
                if realtime:
                    time.sleep(max(0.0, started + sim_s - time.perf_counter()))
        except KeyboardInterrupt:
            interrupted = True
        wall_s = time.perf_counter() - started
        records = tuple(member.record() for member in members)
    return Flight(records, sim_s, wall_s, early, interrupted)
