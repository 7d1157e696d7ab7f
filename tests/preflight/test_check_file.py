"""A file by itself: `vfguide check`."""

from pathlib import Path

import pytest

from vfguide.files.aircraft_file import load_aircraft
from vfguide.files.data import AircraftFiles, find_aircraft
from vfguide.files.errors import InputError
from vfguide.preflight.load import check_file

SHIPPED = find_aircraft("aerosonde")


def test_a_good_aircraft_file_has_no_warnings() -> None:
    assert check_file(SHIPPED.performance) == ()


def test_a_bad_aircraft_file_is_refused_as_where_it_is_flown(tmp_path: Path) -> None:
    file = tmp_path / "aerosonde.toml"
    file.write_text(SHIPPED.performance.read_text().replace("trim = 0.30", "trim = nan"))
    with pytest.raises(InputError) as flown:
        load_aircraft(AircraftFiles("aerosonde", tmp_path, file, None))
    with pytest.raises(InputError) as checked:
        check_file(file)
    assert str(checked.value) == str(flown.value)


def test_what_is_no_file_cannot_be_read(tmp_path: Path) -> None:
    with pytest.raises(InputError) as error:
        check_file(tmp_path)
    assert str(error.value) == f"{tmp_path}: cannot be read: Is a directory"
