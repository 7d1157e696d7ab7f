"""The numbers of the pages, from what the commands on them give: checks them, or writes them anew.

    python tools/page_numbers.py [--write] [PAGE ...]

A page shows numbers of its own commands in two ways. After a block of commands a block `text` shows
lines of what they print; it may leave lines out, and stands for numbers of the machine with `...`.
And a number in a sentence is followed by where it comes from, in a comment that no reader sees:

    passed 23.9<!-- first/result.json vehicles.0.goals.0.time_s .1f --> s after the start

The commands run in an empty folder: FILE is one that they wrote, then come the key and the format.
"""

import argparse
import json
import os
import re
import shlex
import subprocess
import sys
import tempfile
import tomllib
from pathlib import Path
from typing import Any, NamedTuple

ROOT = Path(__file__).parent.parent
PAGES = (ROOT / "README.md", *sorted((ROOT / "docs").glob("*.md")))
"""Paths of all pages, the README first."""
BLOCK = re.compile(
    r"(?:^ *<!-- (?P<mark>[^>]*) -->\n+)?^ *```(?P<kind>\w*)\n(?P<text>.*?)^ *```$", re.M | re.S
)
"""Pattern of a fenced block with its kind, and with the comment before it."""
NUMBER = re.compile(r"(-?\d[\d,]*(?:\.\d+)?)<!-- (\S+\.(?:json|toml)) (\S+) (\S+) -->")
"""Pattern of a number in a sentence with the file that it is from, its key and its format."""
FIGURE = re.compile(r"-?\d+(?:\.\d+)?")
"""Pattern of a number in a line of output."""
SAVED = re.compile(r"Save it as `([^`]+)`:\n+```toml\n(.*?)^```", re.M | re.S)
"""Pattern of a file that the reader saves."""
FOR_EVER = ("vfguide sim", "vfguide fly")
"""Commands that end only when they are asked to."""
VFGUIDE = (sys.executable, "-c", "from vfguide.cli.main import main; main()")
"""Command that runs the program in the place of the page's `vfguide`."""


class Block(NamedTuple):
    """A fenced block of a page."""

    kind: str
    """Word after the fence: sh, text or toml."""
    mark: str
    """Comment before the block; empty: none."""
    lines: tuple[str, ...]


class Done(NamedTuple):
    """A command that was run."""

    line: str
    status: int
    printed: str
    """What it printed, errors included."""


class StaleError(Exception):
    """A page shows something that no command gives; the message says what."""


def blocks_of(text: str) -> list[Block]:
    """The fenced blocks of a page."""
    return [
        Block(found["kind"], found["mark"] or "", tuple(map(str.strip, found["text"].splitlines())))
        for found in BLOCK.finditer(text)
    ]


def commands_of(text: str) -> list[str]:
    """The commands of a page that anybody can run: those of blocks without a comment."""
    lines = [
        line
        for each in blocks_of(text)
        if each.kind == "sh" and not each.mark
        for line in each.lines
    ]
    return [line for line in lines if not line.startswith(FOR_EVER)]


def run_page(text: str, folder: Path) -> list[Done]:
    """Run the commands of a page in an empty folder, with the files that it has the reader save."""
    for name, saved in SAVED.findall(text):
        (folder / name).write_text(saved)
    return [run(line, folder) for line in commands_of(text)]


def run(line: str, folder: Path) -> Done:
    """Run a command of a page in `folder`."""
    words = shlex.split(line)[1:]
    done = subprocess.run(
        [*VFGUIDE, *words],
        cwd=folder,
        env={**os.environ, "COLUMNS": "120"},
        stdout=subprocess.PIPE,
        stderr=subprocess.STDOUT,
        text=True,
        check=False,
        timeout=600,
    )
    return Done(line, done.returncode, done.stdout)


def rewritten(text: str, done: list[Done], folder: Path) -> str:
    """The page with the numbers that its commands gave in `folder`.

    Raises:
        StaleError: it shows a line or a key that there is not.
    """
    text = NUMBER.sub(lambda found: number_with_source(found, folder), text)
    printed = {each.line: each.printed for each in done}
    before: tuple[str, ...] = ()
    for block in blocks_of(text):
        if block.kind == "text":
            output = "".join(printed[line] for line in before if line in printed)
            for line in block.lines:
                text = text.replace(line, line_given(line, output), 1)
        before = block.lines if block.kind == "sh" else before
    return text


def number_with_source(found: re.Match[str], folder: Path) -> str:
    """A number of a sentence with its present value, and with its comment."""
    _, file, key, form = found.groups()
    return f"{value_in(folder / file, key):{form}}<!-- {file} {key} {form} -->"


def value_in(path: Path, key: str) -> float:
    """The absolute value of the number of a dotted key, in a file of results or a scenario.

    Raises:
        StaleError: there is no such file or key.
    """
    try:
        text = path.read_text()
        value: Any = json.loads(text) if path.suffix == ".json" else tomllib.loads(text)
        for part in key.split("."):
            value = value[int(part)] if part.isdigit() else value[part]
        return abs(value)
    except (OSError, KeyError, IndexError, TypeError) as error:
        raise StaleError(f"{path.name}: {key}: there is no such number") from error


def line_given(line: str, output: str) -> str:
    """The line of an output that has the words of a line of a page; `...` stands for anything.

    Raises:
        StaleError: no line has.
    """
    shape = re.escape(squeezed(FIGURE.sub("#", line))).replace(r"\.\.\.", ".*")
    for given in output.splitlines():
        if re.fullmatch(shape, squeezed(FIGURE.sub("#", given))):
            return line if "..." in line or squeezed(given) == squeezed(line) else given.rstrip()
    raise StaleError(f'nothing prints "{line}"')


def squeezed(line: str) -> str:
    """The line with every run of spaces replaced by one."""
    return " ".join(line.split())


def show(page: Path, write: bool) -> bool:
    """Check or write one page; returns whether it shows what its commands give."""
    text = page.read_text()
    with tempfile.TemporaryDirectory() as name:
        folder = Path(name)
        now = rewritten(text, run_page(text, folder), folder)
    if now != text and write:
        page.write_text(now)
    print(f"{page.name}: {'as shown' if now == text else 'written' if write else 'STALE'}")
    return now == text or write


def main() -> int:
    """Check or write pages."""
    parser = argparse.ArgumentParser(description=__doc__.partition("\n")[0])
    parser.add_argument("pages", nargs="*", type=Path, default=PAGES, metavar="PAGE")
    parser.add_argument("--write", action="store_true", help="write the numbers of today")
    asked = parser.parse_args()
    pages = [page for page in asked.pages if commands_of(page.read_text())]
    shown = [show(page, asked.write) for page in pages]
    return 0 if all(shown) else 1


if __name__ == "__main__":
    sys.exit(main())
