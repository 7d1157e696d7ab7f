"""`vfguide campaign --compare A B` as a user types it."""

import json

import pytest
from campaign_folders import VARY, campaign_folder, command, sample_row
from commands import vfguide

from vfguide.campaign.draws import draw
from vfguide.campaign.rows import failed_row

TWO_FORMS = "allowed is SCENARIO --runs N with its options, or --compare A B, with --out at most"

GOOD = [index for index in range(30) if sample_row(draw(7, index, VARY)).verdict == "good"]
"""The flights of the first campaign that changed sides, all of which fail in the second."""


def failing(drawn):
    return failed_row(drawn, "no \x1b[31mengine", "w", "k")


@pytest.fixture(scope="module")
def place(tmp_path_factory):
    root = tmp_path_factory.mktemp("campaigns")
    campaign_folder(root / "a", 40)
    changed = {"version": "1.2.4", "sha256": "cd" * 32, "set": []}
    campaign_folder(root / "b", 30, failing, **changed)
    campaign_folder(root / "same", 40, sample_row)
    return root


@pytest.fixture(scope="module")
def done(place):
    return vfguide("campaign", "--compare", "a", "b", cwd=place)


def test_it_says_what_is_compared(done):
    assert (done.returncode, done.stderr) == (0, "")
    lines = done.stdout.splitlines()
    assert lines[:6] == [
        "A: a, 40 flights of windy.toml, vfguide 1.2.3",
        "B: b, 30 flights of windy.toml, vfguide 1.2.4",
        'version: "1.2.3" in A, "1.2.4" in B',
        "the scenario files differ",
        'set: ["wind.turbulence=light"] in A, [] in B',
        "flights in pairs: 30; intervals have a confidence of 95 %",
    ]


def test_it_prints_the_rates_and_which_flights_changed_sides(done):
    (good,) = (line for line in done.stdout.splitlines() if line.startswith("│ good"))
    cells = [each.strip() for each in good.strip("│").split("│")]
    assert cells[:4] == ["good", f"{len(GOOD) / 30:.2%}", "0.00%", f"{-len(GOOD) / 30:.2%}"]
    assert cells[6:] == [str(len(GOOD)), "0"]
    assert (
        f"flights that changed sides: {len(GOOD)}; good in A alone {len(GOOD)}, in B" in done.stdout
    )
    assert done.stdout.count("  A: good\n") == 20
    assert f"{len(GOOD) - 20} more: --out DIR writes all into DIR/compare.json" in done.stdout


def test_what_a_reason_holds_cannot_steer_the_terminal(done):
    assert "  B: failed: no \\x1b[31mengine\n" in done.stdout
    assert "\x1b" not in done.stdout


def test_figures_that_no_pair_has_are_left_out(done):
    assert "miss_m" not in done.stdout
    assert "goals_reached" in done.stdout


def test_the_file_has_all_flights_that_changed_sides(place):
    done = vfguide("campaign", "--compare", "a", "b", "--out", "c", cwd=place)
    assert done.returncode == 0
    told = json.loads((place / "c" / "compare.json").read_text())
    assert [each["index"] for each in told["changed"]] == GOOD
    for each in told["changed"]:
        drawn = draw(7, each["index"], VARY)
        assert each["seed"] == drawn.seed
        assert each["a"]["command"] == command(drawn)


def test_the_same_campaign_twice(place):
    done = vfguide("campaign", "--compare", "a", "same", cwd=place)
    assert done.returncode == 0
    assert "version, scenario and --set are the same\n" in done.stdout
    assert "flights that changed sides: 0;" in done.stdout
    lines = done.stdout.splitlines()
    (miss,) = (place for place, line in enumerate(lines) if line.startswith("│ miss_m"))
    assert lines[miss + 1].count("0 to 0") == 2


@pytest.mark.parametrize(
    ("arguments", "message"),
    [
        ((), f"campaign: {TWO_FORMS}"),
        (("x.toml",), f"campaign: {TWO_FORMS}"),
        (("--runs", "3"), f"campaign: {TWO_FORMS}"),
        (("--compare", "a", "b", "--runs", "3"), f"--compare a b: {TWO_FORMS}"),
        (("--compare", "a", "b", "--set", "x=1"), f"--compare a b: {TWO_FORMS}"),
        (("x.toml", "--compare", "a", "b"), f"--compare a b: {TWO_FORMS}"),
        (
            ("--compare", "a", "none"),
            "none: no campaign.json; allowed is the folder of a campaign",
        ),
    ],
)
def test_what_is_not_allowed_is_one_message(place, arguments, message):
    done = vfguide("campaign", *arguments, cwd=place)
    assert (done.returncode, done.stdout, done.stderr) == (2, "", f"vfguide: {message}\n")
