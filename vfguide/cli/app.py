"""The commands of `vfguide`, as users type them.

The modules of the commands import the rest of the program only when a command runs, so that
`--help` answers at once.
"""

from typing import Annotated

import typer

from vfguide import __version__
from vfguide.cli import bench, campaign, check, field, fly, replay, run, sim, warm

app = typer.Typer(
    name="vfguide",
    help="Vector-field guidance of fixed-wing aircraft: goal poses to MAVLink body-rate setpoints.",
    no_args_is_help=True,
    rich_markup_mode=None,
    pretty_exceptions_enable=False,
    context_settings={"help_option_names": ["-h", "--help"]},
)
run.add_to(app)
sim.add_to(app)
fly.add_to(app)
check.add_to(app)
campaign.add_to(app)
field.add_to(app)
replay.add_to(app)
bench.add_to(app)
warm.add_to(app)


def show_version(wanted: bool) -> None:
    """Print the version if it is wanted, and end the program then."""
    if wanted:
        typer.echo(f"vfguide {__version__}")
        raise typer.Exit


@app.callback()
def options(
    version: Annotated[
        bool, typer.Option("--version", callback=show_version, is_eager=True, help="Show version.")
    ] = False,
) -> None:
    """Take the options that come before a command."""
