"""`vfguide check`."""

from pathlib import Path
from typing import Annotated

import typer


def check(
    file: Annotated[Path, typer.Argument(help="A scenario or aircraft file, or a shipped name.")],
) -> None:
    """Validate a scenario or aircraft file.

    Example: vfguide check first-flight
    """
    from vfguide.files.data import find_scenario
    from vfguide.preflight.load import check_file
    from vfguide.terminal.compiling import COMPILING
    from vfguide.terminal.console import out, warn

    COMPILING.stage("the checks of the plan")
    path = file if file.exists() else find_scenario(str(file))
    warnings = check_file(path)
    warn(warnings)
    out.print(f"{path}: {'can be flown' if warnings else 'fine'}")


def add_to(app: typer.Typer) -> None:
    """Make it a command."""
    app.command()(check)
