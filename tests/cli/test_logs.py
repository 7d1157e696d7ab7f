"""A log beside the work of a command is a new file."""

import re

import pytest

from vfguide.cli.logs import new_log
from vfguide.files.errors import InputError


def test_a_new_log_is_made_with_its_folder(tmp_path):
    path = tmp_path / "new" / "flight.tlog"
    new_log(path).close()
    assert path.read_bytes() == b""


def test_a_log_that_is_there_already_stays_as_it_is(tmp_path):
    path = tmp_path / "flight.tlog"
    path.write_text("kept")
    with pytest.raises(InputError, match=re.escape(f"--log {path}: already there")):
        new_log(path)
    assert path.read_text() == "kept"


def test_a_log_below_a_file_is_refused(tmp_path):
    (tmp_path / "file").touch()
    with pytest.raises(InputError, match=r"--log .*file: cannot be made: File exists"):
        new_log(tmp_path / "file" / "flight.tlog")
