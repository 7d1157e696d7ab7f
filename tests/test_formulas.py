"""A formula has one place: a function that is named for what it is.

Two arithmetic expressions are one formula if nothing but the names of the quantities differs.
"""

import ast
import copy
from collections import defaultdict

import pytest
from pages import ROOT

LEAST_SIZE = 8
"""Number of operations, numbers, names and subscripts from which an expression is a formula."""
BUILT_IN = ("abs", "max", "min")
OWN_LAWS = ROOT / "vfguide" / "sim"
"""The software autopilot has formulas of its own, that it shares no fault with the companion."""
IDIOMS = {
    "1.0 - abs(a) ** (2.0 * b)",
    "(a * b + c * d) / e",
    "a * (b * c - d * e)",
    "a * a + b * b + c * c",
    "a[0] * a[0] + a[1] * a[1]",
    "a[0] * b[1] - a[1] * b[0]",
    "a[2] - b * math.sin(c)",
    "math.atan2(a[1], a[0])",
    "math.hypot(a - b, c - d)",
    "math.hypot(a[0], a[1])",
    "math.sqrt(a * a + b * b)",
    "max(-a, min(a, b))",
    "max(-a, min(a, b + c * d * e))",
    "max(-a, min(b, c))",
    "max(0.0, 1.0 - a / b)",
    "min(a, b + c * d * e)",
}
"""Products of components, and values within limits: the name of a function would say no more."""


class Nameless(ast.NodeTransformer):
    """Calls the quantities of an expression by letters, in the order in which they come."""

    def __init__(self):
        self.letters = {}

    def visit_Name(self, node):
        letter = chr(ord("a") + len(self.letters))
        return ast.Name(self.letters.setdefault(ast.unparse(node), letter))

    visit_Attribute = visit_Name

    def visit_Call(self, node):
        node.args = [self.visit(each) for each in node.args]
        return node


def is_arithmetic(node):
    """Whether an expression is made of operations, numbers and quantities alone."""
    match node:
        case ast.BinOp(left=left, right=right):
            return is_arithmetic(left) and is_arithmetic(right)
        case ast.UnaryOp(operand=part):
            return is_arithmetic(part)
        case ast.Subscript(value=part, slice=place):
            return is_arithmetic(part) and isinstance(place, ast.Constant)
        case ast.Call(func=function, args=parts, keywords=[]):
            name = ast.unparse(function)
            known = name.startswith("math.") or name in BUILT_IN
            return known and all(map(is_arithmetic, parts))
        case ast.Constant(value=value):
            return isinstance(value, float | int)
        case _:
            return isinstance(node, ast.Name | ast.Attribute)


def formulas_of(source):
    """The formulas of a module, without names."""
    parts = (ast.BinOp, ast.Call, ast.Constant, ast.Name, ast.Subscript, ast.UnaryOp)
    for node in ast.walk(ast.parse(source)):
        if isinstance(node, ast.BinOp | ast.Call) and is_arithmetic(node):
            formula = Nameless().visit(copy.deepcopy(node))
            if sum(isinstance(part, parts) for part in ast.walk(formula)) >= LEAST_SIZE:
                yield ast.unparse(formula)


def twice(sources):
    """Each formula that stands in more than one of the modules, and in which."""
    places = defaultdict(set)
    for name, source in sources.items():
        for formula in formulas_of(source):
            places[formula].add(name)
    return {formula: names for formula, names in places.items() if len(names) > 1}


def test_no_formula_stands_in_two_compiled_modules():
    files = [path for path in (ROOT / "vfguide").rglob("*.py") if OWN_LAWS not in path.parents]
    sources = {str(path.relative_to(ROOT)): path.read_text() for path in files}
    found = twice({name: text for name, text in sources.items() if "@compiled" in text})
    assert {formula: names for formula, names in found.items() if formula not in IDIOMS} == {}
    assert set(found) >= IDIOMS, "an idiom that is none any more"


@pytest.mark.parametrize(
    ("one", "other", "is_twice"),
    [
        ("math.atan2(R[2][1], R[2][2])", "bank = math.atan2(R_nb[2][1], R_nb[2][2])", True),
        ("math.acos(1.0 / load) * s.k * dt", "x + math.acos(1.0 / n) * gain * t", True),
        ("math.atan2(R[2][1], R[2][2])", "math.atan2(R[2][1], R[2][0])", False),
        ("a * b + c * a + d", "a * b + c * d + a", False),
        ("math.sin(a * b + c * d)", "math.cos(a * b + c * d)[0]", False),
    ],
)
def test_names_alone_do_not_make_another_formula(one, other, is_twice):
    assert bool(twice({"one": one, "other": other})) == is_twice
