#!/usr/bin/env python3
"""Whether the code keeps to the words of the glossary, and each constant to a name of its own.

    python tools/check_words.py

Reads the tables of names and of words that are not used any more in docs/glossary.md, and prints
every place in vfguide/ and tools/ where such a name is given to something, or a docstring or a
comment has such a word. Prints besides every public constant of vfguide/ whose name stands for
another constant in another module, unless it is one of `SHARED`. Exit status 1 if there is any.
"""

import ast
import re
import sys
import tokenize
from collections import defaultdict
from collections.abc import Iterator
from io import StringIO
from pathlib import Path

from check_docstrings import constants

ROOT = Path(__file__).parent.parent
GLOSSARY = ROOT / "docs" / "glossary.md"
NAMES_HEADING = "## Names that are not used any more"
WORDS_HEADING = "## Words that are not used any more"
FOLDERS = ("vfguide", "tools")
SHARED = {
    "MAX_DATAGRAM": "one fact of UDP, in two rooms that may not import each other",
}
"""Constants of one name in several modules, and why."""


def table_under(heading: str, text: str) -> frozenset[str]:
    """The first column of the table under a heading, without code marks.

    Raises:
        ValueError: there is no such table.
    """
    _, found, rest = text.partition(heading)
    section = rest.partition("\n## ")[0]
    rows = re.findall(r"^\| `?([\w ]+?)`?(?:, as a variable)? \|", section, re.MULTILINE)
    words = frozenset(rows) - {"was"}
    if not found or not words:
        raise ValueError(f"no table under {heading!r}")
    return words


def names_given(tree: ast.AST) -> Iterator[tuple[int, str]]:
    """Every name that a module gives to something, attributes too, with its line."""
    for node in ast.walk(tree):
        match node:
            case ast.FunctionDef() | ast.ClassDef():
                yield node.lineno, node.name
            case ast.arg():
                yield node.lineno, node.arg
            case ast.Name(ctx=ast.Store()):
                yield node.lineno, node.id
            case ast.Attribute(ctx=ast.Store()):
                yield node.lineno, node.attr
            case ast.alias(asname=str(name)):
                yield node.lineno, name
            case _:
                pass


def prose(source: str) -> Iterator[tuple[int, str]]:
    """The lines of a module's docstrings and comments, with their numbers."""
    for node in ast.walk(ast.parse(source)):
        match node:
            case ast.Expr(value=ast.Constant(value=str(text))):
                yield from enumerate(text.splitlines(), start=node.lineno)
            case _:
                pass
    for token in tokenize.generate_tokens(StringIO(source).readline):
        if token.type == tokenize.COMMENT:
            yield token.start[0], token.string


def words_used(source: str, words: frozenset[str]) -> Iterator[tuple[int, str]]:
    """The given-up words in a module's prose, also in the plural, with their lines."""
    pattern = re.compile(rf"\b({'|'.join(sorted(words))})(?:s|es)?\b", re.IGNORECASE)
    for line, text in prose(source):
        yield from ((line, word.lower()) for word in pattern.findall(text))


def shared_constants() -> Iterator[str]:
    """A line for each constant whose name is defined in several modules."""
    places: defaultdict[str, list[str]] = defaultdict(list)
    for path in sorted((ROOT / "vfguide").rglob("*.py")):
        for constant in constants(ast.parse(path.read_text())):
            for name in constant.names:
                places[name].append(f"{path.relative_to(ROOT)}:{constant.line}")
    for name, each in places.items():
        if len(each) > 1 and name not in SHARED:
            yield f"{name} is defined in {' and '.join(each)}"


def violations() -> Iterator[str]:
    """A line for each old name, each old word and each constant of two meanings."""
    text = GLOSSARY.read_text()
    names, words = table_under(NAMES_HEADING, text), table_under(WORDS_HEADING, text)
    for folder in FOLDERS:
        for path in sorted((ROOT / folder).rglob("*.py")):
            source, at = path.read_text(), path.relative_to(ROOT)
            for line, name in names_given(ast.parse(source)):
                if name.lstrip("_") in names:
                    yield f"{at}:{line}: {name}, see docs/glossary.md"
            for line, word in words_used(source, words):
                yield f'{at}:{line}: "{word}", see docs/glossary.md'
    yield from shared_constants()


def main() -> None:
    """Print the violations."""
    found = list(violations())
    print("\n".join(found) or "no name or word that was given up")
    sys.exit(bool(found))


if __name__ == "__main__":
    main()
