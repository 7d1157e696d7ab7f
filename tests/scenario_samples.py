"""Scenario files for the tests, loaded and checked."""

from pathlib import Path

import pytest
from scenario_texts import MINIMAL

from vfguide.files.errors import InputError
from vfguide.preflight.load import load_scenario
from vfguide.scenario.loaded import LoadedScenario


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
