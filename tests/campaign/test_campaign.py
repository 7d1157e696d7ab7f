"""Campaigns with a pool by hand: whoever flies, in whatever order, with whatever interruptions."""

import json
import random
import shutil

import pyarrow.parquet as pq
import pytest
from campaign_rows import HandPool, failing, flown_row
from scenario_texts import MINIMAL

from vfguide.campaign import summary as summary_module
from vfguide.campaign.campaign import IDENTITY_FILE, End, check_folder, fly_campaign
from vfguide.campaign.condition import parse_condition
from vfguide.campaign.flight import WorkerError
from vfguide.campaign.hold import hold
from vfguide.campaign.looks import FLIGHTS_A_LOOK, Looks
from vfguide.campaign.plan import campaign_plan, condition_on
from vfguide.campaign.results.flown import read_flown
from vfguide.campaign.summary import summarize
from vfguide.campaign.table import TABLE
from vfguide.files.data import data_folder
from vfguide.files.errors import InputError
from vfguide.preflight.load import load_scenario
from vfguide.runs.lockstep import NoRequests

VARY = '\n[vary]\n"wind.speed_mps" = [0, 5]\n"vehicle.0.heading_deg" = {mean = 0, std = 10}\n'
LOW = "rate(miss_m > 0.9) < 0.3 @ 0.95"


class StopAfter(NoRequests):
    """The user ends it after some looks."""

    def __init__(self, looks):
        self._left = looks

    def wanted(self):
        self._left -= 1
        return self._left < 0


@pytest.fixture(scope="module")
def file(tmp_path_factory):
    path = tmp_path_factory.mktemp("scenario") / "x.toml"
    path.write_text(MINIMAL + VARY)
    return path


@pytest.fixture(scope="module")
def plan(file):
    return campaign_plan(str(file), (), 5)


def fly(plan, folder, runs=50, pool=None, looks=None, requests=None):
    pool, looks = pool or HandPool(), looks or Looks(None)
    return fly_campaign(plan, runs, folder, pool, looks, lambda _: None, requests or NoRequests())


def table(folder):
    return pq.read_table(folder / TABLE)


@pytest.mark.parametrize(("seed", "room"), [(1, 1), (2, 3), (3, 40)])
def test_the_table_does_not_depend_on_who_flies(plan, tmp_path, seed, room):
    assert fly(plan, tmp_path / "a") is End.FLOWN
    assert fly(plan, tmp_path / "b", pool=HandPool(seed, room)) is End.FLOWN
    assert table(tmp_path / "a").equals(table(tmp_path / "b"))
    assert table(tmp_path / "a").column("index").to_pylist() == list(range(50))


def test_an_interrupted_campaign_goes_on(plan, tmp_path):
    flown, chance = [], random.Random(4)
    end = None
    for attempt in range(100):
        pool = HandPool(attempt)
        end = fly(plan, tmp_path / "a", pool=pool, requests=StopAfter(chance.randint(1, 6)))
        flown += pool.flown
        if end is End.FLOWN:
            break
        assert end is End.STOPPED
    assert end is End.FLOWN
    assert sorted(flown) == list(range(50))  # none lost, none flown twice
    fly(plan, tmp_path / "b")
    assert table(tmp_path / "a").equals(table(tmp_path / "b"))


def test_more_flights_of_a_campaign_that_was_over(plan, tmp_path):
    fly(plan, tmp_path, runs=20)
    pool = HandPool()
    fly(plan, tmp_path, runs=30, pool=pool)
    assert sorted(pool.flown) == list(range(20, 30))


def test_drawn_values_and_command_are_in_the_table(plan, file, tmp_path):
    fly(plan, tmp_path, runs=3)
    for row in table(tmp_path).to_pylist():
        drawn = plan.job(row["index"]).draw
        assert row["seed"] == drawn.seed
        assert all(row[key] == value for key, value in drawn.values)
        assert row["command"] == (
            f"vfguide run {file} --set=seed={drawn.seed} "
            + " ".join(f"--set={key}={value!r}" for key, value in drawn.values)
        )


@pytest.mark.parametrize(("seed", "room"), [(1, 1), (2, 3), (3, 40)])
def test_a_condition_ends_it_at_the_same_flight(plan, tmp_path, seed, room):
    ends = []
    for name, pool in {"a": HandPool(), "b": HandPool(seed, room)}.items():
        looks = Looks(parse_condition(LOW))
        assert fly(plan, tmp_path / name, 400, pool, looks) is End.DECIDED
        assert looks.is_met
        ends.append(looks.enough)
    assert ends[0] == ends[1]
    assert ends[0] % FLIGHTS_A_LOOK == 0
    assert table(tmp_path / "a").equals(table(tmp_path / "b"))
    assert table(tmp_path / "a").num_rows == ends[0] < 400


def test_a_decided_campaign_stays_decided(plan, tmp_path):
    looks = Looks(parse_condition(LOW))
    fly(plan, tmp_path, 400, looks=looks)
    again, pool = Looks(parse_condition(LOW)), HandPool()
    assert fly(plan, tmp_path, 400, pool, again) is End.DECIDED
    assert (again.enough, again.is_met) == (looks.enough, True)
    assert pool.flown == []


def test_what_is_refuted_and_what_stays_unknown(plan, tmp_path):
    refuted = Looks(parse_condition("rate(miss_m > 0.9) > 0.5 @ 0.95"))
    assert fly(plan, tmp_path / "a", 400, looks=refuted) is End.DECIDED
    assert refuted.is_met is False
    unknown = Looks(parse_condition("rate(miss_m > 0.9) < 0.1 @ 0.99"))
    assert fly(plan, tmp_path / "b", 30, looks=unknown) is End.FLOWN
    assert (unknown.is_met, unknown.trials) == (None, 30)
    assert json.loads(summarize(tmp_path / "b", plan, 30, unknown).to_json())["until"] == {
        "condition": "rate(miss_m > 0.9) < 0.1 @ 0.99",
        "count": unknown.successes,
        "of": 30,
        "rate": unknown.successes / 30,
        "interval": list(summarize(tmp_path / "b", plan, 30, unknown).until.interval),
        "is_met": None,
    }


def test_a_failed_flight_counts_against_the_condition(plan, tmp_path):
    looks = Looks(parse_condition(LOW))
    fly(plan, tmp_path, 30, HandPool(fly=failing), looks)
    misses = [row["miss_m"] for row in table(tmp_path).to_pylist()]
    assert looks.successes == sum(miss is None or miss > 0.9 for miss in misses)
    assert misses.count(None) == 10


def test_rates_and_percentiles(plan, tmp_path):
    fly(plan, tmp_path, 30, HandPool(fly=failing))
    summary = summarize(tmp_path, plan, 30, Looks(None))
    rates = {rate.name: (rate.count, rate.of) for rate in summary.rates}
    assert rates == {"good": (20, 30), "reached": (20, 30), "failed": (10, 30)}
    figures = {figure.column: figure for figure in summary.figures}
    miss = figures["miss_m"]
    assert (miss.known, miss.missing) == (20, 10)
    values = sorted(flown_row(plan.job(k).draw).miss_m for k in range(30) if k % 3)
    assert (miss.least, miss.largest) == (values[0], values[-1])
    median = next(each for each in miss.percentiles if each.percent == 50.0)
    assert median.value == values[9]
    assert median.interval.low < median.value < median.interval.high
    assert "min_clearance_m" not in figures  # there are no obstacles
    assert json.loads((tmp_path / "summary.json").read_text()) == json.loads(summary.to_json())


def test_a_folder_of_the_same_campaign_is_gone_on_with(plan, tmp_path):
    check_folder(tmp_path / "none yet", plan)
    check_folder(tmp_path, plan)
    fly(plan, tmp_path, 3)
    check_folder(tmp_path, plan)


def test_folders_of_others_are_refused(plan, file, tmp_path):
    fly(plan, tmp_path / "a", 3)
    refused = {
        ((), 6): "seed = 5 there, 6 here",
        (("wind.from_deg=90",), 5): 'set = [] there, ["wind.from_deg=90"] here',
    }
    for (overrides, seed), why in refused.items():
        with pytest.raises(InputError, match="of another campaign") as error:
            check_folder(tmp_path / "a", campaign_plan(str(file), overrides, seed))
        assert why in str(error.value)
    (tmp_path / "b").mkdir()
    (tmp_path / "b" / "notes.txt").write_text("mine")
    with pytest.raises(InputError, match="not empty and of no campaign"):
        check_folder(tmp_path / "b", plan)
    for text in ("", "[]", "3", "{"):
        (tmp_path / "b" / IDENTITY_FILE).write_text(text)
        with pytest.raises(InputError, match=r"campaign\.json is none of this program's"):
            check_folder(tmp_path / "b", plan)
    with pytest.raises(InputError, match="is no folder"):
        check_folder(file, plan)


def test_a_scenario_that_was_changed_is_another_one(file, tmp_path):
    own = tmp_path / "own.toml"
    own.write_text(file.read_text())
    fly(campaign_plan(str(own), (), 5), tmp_path / "a", 2)
    own.write_text(file.read_text() + "\n")
    with pytest.raises(InputError, match="sha256"):
        check_folder(tmp_path / "a", campaign_plan(str(own), (), 5))


@pytest.mark.parametrize(
    ("text", "why"),
    [
        ('"wind.sped_mps" = [0, 5]', "unknown key, did you mean speed_mps?"),
        ('"vehicle.4.heading_deg" = [0, 5]', "4 is no index here, allowed 0 to 0"),
        ('"wind.speed_mps" = [0, 500]', "too large, allowed 0 to 50"),
        ('"wind.speed_mps" = [-1, 5]', "too small, allowed 0 to 50"),
        ('"name" = [0, 5]', "wrong type, a string is required"),
        ('"law" = {mean = 0, std = 1}', "unknown"),
    ],
)
def test_what_cannot_be_drawn_is_told_before_the_first_flight(tmp_path, text, why):
    file = tmp_path / "x.toml"
    file.write_text(f"{MINIMAL}\n[vary]\n{text}\n")
    with pytest.raises(InputError) as error:
        campaign_plan(str(file), (), None)
    assert why in str(error.value)
    assert "[vary]" in str(error.value)


def test_the_seed_is_the_scenarios_unless_it_is_given(file):
    assert campaign_plan(str(file), (), None).seed == 1
    assert campaign_plan(str(file), ("seed=9",), None).seed == 9
    for seed in (-1, 2**32):
        with pytest.raises(InputError, match="allowed 0 to 4294967295"):
            campaign_plan(str(file), (), seed)


class NoRoomYet(HandPool):
    """Its scheduler does not answer at first."""

    looks = 0

    @property
    def has_room(self):
        self.looks += 1
        return self.looks > 5 and super().has_room


def test_a_pool_that_takes_no_flight_yet_is_waited_for(plan, tmp_path):
    assert fly(plan, tmp_path, pool=NoRoomYet()) is End.FLOWN
    assert table(tmp_path).num_rows == 50


def test_a_folder_in_which_another_program_flies_is_refused(plan, tmp_path):
    with hold(tmp_path), pytest.raises(InputError, match="another program flies a campaign there"):
        fly(plan, tmp_path)
    assert list(tmp_path.iterdir()) == []
    assert fly(plan, tmp_path) is End.FLOWN


class FaultyPool(HandPool):
    """A worker of it cannot fly."""

    def ended(self, timeout):
        yield from super().ended(timeout)
        if len(self.flown) > 10:
            raise WorkerError("worker 0: no space left")


def test_a_worker_that_cannot_fly_ends_it_and_it_can_be_gone_on_with(plan, tmp_path):
    pool, again = FaultyPool(), HandPool()
    with pytest.raises(InputError, match="no space left"):
        fly(plan, tmp_path, pool=pool)
    assert fly(plan, tmp_path, pool=again) is End.FLOWN
    assert sorted(pool.flown + again.flown) == list(range(50))


def test_an_aircraft_that_was_changed_makes_another_campaign(file, tmp_path):
    own = tmp_path / "own.toml"
    own.write_text(file.read_text())
    fly(campaign_plan(str(own), (), 5), tmp_path / "a", 2)
    check_folder(tmp_path / "a", campaign_plan(str(own), (), 5))
    copy = tmp_path / "aircraft" / "aerosonde"
    shutil.copytree(data_folder() / "aircraft" / "aerosonde", copy)
    check_folder(tmp_path / "a", campaign_plan(str(own), (), 5))
    with (copy / "aerosonde.toml").open("a") as text:
        text.write("\n")
    with pytest.raises(InputError, match="aircraft_sha256"):
        check_folder(tmp_path / "a", campaign_plan(str(own), (), 5))


def test_workers_find_the_aircraft_beside_a_link_to_a_scenario(file, tmp_path):
    link = tmp_path / "link.toml"
    link.symlink_to(file)
    own = tmp_path / "aircraft"
    shutil.copytree(data_folder() / "aircraft" / "aerosonde", own / "aerosonde")
    job = campaign_plan(str(link), (), 5).job(0)
    assert load_scenario(job.scenario).files["aerosonde"].root == own


def test_what_is_drawn_cannot_be_set(file):
    for text in ("wind.speed_mps=3", "vehicle[0].heading_deg=3"):
        with pytest.raises(InputError, match="drawn for each flight"):
            campaign_plan(str(file), (text,), None)


def test_a_path_that_no_table_can_hold_is_refused(file):
    odd = file.with_name("\udcff.toml")
    odd.write_text(file.read_text())
    with pytest.raises(InputError, match="not valid UTF-8"):
        campaign_plan(str(odd), (), None)


@pytest.mark.parametrize(
    ("text", "why"),
    [
        ("rate(verdict == 3) < 0.1 @ 0.95", "cannot be compared with"),
        ("rate(miss_m == good) < 0.1 @ 0.95", "cannot be compared with"),
        ("rate(wind.speed_mps == good) < 0.1 @ 0.95", "cannot be compared with"),
        ("rate(verdict == faild) < 0.1 @ 0.95", "did you mean failed?"),
    ],
)
def test_a_value_that_the_column_cannot_have_is_told_before_the_first_flight(plan, text, why):
    with pytest.raises(InputError, match=why):
        condition_on(text, plan)
    condition_on("rate(verdict == failed) < 0.1 @ 0.95", plan)
    condition_on("rate(reached == false) < 0.1 @ 0.95", plan)


def test_a_folder_may_be_called_as_a_column(plan, tmp_path):
    folder = tmp_path / "seed=3"
    fly(plan, folder, 25)
    assert summarize(folder, plan, 25, Looks(None)).flown == 25
    assert read_flown(folder).columns.column("seed").to_pylist() == [
        plan.job(index).draw.seed for index in range(25)
    ]


def test_an_identity_that_is_no_text_is_refused(plan, tmp_path):
    (tmp_path / IDENTITY_FILE).write_bytes(b"\xff\xfe")
    with pytest.raises(InputError, match=r"campaign\.json is none of this program's"):
        check_folder(tmp_path, plan)


def test_a_summary_that_cannot_be_written_is_told(plan, tmp_path, monkeypatch):
    fly(plan, tmp_path, 2)

    def full(*_):
        raise OSError(28, "No space left on device")

    monkeypatch.setattr(summary_module, "write_atomically", full)
    with pytest.raises(InputError, match=r"cannot be read or written: .*No space left"):
        summarize(tmp_path, plan, 2, Looks(None))
