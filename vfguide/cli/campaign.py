"""`vfguide campaign`."""

import os
from pathlib import Path
from typing import Annotated

import typer

from vfguide.terminal.exit_status import BAD, GOOD

TWO_FORMS = "allowed is SCENARIO --runs N with its options, or --compare A B, with --out at most"
"""The two forms of the command, in words."""


def campaign(
    scenario: Annotated[
        str | None, typer.Argument(help="Path of a scenario file, or a shipped name.")
    ] = None,
    runs: Annotated[int | None, typer.Option(min=1, help="Number of flights.")] = None,
    seed: Annotated[
        int | None, typer.Option(help="Seed of all draws. [default: the scenario's]")
    ] = None,
    workers: Annotated[
        int | None,
        typer.Option(min=1, help="Processes on this machine. [default: one a processor]"),
    ] = None,
    scheduler: Annotated[
        str | None, typer.Option(metavar="ADDRESS", help="A Dask scheduler, as tcp://HOST:PORT.")
    ] = None,
    until: Annotated[
        str | None,
        typer.Option(
            metavar="CONDITION",
            help="End when a rate is known well enough, as rate(miss_m > 2) < 0.01 @ 0.95.",
        ),
    ] = None,
    compare: Annotated[
        tuple[Path, Path] | None,
        typer.Option(
            metavar="A B",
            help="Compare the campaigns in two folders, flight by flight; nothing is flown.",
        ),
    ] = None,
    out: Annotated[
        Path | None,
        typer.Option(
            help="Folder of the results; one of the same campaign is gone on with. "
            "[default: runs/NAME-UTC] With --compare, the folder for compare.json."
        ),
    ] = None,
    set_: Annotated[
        list[str] | None,
        typer.Option("--set", metavar="KEY=VALUE", help="Change a key, as in wind.speed_mps=5."),
    ] = None,
) -> None:
    """Fly a scenario many times, with the values of [vary] drawn at random, or compare campaigns.

    Example: vfguide campaign first-flight --set wind.turbulence=light --runs 4 --out campaign
    """
    if compare is not None:
        flying = (scenario, runs, seed, workers, scheduler, until, set_)
        compare_campaigns(compare, out, is_flying=any(each is not None for each in flying))
        return
    from vfguide.campaign.campaign import End, check_folder, fly_campaign
    from vfguide.campaign.looks import Looks
    from vfguide.campaign.plan import campaign_plan, condition_on
    from vfguide.campaign.pool import local_pool, pool_at
    from vfguide.campaign.results.report import write_report
    from vfguide.campaign.summary import summarize
    from vfguide.files.errors import InputError
    from vfguide.files.new_folder import new_folder
    from vfguide.terminal.campaign_display import CampaignDisplay, print_summary
    from vfguide.terminal.compiling import COMPILING
    from vfguide.terminal.console import complain, warn
    from vfguide.terminal.signals import REQUESTS

    if scenario is None or runs is None:
        raise InputError(f"campaign: {TWO_FORMS}")
    if workers is not None and scheduler is not None:
        raise InputError("--workers, --scheduler: allowed is one of them")
    COMPILING.stage("the checks of the plan")
    plan = campaign_plan(scenario, set_ or [], seed)
    looks = Looks(None if until is None else condition_on(until, plan))
    warn(plan.loaded.warnings)
    if out is not None:
        check_folder(out, plan)
    cluster = pool_at(scheduler) if scheduler else local_pool(workers or os.cpu_count() or 1)
    with REQUESTS, cluster as pool, CampaignDisplay(plan.name, runs) as display:
        folder = out or new_folder(plan.name)
        end = fly_campaign(plan, runs, folder, pool, looks, display, REQUESTS)
    summary = summarize(folder, plan, runs, looks)
    print_summary(summary, folder)
    write_report(folder, summary)
    if end is End.STOPPED:
        complain(REQUESTS.ending.words)
        raise typer.Exit(REQUESTS.ending.status)
    raise typer.Exit(GOOD if looks.condition is None or looks.is_met else BAD)


def compare_campaigns(folders: tuple[Path, Path], out: Path | None, *, is_flying: bool) -> None:
    """Print the comparison of the campaigns of two folders; write it if `out` is given.

    `is_flying` says whether an option is given that is about flights.
    """
    from vfguide.campaign.results.comparison import compare, write_comparison
    from vfguide.campaign.results.pairing import read_pairs
    from vfguide.files.errors import InputError
    from vfguide.terminal.comparison_display import print_comparison

    if is_flying:
        raise InputError(f"--compare {' '.join(map(str, folders))}: {TWO_FORMS}")
    comparison = compare(read_pairs(*folders))
    print_comparison(comparison)
    if out is not None:
        write_comparison(out, comparison)


def add_to(app: typer.Typer) -> None:
    """Make it a command."""
    app.command()(campaign)
