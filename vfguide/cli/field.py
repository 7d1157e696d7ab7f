"""The command `vfguide field`, which evaluates a field at points."""

from pathlib import Path
from typing import Annotated, Literal

import typer


def field(
    scenario: Annotated[str, typer.Argument(help="Path of a scenario file, or a shipped name.")],
    vehicle: Annotated[int, typer.Option(metavar="ID", help="Whose field.")],
    points: Annotated[
        Path, typer.Option(metavar="FILE.csv", help="Where: columns x,y,z,vx,vy,vz,t.")
    ],
    law: Annotated[
        Literal["paper", "field", "flight"] | None,
        typer.Option(help="Whose directions. [default: the law of the scenario]"),
    ] = None,
) -> None:
    """Evaluate the field at points; prints JSON.

    Example: vfguide field paper/example-2 --vehicle 1 --points points.csv
    """
    import json

    from vfguide.field_points.field_points import fields_at
    from vfguide.field_points.points_file import read_points
    from vfguide.preflight.load import load_scenario
    from vfguide.scenario.plans import vehicle_of
    from vfguide.terminal.compiling import COMPILING
    from vfguide.terminal.console import deliver

    COMPILING.stage("the checks of the plan")
    loaded = load_scenario(scenario)
    each = vehicle_of(loaded.scenario, vehicle)
    COMPILING.stage("the field")
    fields = fields_at(loaded, each, read_points(points), law or loaded.scenario.law)
    deliver(json.dumps([each._asdict() for each in fields], indent=1, allow_nan=False))


def add_to(app: typer.Typer) -> None:
    """Add `vfguide field` to the commands of `app`."""
    app.command()(field)
