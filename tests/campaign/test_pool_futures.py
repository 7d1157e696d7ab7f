"""What a pool makes of flights that have ended, without a cluster."""

import tempfile
from concurrent.futures import CancelledError
from types import SimpleNamespace

import pytest
from campaign_rows import flown_row
from distributed import KilledWorker

from vfguide.campaign import pool as module
from vfguide.campaign.draws import draw
from vfguide.campaign.flight import WorkerError
from vfguide.campaign.pool import Pool, temporary_folder
from vfguide.files.errors import InputError


class Future:
    def __init__(self, row=None, error=None, lost=None):
        self.row, self.error, self.lost = row, error, lost
        self.status = "error" if error else "finished"

    def exception(self):
        return self.error

    def result(self):
        if self.lost is not None:
            raise self.lost
        return self.row


def pool_of(monkeypatch, futures):
    """A pool to which the futures are given, all of which have ended."""
    given = iter(futures)
    client = SimpleNamespace(submit=lambda *_, **__: next(given), status="running")
    monkeypatch.setattr(module, "wait", lambda flying, *_: SimpleNamespace(done=set(flying)))
    pool = Pool(lambda: client)
    for index in range(len(futures)):
        pool.submit(SimpleNamespace(draw=draw(1, index, {})))
    return pool


def row(index):
    return flown_row(draw(1, index, {}))


def test_a_flight_whose_workers_die_is_a_row(monkeypatch):
    pool = pool_of(
        monkeypatch, [Future(error=KilledWorker("fly", SimpleNamespace(address="there"), 3))]
    )
    ((job, failed),) = pool.ended(0.1)
    assert (job.draw.index, failed.verdict) == (0, "failed")
    assert failed.reasons[0].startswith("KilledWorker")
    assert pool.is_idle


@pytest.mark.parametrize("error", [WorkerError("full"), ModuleNotFoundError("no vfguide")])
def test_a_worker_that_cannot_fly_is_told_after_the_flights_that_ended(monkeypatch, error):
    futures = [Future(error=error), *(Future(row(index)) for index in range(1, 6))]
    taken = pool_of(monkeypatch, futures).ended(0.1)
    assert sorted(next(taken)[1].index for _ in range(5)) == [1, 2, 3, 4, 5]
    with pytest.raises(WorkerError, match=r"full|no vfguide"):
        next(taken)


@pytest.mark.parametrize("lost", [CancelledError(), OSError("gone")])
def test_a_flight_that_cannot_be_fetched_stays_in_its_hands(monkeypatch, lost):
    pool = pool_of(monkeypatch, [Future(lost=lost)])
    assert list(pool.ended(0.1)) == []
    assert pool.is_lost
    assert not pool.is_idle


def test_no_folder_for_temporary_files(monkeypatch, tmp_path):
    monkeypatch.setattr(tempfile, "tempdir", str(tmp_path / "nowhere"))
    with pytest.raises(InputError, match="no folder for temporary files: No such file"):
        temporary_folder()
