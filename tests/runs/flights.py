"""Runs of the program as a user starts them, for the tests of whole flights."""

import json
import signal
from pathlib import Path
from typing import Any

from programs import Program

from vfguide.link.codec import Frame, decode
from vfguide.link.messages import Message
from vfguide.link.tlog import TlogReader

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


def scenario_file(folder: Path, text: str = FIRST_FLIGHT) -> Path:
    path = folder / "short.toml"
    path.write_text(text)
    return path


def interrupted(path: Path, log: str) -> dict[str, Any]:
    """The result of a run in real time, into `out`, that Ctrl-C ends once a log has begun."""
    folder = path.parent
    flight = ("run", path, "--out", "out", "--no-report", "--realtime")
    with Program(*flight, cwd=folder) as program:
        program.writes(folder / "out" / log)
        program.send(signal.SIGINT)
        assert program.status(30.0) == 130, program.text
    assert "Traceback" not in program.text
    result = json.loads((folder / "out" / "result.json").read_text())
    assert result["reasons"][0] == "interrupted"
    return result


def messages(log: Path) -> list[tuple[int, Frame, Message | None]]:
    """What a log holds: times [us], frames and what they say."""
    return [(time_us, frame, decode(frame)) for time_us, frame in TlogReader.open(log)]
