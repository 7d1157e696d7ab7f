"""The workers of a campaign: a cluster of Dask, on this machine or anywhere."""

import logging
import math
import time
from collections.abc import Callable, Generator
from contextlib import closing, contextmanager, suppress
from tempfile import TemporaryDirectory
from typing import Any

from distributed import Client, Future, LocalCluster, get_worker, wait
from distributed.client import FIRST_COMPLETED, FuturesCancelledError

from vfguide.campaign.flight import Job, fly
from vfguide.campaign.rows import FlightRow, failed_row
from vfguide.files.errors import InputError

FLIGHTS_A_WORKER = 4
"""Number of flights that are given to the cluster for each of its workers; chosen, so that none
waits for the next, and few are flown in vain where a campaign ends early."""
CONNECT_TIMEOUT = 5.0
"""Time in which a scheduler has to answer [s]; chosen."""
ROOM_INTERVAL = 1.0
"""Time between two looks at how many workers there are [s]; chosen."""
NO_DASHBOARD: Any = None
"""Address of Dask's page about itself: there is none, though its types do not say that."""
PRELOAD = "vfguide.campaign.worker_setup"
"""Name of the module that a worker process of ours imports first."""


class Pool:
    """Flights in the hands of a cluster."""

    def __init__(self, connect: Callable[[], Client]) -> None:
        """None yet; `connect` makes a client of the cluster, again where its scheduler was lost.

        Raises:
            OSError: there is no scheduler.
        """
        self._connect = connect
        self._client = connect()
        self._flying: dict[Future[FlightRow], Job] = {}
        self._room = Room()
        self.is_lost = False
        """Whether the scheduler does not answer; what it had is given to it again when it does."""

    @property
    def has_room(self) -> bool:
        """Whether to give it one more flight."""
        if self.is_lost:
            return False
        try:
            return len(self._flying) < self._room.of(self._client)
        except OSError:
            self.is_lost = True
            return False

    @property
    def is_idle(self) -> bool:
        """Whether it has no flight."""
        return not self._flying

    def submit(self, job: Job) -> None:
        """Give it a flight."""
        self._flying[self._client.submit(fly_on_worker, job, pure=False)] = job

    def ended(self, timeout: float) -> list[tuple[Job, FlightRow]]:
        """The flights that have ended; waits for one, at most for `timeout` [s]."""
        if self.is_lost:
            self._find_again()
            return []
        try:
            ended: Any = wait(list(self._flying), timeout, FIRST_COMPLETED)
        except TimeoutError:
            self.is_lost = self._client.status != "running"
            return []
        except (FuturesCancelledError, OSError):
            self.is_lost = True
            return []
        return [(self._flying[future], self._row(future)) for future in ended.done]

    def close(self) -> None:
        """Leave the cluster; flights that have not ended are forgotten there."""
        self._client.close()

    def _row(self, future: Future[FlightRow]) -> FlightRow:
        """The row of a flight that has ended, or whose workers died again and again."""
        job = self._flying.pop(future)
        error = future.exception()
        if error is None:
            return future.result()
        return failed_row(job.draw, f"{type(error).__name__}: {error}", "", "")

    def _find_again(self) -> None:
        """Connect to a scheduler that was lost, if it is there again, and give it what it had."""
        jobs = list(self._flying.values())
        try:
            client = self._connect()
        except OSError:
            return
        with suppress(TimeoutError):
            self._client.close(0)
        self._client, self._flying, self.is_lost = client, {}, False
        for job in jobs:
            self.submit(job)


class Room:
    """How many flights a cluster can have, looked at now and then."""

    def __init__(self) -> None:
        self._flights = 1
        self._looked = -math.inf

    def of(self, client: Client) -> int:
        """The number of flights for the workers that a client sees."""
        if time.monotonic() - self._looked > ROOM_INTERVAL:
            self._looked = time.monotonic()
            workers = client.scheduler_info(n_workers=-1)["workers"].values()
            self._flights = FLIGHTS_A_WORKER * max(1, sum(worker["nthreads"] for worker in workers))
        return self._flights


def fly_on_worker(job: Job) -> FlightRow:
    """Fly a job where it is sent."""
    return fly(job, str(get_worker().name))


@contextmanager
def local_pool(workers: int) -> Generator[Pool]:
    """A pool of processes on this machine, each with one thread; they end with the block."""
    logging.getLogger("distributed").setLevel(logging.CRITICAL)
    with (
        TemporaryDirectory(prefix="vfguide-workers-") as folder,
        LocalCluster(
            n_workers=workers,
            threads_per_worker=1,
            processes=True,
            dashboard_address=NO_DASHBOARD,
            memory_limit=0,
            local_directory=folder,
            preload=PRELOAD,
        ) as cluster,
        closing(Pool(lambda: Client(cluster))) as pool,
    ):
        yield pool


@contextmanager
def pool_at(address: str) -> Generator[Pool]:
    """A pool of the workers of the scheduler at an address, as tcp://127.0.0.1:8786.

    Raises:
        InputError: there is no scheduler.
    """
    logging.getLogger("distributed").setLevel(logging.CRITICAL)
    try:
        pool = Pool(lambda: Client(address, timeout=CONNECT_TIMEOUT))
    except (OSError, ValueError) as error:
        raise InputError(
            f"--scheduler {address}: no scheduler there, "
            "allowed is the address of one, such as tcp://127.0.0.1:8786"
        ) from error
    with closing(pool):
        yield pool
