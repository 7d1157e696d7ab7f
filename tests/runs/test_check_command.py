"""`vfguide check`: what it prints."""

from pathlib import Path

from scenario_texts import MINIMAL, box
from typer.testing import CliRunner

from vfguide.cli.app import app


def test_check_prints_warnings_and_is_content(tmp_path: Path) -> None:
    file = tmp_path / "x.toml"
    file.write_text(MINIMAL + box([0, 15, -100], [20, 14, 300]))
    done = CliRunner().invoke(app, ["check", str(file)])
    assert done.exit_code == 0
    assert "warning: " in done.output
    assert "can be flown" in done.output
