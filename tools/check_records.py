"""Says where the code takes a part of a record by its number, or changes code while it runs.

    python tools/check_records.py

One line for each violation on standard output; the exit status is 1 if there is one. The rules:

1. No subscript by number on anything but vectors, matrices and sequences of like things. A number
   is an integer, a constant (a name in capitals), or an expression or a slice with one in it:
   `row[3]`, `rows[i, 4]`, `memory[AIR + TRUST]`, `row[1:4]`. What may be subscripted so:

   - tuples whose parts are of one type, `tuple[Vec3, Vec3]` or `tuple[float, ...]`; of numbers at
     most three, for more are no vector of ours, unless the tuple is a constant;
   - what Python keeps for like things: the types named in `SEQUENCES`;
   - mappings, whose subscript is a key;
   - arrays that are declared as one of `ARRAYS`, which are aliases in `vfguide.geometry.vector`,
     and parts, sums and multiples of such. An array that is not declared so may be a row of a
     record, and is refused;
   - tables of records, declared as `Table` of `vfguide.kernels.rows`, along their first axis:
     `table[0]` is the row of a record, `table[1:]` a table; `table[0, 3]` is refused.

2. No attribute of a module is set or deleted, but for `HOOKS`, which Python has to be set.
3. No function is built of the code of another (`FunctionType`, `CodeType`).

The types are pyright's: a copy of the sources, in which the rule's expressions are wrapped into
`reveal_type`, is checked in a temporary folder. There each alias of `ARRAYS` and `TABLE` is a class
of its own, so that an array that is declared so is told from any other.
"""

import ast
import json
import re
import subprocess
import sys
import tempfile
from collections.abc import Iterable
from pathlib import Path
from typing import Any, NamedTuple

ROOT = Path(__file__).parent.parent
PACKAGES = ("vfguide", "tools")
ALIASES = Path("vfguide/geometry/vector.py")
"""Path of the module that defines the aliases of `ARRAYS`."""
ARRAYS = ("Vector", "Vectors", "Matrix", "Matrices", "Series", "Indices", "Mask")
"""Aliases of arrays: one vector, many along the last axis, one matrix, many along the last two
axes, a number at each of many instants or of each of many like things, indices, and which of like
things."""
ROWS = Path("vfguide/kernels/rows.py")
TABLE = "Table"
"""Alias of rows of records, which the module ROWS defines."""
SEQUENCES = ("array", "bytearray", "bytes", "deque", "list", "memoryview", "range", "str")
SEQUENCES += ("LiteralString", "Sequence", "GridSpec", "Match")
"""Types of sequences of like things: a `GridSpec` has places of a figure, a `Match` has groups."""
MAPPINGS = ("Counter", "Mapping", "MappingProxyType", "OrderedDict", "defaultdict", "dict")
INDEX = "dtype[signedinteger[_32Bit | _64Bit]]"
"""Type of the arrays of indices that numpy's searches return (`np.intp`)."""
LONGEST = 3
"""Largest number of numbers in a tuple that is a vector."""
HOOKS = ("warnings.showwarning", "sys.unraisablehook")
"""Attributes of modules that a program may replace by its own function, as Python documents."""
BUILDERS = ("FunctionType", "CodeType")
LIKE = "LikeThings"
LIKE_CLASS = f'''
class {LIKE}(np.ndarray[tuple[Any, ...], np.dtype[np.float64]]):
    T: "{LIKE}"
    def __getitem__(self, key: Any) -> "{LIKE}": ...
    def __iter__(self) -> "Iterator[{LIKE}]": ...
    def copy(self, order: Any = "C") -> "{LIKE}": ...
    def __neg__(self) -> "{LIKE}": ...
''' + "".join(
    f'    def __{side}{name}__(self, other: Any) -> "{LIKE}": ...\n'
    for name in ("add", "sub", "mul", "truediv", "matmul", "pow")
    for side in ("", "r")
)
"""Source of the class that, in the copy, arrays declared as vectors, matrices and series have."""
TABLE_KIND = "RowsOfRecords"
TABLE_CLASS = f'''
class {TABLE_KIND}(np.ndarray[tuple[Any, ...], np.dtype[np.float64]]):
    @overload
    def __getitem__(self, key: slice) -> "{TABLE_KIND}": ...
    @overload
    def __getitem__(self, key: Any) -> np.ndarray[tuple[Any, ...], np.dtype[np.float64]]: ...
    def __iter__(self) -> "Iterator[np.ndarray[tuple[Any, ...], np.dtype[np.float64]]]": ...
    def copy(self, order: Any = "C") -> "{TABLE_KIND}": ...
'''
"""Source of the class that, in the copy, tables have."""
SETTINGS = {
    "include": list(PACKAGES),
    "extraPaths": ["tools"],
    "typeCheckingMode": "basic",
    "pythonVersion": "3.11",
    "reportAssertTypeFailure": "error",
}
MISMATCH = re.compile(r'expected "(\d+)" but received "(.*)"', re.DOTALL)


class Question(NamedTuple):
    """An expression whose type decides whether a rule is broken."""

    path: Path
    line: int
    text: str
    """The code that may be a violation."""
    base: str
    """The part of it whose type decides."""
    subscript: bool
    """Whether it is a subscript by number; else it sets an attribute."""
    axes: bool = False
    """Whether the subscript goes beyond the first axis."""


class Violation(NamedTuple):
    """A place where the code breaks a rule."""

    path: Path
    line: int
    text: str

    def __str__(self) -> str:
        """The line that is printed."""
        return f"{self.path}:{self.line}: {self.text}"


def has_number(index: ast.AST) -> bool:
    """Whether a subscript takes its part by a number, alone or beside a variable."""
    match index:
        case ast.Constant(value=value):
            return type(value) is int
        case ast.Name(id=name) | ast.Attribute(attr=name):
            return name.isupper() and len(name) > 1
        case ast.Tuple(elts=parts) | ast.Call(func=ast.Name(id="int" | "slice"), args=parts):
            return any(map(has_number, parts))
        case ast.UnaryOp() | ast.BinOp() | ast.Slice():
            return any(has_number(part) for part in ast.iter_child_nodes(index))
    return False


class Asker(ast.NodeTransformer):
    """Wraps deciding expressions into `reveal_type`, with the number of a question as marker."""

    def __init__(self, path: Path, questions: list[Question]) -> None:
        self.path, self.questions = path, questions

    def visit(self, node: ast.AST) -> Any:
        """The node with its parts, and itself, wrapped where that is needed."""
        text = ast.unparse(node) if isinstance(node, ast.expr) else ""
        self.generic_visit(node)
        match node:
            case ast.Subscript(value=ast.Name(id="Annotated" | "Literal")):
                pass  # a type
            case ast.Subscript(slice=index) if has_number(index):
                axes = isinstance(index, ast.Tuple)
                node.value = self.asked(node.value, text, True, axes)
            case ast.Attribute(value=ast.Name(id="self" | "cls")):
                pass  # what declares the attributes of a class must stay
            case ast.Attribute(ctx=ast.Store()) if text in HOOKS:
                pass
            case ast.Attribute(ctx=ast.Store() | ast.Del()):
                node.value = self.asked(node.value, text, False)
            case ast.Call(func=ast.Name(id="setattr" | "delattr"), args=[base, *rest]):
                node.args = [self.asked(base, text, False), *rest]
        return node

    def asked(self, base: ast.expr, text: str, subscript: bool, axes: bool = False) -> ast.expr:
        """The expression `base`, wrapped; `text` is the code that it is part of."""
        marker = ast.keyword("expected_text", ast.Constant(str(len(self.questions))))
        question = Question(self.path, base.lineno, text, ast.unparse(base), subscript, axes)
        self.questions.append(question)
        asked = ast.Call(ast.Name("reveal_type", ast.Load()), [base], [marker])
        return ast.copy_location(asked, base)


def is_like(kind: ast.expr, constant: bool) -> bool:
    """Whether a type is one of like things; the tuple of a constant may have many numbers."""
    match kind:
        case ast.BinOp():
            return is_like(kind.left, constant) and is_like(kind.right, constant)
        case ast.Subscript(value=ast.Name(id="tuple"), slice=ast.Tuple(elts=parts)):
            kinds = {part_of(part) for part in parts} - {"..."}
            few = len(parts) <= LONGEST or constant or not kinds <= {"float", "int"}
            return few and len(kinds) == 1
        case ast.Subscript(value=ast.Name(id="tuple")):
            return True  # of one part
        case ast.Subscript(value=ast.Name(id="ndarray")):
            return INDEX in ast.unparse(kind)
        case ast.Subscript(value=ast.Name(id="Literal")):
            return all(type(value) is str for value in literals(kind.slice))
        case _:
            head = ast.unparse(kind).split("[", maxsplit=1)[0]
            return head in (LIKE, "None", *SEQUENCES)


def literals(kind: ast.expr) -> tuple[Any, ...]:
    """The values of a `Literal[...]`, given what stands in its brackets."""
    values = ast.literal_eval(kind)
    return values if isinstance(values, tuple) else (values,)


def part_of(kind: ast.expr) -> str:
    """The type of a tuple's part; a constant has that of its kind."""
    match kind:
        case ast.Starred(value=ast.Subscript(slice=ast.Tuple(elts=[part, *_]))):
            return part_of(part)
        case ast.Subscript(value=ast.Name(id="Literal"), slice=ast.Constant(value=value)):
            return type(value).__name__
        case _:
            return ast.unparse(kind)


def breaks(question: Question, kind: str) -> bool:
    """Whether a rule is broken, given the type of the expression that was asked for."""
    if not question.subscript:
        return kind.startswith("Module(")
    if kind.split("[", maxsplit=1)[0] in MAPPINGS:
        return False
    if kind == TABLE_KIND:
        return question.axes
    try:
        return not is_like(ast.parse(kind, mode="eval").body, question.base.isupper())
    except SyntaxError:
        return True


def builders(path: Path, tree: ast.AST) -> Iterable[Violation]:
    """Where functions are built of code."""
    for node in ast.walk(tree):
        if isinstance(node, ast.Call):
            name = ast.unparse(node.func).rsplit(".", maxsplit=1)[-1]
            if name in BUILDERS:
                yield Violation(path, node.lineno, f"{name}(...) builds a function of code")


def with_classes(source: str, path: Path) -> str:
    """A module, in which the aliases are classes of their own kind."""
    head = "import numpy as np\nfrom typing import Any, overload\n"
    head += "from collections.abc import Iterator\n"
    if path == ROWS:
        return head + TABLE_CLASS + renamed(source, (TABLE,), TABLE_KIND)
    return head + LIKE_CLASS + renamed(source, ARRAYS, LIKE) if path == ALIASES else source


def renamed(source: str, aliases: Iterable[str], kind: str) -> str:
    """A module in which some aliases stand for another type."""
    return re.sub(rf"^({'|'.join(aliases)}) = .*$", rf"\1 = {kind}", source, flags=re.M)


def types_of(folder: Path) -> dict[int, str]:
    """The types that pyright reveals in a folder, by the numbers of their questions."""
    (folder / "pyrightconfig.json").write_text(json.dumps(SETTINGS))
    command = [sys.executable, "-m", "pyright", "--outputjson", "--pythonpath", sys.executable]
    done = subprocess.run(command, cwd=folder, check=False, capture_output=True, text=True)
    told = [each["message"] for each in json.loads(done.stdout)["generalDiagnostics"]]
    found = (MISMATCH.search(message) for message in told)
    return {int(match[1]): match[2] for match in found if match}


def violations(root: Path = ROOT) -> list[Violation]:
    """Where the sources under `root` break a rule."""
    questions: list[Question] = []
    found: list[Violation] = []
    with tempfile.TemporaryDirectory() as name:
        for source in sorted(
            each for package in PACKAGES for each in (root / package).rglob("*.py")
        ):
            path = source.relative_to(root)
            tree = ast.parse(source.read_text())
            found += builders(path, tree)
            asked = Asker(path, questions).visit(tree)
            text = ast.unparse(ast.fix_missing_locations(asked))
            copy = Path(name) / path
            copy.parent.mkdir(parents=True, exist_ok=True)
            copy.write_text(with_classes(text, path))
        kinds = types_of(Path(name))
    for number, question in enumerate(questions):
        kind = kinds.get(number, "unknown")
        if breaks(question, kind):
            why = f"by number, of {kind}" if question.subscript else f"is set: {kind}"
            found.append(Violation(question.path, question.line, f"{question.text} {why}"))
    return sorted(found)


if __name__ == "__main__":
    broken = violations()
    print(*broken, sep="\n", end="\n" if broken else "")
    sys.exit(bool(broken))
