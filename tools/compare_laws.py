#!/usr/bin/env python3
"""The same random worlds flown by several laws, side by side, judged by the truth.

    python tools/compare_laws.py --runs 20
    python tools/compare_laws.py --law "only lead" --law "only lead, unassured" --kind movers
    python tools/compare_laws.py --remedies --kind dead-end
    python tools/compare_laws.py --kind field --kind popup --csv laws.csv --markdown laws.md

own plant   the paper's law as printed on the paper's rigid body: any turn, no wind, no gusts, speed
            k_v |p - p_d|, here 25 m/s at the start. Worlds without traffic and fence only.
printed     the direction of the same field, flown by the aeroplane of the laws below, over MAVLink
            on JSBSim, at 25 m/s, in the wind. Traffic is robots with priority; it knows no fence.
unassured   law flight without the run-time assurance
ours        law flight
field       law field, with all its remedies; "no remedy", or "only" one of them: with fewer

The paper leaves the reactive level of obstacles open: here the area of every obstacle reaches
--reach-m beyond its surface where it is narrowest. A flight has reached the goal if it entered
nothing and came within 5 m and 5 deg. The length of the path is that of such flights, over the
shortest one without obstacles, or over that of BIT* where --reference-s is given and nothing moves.
Cost is processor time of one step.
"""

import argparse
import csv
import math
import multiprocessing
import time
from collections.abc import Callable, Iterator, Sequence
from dataclasses import astuple, dataclass, fields
from pathlib import Path
from typing import Any, NamedTuple

import numpy as np
from flown_worlds import DRAWN, SPEED, Table, scenario_of
from measure_avoidance import TREE, Outcome, fly_table, show_failures
from rich.console import Console
from rich.table import Table as RichTable

from vfguide.field.swarm_control import fly_paper_law
from vfguide.geometry.shapes.base import EDGED
from vfguide.geometry.vector import Series
from vfguide.guidance.laws import FIELD_LAW, FLIGHT, PAPER, FieldLaw, Law
from vfguide.guidance.remedies import Remedies
from vfguide.loop.rows import step_measured
from vfguide.runs.steps import Steps

PAPERS_PLANT, PRINTED, OURS, FIELD = "own plant", "printed", "ours", "field"
UNASSURED = "unassured"
"""Name of law flight without the run-time assurance; after a comma, of another law without it."""


def remedied() -> dict[str, FieldLaw]:
    """Law field with no remedy, and with each of them alone."""
    none = Remedies(**dict.fromkeys(Remedies._fields, False))
    alone = {f"only {name}": none._replace(**{name: True}) for name in Remedies._fields}
    return {
        name: FIELD_LAW._replace(remedies=remedies)
        for name, remedies in {"no remedy": none, **alone}.items()
    }


def unassured(laws: dict[str, FieldLaw]) -> dict[str, FieldLaw]:
    """The laws without the run-time assurance, by their names with UNASSURED."""
    return {f"{name}, {UNASSURED}": law._replace(is_assured=False) for name, law in laws.items()}


FIELDS = {FIELD: FIELD_LAW, **remedied()}
"""Law field with all its remedies and with fewer."""
FLOWN: dict[str, Law] = {
    PRINTED: PAPER,
    UNASSURED: FLIGHT._replace(is_assured=False),
    OURS: FLIGHT,
    **FIELDS,
    **unassured(FIELDS),
}
"""The laws of the aeroplane."""
LAWS = (PAPERS_PLANT, *FLOWN)
USUAL = (PAPERS_PLANT, PRINTED, UNASSURED, OURS, f"{FIELD}, {UNASSURED}", FIELD)
"""The laws that are flown where none is named."""
REMEDIES = (PRINTED, OURS, *FIELDS, *unassured(FIELDS))
"""The laws that show what each remedy of law field is for."""
HIGHEST = 1e6
"""Largest reactive level that a scenario may have, dimensionless."""
SLOW = 1000.0
"""Longest time of a flight by law `paper` on its own plant [s]; chosen, since its robots are slow
near the goal."""


@dataclass(frozen=True)
class Row:
    """A line of the table: one law in the worlds of one kind."""

    kind: str
    law: str
    worlds: int
    entered: int
    """Flights that entered something, the ground included."""
    no_escape: int
    """Those among them in which the manoeuvre tree finds no escape."""
    least_clearance_m: float
    reached: int
    """Flights that came within 5 m and 5 deg, and entered nothing."""
    length_median: float
    length_90: float
    step_median_us: float
    step_99_us: float
    acting_percent: float
    """Share of setpoints that the assurance chose."""
    leading_percent: float
    """Share of the time outside the approach in which the field led, in law field."""
    least_leading_percent: float
    """The same share in the flight in which it was the least."""
    route_percent: float
    """Share of the time outside the approach in which law field flew a route."""


class Flown(NamedTuple):
    """One world flown by one law."""

    outcome: Outcome
    took: Series
    """Processor time of each of its steps [us]."""


def with_reach(table: Table, reach: float) -> Table:
    """The world with reactive areas for the paper's law that reach so far beyond surfaces [m]."""
    return {
        **table,
        "obstacle": [
            {**each, "reactive_level": level_of(each, reach)} for each in table.get("obstacle", [])
        ],
    }


def level_of(obstacle: Table, reach: float) -> float:
    """Level U on the narrowest axis at `reach` beyond the surface [m], at most HIGHEST."""
    size, exponent = 1.0, EDGED
    match obstacle["shape"]:
        case "sphere":
            size, exponent = obstacle["radius_m"], 1.0
        case "ellipsoid" | "superquadric":
            a, b, _ = obstacle["semi_axes_m"]
            size = min(a, b)
            exponent = min(obstacle.get("exponents", [1.0]))
        case "box":
            length, width, _ = obstacle["size_m"]
            size = 0.5 * min(length, width)
        case _:
            size = obstacle["radius_m"]
    return min((1.0 + reach / size) ** (2.0 * exponent), HIGHEST)


def on_papers_plant(table: Table) -> Table:
    """The world for the paper's rigid body: with its law and speed, without wind."""
    left_out = ("wind", "traffic", "traffic_receiver", "fence", "avoidance")
    (vehicle,) = table["vehicle"]
    (goal,) = vehicle["goal"]
    apart = float(np.linalg.norm(np.subtract(goal["position_m"], vehicle["position_m"])))
    return {
        **{key: value for key, value in table.items() if key not in left_out},
        "plant": "kinematic",
        "law": "paper",
        "duration_s": SLOW,
        "guidance": {"k_v": SPEED / apart},
    }


def is_for(law: str, table: Table) -> bool:
    """Whether a law can be flown in a world."""
    return law != PAPERS_PLANT or not ("traffic" in table or "fence" in table)


def stands(table: Table) -> bool:
    """Whether nothing in the world moves."""
    moving = any(any(each.get("velocity_mps", ())) for each in table.get("obstacle", []))
    return not moving and not table.get("traffic") and "fence" not in table


def fly_by(law: str, table: Table, number: int, args: argparse.Namespace) -> Flown:
    """One world by one law."""
    took: list[float] = []
    if law == PAPERS_PLANT:
        steps = Steps(paper=timed(fly_paper_law, took))
        return Flown(fly_table(on_papers_plant(table), number, args, steps), np.array(took))
    steps = Steps(measured=timed(step_by(FLOWN[law]), took))
    return Flown(fly_table(under(FLOWN[law], table), number, args, steps), np.array(took))


def under(law: Law, table: Table) -> Table:
    """The world with law field named where it is flown, so that its leaders are recorded."""
    return {**table, "law": "field"} if isinstance(law, FieldLaw) else table


def step_by(law: Law) -> Callable[..., Any]:
    """The step of the control loop with a law that replaces that of the plan."""

    def step(measured: Any, origin: Any, before: Any, legs: Any, airspace: Any, *rest: Any) -> Any:
        _, vehicle = rest
        return step_measured(measured, origin, before, legs, airspace, law, vehicle)

    return step


def timed(function: Any, took: list[float]) -> Any:
    """The function, which appends the processor time of each call to `took` [us]."""

    def noting(*arguments: Any) -> Any:
        began = time.process_time()
        value = function(*arguments)
        took.append(1e6 * (time.process_time() - began))
        return value

    return noting


def fly_all(job: tuple[str, int, argparse.Namespace]) -> dict[str, Flown]:
    """One world by all laws that can be flown in it."""
    kind, number, args = job
    table = with_reach(scenario_of(kind, args.seed, number), args.reach_m)
    flown: dict[str, Flown] = {}
    for law in args.laws:
        asked = args.reference_s if not flown and stands(table) else 0.0
        if is_for(law, table):
            each = argparse.Namespace(**{**vars(args), "reference_s": asked})
            flown[law] = fly_by(law, table, number, each)
    return flown


def prepare(args: argparse.Namespace) -> None:
    """Compile the laws, by flights that are not counted."""
    table = {**scenario_of("field", args.seed, 0), "duration_s": 2.0}
    silent = argparse.Namespace(**{**vars(args), "tree": "none", "reference_s": 0.0})
    for law in args.laws:
        fly_by(law, table, 0, silent)


def row_of(kind: str, law: str, flown: Sequence[dict[str, Flown]]) -> Row:
    """The line of one law in one kind of worlds."""
    outcomes = [each[law].outcome for each in flown if law in each]
    took = np.concatenate([each[law].took for each in flown if law in each])
    references = [shortest(each) for each in flown if law in each]
    clean = [o.meets and not o.hits for o in outcomes]
    lengths = zip(outcomes, references, clean, strict=True)
    over = [o.length_m / r for o, r, counts in lengths if counts]
    hit = [o for o in outcomes if o.hits]
    return Row(
        kind,
        law,
        len(outcomes),
        len(hit),
        sum(o.best_m <= 0.0 for o in hit),
        min(o.clearance_m for o in outcomes),
        sum(clean),
        *(np.quantile(over, (0.5, 0.9)) if over else (np.nan, np.nan)),
        *np.quantile(took, (0.5, 0.99)),
        100.0 * float(np.mean([o.acting for o in outcomes])),
        *shares(outcomes),
    )


def shares(outcomes: Sequence[Outcome]) -> tuple[float, float, float]:
    """Mean and least share in which the field led, mean share of routes [%]; NaN in other laws."""
    led = [o.field.leading_share or 0.0 for o in outcomes if o.field is not None]
    routed = [o.field.route_share or 0.0 for o in outcomes if o.field is not None]
    if not led:
        return math.nan, math.nan, math.nan
    return 100.0 * float(np.mean(led)), 100.0 * min(led), 100.0 * float(np.mean(routed))


def shortest(flown: dict[str, Flown]) -> float:
    """Length of the shortest path in one world [m]: that of BIT*, or else that of Dubins."""
    outcomes = [each.outcome for each in flown.values()]
    asked = [o.reference_m for o in outcomes if np.isfinite(o.reference_m)]
    return asked[0] if asked else outcomes[0].free_m


HEADS = (
    "worlds",
    "law",
    "flown",
    "entered",
    "no escape",
    "least [m]",
    "reached",
    "length, 90 %",
    "step, 99 % [us]",
    "acting [%]",
    "field leads, least, route [%]",
)
WIDTH = 120
"""Width of the table where there is no terminal, a number of characters; chosen."""


def cells(row: Row) -> list[str]:
    """The cells of a row, as they are printed."""
    return [
        row.kind,
        row.law,
        str(row.worlds),
        str(row.entered),
        str(row.no_escape),
        f"{row.least_clearance_m:.1f}",
        str(row.reached),
        f"{row.length_median:.2f}, {row.length_90:.2f}" if row.reached else "-",
        f"{row.step_median_us:.0f}, {row.step_99_us:.0f}",
        f"{row.acting_percent:.2f}",
        "-" if math.isnan(row.leading_percent) else led_cell(row),
    ]


def led_cell(row: Row) -> str:
    """The cell with the shares of law field."""
    led, least, route = row.leading_percent, row.least_leading_percent, row.route_percent
    return f"{led:.1f}, {least:.0f}, {route:.1f}"


def rich_table(rows: Sequence[Row]) -> RichTable:
    """The table for a terminal."""
    table = RichTable()
    for number, head in enumerate(HEADS):
        table.add_column(head, justify="left" if number < 2 else "right")
    for before, row in zip([None, *rows], rows, strict=False):
        if before is not None and before.kind != row.kind:
            table.add_section()
        table.add_row(*cells(row))
    return table


def markdown(rows: Sequence[Row]) -> str:
    """The table in Markdown, for the documentation."""
    lines = [HEADS, ["---"] * len(HEADS), *(cells(row) for row in rows)]
    return "".join(f"| {' | '.join(line)} |\n" for line in lines)


def write_csv(rows: Sequence[Row], path: Path) -> None:
    """Write the table as CSV, with all digits."""
    with path.open("w", newline="") as file:
        writer = csv.writer(file)
        writer.writerow([field.name for field in fields(Row)])
        writer.writerows(astuple(row) for row in rows)


def flown_of(kind: str, args: argparse.Namespace) -> Iterator[dict[str, Flown]]:
    """Fly all worlds of one kind; the flights of each, by the names of the laws."""
    jobs = [(kind, number, args) for number in range(args.first, args.first + args.runs)]
    if args.workers == 1:
        yield from map(fly_all, jobs)
        return
    with multiprocessing.get_context("fork").Pool(args.workers) as pool:
        yield from pool.imap(fly_all, jobs)


def parse(arguments: Sequence[str] | None = None) -> argparse.Namespace:
    """The options of the command line."""
    parser = argparse.ArgumentParser(
        description=__doc__, formatter_class=argparse.RawDescriptionHelpFormatter
    )
    parser.add_argument("--kind", dest="kinds", choices=list(DRAWN), action="append")
    parser.add_argument("--law", dest="laws", choices=LAWS, action="append")
    parser.add_argument(
        "--remedies", action="store_true", help="each remedy of law field alone, and the other laws"
    )
    parser.add_argument("--runs", type=int, default=20, help="worlds of each kind")
    parser.add_argument("--first", type=int, default=0, help="number of the first world")
    parser.add_argument("--seed", type=int, default=1)
    parser.add_argument("--reach-m", type=float, default=100.0, help="of the paper's areas")
    parser.add_argument("--reference-s", type=float, default=0.0, help="given to BIT* (ompl)")
    parser.add_argument(
        "--reference-in-wind", action="store_true", help="turns of BIT* as wide as downwind"
    )
    parser.add_argument("--tree", choices=list(TREE), default="hit")
    parser.add_argument("--workers", type=int, default=1)
    parser.add_argument("--csv", type=Path, help="file for the table")
    parser.add_argument("--markdown", type=Path, help="file for the table")
    args = parser.parse_args(arguments)
    unnamed = REMEDIES if args.remedies else USUAL
    args.kinds, args.laws = args.kinds or list(DRAWN), args.laws or list(unnamed)
    args.out, args.set = None, []
    return args


def main() -> None:
    """Fly all worlds by all laws, and print the table."""
    args = parse()
    prepare(args)
    rows: list[Row] = []
    for kind in args.kinds:
        flown = list(flown_of(kind, args))
        laws = [law for law in args.laws if any(law in each for each in flown)]
        rows += [row_of(kind, law, flown) for law in laws]
        for law in laws:
            print(f"{kind}, {law}, seed {args.seed}:", flush=True)
            show_failures([each[law].outcome for each in flown if law in each])
    console = Console()
    Console(width=None if console.is_terminal else WIDTH).print(rich_table(rows))
    if args.csv:
        write_csv(rows, args.csv)
    if args.markdown:
        args.markdown.write_text(markdown(rows))


if __name__ == "__main__":
    main()
