"""The pages of the documentation as tests read them: tables and commands."""

import re
from collections.abc import Iterator
from pathlib import Path

ROOT = Path(__file__).parent.parent
DOCS = ROOT / "docs"
README = ROOT / "README.md"
PAGES = [README, *sorted(DOCS.glob("*.md"))]

Rows = list[list[str]]


def tables(page: Path) -> Iterator[tuple[str, Rows]]:
    """Every table: the heading it stands under, and its rows without the one of titles."""
    heading, rows = "", []
    for line in [*page.read_text().splitlines(), ""]:
        if line.startswith("#"):
            heading = line.lstrip("#").strip().replace("`", "")
        if line.startswith("|"):
            cells = re.split(r"(?<!\\)\|", line.strip().strip("|"))
            rows.append([cell.strip() for cell in cells])
        elif rows:
            yield heading, rows[2:]
            rows = []


def rows_of(page: Path, *headings: str) -> Rows:
    """The rows of all tables under one of these headings, or of all tables of the page."""
    found = [rows for heading, rows in tables(page) if not headings or heading in headings]
    assert found, f"{page.name} has no table under {headings}"
    return [row for rows in found for row in rows]


def names_in(cell: str) -> list[str]:
    """What stands in backticks."""
    return re.findall(r"`([^`]+)`", cell)
