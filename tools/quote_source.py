"""Quotes a function from its source on a page, in the place of `{{ source FILE FUNCTION }}`."""

import ast
import re
from pathlib import Path
from typing import Any

ROOT = Path(__file__).parent.parent
QUOTE = re.compile(r"^\{\{ source (\S+) (\S+) \}\}$", re.MULTILINE)


def on_page_markdown(markdown: str, **_: Any) -> str:
    """The page with its quotes filled in; mkdocs calls it for each."""
    return QUOTE.sub(lambda found: quoted(ROOT / found[1], found[2]), markdown)


def quoted(path: Path, name: str) -> str:
    """A function without its docstring, as a block of code.

    Raises:
        LookupError: there is no such function.
    """
    text = path.read_text()
    for node in ast.parse(text).body:
        if isinstance(node, ast.FunctionDef) and node.name == name:
            lines = text.splitlines()[node.lineno - 1 : node.end_lineno]
            first, *_ = node.body
            documented = ast.get_docstring(node) is not None
            begin, end = first.lineno - node.lineno, (first.end_lineno or 0) - node.lineno + 1
            shown = lines[:begin] + lines[end:] if documented else lines
            return "\n".join(["```python", *shown, "```"])
    raise LookupError(f"{path} has no function {name}")
