"""Scenario files for the tests."""

from pathlib import Path

import pytest

from vfguide.files.errors import InputError
from vfguide.scenario.load import LoadedScenario, load_scenario

MINIMAL = """\
name = "minimal"

[[vehicle]]
id = 1
position_m = [-500, 0, -100]

[[vehicle.goal]]
position_m = [0, 0, -100]
heading_deg = 0
"""


SECOND = """
[[vehicle]]
id = 2
position_m = [-500, 200, -100]

[[vehicle.goal]]
position_m = [0, 200, -100]
heading_deg = 0
"""
BOX = '\n[[obstacle]]\nname = "{name}"\nshape = "box"\nposition_m = {at}\nsize_m = {size}\n'
SQUARE = "polygon_m = [[-900, -900], [-900, 900], [900, 900], [900, -900]]"
"""Of a zone of a fence."""


def box(at: list[float], size: list[float], more: str = "") -> str:
    return BOX.format(name="shed", at=at, size=size) + more


def loaded_from(
    folder: Path, text: str = MINIMAL, overrides: tuple[str, ...] = ()
) -> LoadedScenario:
    file = folder / "x.toml"
    file.write_text(text)
    return load_scenario(file, overrides)


def message_for(folder: Path, text: str, *overrides: str) -> str:
    """The line that refuses a scenario, behind the name of its file."""
    with pytest.raises(InputError) as error:
        loaded_from(folder, text, overrides)
    message, start = str(error.value), f"{folder / 'x.toml'}: "
    assert "\n" not in message
    assert overrides or message.startswith(start)
    return message.removeprefix(start)
