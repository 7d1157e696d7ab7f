"""`vfguide campaign` as users type it."""

import json
import os
import signal
import subprocess
import time

import pyarrow.parquet as pq
import pytest
from programs import COMPILING, VFGUIDE
from typer.testing import CliRunner

from vfguide.cli.app import app
from vfguide.files.errors import InputError

pytestmark = pytest.mark.slow

WINDY = """
name = "windy"
duration_s = 60
[[vehicle]]
id = 1
position_m = [0.0, 0.0, -150.0]
[[vehicle.goal]]
position_m = [200.0, 20.0, -150.0]
heading_deg = 20.0
[vary]
"wind.speed_mps" = [0.0, 8.0]
"""


@pytest.fixture
def file(tmp_path):
    path = tmp_path / "windy.toml"
    path.write_text(WINDY)
    return path


def run(*arguments, cwd):
    return subprocess.run(
        [*VFGUIDE, *arguments],
        cwd=cwd,
        capture_output=True,
        text=True,
        timeout=COMPILING,
        check=False,
    )


def test_interrupted_gone_on_with_and_flown_alone(file):
    """Ctrl-C goes to all processes of the terminal, the workers among them."""
    folder = file.parent
    command = ("campaign", "windy.toml", "--runs", "12", "--workers", "1", "--out", "out")
    process = subprocess.Popen(
        [*VFGUIDE, *command],
        cwd=folder,
        stderr=subprocess.PIPE,
        stdout=subprocess.DEVNULL,
        text=True,
        start_new_session=True,
    )
    journal = folder / "out" / "journal.jsonl"
    until = time.monotonic() + COMPILING
    while not (journal.exists() and journal.read_text()) and time.monotonic() < until:
        assert process.poll() is None
        time.sleep(0.05)
    os.killpg(process.pid, signal.SIGINT)
    _, told = process.communicate(timeout=30)
    assert process.returncode == 130
    assert told.endswith("vfguide: interrupted\n")
    assert "Traceback" not in told
    assert 1 <= pq.read_table(folder / "out" / "results.parquet").num_rows < 12

    again = run(*command, cwd=folder)
    assert (again.returncode, again.stderr) == (0, "")
    rows = pq.read_table(folder / "out" / "results.parquet").to_pylist()
    assert [row["index"] for row in rows] == list(range(12))
    assert json.loads((folder / "out" / "summary.json").read_text())["flown"] == 12

    row = rows[7]
    program, *arguments = row["command"].split()
    assert program == "vfguide"
    alone = run(*arguments, "--no-report", "--out", "alone", cwd=folder)
    assert alone.returncode == 0
    result = json.loads((folder / "alone" / "result.json").read_text())
    assert result["sim_s"] == row["sim_s"]
    assert json.loads(json.dumps(row["vehicles"])) == result["vehicles"]


@pytest.mark.parametrize(
    ("arguments", "why"),
    [
        (("--workers", "1", "--scheduler", "tcp://127.0.0.1:9"), "allowed is one of them"),
        (("--until", "rate(mis_m > 2) < 0.1 @ 0.95"), "no such column, did you mean miss_m?"),
        (("--until", "often"), "--until often"),
        (("--set", "wind.speed_mps=900"), "allowed 0 to 50"),
        (("--seed", "-3"), "--seed -3: allowed 0 to 4294967295"),
    ],
)
def test_bad_options(file, arguments, why):
    tried = CliRunner().invoke(app, ["campaign", str(file), "--runs", "3", *arguments])
    assert isinstance(tried.exception, InputError)
    assert why in str(tried.exception)
    assert sorted(path.name for path in file.parent.iterdir()) == ["windy.toml"]


def test_a_function_that_draws_worlds_is_refused(tmp_path):
    tried = CliRunner().invoke(app, ["campaign", str(tmp_path / "x.py"), "--runs", "3"])
    assert isinstance(tried.exception, InputError)
    assert "not supported yet" in str(tried.exception)


@pytest.mark.parametrize("arguments", [("--runs", "0"), ("--runs", "many")])
def test_how_many_flights_is_a_number(file, arguments):
    assert CliRunner().invoke(app, ["campaign", str(file), *arguments]).exit_code == 2


def test_how_many_flights_has_to_be_said(file):
    tried = CliRunner().invoke(app, ["campaign", str(file)])
    assert isinstance(tried.exception, InputError)
    assert "SCENARIO --runs N" in str(tried.exception)
