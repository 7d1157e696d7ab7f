#!/usr/bin/env python3
"""Whether the code keeps to the words of the glossary, and each constant to a name of its own.

    python tools/check_words.py

Reads the tables of names and of words that are not used any more in docs/glossary.md, and prints
every place in vfguide/ and tools/ where such a name is given to something, or where such a word is
in a name, a docstring, a comment or a text; and every place in the pages and the templates of the
reports where it is in the prose. Prints besides every public constant of vfguide/ whose name stands
for another constant in another module, unless it is one of `SHARED`. Exit status 1 if there is any.
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
PAGES = ("README.md", "docs/*.md", "vfguide/**/*.j2")
KEPT = frozenset({"episodes", "least_bad", "least bad"})
"""Keys and values of result.json, which keep their old words."""
SHARED = {
    "MAX_DATAGRAM": "one fact of UDP, in two rooms that may not import each other",
}
"""Constants that several modules may define under one name, with the reasons."""


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


def words_of(name: str) -> str:
    """The words of a name with blanks between them."""
    return " ".join(re.findall(r"[A-Z]+(?![a-z])|[A-Z]?[a-z]+|\d+", name)).lower()


def texts(source: str) -> Iterator[tuple[int, str]]:
    """The lines of docstrings, comments and texts of a module, and the words of its names."""
    tree = ast.parse(source)
    for node in ast.walk(tree):
        match node:
            case ast.Constant(value=str(text)) if text not in KEPT:
                yield from enumerate(text.splitlines(), start=node.lineno)
            case _:
                pass
    for token in tokenize.generate_tokens(StringIO(source).readline):
        if token.type == tokenize.COMMENT:
            yield token.start[0], token.string
    yield from ((line, words_of(name)) for line, name in names_given(tree) if name not in KEPT)


def prose(page: str) -> Iterator[tuple[int, str]]:
    """The lines of a page without code, the tags of a template and the glossary's old words."""
    page = page.partition(WORDS_HEADING)[0]
    for mark in (r"(?s)^```.*?^```", r"`[^`\n]*`", r"\{\{.*?\}\}", r"\{%.*?%\}"):
        page = re.sub(mark, lambda code: "\n" * code[0].count("\n"), page, flags=re.MULTILINE)
    yield from enumerate(page.splitlines(), start=1)


def used_in(lines: Iterator[tuple[int, str]], words: frozenset[str]) -> Iterator[tuple[int, str]]:
    """The given-up words in lines, also in the plural, with the numbers of the lines."""
    each = (r"(?:s|es)?\s".join(word.split()) for word in sorted(words))
    pattern = re.compile(rf"\b({'|'.join(each)})(?:s|es)?\b", re.IGNORECASE)
    for line, text in lines:
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
            for line, word in used_in(texts(source), words):
                yield f'{at}:{line}: "{word}", see docs/glossary.md'
    for path in sorted(path for pages in PAGES for path in ROOT.glob(pages)):
        for line, word in used_in(prose(path.read_text()), words):
            yield f'{path.relative_to(ROOT)}:{line}: "{word}", see docs/glossary.md'
    yield from shared_constants()


def main() -> None:
    """Print the violations."""
    found = list(violations())
    print("\n".join(found) or "no name or word that was given up")
    sys.exit(bool(found))


if __name__ == "__main__":
    main()
