#!/usr/bin/env python3
"""Whether every public constant of vfguide/ is explained by a sentence of its own.

    python tools/check_docstrings.py

A constant is a name in capitals to which a module gives a value. Directly below it stands its own
docstring, which begins with a capital letter, ends with a full stop, and does not go on with the
sentence of the constant above. That of a number names the unit in brackets, or says with one of
`PURE` that it has none. Prints every constant that is not explained so; exit status 1 if there is
any. Whether a sentence is true, and where its number comes from, no program can say.
"""

import ast
import re
import sys
from collections.abc import Iterator
from pathlib import Path
from typing import NamedTuple

ROOT = Path(__file__).parent.parent
CONSTANT = re.compile(r"[A-Z][A-Z0-9_]*")
HANGING = re.compile(r"(And|But|Of|Or|That|The same|Then|Those)\b")
"""Beginnings of docstrings that cannot be understood without the line above."""
UNIT = re.compile(r"\[[^\]]+\]")
PURE = re.compile(
    r"\b(bits?|count|cosine|dimensionless|exponent|factor|flags?|gain|index|numbers?|power|ratio|share"
    r"|sign|sine|status|values?)\b",
    re.IGNORECASE,
)
"""Words that say why a number has no unit."""
TYPES = ("NewType", "ParamSpec", "TypeVar")
"""Calls whose result, under a name in capitals, is a type and no constant."""


class Constant(NamedTuple):
    """A name in capitals, or several that share one assignment."""

    line: int
    names: tuple[str, ...]
    value: ast.expr
    docstring: str | None


def constants(tree: ast.Module) -> Iterator[Constant]:
    """The public constants of a module."""
    for node, below in zip(tree.body, [*tree.body[1:], None], strict=True):
        match node:
            case ast.Assign(targets=[target], value=value):
                pass
            case ast.AnnAssign(target=target, value=ast.expr() as value):
                pass
            case _:
                continue
        parts = target.elts if isinstance(target, ast.Tuple) else [target]
        names = tuple(part.id for part in parts if isinstance(part, ast.Name))
        if all(map(CONSTANT.fullmatch, names)) and names and not is_type(value):
            yield Constant(node.lineno, names, value, docstring_in(below))


def is_type(value: ast.expr) -> bool:
    """Whether a value is a variable of types."""
    return isinstance(value, ast.Call) and ast.unparse(value.func) in TYPES


def docstring_in(node: ast.stmt | None) -> str | None:
    """The text of a statement that is a docstring, on one line."""
    match node:
        case ast.Expr(value=ast.Constant(value=str(text))):
            return " ".join(text.split())
        case _:
            return None


def is_number(value: ast.expr) -> bool:
    """Whether a value consists of numbers and constants alone."""
    kinds = (ast.Constant, ast.UnaryOp, ast.BinOp, ast.Name, ast.Tuple, ast.operator, ast.unaryop)
    nodes = [node for node in ast.walk(value) if not isinstance(node, ast.expr_context)]
    literals = [node.value for node in nodes if isinstance(node, ast.Constant)]
    return (
        all(isinstance(node, kinds) for node in nodes)
        and bool(literals)
        and all(type(literal) in (int, float) for literal in literals)
    )


def fault_of(constant: Constant) -> str | None:
    """What is wrong with the docstring of a constant; None where nothing is."""
    text = constant.docstring
    if len(constant.names) > 1:
        return "share one assignment, so that none has a docstring of its own"
    if text is None:
        return "has no docstring"
    if not re.fullmatch(r"[A-Z].*[^.]\.", text):
        return "is not explained by a sentence from a capital letter to a full stop"
    if HANGING.match(text):
        return "is explained by a sentence that hangs on another"
    if is_number(constant.value) and not has_unit(text):
        return "is a number of which neither the unit nor that it has none is said"
    return None


def has_unit(text: str) -> bool:
    """Whether a docstring names a unit, or says that there is none."""
    return bool(UNIT.search(text) or PURE.search(text))


def faults(source: str) -> Iterator[tuple[int, str]]:
    """The line of every constant that is not explained, and what is wrong."""
    for constant in constants(ast.parse(source)):
        if fault := fault_of(constant):
            yield constant.line, f"{', '.join(constant.names)} {fault}"


def violations() -> Iterator[str]:
    """A line for each fault in vfguide/."""
    for path in sorted((ROOT / "vfguide").rglob("*.py")):
        for line, text in faults(path.read_text()):
            yield f"{path.relative_to(ROOT)}:{line}: {text}"


def main() -> None:
    """Print the violations."""
    found = list(violations())
    print("\n".join(found) or "every constant is explained")
    sys.exit(bool(found))


if __name__ == "__main__":
    main()
