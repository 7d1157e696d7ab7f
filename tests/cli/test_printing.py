"""The program on terminals that cannot show a text, or not any more."""

import os
import subprocess
from pathlib import Path

import pytest
from commands import vfguide
from programs import VFGUIDE

pytestmark = pytest.mark.slow

SHORT = ("run", "first-flight", "--no-report", "--set", "duration_s=1")
"""A flight that ends too soon, with a bad verdict."""


def status_of(*arguments, cwd, **options):
    options = {"stdout": subprocess.PIPE, "stderr": subprocess.PIPE, **options}
    done = subprocess.run([*VFGUIDE, *arguments], cwd=cwd, check=False, timeout=300, **options)
    return done.returncode, done.stdout or b"", done.stderr or b""


def with_encoding(encoding):
    return {**os.environ, "PYTHONIOENCODING": encoding, "COLUMNS": "300"}


@pytest.mark.parametrize("encoding", ["ascii", "latin-1", "utf-8"])
def test_an_umlaut_in_a_folder_on_any_terminal(tmp_path, encoding):
    for folder in ("Zürich 1", "東京", "a\nb", os.fsdecode(b"\xff\xfe")):
        done = vfguide(*SHORT, "--out", folder, cwd=tmp_path, encoding=encoding)
        assert done.returncode == 1, done.stderr
        assert "verdict: bad" in done.stdout
        assert (tmp_path / folder / "result.json").is_file()


@pytest.mark.parametrize("encoding", ["ascii", "latin-1", "utf-8"])
def test_the_encoding_of_a_terminal_is_that_of_its_environment(tmp_path, encoding):
    status, out, err = status_of(*SHORT, "--out", "Zü東", cwd=tmp_path, env=with_encoding(encoding))
    assert status == 1, err
    assert "Zü東".encode(encoding, "backslashreplace") in out
    assert b"Traceback" not in err
    assert (tmp_path / "Zü東" / "result.json").is_file()


def test_an_umlaut_in_names_and_in_the_report(tmp_path):
    text = """
name = "Zürich"
duration_s = 2
[[vehicle]]
id = 1
position_m = [-300, 0, -120]
[[vehicle.goal]]
position_m = [0, 0, -120]
heading_deg = 0
[[obstacle]]
name = 'Münster $\\frac{'
shape = "cylinder"
position_m = [0, 300, 0]
radius_m = 30
height_m = 100
"""
    path = tmp_path / os.fsdecode(b"Z\xfcrich.toml")
    path.write_text(text, "utf-8")
    status, out, err = status_of("run", path, cwd=tmp_path, env=with_encoding("ascii"))
    assert status == 1, err
    (folder,) = (tmp_path / "runs").iterdir()
    assert "Münster $\\frac{" in (folder / "report.html").read_text("utf-8")
    assert str(folder.relative_to(tmp_path)).encode("ascii", "backslashreplace") in out


def test_a_full_disk_behind_the_output_changes_no_verdict(tmp_path):
    with Path("/dev/full").open("wb") as full:
        status, _, err = status_of(*SHORT, "--out", "a", cwd=tmp_path, stdout=full)
        assert status == 1, err
        status, _, _ = status_of(*SHORT, "--out", "b", cwd=tmp_path, stdout=full, stderr=full)
    assert status == 1
    assert {path.name for path in (tmp_path / "a").iterdir()} == {
        path.name for path in (tmp_path / "b").iterdir()
    }


def test_a_field_that_nobody_can_read_is_an_error(tmp_path):
    (tmp_path / "points.csv").write_text("x,y,z,vx,vy,vz,t\n0,0,-100,25,0,0,0\n")
    arguments = ("field", "first-flight", "--vehicle", "1", "--points", "points.csv")
    with Path("/dev/full").open("wb") as full:
        status, _, err = status_of(*arguments, cwd=tmp_path, stdout=full)
    assert status == 2
    assert err.endswith(b"vfguide: standard output cannot be written: No space left on device\n")


def test_a_reader_that_ends(tmp_path):
    reading, writing = os.pipe()
    os.close(reading)
    status, _, err = status_of(*SHORT, "--out", "a", cwd=tmp_path, stdout=writing)
    os.close(writing)
    assert status == 1, err
    assert err == b""


def test_without_any_output(tmp_path):
    closed = f"{VFGUIDE[0]} -c '{VFGUIDE[2]}' {' '.join(SHORT)} --out a >&- 2>&-"
    done = subprocess.run(closed, shell=True, cwd=tmp_path, check=False)
    assert done.returncode == 1
    assert (tmp_path / "a" / "result.json").is_file()


def test_runs_of_one_second_have_folders_of_their_own(tmp_path):
    started = [
        subprocess.Popen([*VFGUIDE, *SHORT], cwd=tmp_path, stderr=subprocess.PIPE, text=True)
        for _ in range(4)
    ]
    for process in started:
        _, err = process.communicate()
        assert process.returncode == 1, err
    folders = list((tmp_path / "runs").iterdir())
    assert len(folders) == 4
    assert all((folder / "result.json").is_file() for folder in folders)
