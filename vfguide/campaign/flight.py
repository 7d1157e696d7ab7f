"""One flight of a campaign, as a worker flies it: drawn, flown, judged, put into a row."""

import platform
from functools import cache
from pathlib import Path
from tempfile import TemporaryDirectory
from typing import NamedTuple

from vfguide.campaign.draws import Draw
from vfguide.campaign.inputs import Inputs, inputs_of
from vfguide.campaign.rows import FlightRow, failed_row, row_of
from vfguide.files.errors import InputError
from vfguide.link.tlog import TlogError
from vfguide.preflight.load import load_scenario
from vfguide.results.result import Result
from vfguide.runs.lockstep import fly_scenario, judged

CPU_INFO = Path("/proc/cpuinfo")
"""Where Linux says what the processor is."""


class WorkerError(InputError):
    """A worker cannot fly, whatever the flight; the campaign ends, and can be gone on with."""


class Job(NamedTuple):
    """A flight to be flown, wherever a worker is."""

    scenario: str
    """Path of a scenario file, or a shipped name."""
    overrides: tuple[str, ...]
    """What `--set` replaces in all flights."""
    draw: Draw
    aircraft: tuple[str, ...]
    """Names of its aircraft."""
    inputs: Inputs
    """What it has to be flown from."""


def fly(job: Job, worker: str, within: str | None = None) -> FlightRow:
    """Fly a job as a worker of some name; a flight that fails is a row with its reason.

    Args:
        job: the flight.
        worker: name of the worker.
        within: folder for its logs meanwhile; None: that of the system.

    Raises:
        WorkerError: the reason is not the flight, but where it is flown.
    """
    try:
        check_inputs(job)
        return row_of(job.draw, flown(job, within), worker, processor())
    except (OSError, MemoryError, TlogError, WorkerError) as error:
        told = str(error) or type(error).__name__
        raise WorkerError(f"worker {worker} at flight {job.draw.index}: {told}") from error
    except InputError as error:
        return failed_row(job.draw, str(error), worker, processor())
    except Exception as error:  # noqa: BLE001 - whatever a flight of thousands raises is its result
        return failed_row(job.draw, f"{type(error).__name__}: {error}", worker, processor())


def check_inputs(job: Job) -> None:
    """See that a job is flown from that with which its campaign began.

    Raises:
        WorkerError: it is not.
        OSError: a file cannot be read.
    """
    try:
        there = inputs_of(job.scenario, job.aircraft)
    except InputError as error:
        raise WorkerError(str(error)) from error
    for name, found, wanted in zip(Inputs._fields, there, job.inputs, strict=True):
        if found != wanted:
            raise WorkerError(f"{job.scenario}: not the {name} with which the campaign began")


def flown(job: Job, within: str | None) -> Result:
    """Fly a job in a folder that is left with its end, and judge it.

    Raises:
        InputError: it cannot be flown.
    """
    loaded = load_scenario(job.scenario, job.overrides, job.draw.overrides)
    with TemporaryDirectory(prefix="vfguide-flight-", dir=within) as folder:
        return judged(loaded, fly_scenario(loaded, Path(folder)))


@cache
def processor() -> str:
    """Kind of the processor of this computer."""
    try:
        lines = CPU_INFO.read_text().splitlines()
    except OSError:
        lines = []
    names = (line.partition(":") for line in lines if line.startswith("model name"))
    return next((name.strip() for _, _, name in names), platform.machine())
