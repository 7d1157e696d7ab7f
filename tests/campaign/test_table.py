"""The table of a campaign: whole at any moment, in order, nothing lost and nothing twice."""

import json
import random

import pyarrow as pa
import pyarrow.parquet as pq
import pytest
from campaign_rows import flown_row
from hypothesis import given, settings
from hypothesis import strategies as st

from vfguide.campaign import table as module
from vfguide.campaign.draws import draw
from vfguide.campaign.rows import columns_of
from vfguide.campaign.schema import schema_of
from vfguide.campaign.table import JOURNAL, TABLE, CampaignTable, line_of

SCHEMA = schema_of([])


def columns(index):
    drawn = draw(1, index, {})
    return columns_of(flown_row(drawn), drawn, f"fly {index}")


def written(folder):
    return pq.read_table(folder / TABLE).column("index").to_pylist()


def kept(folder):
    return sorted(written(folder) + [row["index"] for row in module.journal(folder / JOURNAL)])


def kill(table):
    """Whatever a program has not done yet when it is killed is not done."""
    table._journal.close()


@settings(max_examples=10, deadline=None)
@given(st.permutations(range(60)), st.sets(st.integers(0, 59), max_size=5))
def test_any_order_any_number_of_restarts(tmp_path_factory, order, restarts):
    folder, flown = tmp_path_factory.mktemp("table"), []
    table = CampaignTable(folder, SCHEMA)
    for count, index in enumerate(order):
        if count in restarts:
            kill(table)
            assert kept(folder) == sorted(order[:count])
            table = CampaignTable(folder, SCHEMA)
            assert table.number == count
        flown += [row["index"] for row in table.add(columns(index))]
        assert table.whole == len(flown)
        if count % 10 == 0:
            assert written(folder) == list(range(len(written(folder))))
    assert flown == list(range(60))
    table.close()
    assert written(folder) == list(range(60))
    assert [row["command"] for row in table.rows()] == [f"fly {index}" for index in range(60)]


def test_the_file_is_readable_from_the_first_moment(tmp_path):
    kill(CampaignTable(tmp_path, SCHEMA))
    assert pq.read_table(tmp_path / TABLE).schema.equals(SCHEMA)
    assert written(tmp_path) == []


def test_a_line_that_was_cut_is_no_flight(tmp_path):
    line = line_of(columns(0))
    for cut in random.Random(1).sample(range(1, len(line) - 1), 20):
        (tmp_path / JOURNAL).write_text(line_of(columns(1)) + line[:cut])
        with CampaignTable(tmp_path, SCHEMA) as table:
            assert not table.has(0)
            assert table.has(1)


def test_killed_between_file_and_journal(tmp_path):
    """The Parquet file was written, what it holds is in the journal still."""
    with CampaignTable(tmp_path, SCHEMA) as table:
        for index in range(30):
            table.add(columns(index))
    (tmp_path / JOURNAL).write_text("".join(line_of(columns(index)) for index in range(25, 32)))
    with CampaignTable(tmp_path, SCHEMA) as table:
        assert table.number == 32
    assert written(tmp_path) == list(range(32))


def test_a_failed_writing_loses_nothing(tmp_path, monkeypatch):
    table = CampaignTable(tmp_path, SCHEMA)
    for index in range(10):
        table.add(columns(index))

    def full(*_, **__):
        raise OSError(28, "No space left on device")

    with monkeypatch.context() as patch:
        patch.setattr(module.pq.ParquetWriter, "write_batch", full)
        with pytest.raises(OSError, match="No space"):
            table.close()
    assert sorted(path.name for path in tmp_path.iterdir()) == [JOURNAL, TABLE]
    assert kept(tmp_path) == list(range(10))
    with CampaignTable(tmp_path, SCHEMA) as again:
        assert again.number == 10


def test_other_columns_are_refused(tmp_path):
    CampaignTable(tmp_path, schema_of(["wind.speed_mps"])).close()
    with pytest.raises(pa.ArrowInvalid, match="other columns"):
        CampaignTable(tmp_path, SCHEMA)


def test_a_damaged_file_is_refused(tmp_path):
    (tmp_path / TABLE).write_bytes(b"PAR1 and nothing more")
    with pytest.raises(pa.ArrowInvalid):
        CampaignTable(tmp_path, SCHEMA)


def test_the_first_flights_alone(tmp_path):
    with CampaignTable(tmp_path, SCHEMA) as table:
        for index in [*range(50), 60, 61]:
            table.add(columns(index))
        table.cut(40)
        assert table.number == 40
        assert not table.has(60)
    assert written(tmp_path) == list(range(40))
    assert (tmp_path / JOURNAL).read_text() == ""
    with CampaignTable(tmp_path, SCHEMA) as table:
        table.add(columns(40))
    assert written(tmp_path) == list(range(41))


def test_few_flights_wait_in_memory(tmp_path):
    """However many were flown."""
    with CampaignTable(tmp_path, SCHEMA) as table:
        row, most = columns(0), 0
        for index in range(12_000):
            table.add({**row, "index": index})
            most = max(most, len(table._ready))
    assert most <= module.LARGEST_GROUP
    assert len(written(tmp_path)) == 12_000


def test_lines_are_strict_json():
    assert json.loads(line_of(columns(0)))["index"] == 0
    with pytest.raises(ValueError, match="not JSON compliant"):
        line_of({"miss_m": float("nan")})


def test_lines_that_are_no_flight_are_passed_over(tmp_path):
    whole = [line_of(columns(index)).encode() for index in (0, 1)]
    odd = [line_of({**columns(2), "index": index}).encode() for index in (-1, "2", 2.5, True, None)]
    others = [b"\xff\xfe\n", b"[" * 100_000 + b"\n", b"[]\n", b'{"index": 2}\n', bytes(100) + b"\n"]
    (tmp_path / JOURNAL).write_bytes(b"".join([whole[0], *odd, *others, whole[1], whole[1]]))
    with CampaignTable(tmp_path, SCHEMA) as table:
        assert table.number == 2
    assert written(tmp_path) == [0, 1]


def test_what_a_killed_program_has_half_written_is_removed(tmp_path):
    half = tmp_path / f".{TABLE}.4711"
    half.write_bytes(b"PAR1")
    CampaignTable(tmp_path, SCHEMA).close()
    assert not half.exists()


@pytest.mark.parametrize(
    "change",
    [
        {"miss_m": "wide"},
        {"seed": 2**70},
        {"index": 2**70},
        {"verdict": None},
        {"verdict": "odd"},
        {"reasons": 3},
        {"vehicles": 3},
        {"reached": 1},
    ],
)
def test_a_flight_that_no_column_can_hold_is_flown_again(tmp_path, change):
    """A journal that was changed by hand does not keep a campaign from going on."""
    odd = {**columns(0), **change}
    (tmp_path / JOURNAL).write_text(line_of(odd) + line_of(columns(1)))
    with CampaignTable(tmp_path, SCHEMA) as table:
        assert table.number == 1
        table.add(columns(0))
    assert written(tmp_path) == [0, 1]
