"""Pools of real processes: rows are those of flights at home, whoever is killed meanwhile."""

import re
import signal
import subprocess
import sys
import tempfile
import time
import warnings
from dataclasses import replace
from pathlib import Path

import psutil
import pyarrow.parquet as pq
import pytest

from vfguide.campaign.campaign import End, fly_campaign
from vfguide.campaign.flight import fly
from vfguide.campaign.looks import Looks
from vfguide.campaign.plan import campaign_plan
from vfguide.campaign.pool import FOR_THE_PROGRAM, local_pool, pool_at
from vfguide.campaign.summary import UNREPEATABLE
from vfguide.campaign.table import TABLE
from vfguide.files.errors import InputError
from vfguide.runs.lockstep import NoRequests

pytestmark = [
    pytest.mark.slow,
    pytest.mark.filterwarnings("ignore"),  # Dask's own, of sockets that a killed process leaves
]
KINEMATIC = """
name = "rigid body"
plant = "kinematic"
law = "paper"
duration_s = 60

[[vehicle]]
id = 1
position_m = [0.0, 0.0, -50.0]

[[vehicle.goal]]
position_m = [30.0, 20.0, -60.0]
heading_deg = 45.0

[vary]
"vehicle.0.heading_deg" = [-180, 180]
"""
RUNS = 24


@pytest.fixture(scope="module")
def plan(tmp_path_factory):
    file = tmp_path_factory.mktemp("scenario") / "x.toml"
    file.write_text(KINEMATIC)
    return campaign_plan(str(file), (), 3)


@pytest.fixture(scope="module")
def at_home(plan):
    """The rows of the same flights, flown in this process."""
    return [fly(plan.job(index), "here") for index in range(RUNS)]


def told(row):
    return replace(row, worker="", wall_s=None, realtime_factor=None)


def flown(plan, folder, pool, progress=lambda _: None):
    end = fly_campaign(plan, RUNS, folder, pool, Looks(None), progress, NoRequests())
    assert end is End.FLOWN
    return pq.read_table(folder / TABLE)


def repeatable(table):
    return table.drop_columns(sorted(UNREPEATABLE))


def matches(table, rows):
    names = [name for name in rows[0].__dataclass_fields__ if name not in UNREPEATABLE]
    simple = [name for name in names if name not in ("vehicles", "reasons")]
    for there, here in zip(table.to_pylist(), rows, strict=True):
        assert {name: there[name] for name in simple} == {
            name: getattr(here, name) for name in simple
        }
        assert [each["setpoints"] for each in there["vehicles"]] == [
            each.setpoints for each in here.vehicles
        ]


def workers_of_mine():
    children = psutil.Process().children(recursive=True)
    return [each for each in children if "spawn_main" in " ".join(each.cmdline())]


def test_two_workers_of_which_one_is_killed(plan, at_home, tmp_path):
    killed = []

    def kill_one(standing):
        if standing.flown >= 5 and not killed:
            killed.append(workers_of_mine()[0])
            killed[0].kill()

    with local_pool(2) as pool:
        table = flown(plan, tmp_path, pool, kill_one)
    assert killed
    matches(table, at_home)
    assert set(table.column("verdict").to_pylist()) == {"good"}


def test_workers_never_hear_of_ctrl_c_and_leave_nothing_behind(plan, tmp_path, monkeypatch):
    """Blocked from their first moment on; what they write meanwhile goes with them."""
    monkeypatch.setattr(tempfile, "tempdir", str(tmp_path / "temporary"))
    (tmp_path / "temporary").mkdir()
    with local_pool(1) as pool:
        masks = [
            int(re.search(r"SigBlk:\s*(\w+)", Path(f"/proc/{each.pid}/status").read_text())[1], 16)
            for each in workers_of_mine()
        ]
        pool.submit(plan.job(0))
        while not list((tmp_path / "temporary").rglob("vfguide-flight-*")):
            assert not list(pool.ended(0.0))
    assert masks
    assert all(mask >> number - 1 & 1 for mask in masks for number in FOR_THE_PROGRAM)
    assert signal.pthread_sigmask(signal.SIG_BLOCK, ()) == set()
    assert list((tmp_path / "temporary").rglob("vfguide-*")) == []


def test_two_pools_at_once_are_not_in_each_others_way():
    """All listen on this machine alone, at any port; nothing is told of the other."""
    with warnings.catch_warnings(record=True) as told:
        warnings.simplefilter("always")
        with local_pool(1), local_pool(1):
            sockets = psutil.Process().net_connections()
    listening = [each.laddr for each in sockets if each.status == psutil.CONN_LISTEN]
    assert {address.ip for address in listening} == {"127.0.0.1"}
    assert 8787 not in {address.port for address in listening}
    assert not [each for each in told if "Port" in str(each.message)]


@pytest.fixture
def start_cluster(tmp_path):
    """Starts a scheduler at a port with two workers; the process of the scheduler, its address."""
    processes = []

    def start(name, *arguments):
        command = [sys.executable, "-m", f"distributed.cli.dask_{name}", *arguments]
        path = tmp_path / f"{len(processes)}.log"
        with path.open("wb") as log:
            processes.append(subprocess.Popen(command, stderr=log, stdout=log, cwd=tmp_path))
        return processes[-1], path

    def start_all(port=0):
        options = ("--host", "127.0.0.1", "--port", str(port), "--no-dashboard")
        scheduler, log = start("scheduler", *options)
        while not (found := re.search(r"tcp://127\.0\.0\.1:\d+", log.read_text())):
            assert scheduler.poll() is None, log.read_text()
            time.sleep(0.05)
        for _ in range(2):
            start("worker", found.group(), "--nthreads", "1", "--no-dashboard", "--no-nanny")
        return scheduler, found.group()

    yield start_all
    for process in processes:
        process.kill()
        process.wait()


def test_a_scheduler_that_is_stopped_and_started_again(plan, at_home, tmp_path, start_cluster):
    """Workers leave with their scheduler, so that they are started again too."""
    scheduler, address = start_cluster()
    stopped = []

    def stop(standing):
        if standing.flown >= 5 and not stopped:
            stopped.append(standing.flown)
            scheduler.terminate()
            scheduler.wait()
            start_cluster(int(address.rpartition(":")[2]))

    with pool_at(address) as pool:
        table = flown(plan, tmp_path / "out", pool, stop)
    assert stopped
    matches(table, at_home)


def test_no_scheduler():
    with pytest.raises(InputError, match="no scheduler there"), pool_at("tcp://127.0.0.1:9"):
        pass
    with pytest.raises(InputError, match="no scheduler there"), pool_at("nonsense://x"):
        pass
