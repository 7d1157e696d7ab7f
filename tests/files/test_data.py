"""Where scenarios and aircraft are found."""

import errno
import os
from collections.abc import Callable
from pathlib import Path

import pytest

from vfguide.files.data import data_folder, find_aircraft, find_scenario, shipped_scenarios
from vfguide.files.errors import InputError
from vfguide.files.looked_for import is_file, is_there


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


LONG = "y" * 300
"""No file system of Linux has names of more than 255 bytes."""


@pytest.mark.parametrize("name", [LONG, f"{LONG}.toml", f"./{LONG}/y.toml"])
def test_a_scenario_that_cannot_be_looked_for(name: str) -> None:
    with pytest.raises(InputError, match=r"^y+\.\.\.: cannot be looked for: File name too long$"):
        find_scenario(name)


def test_an_aircraft_that_cannot_be_looked_for(tmp_path: Path) -> None:
    with pytest.raises(InputError, match="cannot be looked for: File name too long"):
        find_aircraft(LONG, beside=tmp_path / "x.toml")


@pytest.mark.parametrize("ask", [is_file, is_there])
@pytest.mark.parametrize("number", [errno.EACCES, errno.ENAMETOOLONG, errno.EIO, errno.ESTALE])
def test_whatever_the_system_refuses_is_bad_input(
    monkeypatch: pytest.MonkeyPatch, ask: Callable[[Path], bool], number: int
) -> None:
    def refuse(*_: object, **__: object) -> None:
        raise OSError(number, os.strerror(number))

    monkeypatch.setattr(Path, "stat", refuse)
    with pytest.raises(InputError, match=rf"^here\.toml: cannot be .*: {os.strerror(number)}$"):
        ask(Path("here.toml"))


@pytest.mark.parametrize("ask", [is_file, is_there])
def test_what_is_not_there_is_no_error(tmp_path: Path, ask: Callable[[Path], bool]) -> None:
    (tmp_path / "loop").symlink_to(tmp_path / "loop")
    (tmp_path / "file").touch()
    for name in ("nothing", "loop", "file/below", "a\0b"):
        assert not ask(tmp_path / name)
    assert ask(tmp_path / "file")


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
