"""A flight where it is flown: what is its own fault, and what is that of the place."""

import pickle
import shutil

import pytest
from scenario_texts import MINIMAL

from vfguide.campaign import flight as module
from vfguide.campaign.flight import CPU_INFO, WorkerError, fly, processor
from vfguide.campaign.plan import campaign_plan
from vfguide.files.data import data_folder
from vfguide.files.errors import InputError


@pytest.fixture
def file(tmp_path):
    path = tmp_path / "x.toml"
    path.write_text(MINIMAL)
    return path


def raising(error):
    def flown(*_):
        raise error

    return flown


@pytest.mark.parametrize("error", [InputError("no engine"), ValueError("no engine")])
def test_a_flight_that_cannot_be_flown_is_a_row(file, monkeypatch, error):
    monkeypatch.setattr(module, "flown", raising(error))
    row = fly(campaign_plan(str(file), (), 1).job(3), "a")
    assert (row.index, row.verdict) == (3, "failed")
    assert row.reasons[0].endswith("no engine")


@pytest.mark.parametrize("error", [OSError(28, "No space left on device"), MemoryError()])
def test_a_full_disk_is_the_fault_of_no_flight(file, monkeypatch, error):
    monkeypatch.setattr(module, "flown", raising(error))
    with pytest.raises(
        WorkerError, match=r"worker a at flight 3: .*(No space|MemoryError)"
    ) as told:
        fly(campaign_plan(str(file), (), 1).job(3), "a")
    assert str(pickle.loads(pickle.dumps(told.value))) == str(told.value)


def test_a_scenario_that_changes_ends_the_campaign(file, monkeypatch):
    monkeypatch.setattr(module, "flown", raising(InputError("flown")))
    job = campaign_plan(str(file), (), 1).job(3)
    assert fly(job, "a").reasons == ("flown",)
    file.write_text(MINIMAL + "\n")
    with pytest.raises(WorkerError, match="not the scenario with which the campaign began"):
        fly(job, "a")
    file.unlink()
    with pytest.raises(WorkerError, match="no such file"):
        fly(job, "a")


def test_an_aircraft_or_a_program_that_changes_ends_the_campaign(file, monkeypatch):
    monkeypatch.setattr(module, "flown", raising(InputError("flown")))
    own = file.parent / "aircraft" / "aerosonde"
    shutil.copytree(data_folder() / "aircraft" / "aerosonde", own)
    job = campaign_plan(str(file), (), 1).job(3)
    assert fly(job, "a").reasons == ("flown",)
    other = job._replace(inputs=job.inputs._replace(program="0.0"))
    with pytest.raises(WorkerError, match="not the program with which the campaign began"):
        fly(other, "a")
    with (own / "aerosonde.toml").open("a") as text:
        text.write("\n")
    with pytest.raises(WorkerError, match="not the aircraft with which the campaign began"):
        fly(job, "a")


def test_a_computer_that_does_not_say_what_it_is(monkeypatch):
    monkeypatch.setattr(module, "CPU_INFO", CPU_INFO / "nowhere")
    assert processor.__wrapped__()
