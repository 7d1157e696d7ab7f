#!/usr/bin/env python3
"""Whether the code keeps to the words of the glossary.

    python tools/check_words.py

Reads the table of names that are not used any more in docs/glossary.md and prints every place in
vfguide/ and tools/ where one is given to something; exit status 1 if there is any.
"""

import ast
import re
import sys
from collections.abc import Iterator
from pathlib import Path

ROOT = Path(__file__).parent.parent
GLOSSARY = ROOT / "docs" / "glossary.md"
HEADING = "## Names that are not used any more"
FOLDERS = ("vfguide", "tools")


def old_names(text: str) -> frozenset[str]:
    """The names in the first column of the table under HEADING.

    Raises:
        ValueError: there is no such table.
    """
    _, heading, table = text.partition(HEADING)
    names = re.findall(r"^\| `(\w+)`", table, re.MULTILINE)
    if not heading or not names:
        raise ValueError(f"no table of names under {HEADING!r}")
    return frozenset(names)


def names_given(tree: ast.AST) -> Iterator[tuple[int, str]]:
    """Every name that a module gives to something, with its line."""
    for node in ast.walk(tree):
        match node:
            case ast.FunctionDef() | ast.ClassDef():
                yield node.lineno, node.name
            case ast.arg():
                yield node.lineno, node.arg
            case ast.Name(ctx=ast.Store()):
                yield node.lineno, node.id
            case ast.alias(asname=str(name)):
                yield node.lineno, name
            case _:
                pass


def violations() -> Iterator[str]:
    """A line for each old name that is given to something."""
    old = old_names(GLOSSARY.read_text())
    for folder in FOLDERS:
        for path in sorted((ROOT / folder).rglob("*.py")):
            for line, name in names_given(ast.parse(path.read_text())):
                if name in old:
                    yield f"{path.relative_to(ROOT)}:{line}: {name}, see docs/glossary.md"


def main() -> None:
    """Print the violations."""
    found = list(violations())
    print("\n".join(found) or "no name that was given up")
    sys.exit(bool(found))


if __name__ == "__main__":
    main()
