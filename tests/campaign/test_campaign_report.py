"""The report of a campaign, from folders whose rows are made by hand."""

import re
from dataclasses import replace
from html.parser import HTMLParser
from pathlib import Path

import numpy as np
import pyarrow.parquet as pq
import pytest
from campaign_folders import VARY, campaign_folder, command, near_obstacle, sample_row

from vfguide.campaign.draws import draw
from vfguide.campaign.intervals import Interval
from vfguide.campaign.results.figures import Shown, bars_between, campaign_pictures
from vfguide.campaign.results.flown import read_flown
from vfguide.campaign.results.report import REPORT, render, write_report
from vfguide.campaign.results.worst import CLEARANCE, MISS, SHOWN, worst_figure, worst_first
from vfguide.campaign.rows import failed_row
from vfguide.campaign.summary import Summary, UntilSummary, figures_of, rates_of
from vfguide.campaign.table import TABLE
from vfguide.files.errors import InputError
from vfguide.files.vary import Uniform

pytestmark = pytest.mark.slow

NUMBER = 40


class Page(HTMLParser):
    """What a page refers to, the tags that are open, and its text."""

    def __init__(self, text: str) -> None:
        super().__init__()
        self.open: list[str] = []
        self.references: list[str] = []
        self.words: list[str] = []
        self.feed(text)
        self.close()
        self.text = " ".join(" ".join(self.words).split())

    def handle_starttag(self, tag, attrs):
        if tag not in {"meta", "img", "wbr", "br"}:
            self.open.append(tag)
        self.references += [value or "" for key, value in attrs if key in {"src", "href", "data"}]

    def handle_endtag(self, tag):
        assert self.open.pop() == tag

    def handle_data(self, data):
        self.words.append(data)


def summary_of(folder: Path, **changes: object) -> Summary:
    flights = pq.read_table(folder / TABLE)
    made = Summary(
        "windy <i>name</i>",
        "1.2.3",
        7,
        NUMBER + 2,
        flights.num_rows,
        tuple(rates_of(flights)),
        tuple(figures_of(flights)),
        ("Kind A",),
        None,
    )
    return replace(made, **changes)


@pytest.fixture(scope="module")
def folder(tmp_path_factory):
    return campaign_folder(tmp_path_factory.mktemp("campaigns") / "a", NUMBER)


@pytest.fixture(scope="module")
def source(folder):
    write_report(folder, summary_of(folder))
    return (folder / REPORT).read_text()


@pytest.fixture(scope="module")
def page(source):
    return Page(source)


def test_it_needs_nothing_beside_it(source, page):
    assert page.open == []
    assert len(page.references) == 2
    assert all(each.startswith("data:image/png;base64,") for each in page.references)
    assert not re.search(r"<script|url\(|@import|https?://", source)


def test_names_and_reasons_are_no_markup(source, page):
    assert "<b>lost" not in source
    assert "<i>" not in source
    assert "worker: <b>lost</b> & gone" in page.text
    assert "windy <i>name</i>" in page.text


def test_the_head_says_what_was_flown(page):
    assert "vfguide 1.2.3 · seed 7 · 40 of 42 flights flown · Kind A" in page.text


def test_rates_have_their_exact_intervals(page):
    assert "Good 77.50 % 31 of 40; 61.55 % to 89.16 %" in page.text  # scipy.stats.binomtest
    assert "Failed 10.00 % 4 of 40; 2.79 % to 23.66 %" in page.text  # the same


def test_the_worst_flights_come_with_the_commands_that_fly_them(folder, page):
    flown = read_flown(folder)
    order = worst_first(flown, worst_figure(flown))
    listed = [int(each) for each in re.findall(r"Flight (\d+), (?:failed|bad|good)", page.text)]
    assert listed == order[:SHOWN].tolist()
    for index in listed:
        assert command(draw(7, index, VARY)) in page.text
    assert "of results.parquet has the command of every flight" in page.text


def test_few_flights_are_said_to_be_too_few(page):
    row = page.text[page.text.index("miss_m 36 4 without") : page.text.index("course_error_deg 36")]
    assert row.count("too few") == 4  # 1, 5, 95 and 99 %: 0.95^36 is above 0.025, 0.75^36 below


def test_one_kind_of_processor_needs_no_warning(page):
    assert "More than one kind of processor" not in page.text


def test_a_mixed_cluster_is_told_of(folder):
    text = render(summary_of(folder, processors=("Kind A", "Kind B")), read_flown(folder))
    assert "the bytes of a flight are the same on one kind only" in Page(text).text


@pytest.mark.parametrize(
    ("is_met", "words"), [(True, "Met."), (False, "Not met."), (None, "Not known well enough")]
)
def test_the_condition_and_what_is_known_of_it(folder, is_met, words):
    until = UntilSummary("rate(miss_m > 2) < 0.01 @ 0.9", 3, 40, 0.075, Interval(0.01, 0.2), is_met)
    text = Page(render(summary_of(folder, until=until), read_flown(folder))).text
    assert "rate(miss_m > 2) < 0.01 @ 0.9" in text
    assert words in text
    assert "3 of the 40 flights that were looked at, 7.50 %" in text
    assert "within 1.00 % to 20.00 %" in text


def test_failed_flights_are_the_worst_then_bad_ones_then_by_the_figure(folder):
    flown = read_flown(folder)
    assert worst_figure(flown) == MISS
    order = worst_first(flown, MISS)
    verdicts = flown.verdicts[order].tolist()
    assert verdicts == ["failed"] * 4 + ["bad"] * 5 + ["good"] * 31
    misses = flown.values("miss_m")[order]
    assert (np.diff(misses[4:9]) <= 0.0).all()
    assert (np.diff(misses[9:]) <= 0.0).all()


def test_with_obstacles_the_least_clearance_is_the_worst(tmp_path):
    flown = read_flown(campaign_folder(tmp_path / "a", 20, near_obstacle))
    assert worst_figure(flown) == CLEARANCE
    clearances = flown.values("min_clearance_m")[worst_first(flown, CLEARANCE)]
    assert np.isnan(clearances[:2]).all()  # they failed
    assert (np.diff(clearances[2:]) >= 0.0).all()
    assert "by the least clearance" in render(summary_of(tmp_path / "a"), flown)


def test_without_what_varies_there_is_no_scatter(tmp_path):
    folder = campaign_folder(tmp_path / "a", 12, vary={})
    page = Page(render(summary_of(folder), read_flown(folder)))
    assert len(page.references) == 1
    assert "the flights differ in their seed alone" in page.text


def test_a_campaign_in_which_all_flights_failed(tmp_path):
    def failing(drawn):
        return failed_row(drawn, "no engine", "w", "Kind A")

    folder = campaign_folder(tmp_path / "a", 5, failing)
    page = Page(render(summary_of(folder), read_flown(folder)))
    assert "Failed 100.00 % 5 of 5" in page.text
    assert page.text.count("no engine") == 5
    assert len(page.references) == 1


def test_a_campaign_in_which_no_flight_failed(tmp_path):
    def flown(drawn):
        return sample_row(replace(drawn, index=0))

    folder = campaign_folder(
        tmp_path / "a", 20, lambda drawn: replace(flown(drawn), index=drawn.index)
    )
    page = Page(render(summary_of(folder), read_flown(folder)))  # matplotlib warns of no layout
    assert "Failed 0.00 % 0 of 20" in page.text
    assert len(page.references) == 2


def test_a_campaign_of_one_flight(tmp_path):
    folder = campaign_folder(tmp_path / "a", 1)
    assert Page(render(summary_of(folder), read_flown(folder))).open == []


def test_no_flight_no_report(tmp_path):
    folder = campaign_folder(tmp_path / "a", 0)
    write_report(folder, summary_of(folder))
    assert not (folder / REPORT).exists()


def test_a_report_that_cannot_be_written_is_told(tmp_path):
    folder = campaign_folder(tmp_path / "a", 2)
    (folder / REPORT).mkdir()
    with pytest.raises(InputError, match=r"report\.html: cannot be written"):
        write_report(folder, summary_of(folder))


def test_wide_misses_and_names_that_are_long_are_drawn(tmp_path):
    def wide(drawn):
        row = sample_row(drawn)
        return row if row.miss_m is None else replace(row, miss_m=10.0 ** (drawn.index % 7))

    vary = {**VARY, "vehicles.0.goals.0.a_very_long_name_of_a_key": Uniform(1.0, 1.0)}
    flown = read_flown(campaign_folder(tmp_path / "a", 15, wide, vary))
    pictures = campaign_pictures(Shown(flown, MISS, worst_first(flown, MISS)[:3]))
    assert all(each is not None and each.png.startswith(b"\x89PNG") for each in pictures)


def test_bars_leave_out_what_is_stray_and_keep_what_is_not():
    even = np.linspace(0.0, 1.0, 1000)
    assert bars_between(even) == (0.0, 1.0)
    low, high = bars_between(np.append(even, 1e6))
    assert low == 0.0
    assert high < 10.0
    assert bars_between(np.append(even, np.full(100, 50.0))) == (0.0, 50.0)
    assert bars_between(np.append(np.zeros(99), 7.0)) == (0.0, 7.0)


def test_long_columns_are_read_for_a_few_flights_alone(folder):
    flown = read_flown(folder)
    assert {"reasons", "command", "worker", "vehicles", "wall_s"}.isdisjoint(
        flown.columns.column_names
    )
    texts = flown.texts([13, 2])
    assert texts[13].reasons == ("worker: <b>lost</b> & gone",)
    assert texts[2].command == command(draw(7, 2, VARY))
