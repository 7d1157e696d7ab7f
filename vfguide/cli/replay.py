"""The command `vfguide replay`, which repeats a recorded flight and compares its setpoints."""

from pathlib import Path
from typing import TYPE_CHECKING, Annotated

import typer

from vfguide.terminal.exit_status import BAD, GOOD

if TYPE_CHECKING:
    from collections.abc import Sequence

    from vfguide.link.tlog import TlogReader
    from vfguide.replay.compare import Comparison


def replay(
    log: Annotated[Path, typer.Argument(help="Log of a companion, vehicle-ID.tlog.")],
    scenario: Annotated[
        str | None, typer.Option(help="What was flown. [default: scenario.toml beside the log]")
    ] = None,
    vehicle: Annotated[
        int | None, typer.Option(help="Which vehicle. [default: the only one in the log]")
    ] = None,
    set_: Annotated[
        list[str] | None,
        typer.Option("--set", metavar="KEY=VALUE", help="Change a key, as in guidance.k_w=3."),
    ] = None,
    out: Annotated[
        Path | None, typer.Option(help="Folder for what the companion receives and sends now.")
    ] = None,
) -> None:
    """Feed recorded inputs through the same companion, compare its setpoints.

    Exit status 0: identical to the bit. 1: different, the first difference is named.

    Example: vfguide replay results/vehicle-1.tlog
    """
    from contextlib import ExitStack

    from vfguide.link.tlog import UsableTimes
    from vfguide.link.tlog_writer import TlogWriter
    from vfguide.preflight.load import load_scenario
    from vfguide.replay.compare import Replay
    from vfguide.runs.run import prepared
    from vfguide.scenario.plans import plan_of, vehicle_of
    from vfguide.terminal.compiling import COMPILING
    from vfguide.terminal.console import out as console
    from vfguide.terminal.console import warn

    reader = open_log(log)
    COMPILING.stage("the checks of the plan")
    loaded = load_scenario(scenario or str(log.parent / "scenario.toml"), set_ or [])
    loaded.require_mavlink()
    sysid = vehicle if vehicle is not None else only_vehicle(log, reader)
    plan = plan_of(loaded, vehicle_of(loaded.scenario, sysid))
    times = UsableTimes(reader)
    with ExitStack() as stack:
        record = ignore
        if out is not None:
            prepared(out)
            record = stack.enter_context(TlogWriter(out / f"vehicle-{sysid}.tlog")).write_all
        COMPILING.stage("the control loop")
        found = Replay(sysid, plan, record).compare(times)
    warn(flaws_of(log, reader))
    if times.wrong:
        frames = f"{times.wrong} frame{'s'[: times.wrong > 1]}"
        warn([f"{log}: {frames} with a time that cannot be, taken as that of the one before"])
    require_setpoints(log, sysid, found)
    console.print(f"vehicle {sysid}: {found.recorded} setpoints recorded, {found.replayed} now")
    if found.difference is None:
        console.print("identical")
        raise typer.Exit(GOOD)
    first = found.difference
    console.print(f"different, first at setpoint {first.number} ({first.time} us): {first.what}")
    raise typer.Exit(BAD)


def ignore(_: int, __: "Sequence[bytes]") -> None:
    """Record nothing of the frames that a companion receives and sends."""


def open_log(path: Path) -> "TlogReader":
    """An open reader of the log at `path`.

    Raises:
        InputError: it is no .tlog, or cannot be read.
    """
    from vfguide.files.errors import InputError
    from vfguide.link.tlog import TlogError, TlogReader

    if path.suffix != ".tlog":
        raise InputError(f"{path}: not a .tlog; other kinds of logs are not supported yet")
    try:
        return TlogReader.open(path)
    except TlogError as error:
        raise InputError(str(error)) from error


def only_vehicle(path: Path, reader: "TlogReader") -> int:
    """The system id of the one vehicle whose companion speaks in the log.

    Raises:
        InputError: none speaks in it, or several do.
    """
    from vfguide.files.errors import InputError
    from vfguide.replay.compare import companions_in

    companions = companions_in(reader)
    if not reader.frames:
        raise InputError(f"{path}: no MAVLink frame in its {reader.junk_bytes} bytes")
    if not companions:
        flaws = "".join(f"; {each}" for each in flaws_of(path, reader))
        reason = "no companion speaks in it, so there is nothing to compare"
        raise InputError(f"{path}: {reason}{flaws}")
    if len(companions) > 1:
        known = ", ".join(map(str, companions))
        raise InputError(f"{path}: several companions speak in it, choose --vehicle from {known}")
    return companions[0]


def flaws_of(path: Path, reader: "TlogReader") -> list[str]:
    """What is wrong with a log that was read, one message each."""
    flaws: list[str] = []
    if damage := reader.damage:
        places = "a place" if len(damage) == 1 else f"{len(damage)} places"
        where = f"{reader.junk_bytes} bytes in {places}, the first at byte {damage[0].at}"
        flaws.append(f"{path}: damaged, no record in {where}")
    if reader.steps_back:
        flaws.append(f"{path}: its times go back, {reader.steps_back} times")
    return flaws


def require_setpoints(path: Path, sysid: int, found: "Comparison") -> None:
    """Make sure that the log has setpoints to compare.

    Raises:
        InputError: the log has no setpoint of this vehicle.
    """
    from vfguide.files.errors import InputError

    if not found.recorded:
        raise InputError(f"{path}: no setpoint of vehicle {sysid} in it")


def add_to(app: typer.Typer) -> None:
    """Add `vfguide replay` to the commands of `app`."""
    app.command()(replay)
