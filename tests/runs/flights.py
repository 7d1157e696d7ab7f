"""Runs of the program as a user starts them, for the tests of whole flights."""

import os
import subprocess
import sys
from pathlib import Path

VFGUIDE = (sys.executable, "-c", "from vfguide.cli.main import main; main()")

FIRST_FLIGHT = """
name = "short"
duration_s = 60.0
[wind]
speed_mps = 4.0
from_deg = 200.0
turbulence = "light"
[[vehicle]]
id = 7
position_m = [-300.0, 100.0, -120.0]
heading_deg = 40.0
[[vehicle.goal]]
position_m = [0.0, 0.0, -125.0]
heading_deg = 10.0
"""


def vfguide(*arguments: object, cwd: Path, **options: object) -> subprocess.CompletedProcess[str]:
    return subprocess.run(
        [*VFGUIDE, *map(str, arguments)],
        cwd=cwd,
        env={**os.environ, "COLUMNS": "300"},
        capture_output=True,
        text=True,
        check=False,
        **options,
    )


def scenario_file(folder: Path, text: str = FIRST_FLIGHT) -> Path:
    path = folder / "short.toml"
    path.write_text(text)
    return path
