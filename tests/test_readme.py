"""The commands of the README, of the first-flight page and of every --help, as written."""

import re
import shlex
import signal
from pathlib import Path

import pytest
from commands import vfguide, vfguide_alone
from page_numbers import blocks_of, rewritten, run_page
from pages import DOCS, README, ROOT
from programs import Program

pytestmark = pytest.mark.slow

PAGES = [README, DOCS / "first-flight.md"]
BROUGHT = {"points.csv": "x,y,z,vx,vy,vz,t\n-20,5,10,12,3,2,0\n"}
"""Files of their own that users need for the examples of --help."""
FOR_EVER = {"sim", "fly"}
"""Commands that end when they are told to."""


def lines_of(page: Path) -> list[str]:
    """The commands of a page that anybody can run."""
    blocks = [block for block in blocks_of(page.read_text()) if block.kind == "sh"]
    return [line for block in blocks if not block.mark for line in block.lines]


def help_of(*command: str) -> str:
    done = vfguide(*command, "--help", cwd=ROOT)
    assert done.returncode == 0
    return done.stdout


def examples() -> list[str]:
    """The examples of all commands, in the order of `vfguide --help`."""
    listed = help_of().partition("Commands:")[2]
    names = re.findall(r"^  (\w+)", listed, re.MULTILINE)
    assert {"run", "sim", "fly", "check", "replay", "bench"} <= set(names)
    found = []
    for name in names:
        example = re.search(r"Example:\s+(vfguide .*?)(?:\n\n|\Z)", help_of(name), re.DOTALL)
        assert example, f"no example in vfguide {name} --help"
        found.append(" ".join(example[1].split()))
    return found


def test_a_page_gives_only_commands_of_ours():
    for page in PAGES:
        assert lines_of(page)
        assert all(line.startswith("vfguide ") for line in lines_of(page))


@pytest.mark.parametrize("page", PAGES, ids=["readme", "first-flight"])
def test_commands_run_as_written_and_give_the_numbers_of_the_page(page, tmp_path):
    text = page.read_text()
    done = run_page(text, tmp_path)
    assert len(done) > 3
    for each in done:
        assert each.status == 0, f"{each.line}\n{each.printed}"
    assert rewritten(text, done, tmp_path) == text, "python tools/page_numbers.py --write"


def test_examples_of_the_help_run_as_written(tmp_path):
    for name, text in BROUGHT.items():
        (tmp_path / name).write_text(text)
    for line in examples():
        words = shlex.split(line)[1:]
        if words[0] not in FOR_EVER:
            done = vfguide_alone(*words, cwd=tmp_path)
            assert done.returncode == 0, f"{line}\n{done.stdout}{done.stderr}"


def test_simulator_and_companion_as_written(tmp_path):
    lines = {line for page in PAGES for line in lines_of(page)} | set(examples())
    (sim,) = [line for line in lines if line.startswith("vfguide sim ")]
    (fly,) = [line for line in lines if line.startswith("vfguide fly ")]
    with Program(*shlex.split(sim)[1:], cwd=tmp_path) as simulator:
        simulator.says("Ctrl-C ends it")
        with Program(*shlex.split(fly)[1:], cwd=tmp_path) as companion:
            companion.says("the autopilot follows")
            companion.send(signal.SIGINT)
            assert companion.status() == 0
        simulator.send(signal.SIGINT)
        assert simulator.status() == 0
    (log,) = tmp_path.glob("runs/*/vehicle-1.tlog")
    assert vfguide("replay", str(log), cwd=tmp_path).returncode == 0


def test_a_scenario_of_a_page_is_one(tmp_path):
    """Every complete scenario that is shown can be flown."""
    shown = [
        text
        for page in (README, *DOCS.glob("*.md"))
        for text in re.findall(r"^```toml\n(.*?)^```", page.read_text(), re.MULTILINE | re.DOTALL)
    ]
    assert shown
    for text in shown:
        (tmp_path / "shown.toml").write_text(text)
        done = vfguide("check", "shown.toml", cwd=tmp_path)
        assert done.returncode == 0, text + done.stderr
