"""Two campaigns that were flown in pairs, from folders whose rows are made by hand."""

import json
from dataclasses import replace

import numpy as np
import pyarrow as pa
import pyarrow.parquet as pq
import pytest
from campaign_folders import VARY, campaign_folder, command, sample_row

from vfguide.campaign.campaign import IDENTITY_FILE
from vfguide.campaign.draws import draw
from vfguide.campaign.pairs import paired_difference, rate_difference
from vfguide.campaign.results.comparison import (
    BOOTSTRAP_SEED,
    COMPARISON,
    compare,
    write_comparison,
)
from vfguide.campaign.results.pairing import read_pairs
from vfguide.campaign.rows import failed_row
from vfguide.campaign.table import TABLE
from vfguide.files.errors import InputError
from vfguide.files.vary import Uniform

NUMBER = 40
SHRUNK = 0.9
"""What the second campaign leaves of a miss."""


def other_row(drawn):
    """Misses less, but fails in flight 5, and does not in flight 13."""
    if drawn.index == 5:
        return failed_row(drawn, "no engine", "w2", "Kind A")
    row = sample_row(replace(drawn, index=0) if drawn.index == 13 else drawn)
    miss = None if row.miss_m is None else SHRUNK * row.miss_m
    return replace(row, index=drawn.index, miss_m=miss)


@pytest.fixture(scope="module")
def folders(tmp_path_factory):
    root = tmp_path_factory.mktemp("campaigns")
    first = campaign_folder(root / "a", NUMBER)
    return first, campaign_folder(root / "b", NUMBER + 5, other_row, version="1.2.4")


@pytest.fixture(scope="module")
def comparison(folders):
    return compare(read_pairs(*folders))


def test_flights_of_both_are_paired(comparison):
    assert (comparison.a.flights, comparison.b.flights, comparison.pairs) == (40, 45, 40)
    assert comparison.a.campaign["version"] == "1.2.3"
    assert comparison.b.campaign["version"] == "1.2.4"


def test_rates_and_their_difference(comparison):
    good, reached, failed = comparison.rates
    assert [each.name for each in comparison.rates] == ["good", "reached", "failed"]
    assert (good.a.count, good.b.count, good.only_a, good.only_b) == (31, 31, 1, 1)
    assert (good.difference, good.interval) == (0.0, rate_difference(1, 1, 40, 0.95).interval)
    assert (reached.only_a, reached.only_b) == (1, 1)
    assert (failed.a.count, failed.b.count, failed.only_a, failed.only_b) == (4, 4, 1, 1)


def test_figures_of_the_pairs_in_which_both_have_it(comparison, folders):
    miss = next(each for each in comparison.figures if each.column == "miss_m")
    first, second = (pq.read_table(each / TABLE).column("miss_m").to_numpy() for each in folders)
    both = ~np.isnan(first) & ~np.isnan(second[:NUMBER])
    a, b = first[both], second[:NUMBER][both]
    assert miss.pairs == both.sum() == 35
    assert (miss.median_a.value, miss.median_b.value) == (sorted(a)[17], sorted(b)[17])
    assert miss.mean_difference.value == pytest.approx((b - a).mean())
    assert miss.median_difference.value == sorted(b - a)[17]
    found = paired_difference(a, b, 0.95, np.random.default_rng(BOOTSTRAP_SEED))
    assert miss.mean_difference.interval == found.mean.interval
    assert miss.median_difference.interval == found.median.interval


def test_what_varies_and_what_cannot_be_repeated_is_not_compared(comparison):
    names = {each.column for each in comparison.figures}
    assert names == {"goals_reached", "miss_m", "course_error_deg", "max_bank_deg", "sim_s"}


def test_flights_that_changed_sides(comparison):
    lost, gained = comparison.changed
    assert (lost.index, lost.a.verdict, lost.b.verdict) == (5, "good", "failed")
    assert lost.b.reasons == ("no engine",)
    assert (gained.index, gained.a.verdict, gained.b.verdict) == (13, "failed", "good")
    assert gained.a.reasons == ("worker: <b>lost</b> & gone",)
    for flight in comparison.changed:
        drawn = draw(7, flight.index, VARY)
        assert flight.seed == drawn.seed
        assert flight.a.command == flight.b.command == command(drawn)


def test_a_campaign_compared_with_itself_does_not_differ(folders):
    same = compare(read_pairs(folders[0], folders[0]))
    assert same.changed == ()
    assert all(each.difference == 0.0 for each in same.rates)
    assert all(each.mean_difference.value == 0.0 for each in same.figures)


def test_the_file_has_all_of_it(comparison, tmp_path):
    write_comparison(tmp_path / "new" / "out", comparison)
    told = json.loads((tmp_path / "new" / "out" / COMPARISON).read_text())
    assert told["pairs"] == 40
    assert [each["index"] for each in told["changed"]] == [5, 13]
    assert told["b"]["campaign"]["version"] == "1.2.4"
    assert told["rates"][0]["only_a"] == 1


def refused(first, second):
    """The message with which a comparison is refused."""
    with pytest.raises(InputError) as error:
        compare(read_pairs(first, second))
    return str(error.value)


def test_other_seeds_are_told(folders, tmp_path):
    other = campaign_folder(tmp_path / "b", 3, seed=8)
    here, there = (draw(seed, 0, VARY).seed for seed in (7, 8))
    message = refused(folders[0], other)
    assert f"flight 0: seed = {here} in {folders[0]}, {there} in {other}" in message
    assert "allowed are campaigns with the same --seed and the same [vary]" in message


def test_other_drawn_values_are_told(folders, tmp_path):
    vary = {**VARY, "wind.speed_mps": Uniform(2.0, 13.0)}
    message = refused(folders[0], campaign_folder(tmp_path / "b", 3, vary=vary))
    assert "flight 0: wind.speed_mps = " in message


@pytest.mark.parametrize("is_swapped", [False, True])
def test_another_key_that_varies_is_told(folders, tmp_path, is_swapped):
    vary = {"wind.speed_mps": VARY["wind.speed_mps"]}
    both = [folders[0], campaign_folder(tmp_path / "b", 3, vary=vary)]
    message = refused(*(reversed(both) if is_swapped else both))
    assert f"vehicles.0.airspeed_mps varies in {folders[0]} alone" in message


def test_an_empty_campaign_is_told(folders, tmp_path):
    empty = campaign_folder(tmp_path / "b", 0)
    assert refused(folders[0], empty) == f"{empty}: the campaign has no flight yet"


def damaged(folder, name, content):
    """A folder with one file that is not as it should be; None: it is not there."""
    campaign_folder(folder, 3)
    (folder / name).unlink()
    if content is not None:
        (folder / name).write_bytes(content)
    return folder


@pytest.mark.parametrize(
    ("name", "content", "why"),
    [
        (IDENTITY_FILE, None, r"no campaign\.json; allowed is the folder of a campaign"),
        (IDENTITY_FILE, b"{", "cannot be read"),
        (IDENTITY_FILE, b"\xff", "cannot be read"),
        (IDENTITY_FILE, b"[]", "none of this program's"),
        (TABLE, None, r"no results\.parquet; allowed is the folder of a campaign"),
        (TABLE, b"", "cannot be read"),
        (TABLE, b"PAR1 and what is none PAR1", "cannot be read"),
    ],
)
def test_a_folder_without_a_campaign_is_told(folders, tmp_path, name, content, why):
    other = damaged(tmp_path / "b", name, content)
    with pytest.raises(InputError, match=why):
        read_pairs(other, folders[0])
    with pytest.raises(InputError, match=why):
        read_pairs(folders[0], other)


def test_a_folder_that_is_none_is_told(folders, tmp_path):
    assert refused(folders[0], tmp_path / "b").startswith(f"{tmp_path / 'b'}: no campaign.json")


def test_a_table_that_was_cut_is_told(folders, tmp_path):
    whole = (folders[0] / TABLE).read_bytes()
    other = damaged(tmp_path / "b", TABLE, whole[: len(whole) // 2])
    assert "cannot be read" in refused(folders[0], other)


def test_a_table_whose_words_are_damaged_is_told(folders, tmp_path):
    path = folders[0] / TABLE
    metadata = pq.ParquetFile(path).metadata.row_group(0)
    columns = [metadata.column(place) for place in range(metadata.num_columns)]
    broken = next(each for each in columns if each.path_in_schema == "command")
    content = bytearray(path.read_bytes())
    first = broken.dictionary_page_offset or broken.data_page_offset
    content[first : first + broken.total_compressed_size] = bytes(broken.total_compressed_size)
    other = damaged(tmp_path / "b", TABLE, bytes(content))
    campaign_folder(tmp_path / "c", 3, lambda drawn: failed_row(drawn, "no", "w", "k"))
    assert "cannot be read" in refused(tmp_path / "c", other)


@pytest.mark.parametrize("change", ["missing", "another type"])
def test_a_table_of_something_else_is_told(folders, tmp_path, change):
    other = campaign_folder(tmp_path / "b", 3)
    table = pq.read_table(other / TABLE)
    place = table.column_names.index("verdict")
    table = table.remove_column(place)
    if change == "another type":
        table = table.add_column(place, "verdict", pa.array([1, 2, 3]))
    pq.write_table(table, other / TABLE)
    assert "no column verdict of type string" in refused(folders[0], other)


def test_a_comparison_that_cannot_be_written_is_told(comparison, tmp_path):
    (tmp_path / "out").write_text("")
    with pytest.raises(InputError, match=r"--out .*: cannot be written"):
        write_comparison(tmp_path / "out", comparison)
