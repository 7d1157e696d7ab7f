"""A campaign: flights given to a pool, kept as they end, in one folder that can be gone on with."""

import json
from collections import deque
from collections.abc import Callable
from dataclasses import dataclass
from enum import Enum
from pathlib import Path

from pyarrow import ArrowException

from vfguide.campaign.hold import hold
from vfguide.campaign.looks import Looks
from vfguide.campaign.plan import CampaignPlan
from vfguide.campaign.pool import Pool
from vfguide.campaign.rows import columns_of
from vfguide.campaign.schema import schema_of
from vfguide.campaign.table import CampaignTable
from vfguide.files.atomic import write_atomically
from vfguide.files.errors import InputError
from vfguide.runs.lockstep import Requests

IDENTITY_FILE = "campaign.json"
"""Name of the file that says which campaign a folder is of."""
LOOK = 0.2
"""Longest time for which a request of the user to end is not seen [s]; chosen."""


class End(Enum):
    """How a campaign ended."""

    FLOWN = "flown"
    """All flights were flown."""
    DECIDED = "decided"
    """The condition of the user was decided; the flights after that are left out."""
    STOPPED = "stopped"
    """The user ended it; it can be gone on with."""


@dataclass(frozen=True)
class Standing:
    """How far a campaign is."""

    flown: int
    """Number of flights that have ended."""
    runs: int
    """Number of flights that it shall have."""


Progress = Callable[[Standing], None]
"""Called after every flight."""


def fly_campaign(
    plan: CampaignPlan,
    runs: int,
    folder: Path,
    pool: Pool,
    looks: Looks,
    progress: Progress,
    requests: Requests,
) -> End:
    """Fly those flights of a campaign that are not in its folder.

    Args:
        plan: of the campaign.
        runs: number of flights that it shall have.
        folder: of its results, checked.
        pool: who flies.
        looks: at the flights in their order, whether they are enough.
        progress: called after every flight.
        requests: of the user to end, looked for all the time.

    Raises:
        InputError: the folder cannot be written, or another program flies a campaign there; or a
            worker cannot fly.
    """
    try:
        folder.mkdir(parents=True, exist_ok=True)
        with hold(folder):
            write_atomically(folder / IDENTITY_FILE, plan.identity)
            with CampaignTable(folder, schema_of(plan.vary)) as table:
                looks.take(table.rows())
                return _fly(plan, runs, table, pool, looks, progress, requests)
    except (OSError, ArrowException) as error:
        raise InputError(f"{folder}: cannot be read or written: {error}") from error


def _fly(
    plan: CampaignPlan,
    runs: int,
    table: CampaignTable,
    pool: Pool,
    looks: Looks,
    progress: Progress,
    requests: Requests,
) -> End:
    """Keep the pool busy until all flights have ended, or nobody wants more."""
    left = deque(index for index in range(runs) if not table.has(index))
    progress(Standing(table.number, runs))
    while not requests.wanted():
        if looks.enough is not None:
            table.cut(looks.enough)
            return End.DECIDED
        give(pool, plan, left)
        if pool.is_idle and not left:
            return End.FLOWN
        for job, row in pool.ended(LOOK):
            looks.take(table.add(columns_of(row, job.draw, plan.command(job.draw))))
            progress(Standing(table.number, runs))
    return End.STOPPED


def give(pool: Pool, plan: CampaignPlan, left: deque[int]) -> None:
    """Give the pool the next flights while it has room."""
    while left and pool.has_room:
        pool.submit(plan.job(left.popleft()))


def check_folder(folder: Path, plan: CampaignPlan) -> None:
    """See that a folder may be that of a campaign: none yet, empty, or of the same one.

    Raises:
        InputError: it is of another campaign or version, or not of one, or cannot be read.
    """
    allowed = "allowed is a new or an empty folder, or one of the same campaign"
    identity = folder / IDENTITY_FILE
    try:
        if not folder.exists() or (folder.is_dir() and not any(folder.iterdir())):
            return
        there = identity.read_text(errors="replace") if identity.is_file() else None
        is_folder = folder.is_dir()
    except OSError as error:
        raise InputError(f"--out {folder}: cannot be read: {error.strerror or error}") from error
    if there is None:
        what = "not empty and of no campaign" if is_folder else "is no folder"
        raise InputError(f"--out {folder}: {what}; {allowed}")
    if there != plan.identity:
        told = difference(there, plan.identity)
        raise InputError(f"--out {folder}: of another campaign, {told}; {allowed}")


def difference(there: str, here: str) -> str:
    """In what two identities differ, in words."""
    try:
        before, after = json.loads(there), json.loads(here)
        key = next(key for key in after if before.get(key) != after[key])
    except (ValueError, AttributeError, StopIteration):
        return f"{IDENTITY_FILE} is none of this program's"
    return f"{key} = {json.dumps(before.get(key))} there, {json.dumps(after[key])} here"
