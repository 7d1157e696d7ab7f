"""Where scenarios and aircraft are found."""

from pathlib import Path

import pytest
from flight_samples import MINIMAL, loaded_from

from vfguide.runs.models import require_models
from vfguide.scenario.data import data_folder, find_aircraft, find_scenario, shipped_scenarios
from vfguide.scenario.errors import InputError
from vfguide.scenario.load import check_file


def test_shipped_names() -> None:
    assert "first-flight" in shipped_scenarios()
    expected = data_folder() / "scenarios" / "first-flight.toml"
    assert find_scenario("first-flight") == find_scenario("first-flight.toml") == expected
    assert expected.is_file()


def test_a_path_comes_before_a_shipped_name(
    tmp_path: Path, monkeypatch: pytest.MonkeyPatch
) -> None:
    (tmp_path / "first-flight.toml").write_text(MINIMAL)
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


def test_what_is_no_file_cannot_be_read(tmp_path: Path) -> None:
    with pytest.raises(InputError) as error:
        check_file(tmp_path)
    assert str(error.value) == f"{tmp_path}: cannot be read: Is a directory"


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


def test_an_aircraft_without_a_model_cannot_be_simulated(tmp_path: Path) -> None:
    shipped = find_aircraft("aerosonde").performance.read_text()
    (tmp_path / "aircraft").mkdir()
    (tmp_path / "aircraft" / "aerosonde.toml").write_text(shipped)
    loaded = loaded_from(tmp_path)
    with pytest.raises(InputError) as error:
        require_models(loaded)
    missing = tmp_path / "aircraft" / "aerosonde" / "aerosonde.xml"
    expected = f"{missing}: no such file, the simulation of aerosonde needs it"
    assert str(error.value) == expected
