"""A run: a scenario is flown, judged and reported, all in one folder."""

from collections.abc import Sequence
from dataclasses import dataclass
from pathlib import Path

from vfguide.files.errors import InputError
from vfguide.files.new_folder import new_folder
from vfguide.link.tlog import TlogError
from vfguide.report.report import write_report
from vfguide.results.record import FlightRecord
from vfguide.results.result import Result, write_result
from vfguide.runs.lockstep import Ending, Progress, Requests, fly_scenario, judged
from vfguide.runs.models import require_models
from vfguide.runs.warm_up import Tell, tell_nobody
from vfguide.scenario.loaded import LoadedScenario


@dataclass(frozen=True)
class Run:
    """A run that is over."""

    folder: Path
    """Where everything was written."""
    result: Result
    interrupted: bool


def run_scenario(
    loaded: LoadedScenario,
    wanted: Path | None,
    progress: Progress,
    requests: Requests,
    command: str,
    tell: Tell = tell_nobody,
    *,
    realtime: bool = False,
    report: bool = True,
) -> Run:
    """Fly a scenario and write everything that contract and user expect to a folder.

    That is the `wanted` one, or a new one below `runs`.

    A flight that the user stopped is judged, but not drawn: drawing takes seconds.

    Raises:
        InputError: the folder is not empty, cannot be written or is full, or an aircraft's
            model cannot be flown.
    """
    require_models(loaded)
    folder = prepared(wanted) if wanted else new_folder(loaded.scenario.name)
    try:
        loaded.write_resolved(folder / "scenario.toml")
        flight = fly_scenario(loaded, folder, progress, requests, tell, realtime=realtime)
        result = judged(loaded, flight)
        write_result(result, folder / "result.json")
        write_identified(loaded, flight.records, folder)
        if report and flight.ending is not Ending.STOPPED:
            write_report(folder, loaded, flight.records, result, command)
    except (OSError, TlogError) as error:
        raise InputError(f"{folder}: cannot be written: {error}") from error
    return Run(folder, result, flight.ending is Ending.STOPPED)


def write_identified(loaded: LoadedScenario, records: Sequence[FlightRecord], folder: Path) -> None:
    """Write an aircraft file of what each test flight has shown, `aircraft-ID/NAME.toml`."""
    for record in records:
        if record.identified is not None:
            loaded.write_identified(record.vehicle, record.identified, folder)


def prepared(folder: Path) -> Path:
    """Make the folder of the results; an empty one will do.

    Raises:
        InputError: there is something in it, or it cannot be made.
    """
    try:
        folder.mkdir(parents=True, exist_ok=True)
        full = any(folder.iterdir())
    except OSError as error:
        reason = error.strerror or error
        raise InputError(f"--out {folder}: cannot be made: {reason}") from error
    if full:
        raise InputError(f"--out {folder}: not empty, allowed is a new or an empty folder")
    return folder
