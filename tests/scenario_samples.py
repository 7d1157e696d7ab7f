"""Scenario files for the tests."""

from pathlib import Path

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


def loaded_from(
    folder: Path, text: str = MINIMAL, overrides: tuple[str, ...] = ()
) -> LoadedScenario:
    file = folder / "x.toml"
    file.write_text(text)
    return load_scenario(file, overrides)
