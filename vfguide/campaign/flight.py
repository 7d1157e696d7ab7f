"""One flight of a campaign, as a worker flies it: drawn, flown, judged, put into a row."""

import platform
from functools import cache
from pathlib import Path
from tempfile import TemporaryDirectory
from typing import NamedTuple

from vfguide.campaign.draws import Draw
from vfguide.campaign.rows import FlightRow, failed_row, row_of
from vfguide.files.errors import InputError
from vfguide.preflight.load import load_scenario
from vfguide.results.result import Result
from vfguide.runs.lockstep import fly_scenario, judged

CPU_INFO = Path("/proc/cpuinfo")
"""Where Linux says what the processor is."""


class Job(NamedTuple):
    """A flight to be flown, wherever a worker is."""

    scenario: str
    """Path of a scenario file, or a shipped name."""
    overrides: tuple[str, ...]
    """What `--set` replaces in all flights."""
    draw: Draw


def fly(job: Job, worker: str) -> FlightRow:
    """Fly a job as a worker of some name; a flight that fails is a row with its reason."""
    try:
        return row_of(job.draw, flown(job), worker, processor())
    except InputError as error:
        return failed_row(job.draw, str(error), worker, processor())
    except Exception as error:  # noqa: BLE001 - whatever a flight of thousands raises is its result
        return failed_row(job.draw, f"{type(error).__name__}: {error}", worker, processor())


def flown(job: Job) -> Result:
    """Fly a job in a folder that is left with its end, and judge it.

    Raises:
        InputError: it cannot be flown.
    """
    loaded = load_scenario(job.scenario, job.overrides, job.draw.overrides)
    with TemporaryDirectory(prefix="vfguide-flight-") as folder:
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
