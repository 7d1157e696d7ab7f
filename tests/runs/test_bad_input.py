"""What `vfguide fly` refuses, and how."""

import socket

import pytest
from programs import companion_port, free_vehicles

from vfguide.cli.program import run_command

PORT = companion_port(*free_vehicles())
GOOD = ["first-flight", "--vehicle", "1", "--connect", f"udpin:127.0.0.1:{PORT}"]


@pytest.fixture
def refuse(monkeypatch, capsys, tmp_path):
    monkeypatch.chdir(tmp_path)

    def run(*arguments):
        monkeypatch.setattr("sys.argv", ["vfguide", "fly", *arguments])
        assert run_command() == 2
        assert not (tmp_path / "runs").exists()
        return capsys.readouterr().err.strip()

    return run


def with_url(url):
    return [*GOOD[:-1], url]


@pytest.mark.parametrize(
    "url",
    [
        "14540",
        "udp:127.0.0.1:14540",
        "udpin:127.0.0.1",
        "udpin:127.0.0.1:0",
        "udpin:127.0.0.1:70000",
        "udpin::14540",
        "serial:/dev/ttyACM0",
        "",
    ],
)
def test_urls_that_are_none(refuse, url):
    message = refuse(*with_url(url))
    assert len(message.splitlines()) == 1
    assert "--connect" in message
    assert "udpin:HOST:PORT" in message


@pytest.mark.parametrize("url", ["tcp:127.0.0.1:5760", "serial:/dev/ttyACM0:57600"])
def test_urls_that_cannot_be_flown_yet(refuse, url):
    message = refuse(*with_url(url))
    assert len(message.splitlines()) == 1
    assert "not supported yet" in message


def test_a_host_that_is_not_this_machine(refuse):
    message = refuse(*with_url("udpin:192.0.2.1:14540"))
    assert len(message.splitlines()) == 1
    assert "cannot listen there" in message


def test_a_port_in_use(refuse):
    with socket.socket(socket.AF_INET, socket.SOCK_DGRAM) as taken:
        taken.bind(("127.0.0.1", PORT))
        message = refuse(*GOOD)
    assert len(message.splitlines()) == 1
    assert str(PORT) in message


def test_a_vehicle_that_does_not_exist(refuse):
    message = refuse("first-flight", "--vehicle", "7", *GOOD[3:])
    assert len(message.splitlines()) == 1
    assert "--vehicle 7" in message
    assert "allowed 1" in message


@pytest.mark.parametrize(("missing", "kept"), [("--vehicle", GOOD[3:]), ("--connect", GOOD[1:3])])
def test_options_that_must_be_given(refuse, missing, kept):
    message = refuse("first-flight", *kept)
    assert missing in message.splitlines()[-1]
    assert "Traceback" not in message


def test_a_scenario_that_does_not_exist(refuse):
    assert "shipped: avoidance/balloon, avoidance/crossing, " in refuse("nowhere", *GOOD[1:])


def test_a_log_that_is_there_already(refuse, tmp_path):
    log = tmp_path / "vehicle-1.tlog"
    log.write_bytes(b"precious")
    assert "already there" in refuse(*GOOD, "--log", str(log))
    assert "already there" in refuse(*GOOD, "--log", str(tmp_path))
    assert log.read_bytes() == b"precious"


def test_a_log_beside_another_scenario(refuse, tmp_path):
    (tmp_path / "scenario.toml").write_text('name = "another"\n')
    assert "another scenario" in refuse(*GOOD, "--log", str(tmp_path))
    assert not list(tmp_path.glob("*.tlog"))
