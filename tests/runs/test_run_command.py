"""`vfguide run` in good and bad hands."""

import json
import resource
import signal

import pytest
from commands import vfguide, vfguide_alone
from flights import interrupted, scenario_file

from vfguide.files.data import find_aircraft
from vfguide.link.tlog import TlogReader

pytestmark = pytest.mark.slow

RESULT_KEYS = {
    *("name", "version", "seed", "verdict", "reasons", "sim_s", "wall_s", "realtime_factor"),
    *("min_separation_m", "vehicles"),
}
VEHICLE_KEYS = {
    *("id", "goals", "obstacles", "fence_clearance_m", "assurance", "traffic", "identified"),
    "field",
    "max_bank_deg",
    *("load_factor", "airspeed_mps", "altitude_m", "setpoints", "setpoint_rate_hz"),
}
FIGURES = ("path-3d", "path-plan", "path-side", "position", "attitude", "envelope", "rates", "air")


def test_a_run_leaves_everything(tmp_path):
    done = vfguide_alone("run", scenario_file(tmp_path), "--out", "out", cwd=tmp_path)
    assert done.returncode == 0, done.stderr
    assert "verdict: good" in done.stdout
    out = tmp_path / "out"
    assert {path.name for path in out.iterdir()} == {
        *("scenario.toml", "result.json", "report.html", "figures"),
        *("flight.tlog", "vehicle-7.tlog"),
    }
    result = json.loads((out / "result.json").read_text())
    assert set(result) == RESULT_KEYS
    assert set(result["vehicles"][0]) == VEHICLE_KEYS
    for name in FIGURES:
        assert (out / "figures" / f"{name}.png").read_bytes().startswith(b"\x89PNG")
    assert "://" not in (out / "report.html").read_text()


def test_a_run_that_ends_too_soon_is_bad(tmp_path):
    path = scenario_file(tmp_path)
    done = vfguide(
        "run", path, "--out", "out", "--no-report", "--set", "duration_s=5", cwd=tmp_path
    )
    assert done.returncode == 1
    result = json.loads((tmp_path / "out" / "result.json").read_text())
    assert result["verdict"] == "bad"
    assert result["reasons"] == ["time", "goal 1 of vehicle 7 not reached"]
    assert result["sim_s"] == 5.0


def test_without_out_the_folder_is_named_after_the_scenario(tmp_path):
    path = scenario_file(tmp_path)
    done = vfguide("run", path, "--no-report", "--set", "duration_s=1", cwd=tmp_path)
    assert done.returncode == 1
    (folder,) = (tmp_path / "runs").iterdir()
    assert folder.name.startswith("short-20")


def test_an_existing_empty_folder_is_fine(tmp_path):
    (tmp_path / "out").mkdir()
    path = scenario_file(tmp_path)
    done = vfguide(
        "run", path, "--out", "out", "--no-report", "--set", "duration_s=1", cwd=tmp_path
    )
    assert done.returncode == 1, done.stderr


def test_a_full_folder_is_refused_and_left_alone(tmp_path):
    (tmp_path / "out").mkdir()
    (tmp_path / "out" / "mine").write_text("keep")
    done = vfguide("run", scenario_file(tmp_path), "--out", "out", cwd=tmp_path)
    assert done.returncode == 2
    assert done.stderr == ("vfguide: --out out: not empty, allowed is a new or an empty folder\n")
    assert [path.name for path in (tmp_path / "out").iterdir()] == ["mine"]


def test_a_folder_that_cannot_be_made(tmp_path):
    (tmp_path / "file").write_text("")
    done = vfguide("run", scenario_file(tmp_path), "--out", "file/out", cwd=tmp_path)
    assert done.returncode == 2
    assert done.stderr == "vfguide: --out file/out: cannot be made: Not a directory\n"


def limit_files():
    """From now on a file may have 60,000 bytes: a disk that fills up in flight."""
    signal.signal(signal.SIGXFSZ, signal.SIG_IGN)
    resource.setrlimit(resource.RLIMIT_FSIZE, (60_000, 60_000))


def test_a_disk_that_fills_up(tmp_path):
    path = scenario_file(tmp_path)
    warm = vfguide("check", path, cwd=tmp_path)
    assert warm.returncode == 0, warm.stderr
    done = vfguide_alone(
        *("run", path, "--out", "out", "--no-report"), cwd=tmp_path, preexec_fn=limit_files
    )
    assert done.returncode == 2
    assert "cannot be written" in done.stderr
    assert "Traceback" not in done.stderr
    assert not (tmp_path / "out" / "result.json").exists()
    reader = TlogReader.open(tmp_path / "out" / "flight.tlog")
    assert sum(1 for _ in reader) > 100
    assert reader.junk_bytes == 0


def test_ctrl_c_in_flight_keeps_what_was_flown(tmp_path):
    interrupted(scenario_file(tmp_path), "vehicle-7.tlog")
    for name in ("flight.tlog", "vehicle-7.tlog"):
        reader = TlogReader.open(tmp_path / "out" / name)
        assert sum(1 for _ in reader) > 100
        assert reader.junk_bytes == 0
    replayed = vfguide("replay", "out/vehicle-7.tlog", cwd=tmp_path)
    assert replayed.returncode == 0, replayed.stdout


@pytest.mark.parametrize(
    ("arguments", "message"),
    [
        (("run", "no-such"), "no-such"),
        (("run", "first-flight", "--set", "wind.sped_mps=3"), "wind.sped_mps"),
        (("run", "first-flight", "--set", "wind"), "wind"),
        (("check", "no-such"), "no-such"),
        (("replay", "no.tlog"), "no.tlog"),
        (("replay", "no.bin"), "no.bin: not a .tlog"),
        (("run",), "Missing argument"),
        (("run", "first-flight", "--seed", "x"), "--seed"),
    ],
)
def test_bad_words_on_the_command_line(arguments, message, tmp_path):
    done = vfguide(*arguments, cwd=tmp_path)
    assert done.returncode == 2
    assert message in done.stderr
    assert "Traceback" not in done.stderr
    assert list(tmp_path.iterdir()) == []


@pytest.mark.parametrize(
    "arguments",
    [("check", "first-flight"), ("check", "no-such"), ("run", "first-flight", "--set", "wind")],
)
def test_in_a_process_of_its_own_it_ends_and_says_the_same(arguments, tmp_path):
    here, alone = (run(*arguments, cwd=tmp_path) for run in (vfguide, vfguide_alone))
    assert (here.returncode, here.stdout) == (alone.returncode, alone.stdout)
    assert here.stderr == alone.stderr


def test_brackets_in_a_message_are_shown_as_typed(tmp_path):
    path = scenario_file(tmp_path)
    path.write_text(path.read_text().replace('name = "short"', 'name = "[red]x[/red]"'))
    done = vfguide("check", path, cwd=tmp_path)
    assert done.returncode == 2
    assert "[red]x[/red]" in done.stderr


def test_a_model_that_jsbsim_cannot_read(tmp_path):
    folder = tmp_path / "aircraft" / "aerosonde"
    folder.mkdir(parents=True)
    shipped = find_aircraft("aerosonde")
    (folder / "aerosonde.toml").write_text(shipped.performance.read_text())
    (folder / "aerosonde.xml").write_text(shipped.model.read_text()[:3000])
    done = vfguide("run", scenario_file(tmp_path), "--out", "out", cwd=tmp_path)
    assert done.returncode == 2
    assert "aerosonde.xml" in done.stderr
    assert "Traceback" not in done.stderr
