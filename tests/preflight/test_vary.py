"""`[vary]`: what may be drawn and how; a plain run flies the written values."""

import pytest
from scenario_samples import loaded_from, message_for
from scenario_texts import MINIMAL

from vfguide.files.scenario_file import ScenarioFile
from vfguide.files.source import Source
from vfguide.files.vary import FORMS, Normal, Uniform


def varied(folder, text):
    file = folder / "x.toml"
    file.write_text(f"{MINIMAL}\n[vary]\n{text}\n")
    return Source(file).parse(ScenarioFile).vary


def test_both_distributions(tmp_path):
    text = '"wind.speed_mps" = [0, 8.5]\n"vehicle.0.heading_deg" = {mean = 10, std = 2.5}'
    assert varied(tmp_path, text) == {
        "wind.speed_mps": Uniform(0.0, 8.5),
        "vehicle.0.heading_deg": Normal(10.0, 2.5),
    }


def test_a_run_flies_the_written_values(tmp_path):
    plain = loaded_from(tmp_path, MINIMAL).scenario
    assert (
        loaded_from(tmp_path, f'{MINIMAL}\n[vary]\n"wind.speed_mps" = [3, 8]\n').scenario == plain
    )


@pytest.mark.parametrize(
    "value",
    [
        "[1.0]",
        "[1, 2, 3]",
        '["a", 2]',
        "[true, 2]",
        "[0, nan]",
        "[0, inf]",
        "3",
        '"light"',
        "{mean = 1}",
        "{mean = 1, std = -1}",
        "{mean = 1, std = 2, low = 3}",
        "{mean = nan, std = 1}",
        "[]",
        "{}",
        "[0, 1e301]",
        "{mean = 0, std = 1e308}",
        f"[0, 1{'0' * 400}]",
    ],
)
def test_other_forms_are_refused_by_name(tmp_path, value):
    message = message_for(tmp_path, f'{MINIMAL}\n[vary]\n"wind.speed_mps" = {value}\n')
    assert message.startswith("vary.wind.speed_mps")
    assert message.endswith(FORMS)


def test_a_range_upside_down(tmp_path):
    message = message_for(tmp_path, f'{MINIMAL}\n[vary]\n"wind.speed_mps" = [8, 0]\n')
    assert message == f"vary.wind.speed_mps = [8, 0]: upside down, {FORMS}"


@pytest.mark.parametrize("key", ["", "wind speed", ".wind", "wind.", "wind..speed_mps"])
def test_what_is_no_key(tmp_path, key):
    message = message_for(tmp_path, f'{MINIMAL}\n[vary]\n"{key}" = [0, 1]\n')
    assert f'"{key}" is no key' in message


def test_the_seed_is_the_campaigns(tmp_path):
    message = message_for(tmp_path, f"{MINIMAL}\n[vary]\nseed = [0, 1]\n")
    assert "the campaign gives every flight a seed of its own" in message


def test_a_key_that_is_not_quoted(tmp_path):
    message = message_for(tmp_path, f"{MINIMAL}\n[vary]\nwind.speed_mps = [0, 1]\n")
    assert message.startswith("vary.wind")
    assert message.endswith(FORMS)


@pytest.mark.parametrize("other", ["vehicle[0].heading_deg", "vehicle.00.heading_deg"])
def test_one_key_is_drawn_once(tmp_path, other):
    text = f'"vehicle.0.heading_deg" = [0, 1]\n"{other}" = [0, 1]'
    message = message_for(tmp_path, f"{MINIMAL}\n[vary]\n{text}\n")
    assert message.endswith(
        f'"{other}" and "vehicle.0.heading_deg" are the same key, allowed is one of them'
    )
