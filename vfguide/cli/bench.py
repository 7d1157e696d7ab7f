"""The command `vfguide bench`, which measures the program against bare JSBSim."""

from typing import Annotated

import typer


def bench(
    json: Annotated[bool, typer.Option("--json", help="Print JSON.")] = False,
) -> None:
    """Measure the parts and a whole run against bare JSBSim, in one process.

    Example: vfguide bench --json
    """
    from dataclasses import asdict
    from json import dumps

    from rich.table import Table

    from vfguide.runs.bench import measure
    from vfguide.terminal.compiling import COMPILING
    from vfguide.terminal.console import deliver, out

    COMPILING.stage("what is measured")
    figures = asdict(measure())
    if json:
        deliver(dumps(figures, indent=2))
        return
    table = Table("figure", "value")
    for name, value in figures.items():
        table.add_row(name, f"{value:g}")
    out.print(table)


def add_to(app: typer.Typer) -> None:
    """Add `vfguide bench` to the commands of `app`."""
    app.command()(bench)
