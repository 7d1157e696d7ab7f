"""Every block of every page is run, or says who runs it; numbers are what the commands give."""

import re
import subprocess

import page_numbers
import pytest
from page_numbers import PAGES, Done, StaleError, blocks_of, rewritten
from pages import ROOT

MARKS = {
    "set up": "CI",
    "checkout": "the test that it names",
    "by hand": "nobody, and it says why",
}
"""Who runs the commands of a block with a comment, by the beginning of the comment."""
MEASURED = re.compile(
    r"<!-- measured: (?P<command>[^;]+); \d{4}-\d\d-\d\d, (?P<commit>[0-9a-f]{7,}) -->"
)
TOOLS = re.compile(r"tools/(measure_(?!aircraft\b|turbulence\b)\w+|compare_laws)\.py")
"""Tools whose tables take long. Aircraft and turbulence have tests of their own that run them."""

BLOCKS = [
    (page, number, block)
    for page in PAGES
    for number, block in enumerate(blocks_of(page.read_text()))
]


def sections(text):
    """Parts of a page, each from a heading to the next."""
    return re.split(r"^(?=##? )", text, flags=re.MULTILINE)


def test_pages_have_blocks():
    assert len(BLOCKS) > 20
    fences = sum(len(re.findall(r"^ *```\w+$", page.read_text(), re.M)) for page in PAGES)
    assert len(BLOCKS) == fences


@pytest.mark.parametrize(
    "block", [pytest.param(block, id=f"{page.stem} {n}") for page, n, block in BLOCKS]
)
def test_every_block_is_run_or_says_who_runs_it(block):
    assert block.kind in ("sh", "text", "toml")
    if block.kind != "sh":
        return  # text: compared with what was printed; toml: checked as scenarios
    if not block.mark:
        assert all(line.startswith("vfguide ") for line in block.lines)
        return
    who, _, what = block.mark.partition(": ")
    assert who in MARKS
    assert what
    if who == "checkout":
        assert (ROOT / what).exists()


def test_text_follows_the_commands_that_print_it():
    for page in PAGES:
        kinds = [block.kind for block in blocks_of(page.read_text())]
        for before, kind in zip(["", *kinds], kinds, strict=False):
            assert kind != "text" or before == "sh", page


@pytest.mark.parametrize("page", PAGES, ids=lambda page: page.stem)
def test_long_measurements_say_command_date_and_commit(page):
    for part in sections(page.read_text()):
        bare = re.sub(r"<!--.*?-->", "", part, flags=re.S)
        named = {name for name in TOOLS.findall(bare) if page.stem != "contributing"}
        told = {
            name for found in MEASURED.finditer(part) for name in TOOLS.findall(found["command"])
        }
        assert named <= told, part.splitlines()[0]


def test_measurements_name_tools_and_commits_that_there_are():
    found = [match for page in PAGES for match in MEASURED.finditer(page.read_text())]
    assert len(found) >= 8
    assert len(found) == sum(page.read_text().count("<!-- measured:") for page in PAGES)
    for match in found:
        tool, *options = match["command"].split()[1:]
        source = (ROOT / tool).read_text()
        for option in options:
            assert not option.startswith("--") or f'"{option}"' in source, match[0]
        if (ROOT / ".git").exists() and not (ROOT / ".git" / "shallow").exists():
            git = ("git", "-c", "safe.directory=*")  # the checkout may be somebody else's
            known = [*git, "cat-file", "-e", f"{match['commit']}^{{commit}}"]
            assert subprocess.run(known, cwd=ROOT, check=False).returncode == 0, match[0]


PAGE = """
```sh
vfguide run x --out x
```

```text
| time 24.0 s |
verdict: good
flown in ... s
```

passed 24.0<!-- x/result.json goals.0.time_s .1f --> s
"""
PRINTED = "+--+\n|  time  23.9 s |\nverdict: good\n9.0 s flown in 0.3 s\nflown in 0.3 s\n"


@pytest.fixture
def folder(tmp_path):
    (tmp_path / "x").mkdir()
    (tmp_path / "x" / "result.json").write_text('{"goals": [{"time_s": 23.94}]}')
    return tmp_path


def test_numbers_of_before_are_written_anew(folder):
    now = rewritten(PAGE, [Done("vfguide run x --out x", 0, PRINTED)], folder)
    assert now == PAGE.replace("| time 24.0 s |", "|  time  23.9 s |").replace(
        "passed 24.0<", "passed 23.9<"
    )
    assert rewritten(now, [Done("vfguide run x --out x", 0, PRINTED)], folder) == now


@pytest.mark.parametrize(
    ("shown", "instead"),
    [("verdict: good", "verdict: bad"), ("goals.0", "goals.1"), ("x/result", "y/result")],
)
def test_what_nothing_gives_is_an_error(folder, shown, instead):
    with pytest.raises(StaleError):
        rewritten(PAGE.replace(shown, instead), [Done("vfguide run x --out x", 0, PRINTED)], folder)


def test_the_tool_has_a_page_to_write():
    assert [page.stem for page in PAGES if page_numbers.commands_of(page.read_text())] == [
        "README",
        "first-flight",
    ]
