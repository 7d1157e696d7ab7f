"""Scenarios resolved and not checked: their checks stand above them."""

from pathlib import Path

from scenario_texts import MINIMAL

from vfguide.files.overrides import parse_override
from vfguide.files.scenario_file import ScenarioFile
from vfguide.files.source import Source
from vfguide.scenario.loaded import LoadedScenario, resolved_from


def resolved_file(file: Path, overrides: tuple[str, ...] = ()) -> LoadedScenario:
    source = Source(file, tuple(map(parse_override, overrides)))
    return resolved_from(source.parse(ScenarioFile), source)


def resolved_text(
    folder: Path, text: str = MINIMAL, overrides: tuple[str, ...] = ()
) -> LoadedScenario:
    file = folder / "x.toml"
    file.write_text(text)
    return resolved_file(file, overrides)
