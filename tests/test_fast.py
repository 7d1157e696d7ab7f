"""`pytest -m fast` leaves no package of the program out."""

import ast
from pathlib import Path

from pages import ROOT

PACKAGES = {path.parent.name for path in (ROOT / "vfguide").glob("*/__init__.py")}
SLOW = "\npytestmark = pytest.mark.slow\n"


def packages_used(module: Path) -> set[str]:
    """The packages of vfguide from which a file imports."""
    found = [
        node for node in ast.walk(ast.parse(module.read_text())) if isinstance(node, ast.ImportFrom)
    ]
    names = [(node.module or "").split(".") for node in found]
    return {name[1] for name in names if name[0] == "vfguide" and len(name) > 1}


def test_every_package_has_fast_tests():
    modules = [path for path in (ROOT / "tests").rglob("test_*.py") if SLOW not in path.read_text()]
    assert len(PACKAGES) > 8
    assert PACKAGES - set().union(*map(packages_used, modules)) == set()


def test_every_package_with_a_folder_of_tests_has_fast_ones_there():
    folders = [path for path in (ROOT / "tests").iterdir() if path.name in PACKAGES]
    assert len(folders) > 8
    for folder in folders:
        assert any(SLOW not in path.read_text() for path in folder.glob("test_*.py")), folder


def test_every_test_is_either_fast_or_slow(request):
    for item in request.session.items:
        marks = [name for name in ("fast", "slow") if item.get_closest_marker(name)]
        assert len(marks) == 1, item.nodeid
