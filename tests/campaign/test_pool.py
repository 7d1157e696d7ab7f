"""Pools of real processes: rows are those of flights at home, whoever is killed meanwhile."""

import os
import re
import signal
import subprocess
import sys
import time
from dataclasses import replace

import pyarrow.parquet as pq
import pytest
from distributed import Client

from vfguide.campaign.campaign import End, fly_campaign
from vfguide.campaign.flight import fly
from vfguide.campaign.looks import Looks
from vfguide.campaign.plan import campaign_plan
from vfguide.campaign.pool import local_pool, pool_at
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


def children(pid):
    command = ["ps", "-o", "pid=,args=", "--ppid", str(pid)]
    lines = subprocess.check_output(command, text=True).splitlines()
    return [int(line.split()[0]) for line in lines if "spawn_main" in line]


def test_two_workers_of_which_one_is_killed(plan, at_home, tmp_path):
    killed = []

    def kill_one(standing):
        if standing.flown >= 5 and not killed:
            killed.append(max(children(os.getpid())))
            os.kill(killed[0], signal.SIGKILL)

    with local_pool(2) as pool:
        table = flown(plan, tmp_path, pool, kill_one)
    assert killed
    matches(table, at_home)
    assert set(table.column("verdict").to_pylist()) == {"good"}


@pytest.fixture
def cluster(tmp_path):
    """The address of a scheduler with two workers, and what starts the scheduler again."""
    processes = []

    def start(*arguments, **options):
        command = [sys.executable, "-m", "distributed.cli.dask_" + arguments[0], *arguments[1:]]
        log = (tmp_path / f"{arguments[0]}-{len(processes)}.log").open("wb")
        processes.append(subprocess.Popen(command, stderr=log, stdout=log, **options))
        log.close()
        return processes[-1], tmp_path / f"{arguments[0]}-{len(processes) - 1}.log"

    def scheduler(port=0):
        process, log = start(
            "scheduler", "--host", "127.0.0.1", "--port", str(port), "--no-dashboard"
        )
        while not (found := re.search(r"tcp://127\.0\.0\.1:(\d+)", log.read_text())):
            assert process.poll() is None
            time.sleep(0.05)
        return process, found.group()

    first, address = scheduler()
    for name in ("one", "two"):
        folder = tmp_path / name
        folder.mkdir()
        options = ("--nthreads", "1", "--no-dashboard", "--name", name, "--no-nanny")
        start("worker", address, *options, cwd=folder)
    yield first, address, scheduler
    for process in processes:
        process.kill()
        process.wait()


def test_a_scheduler_that_is_stopped_and_started_again(plan, at_home, tmp_path, cluster):
    first, address, start_scheduler = cluster
    with Client(address) as client:
        client.wait_for_workers(2, timeout=60)
    stopped = []

    def stop(standing):
        if standing.flown >= 5 and not stopped:
            first.terminate()
            first.wait()
            stopped.append(standing.flown)
            start_scheduler(int(address.rpartition(":")[2]))

    with pool_at(address) as pool:
        table = flown(plan, tmp_path / "out", pool, stop)
    assert stopped
    matches(table, at_home)


def test_no_scheduler():
    with pytest.raises(InputError, match="no scheduler there"), pool_at("tcp://127.0.0.1:9"):
        pass
    with pytest.raises(InputError, match="no scheduler there"), pool_at("nonsense://x"):
        pass
