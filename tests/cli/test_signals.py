"""A request to end is heard at every moment, while everything is compiled too."""

import os
import signal
import subprocess
import time

import pytest
from programs import VFGUIDE, free_vehicles, offboard_port

pytestmark = pytest.mark.slow

POINTS = "x,y,z,vx,vy,vz,t\n0,0,-100,25,0,0,0\n"
ENDS = {
    "run": (130, "vfguide: interrupted"),
    "check": (130, "vfguide: interrupted"),
    "field": (130, "vfguide: interrupted"),
    "fly": (0, "vfguide: ended before anything was sent"),
    "sim": (0, "vfguide: ended before the flight"),
}


def arguments_of(command, sysid):
    return {
        "run": ("run", "towers", "--out", "out"),
        "check": ("check", "towers"),
        "field": ("field", "towers", "--vehicle", "1", "--points", "points.csv"),
        "fly": (
            *("fly", "first-flight", "--vehicle", "1", "--log", "log"),
            *("--connect", f"udpin:127.0.0.1:{offboard_port(sysid)}"),
        ),
        "sim": ("sim", "one.toml"),
    }[command]


HEARING_HANGUPS = ("env", "--default-signal=HUP")
"""Tests may run below `nohup`, where SIGHUP is ignored."""
MOMENTS = {signal.SIGINT: 0.0, signal.SIGTERM: 0.9, signal.SIGHUP: 2.3}
"""Times after the beginning of the compilation when each is sent [s]: in different stages of it."""


@pytest.mark.parametrize("command", ENDS)
@pytest.mark.parametrize("number", [signal.SIGINT, signal.SIGTERM, signal.SIGHUP])
def test_while_everything_is_compiled(tmp_path, command, number):
    (sysid,) = free_vehicles()
    (tmp_path / "points.csv").write_text(POINTS)
    (tmp_path / "one.toml").write_text(
        f'name = "one"\n[[vehicle]]\nid = {sysid}\nposition_m = [-300, 0, -120]\n'
        "[[vehicle.goal]]\nposition_m = [0, 0, -120]\nheading_deg = 0\n"
    )
    with subprocess.Popen(
        [*HEARING_HANGUPS, *VFGUIDE, *arguments_of(command, sysid)],
        cwd=tmp_path,
        env={**os.environ, "XDG_CACHE_HOME": str(tmp_path / "cache")},
        stdout=subprocess.PIPE,
        stderr=subprocess.STDOUT,
        text=True,
    ) as process:
        try:
            assert "compiling" in process.stdout.readline()
            time.sleep(MOMENTS[number])
            sent = time.monotonic()
            process.send_signal(number)
            text = process.communicate(timeout=30)[0]
            assert time.monotonic() - sent < 1.0
        finally:
            process.kill()
    expected, words = ENDS[command]
    assert (process.returncode, text.splitlines()[-1]) == (expected, words)
    assert "Traceback" not in text
