"""Where scenarios and aircraft are found."""

from pathlib import Path

import pytest

from vfguide.files.data import data_folder, find_aircraft, find_scenario, shipped_scenarios
from vfguide.files.errors import InputError


def test_shipped_names() -> None:
    assert "first-flight" in shipped_scenarios()
    expected = data_folder() / "scenarios" / "first-flight.toml"
    assert find_scenario("first-flight") == find_scenario("first-flight.toml") == expected
    assert expected.is_file()


def test_a_path_comes_before_a_shipped_name(
    tmp_path: Path, monkeypatch: pytest.MonkeyPatch
) -> None:
    (tmp_path / "first-flight.toml").write_text("")
    monkeypatch.chdir(tmp_path)
    assert find_scenario("first-flight.toml") == Path("first-flight.toml")
    assert find_scenario("first-flight") == data_folder() / "scenarios" / "first-flight.toml"


@pytest.mark.parametrize(
    ("name", "hint"),
    [("first-fligt", ", did you mean first-flight?"), ("zzz", ""), ("", ""), ("..", "")],
)
def test_an_unknown_scenario(name: str, hint: str) -> None:
    with pytest.raises(InputError) as error:
        find_scenario(name)
    shipped = ", ".join(shipped_scenarios())
    expected = f"{name}: no such file and no shipped scenario{hint}; shipped: {shipped}"
    assert str(error.value) == expected


def test_shipped_aircraft() -> None:
    files = find_aircraft("aerosonde")
    assert files.root == data_folder() / "aircraft"
    assert files.performance == files.root / "aerosonde" / "aerosonde.toml"


@pytest.mark.parametrize("place", ["mine.toml", "mine/mine.toml"])
def test_own_aircraft_stand_beside_the_scenario(tmp_path: Path, place: str) -> None:
    performance = tmp_path / "aircraft" / place
    performance.parent.mkdir(parents=True)
    performance.write_text("")
    files = find_aircraft("mine", beside=tmp_path / "x.toml")
    assert (files.performance, files.model) == (performance, None)
    model = tmp_path / "aircraft" / "mine" / "mine.xml"
    model.parent.mkdir(exist_ok=True)
    model.write_text("")
    assert find_aircraft("mine", beside=tmp_path / "x.toml").model == model


def test_own_aircraft_come_before_shipped_ones(tmp_path: Path) -> None:
    performance = tmp_path / "aircraft" / "aerosonde.toml"
    performance.parent.mkdir()
    performance.write_text("")
    files = find_aircraft("aerosonde", beside=tmp_path / "x.toml")
    assert files.performance == performance
