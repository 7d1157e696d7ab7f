"""The progress bar of a flight, and its result on the terminal."""

from collections.abc import Sequence
from pathlib import Path
from typing import Self

from rich.progress import BarColumn, Progress, TextColumn, TimeElapsedColumn
from rich.table import Table

from vfguide.results.closest import closest
from vfguide.results.result import Result
from vfguide.results.verdict import in_words
from vfguide.runs.fleet import Flown
from vfguide.scenario.resolved import Scenario
from vfguide.terminal.console import err, out, shown

REFRESH = 1.0
"""Simulated time between two updates of the progress bar [s]; chosen."""


class FlightDisplay:
    """Shows simulated time, goals reached and time taken; nothing where there is no terminal."""

    def __init__(self, scenario: Scenario) -> None:
        self._progress = Progress(
            TextColumn("{task.description}", markup=False),
            BarColumn(),
            TextColumn("{task.completed:.0f} of at most {task.total:.0f} s  {task.fields[state]}"),
            TimeElapsedColumn(),
            console=err,
            transient=True,
            disable=not err.is_terminal,
        )
        self._task = self._progress.add_task(
            shown(scenario.name), total=scenario.duration_s, state="preparing"
        )
        self._next = 0.0

    def __call__(self, sim_s: float, members: Sequence[Flown]) -> None:
        """Show the vehicles at the simulated time `sim_s` [s], no more often than every REFRESH."""
        if sim_s < self._next:
            return
        self._next = sim_s + REFRESH
        reached = sum(member.legs.reached for member in members)
        goals = sum(len(member.vehicle.goals) for member in members)
        state = f"{reached} of {goals} goals"
        self._progress.update(self._task, completed=sim_s, state=state)

    def __enter__(self) -> Self:
        self._progress.start()
        return self

    def __exit__(self, *_: object) -> None:
        self._progress.stop()


def print_result(result: Result, folder: Path) -> None:
    """Print the figures of every goal, least distances, the verdict and the path of the results."""
    table = Table(
        "vehicle", "goal", "reached", "time s", "miss m", "told m", "course deg", "climb deg"
    )
    for vehicle in result.vehicles:
        for number, goal in enumerate(vehicle.goals, start=1):
            figures = (goal.miss_m, goal.told_miss_m, goal.course_error_deg, goal.climb_error_deg)
            table.add_row(
                str(vehicle.id),
                str(number),
                "yes" if goal.reached else "no",
                "-" if goal.time_s is None else f"{goal.time_s:.1f}",
                *("-" if figure is None else f"{figure:.2f}" for figure in figures),
            )
    out.print(table)
    factor = f", {result.realtime_factor:.0f} x real time" if result.realtime_factor else ""
    out.print(f"{result.sim_s:.1f} s flown in {result.wall_s:.2f} s{factor}")
    if distances := least_distances(result):
        out.print(f"least {', '.join(distances)}")
    for line in (*traffic_lines(result), *assurance_lines(result)):
        out.print(line)
    for reason in result.reasons:
        out.print(f"  {in_words(reason)}", style="red")
    good = result.verdict == "good"
    out.print(f"verdict: {result.verdict}", style="bold green" if good else "bold red")
    report = folder / "report.html"
    out.print(f"results: {report if report.exists() else folder}")


def least_distances(result: Result) -> list[str]:
    """Least distances from obstacles, from outside the fence and between vehicles, in words."""
    distances: list[str] = []
    if nearest := closest(result):
        where = f"vehicle {nearest.vehicle}, {nearest.obstacle}"
        distances.append(f"clearance {nearest.clearance:.2f} m ({where})")
    fences = [(each.fence_clearance_m, each.id) for each in result.vehicles]
    if known := [(least, sysid) for least, sysid in fences if least is not None]:
        least, sysid = min(known)
        distances.append(f"distance inside the fence {least:.2f} m (vehicle {sysid})")
    if result.min_separation_m is not None:
        distances.append(f"separation {result.min_separation_m:.2f} m")
    return distances


def traffic_lines(result: Result) -> list[str]:
    """A line for each of the other aircraft: the vehicle it came nearest to, how near, and when."""
    lines: list[str] = []
    for passes in zip(*(vehicle.traffic for vehicle in result.vehicles), strict=True):
        distances = [each.closest_m for each in passes]
        nearest = distances.index(min(distances))
        each, vehicle = passes[nearest], result.vehicles[nearest].id
        lines.append(
            f"traffic: {shown(each.name)} came within {each.closest_m:.0f} m of vehicle {vehicle} "
            f"after {each.closest_s:.1f} s, {each.min_clearance_m:.0f} m from its volume"
        )
    return lines


def assurance_lines(result: Result) -> list[str]:
    """A line for each vehicle whose assurance acted: how often, in which share of its setpoints."""
    lines: list[str] = []
    for vehicle in result.vehicles:
        each = vehicle.assurance
        if each is None or not each.episodes:
            continue
        times = len(each.episodes)
        share = f"{100.0 * (each.acting_share or 0.0):.1f} % of its setpoints"
        line = f"assurance: vehicle {vehicle.id} acted {times} time{'s'[: times > 1]}, in {share}"
        if each.least_bad:
            line += f"; NOTHING WAS CLEAR in {each.least_bad} setpoints"
        lines.append(line)
    return lines
