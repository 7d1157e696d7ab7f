"""The command `vfguide run`, which flies a scenario and judges it."""

import shlex
from pathlib import Path
from typing import TYPE_CHECKING, Annotated

import typer

from vfguide.terminal.exit_status import BAD, GOOD

if TYPE_CHECKING:
    from vfguide.results.result import Result


def run(
    scenario: Annotated[str, typer.Argument(help="Path of a scenario file, or a shipped name.")],
    out: Annotated[
        Path | None, typer.Option(help="Folder of the results. [default: runs/NAME-UTC]")
    ] = None,
    seed: Annotated[int | None, typer.Option(help="Seed of everything random.")] = None,
    set_: Annotated[
        list[str] | None,
        typer.Option("--set", metavar="KEY=VALUE", help="Change a key, as in wind.speed_mps=5."),
    ] = None,
    realtime: Annotated[bool, typer.Option("--realtime", help="No faster than the clock.")] = False,
    report: Annotated[bool, typer.Option(help="Draw the figures and the report.")] = True,
    view: Annotated[bool, typer.Option("--view", help="Open the report in a browser.")] = False,
) -> None:
    """Fly a scenario to its end and judge it.

    Example: vfguide run first-flight --set wind.speed_mps=6 --out results
    """
    from vfguide.preflight.load import load_scenario
    from vfguide.runs.run import run_scenario
    from vfguide.terminal.compiling import COMPILING
    from vfguide.terminal.console import complain, warn
    from vfguide.terminal.flight_display import FlightDisplay, print_result
    from vfguide.terminal.signals import REQUESTS

    changes = [*(set_ or []), *([] if seed is None else [f"seed={seed}"])]
    COMPILING.stage("the checks of the plan")
    loaded = load_scenario(scenario, changes)
    warn(loaded.warnings)
    again = shlex.join(["vfguide", "run", scenario, *(f"--set={change}" for change in changes)])
    with FlightDisplay(loaded.scenario) as display:
        done = run_scenario(
            loaded, out, display, REQUESTS, again, COMPILING.stage, realtime=realtime, report=report
        )
    print_result(done.result, done.folder)
    if done.interrupted:
        complain(REQUESTS.ending.words)
        raise typer.Exit(REQUESTS.ending.status)
    if view and report:
        typer.launch(str(done.folder / "report.html"))
    raise typer.Exit(status_of(done.result))


def status_of(result: "Result") -> int:
    """The exit status of the verdict of a run."""
    return GOOD if result.verdict == "good" else BAD


def add_to(app: typer.Typer) -> None:
    """Add `vfguide run` to the commands of `app`."""
    app.command()(run)
