"""A request to end is heard at every moment, while everything is compiled too."""

import os
import re
import signal
import subprocess
import sys
import time

import pytest
from programs import VFGUIDE, free_vehicles, offboard_port

from vfguide.terminal.signals import INTERRUPTION, STOP_SIGNALS, EndRequests

pytestmark = pytest.mark.slow

POINTS = "x,y,z,vx,vy,vz,t\n0,0,-100,25,0,0,0\n"
ENDS = {
    "run": (130, "vfguide: interrupted"),
    "check": (130, "vfguide: interrupted"),
    "field": (130, "vfguide: interrupted"),
    "replay": (130, "vfguide: interrupted"),
    "warm": (130, "vfguide: interrupted"),
    "fly": (0, "vfguide: ended before anything was sent"),
    "sim": (0, "vfguide: ended before the flight"),
}


def arguments_of(command, sysid):
    return {
        "run": ("run", "towers", "--out", "out"),
        "check": ("check", "towers"),
        "replay": ("replay", "flown/vehicle-1.tlog"),
        "warm": ("warm",),
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


@pytest.fixture(scope="module")
def flown(tmp_path_factory):
    """A folder of results."""
    folder = tmp_path_factory.mktemp("flight") / "flown"
    subprocess.run([*VFGUIDE, "run", "first-flight", "--no-report", "--out", folder], check=True)
    return folder


@pytest.mark.parametrize("command", ENDS)
@pytest.mark.parametrize("number", [signal.SIGINT, signal.SIGTERM, signal.SIGHUP])
def test_while_everything_is_compiled(tmp_path, flown, command, number):
    (sysid,) = free_vehicles()
    (tmp_path / "points.csv").write_text(POINTS)
    (tmp_path / "flown").symlink_to(flown)
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
            while "compiling" not in (line := process.stdout.readline()):
                assert line, "it ended before"
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


LAST_LINES = {"check": ".*: fine", "replay": "identical", "field": "]"}
"""The last line of what each prints."""


def short_arguments(command):
    return arguments_of(command, 1) if command != "check" else ("check", "first-flight")


@pytest.fixture(scope="module")
def at_work(flown):
    """A folder in which each has run once, so that it has nothing to compile and tell."""
    (flown.parent / "points.csv").write_text(POINTS)
    for command in LAST_LINES:
        once = [*VFGUIDE, *short_arguments(command)]
        subprocess.run(once, cwd=flown.parent, check=True, capture_output=True)
    return flown.parent


@pytest.mark.parametrize("number", STOP_SIGNALS)
@pytest.mark.parametrize("command", LAST_LINES)
def test_after_the_last_line_nothing_is_ended(at_work, command, number):
    """The work is done and shown: its exit status is not that of a signal that came after it."""
    with subprocess.Popen(
        [*HEARING_HANGUPS, *VFGUIDE, *short_arguments(command)],
        cwd=at_work,
        stdout=subprocess.PIPE,
        stderr=subprocess.PIPE,
        text=True,
    ) as process:
        while not re.fullmatch(
            LAST_LINES[command], (line := process.stdout.readline()).strip("\n")
        ):
            assert line, process.stderr.read()
        process.send_signal(number)
        rest, complaints = process.communicate(timeout=30)
    assert (process.returncode, rest, complaints) in (
        (0, "", ""),
        (130, "", "vfguide: interrupted\n"),
    )


@pytest.mark.parametrize("number", STOP_SIGNALS)
def test_before_it_can_be_heard(number):
    """What comes while Python imports the program is held back, and heard then."""
    numbers = [int(each) for each in STOP_SIGNALS]
    begin = (
        f"import os, signal; signal.pthread_sigmask(signal.SIG_BLOCK, {numbers}); "
        f"os.kill(os.getpid(), {int(number)}); from vfguide.cli.main import main; main()"
    )
    command = [*HEARING_HANGUPS, sys.executable, "-c", begin, "check", "first-flight"]
    done = subprocess.run(command, capture_output=True, text=True, check=False, timeout=60)
    assert (done.returncode, done.stdout, done.stderr) == (130, "", "vfguide: interrupted\n")


def test_while_the_report_is_drawn(tmp_path):
    with subprocess.Popen(
        [*VFGUIDE, "run", "first-flight", "--out", "out"],
        cwd=tmp_path,
        stdout=subprocess.DEVNULL,
        stderr=subprocess.PIPE,
        text=True,
    ) as process:
        while not (tmp_path / "out" / "result.json").exists():
            assert process.poll() is None
            time.sleep(0.01)
        sent = time.monotonic()
        process.send_signal(signal.SIGINT)
        complaint = process.communicate(timeout=30)[1]
        assert time.monotonic() - sent < 1.0
    assert (process.returncode, complaint) == (130, "vfguide: interrupted\n")
    assert not (tmp_path / "out" / "report.html").exists()


@pytest.fixture
def requests():
    """Requests that are heard, and how the process would have been ended by them."""
    asked, ended = EndRequests(), []
    with asked.heard(INTERRUPTION, ended.append):
        yield asked, ended


def ask():
    os.kill(os.getpid(), signal.SIGINT)
    time.sleep(0.2)


def test_nothing_is_raised_in_the_middle_of_a_library(requests):
    _, ended = requests
    ask()
    assert ended == [INTERRUPTION]


def test_a_loop_that_sees_a_request_ends_by_itself(requests):
    asked, ended = requests
    with asked:
        assert not asked.wanted()
        ask()
        assert asked.wanted()
    assert ended == []


def test_a_request_that_a_loop_has_not_seen_is_not_lost(requests):
    asked, ended = requests
    with asked:
        assert not asked.wanted()
        ask()
        assert ended == []
    assert ended == [INTERRUPTION]


def test_who_is_asked_again_while_it_ends_has_little_time(requests):
    asked, ended = requests
    with asked:
        ask()
        assert asked.wanted()
    os.kill(os.getpid(), signal.SIGINT)
    time.sleep(0.1)
    assert ended == []
    time.sleep(0.5)
    assert ended == [INTERRUPTION]


def test_what_is_asked_when_the_work_is_done_changes_nothing(requests):
    asked, ended = requests
    asked.close()
    ask()
    assert ended == []
