"""The report of a run: one HTML file that needs no other file, and the figures besides."""

import base64
from collections.abc import Sequence
from pathlib import Path

from jinja2 import Environment, PackageLoader, StrictUndefined

from vfguide.files.atomic import write_atomically
from vfguide.report.drawing import Flights
from vfguide.report.figures import Picture, draw_figures
from vfguide.results.closest import closest
from vfguide.results.record import FlightRecord
from vfguide.results.result import Result
from vfguide.results.verdict import in_words
from vfguide.scenario.loaded import LoadedScenario

NO_VALUE = "-"
"""Text in a table for a value that does not exist."""


def write_report(
    folder: Path,
    loaded: LoadedScenario,
    records: Sequence[FlightRecord],
    result: Result,
    command: str,
) -> None:
    """Write `figures/*.png` and `report.html`.

    Args:
        folder: folder of the run.
        loaded: the scenario that was flown.
        records: the records of the flights, from which `result` was made.
        result: the result of the run.
        command: the command line that flies the scenario again.
    """
    pictures = draw_figures(Flights(loaded, records))
    (folder / "figures").mkdir(exist_ok=True)
    for picture in pictures:
        write_atomically(folder / "figures" / f"{picture.name}.png", picture.png)
    write_atomically(folder / "report.html", render(loaded, result, pictures, command))


def render(
    loaded: LoadedScenario, result: Result, pictures: Sequence[Picture], command: str
) -> str:
    """The report as HTML."""
    return (
        page_environment()
        .get_template("report/report.html.j2")
        .render(
            scenario=loaded.scenario,
            resolved=loaded.scenario.to_toml(),
            result=result,
            pictures=pictures,
            closest=closest(result),
            kinematic=loaded.scenario.plant == "kinematic",
            command=command,
        )
    )


def page_environment() -> Environment:
    """What makes a page of a template, which is named by its path in the program."""
    environment = Environment(
        loader=PackageLoader("vfguide", "."),
        autoescape=True,
        undefined=StrictUndefined,
        trim_blocks=True,
        lstrip_blocks=True,
    )
    environment.filters["in_words"] = in_words
    environment.filters["number"] = number
    environment.filters["figure"] = figure
    environment.filters["range"] = span
    environment.filters["data_uri"] = data_uri
    return environment


def number(value: float | None, digits: int = 2) -> str:
    """A number for a table with so many decimals; a dash where there is none."""
    return NO_VALUE if value is None else f"{value:.{digits}f}"


def figure(value: float | None, digits: int = 3) -> str:
    """A number for a table with so many significant digits; a dash where there is none."""
    return NO_VALUE if value is None else f"{value:.{digits}g}"


def span(values: tuple[float | None, float | None], digits: int = 1) -> str:
    """A range for a table, its ends with so many decimals; a dash where there is none."""
    if values == (None, None):
        return NO_VALUE
    return f"{number(values[0], digits)} to {number(values[1], digits)}"


def data_uri(png: bytes) -> str:
    """A PNG as a data URI, the source of an image in HTML (RFC 2397)."""
    return f"data:image/png;base64,{base64.b64encode(png).decode()}"
