"""The workers of a campaign: a cluster of Dask, on this machine or anywhere."""

import logging
import math
import signal
import time
from collections.abc import Callable, Generator, Iterable, Iterator
from concurrent.futures import CancelledError
from contextlib import closing, contextmanager, suppress
from multiprocessing import resource_tracker
from tempfile import TemporaryDirectory
from typing import Any

from distributed import Client, Future, KilledWorker, LocalCluster, get_worker, wait
from distributed.client import FIRST_COMPLETED

from vfguide.campaign.flight import Job, WorkerError, fly
from vfguide.campaign.rows import FlightRow, failed_row
from vfguide.files.errors import InputError

FLIGHTS_A_WORKER = 4
"""Number of flights that are given to the cluster for each of its workers; chosen, so that none
waits for the next, and few are flown in vain where a campaign ends early."""
CONNECT_TIMEOUT = 5.0
"""Time in which a scheduler has to answer [s]; chosen."""
ROOM_INTERVAL = 1.0
"""Time between two looks at how many workers there are [s]; chosen."""
ANY_PORT = "127.0.0.1:0"
"""Address of the HTTP server of a scheduler, which shows no page then; that of Dask has a port of
its own, of which the second campaign at once is warned."""
FOR_THE_PROGRAM = (signal.SIGINT, signal.SIGTERM, signal.SIGHUP)
"""The signals that ask for an end, which a terminal and `kill` can send to the workers too."""
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

    def ended(self, timeout: float) -> Iterator[tuple[Job, FlightRow]]:
        """The flights that have ended; waits for one, at most for `timeout` [s].

        Raises:
            WorkerError: a worker cannot fly; it comes after the flights that have ended.
        """
        if self.is_lost:
            self._find_again()
            return
        try:
            ended: Any = wait(list(self._flying), timeout, FIRST_COMPLETED)
            yield from self._taken(sorted(ended.done, key=lambda each: each.status == "error"))
        except TimeoutError:
            self.is_lost = self._client.status != "running"
        except (CancelledError, OSError):
            self.is_lost = True

    def close(self) -> None:
        """Leave the cluster; flights that have not ended are forgotten there."""
        self._client.close()

    def _taken(self, ended: Iterable[Future[FlightRow]]) -> Iterator[tuple[Job, FlightRow]]:
        """Flights with their rows, no longer in its hands; one that cannot be fetched stays."""
        for future in ended:
            job = self._flying[future]
            row = row_of_future(future, job)
            del self._flying[future]
            yield job, row

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


def row_of_future(future: Future[FlightRow], job: Job) -> FlightRow:
    """The row of a flight that has ended, or whose workers died again and again.

    Raises:
        WorkerError: its worker cannot fly.
        CancelledError: the scheduler has forgotten it.
        OSError: it cannot be fetched.
    """
    error: Any = future.exception()
    if error is None:
        return future.result()
    told = f"{type(error).__name__}: {error}"
    if isinstance(error, KilledWorker):
        return failed_row(job.draw, told, "", "")
    if isinstance(error, WorkerError):
        raise error
    raise WorkerError(f"a worker cannot take flight {job.draw.index}: {told}") from error


def fly_on_worker(job: Job) -> FlightRow:
    """Fly a job where it is sent, in the folder of the worker, which is removed with it."""
    worker = get_worker()
    return fly(job, str(worker.name), worker.local_directory)


@contextmanager
def local_pool(workers: int) -> Generator[Pool]:
    """A pool of processes on this machine, each with one thread; they end with the block.

    Raises:
        InputError: there is no folder for temporary files.
    """
    logging.getLogger("distributed").setLevel(logging.CRITICAL)
    with (
        temporary_folder() as folder,
        local_cluster(workers, folder) as cluster,
        closing(Pool(lambda: Client(cluster))) as pool,
    ):
        yield pool


def temporary_folder() -> TemporaryDirectory[str]:
    """A folder for what workers write; a context manager that removes it.

    Raises:
        InputError: it cannot be made.
    """
    try:
        return TemporaryDirectory(prefix="vfguide-workers-", ignore_cleanup_errors=True)
    except OSError as error:
        raise InputError(f"no folder for temporary files: {error.strerror or error}") from error


def local_cluster(workers: int, folder: str) -> LocalCluster:
    """Processes on this machine that never hear a request to end: that is for the program alone.

    The program ends them in good order. The signals are blocked in the threads that begin here, and
    so from the first moment in the processes that these begin. The first of these processes would
    be the resource tracker of Python, after which it lets the signals through: it begins before.
    """
    resource_tracker.ensure_running()
    before = signal.pthread_sigmask(signal.SIG_BLOCK, FOR_THE_PROGRAM)
    try:
        return LocalCluster(
            n_workers=workers,
            threads_per_worker=1,
            processes=True,
            scheduler_kwargs={"dashboard": False, "dashboard_address": ANY_PORT},
            memory_limit=0,
            local_directory=folder,
            preload=PRELOAD,
        )
    finally:
        signal.pthread_sigmask(signal.SIG_SETMASK, before)


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
