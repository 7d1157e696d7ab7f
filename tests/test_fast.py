"""`pytest -m fast` leaves no package of the program out."""

import ast
from pathlib import Path
from types import SimpleNamespace

import pytest
from pages import ROOT
from slow_modules import is_slow

PACKAGES = {path.parent.name for path in (ROOT / "vfguide").glob("*/__init__.py")}
TESTS = ROOT / "tests"


def packages_used(module: Path) -> set[str]:
    """The packages of vfguide from which a file imports."""
    found = [
        node for node in ast.walk(ast.parse(module.read_text())) if isinstance(node, ast.ImportFrom)
    ]
    names = [(node.module or "").split(".") for node in found]
    return {name[1] for name in names if name[0] == "vfguide" and len(name) > 1}


def test_every_package_has_fast_tests_of_its_own():
    """Modules in its folder that use it, so that they fail where it is broken."""
    assert len(PACKAGES) > 8
    for package in PACKAGES:
        fast = [path for path in (TESTS / package).glob("test_*.py") if not is_slow(path)]
        assert any(package in packages_used(path) for path in fast), package


def test_every_test_is_either_fast_or_slow(request):
    for item in request.session.items:
        marks = [name for name in ("fast", "slow") if item.get_closest_marker(name)]
        assert len(marks) == 1, item.nodeid


@pytest.mark.parametrize(("chosen", "left_out"), [("fast", True), ("", None), ("slow", None)])
def test_slow_modules_are_not_even_imported_for_the_fast_ones(request, tmp_path, chosen, left_out):
    settings = request.config.pluginmanager.get_plugin(str(TESTS / "conftest.py"))
    config = SimpleNamespace(option=SimpleNamespace(markexpr=chosen))
    for name, text in (("slow", "import pytest\n\npytestmark = pytest.mark.slow\n"), ("fast", "")):
        module = tmp_path / f"test_{name}.py"
        module.write_text(text)
        ignored = settings.pytest_ignore_collect(module, config)
        assert ignored is (left_out if name == "slow" else None)
