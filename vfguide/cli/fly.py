"""The command `vfguide fly`, which guides one vehicle over a link."""

from contextlib import ExitStack, closing
from datetime import UTC, datetime
from functools import partial
from pathlib import Path
from typing import TYPE_CHECKING, Annotated

import typer

from vfguide.terminal.exit_status import BAD, GOOD

if TYPE_CHECKING:
    from vfguide.aircraft.identification import Identified
    from vfguide.daemon.transport import Transport
    from vfguide.link.tlog_writer import TlogWriter
    from vfguide.scenario.loaded import LoadedScenario


def fly(
    scenario: Annotated[str, typer.Argument(help="Path of a scenario file, or a shipped name.")],
    vehicle: Annotated[int, typer.Option(help="Which vehicle of it: its MAVLink system id.")],
    connect: Annotated[
        str, typer.Option(help="Where its autopilot is: udpin:HOST:PORT or udpout:HOST:PORT.")
    ],
    engage: Annotated[
        bool, typer.Option("--engage", help="Ask for OFFBOARD; else the operator has to choose it.")
    ] = False,
    log: Annotated[
        Path | None,
        typer.Option(help="Folder of the log, or a .tlog file. [default: runs/fly-NAME-ID-UTC]"),
    ] = None,
) -> None:
    """Guide one vehicle, until Ctrl-C: it hands over to the autopilot's hold first.

    Example: vfguide fly first-flight --vehicle 1 --connect udpin:127.0.0.1:14540 --engage
    """
    from vfguide.companion.companion import Companion
    from vfguide.companion.session import Session
    from vfguide.daemon.clock import Clock
    from vfguide.daemon.daemon import Daemon, HandoverResult
    from vfguide.daemon.flight_log import FlightLog
    from vfguide.daemon.warm_up import warm_up
    from vfguide.preflight.load import load_scenario
    from vfguide.scenario.plans import plan_of, vehicle_of
    from vfguide.terminal.compiling import COMPILING
    from vfguide.terminal.console import complain, warn
    from vfguide.terminal.signals import REQUESTS, CommandEnd

    COMPILING.stage("the checks of the plan")
    loaded = load_scenario(scenario)
    loaded.require_mavlink()
    loaded.require_assured_law()
    warn(loaded.warnings)
    plan = plan_of(loaded, vehicle_of(loaded.scenario, vehicle))
    with ExitStack() as stack:
        transport = stack.enter_context(closing(open_transport(connect, vehicle)))
        path = log_path(log, loaded.scenario.name, vehicle)
        flight_log = stack.enter_context(closing(FlightLog(open_log(path, path != log, loaded))))
        COMPILING.stage("the control loop")
        warm_up(plan)
        session = Session(Companion(vehicle, plan, engage=engage), flight_log.write)
        say(f"waiting for the autopilot of vehicle {vehicle} at {connect}; log: {path}")
        say("Ctrl-C hands over and ends")
        save = partial(save_identified, loaded, vehicle, folder=path.parent)
        daemon = Daemon(session, transport, flight_log, Clock(), say, save)
        stack.enter_context(REQUESTS)
        outcome = daemon.run(REQUESTS.seen)
        status = GOOD if outcome is HandoverResult.HANDED_OVER else BAD
        REQUESTS.ending = CommandEnd(status, "ended")
    if outcome is HandoverResult.UNCONFIRMED:
        complain("the autopilot did not confirm its hold: look what it flies")
    if outcome is HandoverResult.CUT_SHORT:
        complain("ended at once: the autopilot has not confirmed its hold")
    raise typer.Exit(status)


def say(line: str) -> None:
    """Print one line for the operator, with the time of day, UTC."""
    from vfguide.terminal.console import out

    out.print(f"{datetime.now(UTC):%H:%M:%S} {line}")


def open_transport(text: str, sysid: int) -> "Transport":
    """The link to the vehicle `sysid` that a URL names.

    Raises:
        InputError: the URL names none, or one that cannot be opened.
    """
    from vfguide.daemon.connect import connect
    from vfguide.daemon.transport import ConnectError
    from vfguide.files.errors import InputError
    from vfguide.link.url import UrlError, parse_url

    try:
        return connect(parse_url(text), sysid)
    except (UrlError, ConnectError) as error:
        raise InputError(f"--connect {error}") from error


def log_path(asked: Path | None, name: str, sysid: int) -> Path:
    """The path of the log: the .tlog that is asked for, else vehicle-ID.tlog in a folder.

    The folder is the one that is asked for, else a new one in `runs`.

    Raises:
        InputError: a new folder cannot be made.
    """
    from vfguide.files.new_folder import new_folder

    if asked is not None and asked.suffix == ".tlog":
        return asked
    folder = asked or new_folder(f"fly-{name}-{sysid}")
    return folder / f"vehicle-{sysid}.tlog"


def open_log(path: Path, in_folder: bool, loaded: "LoadedScenario") -> "TlogWriter":
    """A new log; `in_folder`, with the scenario beside it, where a replay looks for it.

    Raises:
        InputError: log or scenario cannot be written, the log is there already, or the scenario
            there is another one.
    """
    from vfguide.cli.logs import new_log
    from vfguide.files.errors import InputError
    from vfguide.files.looked_for import is_there

    folder, scenario = path.parent, path.with_name("scenario.toml")
    if not in_folder:
        return new_log(path)
    if is_there(scenario) and scenario.read_bytes() != loaded.scenario.to_toml().encode():
        raise InputError(f"--log {folder}: a log of another scenario, allowed is a new folder")
    log = new_log(path)
    try:
        loaded.write_resolved(scenario)
    except OSError as error:
        raise InputError(f"--log {folder}: cannot be written: {error.strerror}") from error
    return log


def save_identified(
    loaded: "LoadedScenario", sysid: int, found: "Identified", *, folder: Path
) -> None:
    """Write the aircraft as the test flight has shown it into `folder`, and tell the operator."""
    from vfguide.scenario.plans import vehicle_of

    try:
        loaded.write_identified(vehicle_of(loaded.scenario, sysid), found, folder)
        say(f"what the test flight has shown: {folder / f'aircraft-{sysid}'}")
    except OSError as error:
        say(f"{folder}: what the test flight has shown cannot be written: {error.strerror}")


def add_to(app: typer.Typer) -> None:
    """Add `vfguide fly` to the commands of `app`."""
    app.command()(fly)
