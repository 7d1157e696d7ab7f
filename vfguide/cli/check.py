"""The command `vfguide check`, which validates a scenario or aircraft file."""

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
    from vfguide.files.looked_for import is_there
    from vfguide.preflight.load import check_file
    from vfguide.terminal.compiling import COMPILING
    from vfguide.terminal.console import out, warn

    COMPILING.stage("the checks of the plan")
    path = file if is_there(file) else find_scenario(str(file))
    warnings = check_file(path)
    warn(warnings)
    out.print(f"{path}: {'can be flown' if warnings else 'fine'}")


def add_to(app: typer.Typer) -> None:
    """Add `vfguide check` to the commands of `app`."""
    app.command()(check)
