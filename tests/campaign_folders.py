"""Folders of campaigns whose rows are made by hand, without a flight."""

import json
from collections.abc import Callable, Iterator, Mapping
from dataclasses import replace
from pathlib import Path

from vfguide.campaign.campaign import IDENTITY_FILE
from vfguide.campaign.draws import Draw, draw
from vfguide.campaign.rows import FlightRow, columns_of, failed_row
from vfguide.campaign.schema import schema_of
from vfguide.campaign.table import CampaignTable
from vfguide.files.vary import Distribution, Normal, Uniform

VARY: Mapping[str, Distribution] = {
    "wind.speed_mps": Uniform(2.0, 12.0),
    "vehicles.0.airspeed_mps": Normal(22.0, 1.0),
}
IDENTITY_OF_SAMPLES = {
    "version": "1.2.3",
    "scenario": "windy.toml",
    "sha256": "ab" * 32,
    "set": ["wind.turbulence=light"],
    "seed": 7,
}
FAILS_EVERY = 10
"""Flights 3, 13, 23 and so on failed."""
STRONG = 10.0
"""Wind above which a goal is missed [m/s]."""

RowOf = Callable[[Draw], FlightRow]


def sample_row(drawn: Draw) -> FlightRow:
    """The row of a flight that misses its goal in strong wind, and sometimes fails."""
    wind = drawn.values[0][1] if drawn.values else 5.0
    if drawn.index % FAILS_EVERY == 3:
        return failed_row(drawn, "worker: <b>lost</b> & gone", "w1", "Kind A")
    good = wind <= STRONG
    return FlightRow(
        index=drawn.index,
        seed=drawn.seed,
        verdict="good" if good else "bad",
        reasons=() if good else ("goal: vehicle 1, goal 1 not reached",),
        worker="w1",
        processor="Kind A",
        reached=good,
        goals_reached=int(good),
        miss_m=0.1 * wind + (drawn.seed % 100) / 100.0 + (0.0 if good else 40.0),
        course_error_deg=wind / 7.0,
        max_bank_deg=35.0,
        sim_s=60.0 + wind,
        wall_s=0.5,
        realtime_factor=130.0,
    )


def near_obstacle(drawn: Draw) -> FlightRow:
    """The same with an obstacle beside the path."""
    row = sample_row(drawn)
    return row if row.miss_m is None else replace(row, min_clearance_m=30.0 - row.miss_m)


def command(drawn: Draw) -> str:
    return f"vfguide run windy.toml --set=seed={drawn.seed}"


def columns(number: int, row_of: RowOf, vary: Mapping[str, Distribution], seed: int) -> Iterator:
    for index in range(number):
        drawn = draw(seed, index, vary)
        yield columns_of(row_of(drawn), drawn, command(drawn))


def campaign_folder(
    folder: Path,
    number: int = 40,
    row_of: RowOf = sample_row,
    vary: Mapping[str, Distribution] = VARY,
    seed: int = 7,
    **identity: object,
) -> Path:
    """A folder of a campaign with so many flights."""
    folder.mkdir(parents=True)
    told = {**IDENTITY_OF_SAMPLES, "seed": seed, **identity}
    (folder / IDENTITY_FILE).write_text(json.dumps(told, indent=2) + "\n")
    with CampaignTable(folder, schema_of(vary)) as table:
        for each in columns(number, row_of, vary, seed):
            table.add(each)
    return folder
