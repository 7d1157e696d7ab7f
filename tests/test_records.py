"""Records are read by the names of their fields: the rule of `tools/check_records.py`."""

from pathlib import Path

import pytest
from check_records import ALIASES, ROOT, ROWS, violations

pytestmark = pytest.mark.slow
HEAD = """
from array import array
from typing import Annotated, Any, NamedTuple
import math
import numpy as np
import vfguide.geometry.vector
from vfguide.geometry import vector
from vfguide.kernels.rows import Table
from vfguide.geometry.vector import Mask, Matrices, Series, Vector, Vectors, Vec3
Poses = Table
Row = np.ndarray[Any, np.dtype[np.float64]]
FIRST = 0
STEPS = (0.1, 0.2, 0.3, 0.4)
class Gust(NamedTuple):
    speed: float
    v_n: Vec3
    P: Annotated[Vector, 3]
def measured() -> tuple[float, str]: ...
def both() -> tuple[Gust, Gust]: ...
"""
REFUSED = [
    ("gust: Gust", "gust[0]"),
    ("gust: Gust", "gust[:1]"),
    ("gust: Gust", "gust[FIRST]"),
    ("gust: Gust", "(3.0 + gust[-1])"),
    ("gust: Gust", "f'{gust[1]}'"),
    ("at: tuple[float, str]", "at[1]"),
    ("at: tuple[float, float, float, float]", "at[3]"),
    ("at: tuple[float, float] | tuple[float, str]", "at[1]"),
    ("i: int", "measured()[0]"),
    ("row: Row", "row[3]"),
    ("row: Row", "row[FIRST]"),
    ("row: Row", "row[FIRST + 1]"),
    ("row: Row, i: int", "row[i + 1]"),
    ("row: Row, i: int", "row[i, 4]"),
    ("row: Row, i: int", "row[i, 1:4]"),
    ("row: Row", "row[:, FIRST:]"),
    ("row: Any", "row[3]"),
    ("rows: Any, i: int", "rows[i][3]"),
    ("numbers: Vector", "np.asarray(numbers)[0]"),
    ("table: Table", "table[FIRST, 3]"),
    ("table: Poses, i: int", "table[i, 1:]"),
    ("table: Table, i: int", "table[i][3]"),
    ("table: Table", "[row[3] for row in table]"),
    ("table: Table, good: Mask", "table[good].T[0]"),
]
ALLOWED = [
    ("gust: Gust", "gust.v_n[0]"),
    ("gust: Gust", "gust.P[FIRST]"),
    ("gust: Gust", "both()[1].v_n[2]"),
    ("at: tuple[Vec3, Vec3]", "at[1][0]"),
    ("at: tuple[float, ...]", "at[7]"),
    ("at: tuple[Gust]", "at[0]"),
    ("names: list[str]", "names[0][:-1]"),
    ("names: dict[int, Gust]", "names[3]"),
    ("numbers: array[float]", "numbers[-1]"),
    ("row: Row, i: int", "row[i]"),
    ("row: Row, i: int", "row[:, i]"),
    ("row: Row", "row[:, None]"),
    ("row: Row", "np.flatnonzero(row < 0.0)[0]"),
    ("v: Vector", "v[0]"),
    ("v: Vectors, i: int", "v[i][0]"),
    ("v: Vectors, w: Vectors", "(0.5 * (v - w) @ v)[:, 2]"),
    ("R: Matrices", "R[..., 0, :]"),
    ("time: Series, i: int", "time[i + 1] - time[i]"),
    ("i: int", "STEPS[3]"),
    ("table: Table", "table[FIRST]"),
    ("table: Poses, i: int", "table[1:].copy()[i - 1]"),
    ("good: Mask", "good[1:] & good[:-1]"),
    ("table: Table", "table.shape[1]"),
]
CHANGED = [
    ("vector.add = len", 1),
    ("vfguide.geometry.vector.add = len", 1),
    ("math.pi += 1.0", 1),
    ("del math.pi", 1),
    ("setattr(vector, 'add', len)", 1),
    ("import types; f = types.FunctionType(len.__code__, {})", 1),
    ("its = Gust; its.speed = 1.0", 0),
    ("STEPS.count(1.0)", 0),
]


def test_the_sources_keep_the_rule():
    assert violations() == []


@pytest.fixture(scope="module")
def judged(tmp_path_factory: pytest.TempPathFactory) -> dict[str, int]:
    """How many violations there are in each module of the examples, by its name."""
    root = tmp_path_factory.mktemp("examples")
    (root / "tools").mkdir()
    for path in (ALIASES, ROWS):
        (root / path).parent.mkdir(parents=True, exist_ok=True)
        (root / path).write_text((ROOT / path).read_text())
    for folder in (ALIASES.parent, ROWS.parent, ALIASES.parent.parent):
        (root / folder / "__init__.py").touch()
    for kind, examples in (("refused", REFUSED), ("allowed", ALLOWED)):
        for number, (arguments, code) in enumerate(examples):
            text = f"{HEAD}\ndef example({arguments}):\n    return {code}\n"
            (root / "vfguide" / f"{kind}_{number}.py").write_text(text)
    for number, (code, _) in enumerate(CHANGED):
        (root / "vfguide" / f"changed_{number}.py").write_text(f"{HEAD}\n{code}\n")
    counts: dict[str, int] = {}
    for its in violations(root):
        counts[Path(its.path).stem] = counts.get(Path(its.path).stem, 0) + 1
    return counts


@pytest.mark.parametrize("number", range(len(REFUSED)), ids=lambda n: REFUSED[n][1])
def test_the_rule_refuses(number: int, judged: dict[str, int]):
    assert judged.get(f"refused_{number}") == 1


@pytest.mark.parametrize("number", range(len(ALLOWED)), ids=lambda n: ALLOWED[n][1])
def test_the_rule_allows(number: int, judged: dict[str, int]):
    assert f"allowed_{number}" not in judged


@pytest.mark.parametrize("number", range(len(CHANGED)), ids=lambda n: CHANGED[n][0])
def test_the_rule_sees_what_changes_a_module(number: int, judged: dict[str, int]):
    assert judged.get(f"changed_{number}", 0) == CHANGED[number][1]


def test_the_aliases_themselves_are_kept(judged: dict[str, int]):
    assert judged.get(ALIASES.stem, 0) == 0
