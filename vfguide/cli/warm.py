"""The command `vfguide warm`, which compiles everything ahead."""

import typer


def warm() -> None:
    """Compile everything ahead, so that no later command has to wait for it.

    It flies all shipped scenarios. Example: vfguide warm
    """
    from vfguide.kernels.compiled import cache_folder
    from vfguide.runs.warm_everything import everything
    from vfguide.terminal.compiling import COMPILING
    from vfguide.terminal.console import out

    stages = everything()
    for number, stage in enumerate(stages, start=1):
        out.print(f"{number} of {len(stages)}: {stage.name}")
        COMPILING.stage(stage.name, number, len(stages))
        stage.do()
    out.print(f"everything is compiled, and kept in {cache_folder()}")


def add_to(app: typer.Typer) -> None:
    """Add `vfguide warm` to the commands of `app`."""
    app.command()(warm)
