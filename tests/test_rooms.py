"""A room's tests import nothing that stands above it, neither by themselves nor through helpers."""

import ast
import tomllib
from collections import Counter
from pathlib import Path

import pytest
from pages import ROOT

TESTS = ROOT / "tests"
CONTRACTS = tomllib.loads((ROOT / "pyproject.toml").read_text())["tool"]["importlinter"][
    "contracts"
]
(LAYERS,) = (contract["layers"] for contract in CONTRACTS if contract["type"] == "layers")
HEIGHT = {
    room.strip().removeprefix("vfguide."): -depth
    for depth, layer in enumerate(LAYERS)
    for room in layer.split("|")
}
"""Of each room; rooms of one layer have the same, and none of those knows the others."""
CROWDED = 16
"""Modules of a folder above which a newcomer does not see what is in it."""
LONG = 250
"""Lines of a module above which it is probably two things."""
ONE_THING = {
    "companion/companion.py": "one method for each message",
    "companion/mode_control.py": "who flies: one method for each event of the engagement",
    "kernels/rows.py": "records as rows, and the functions that are written for them",
    "link/enums.py": "one class for each enumeration of the dialect",
    "link/messages.py": "one record for each message of the dialect",
    "sim/autopilot/telemetry.py": "one function for each stream",
}
"""Longer modules, and what each is."""
WHOLE_RUNS = "runs"
"""Its folder has what is run from the command line on."""


def modules_of(file: Path) -> set[str]:
    """What a file imports, names from modules included."""
    found = set()
    for node in ast.walk(ast.parse(file.read_text())):
        if isinstance(node, ast.Import):
            found |= {alias.name for alias in node.names}
        elif isinstance(node, ast.ImportFrom) and node.module:
            found |= {node.module, *(f"{node.module}.{alias.name}" for alias in node.names)}
    return found


def helper(name: str, folder: Path, tests: Path) -> Path | None:
    """The file of a module that stands beside the tests."""
    places = (where / f"{name}.py" for where in (folder, tests))
    return next((place for place in places if place.exists()), None)


def imports_of(file: Path, tests: Path) -> set[str]:
    """What of the program a test imports, directly or through helpers."""
    found, left, seen = set(), [file], set()
    while left:
        seen.add(each := left.pop())
        for module in modules_of(each):
            if module.startswith("vfguide."):
                found.add(module)
            elif (its := helper(module, file.parent, tests)) and its not in seen:
                left.append(its)
    return found


def too_high(file: Path, tests: Path) -> list[str]:
    """What a test imports that stands above its room, or beside it."""
    room = file.parent.name
    return sorted(
        module
        for module in imports_of(file, tests)
        if (other := module.split(".")[1]) in HEIGHT
        and other != room
        and HEIGHT[other] >= HEIGHT[room]
    )


MODULES = [
    file
    for room in HEIGHT
    if room != WHOLE_RUNS
    for file in sorted((TESTS / room).glob("test_*.py"))
]


@pytest.mark.parametrize("file", MODULES, ids=lambda file: f"{file.parent.name}/{file.stem}")
def test_a_rooms_tests_import_nothing_above_it(file):
    assert too_high(file, TESTS) == []


def test_no_room_is_crowded():
    modules = [path for path in (ROOT / "vfguide").rglob("*.py") if path.name != "__init__.py"]
    sizes = Counter(path.parent.relative_to(ROOT / "vfguide").as_posix() for path in modules)
    assert {room.partition("/")[0] for room in sizes} == set(HEIGHT)
    assert {room: size for room, size in sizes.items() if size > CROWDED} == {}


def test_no_module_is_two_things():
    package = ROOT / "vfguide"
    lines = {path: path.read_text().count("\n") for path in package.rglob("*.py")}
    long = {path.relative_to(package).as_posix() for path in lines if lines[path] > LONG}
    assert long == set(ONE_THING)


def test_every_folder_of_tests_is_a_room():
    folders = {file.parent.name for file in TESTS.glob("*/*.py")}
    assert folders - set(HEIGHT) == set()
    assert len(MODULES) > 80


@pytest.mark.parametrize(
    ("text", "found"),
    [
        ("from vfguide.geometry import units", []),
        ("from vfguide.paths.leg import Leg", []),
        ("from vfguide.loop.legs import Goal", ["vfguide.loop.legs", "vfguide.loop.legs.Goal"]),
        ("import vfguide.sim.plant", ["vfguide.sim.plant"]),
        ("def late():\n    from vfguide import cli", ["vfguide.cli"]),
        ("from helping import Goal", ["vfguide.loop.legs", "vfguide.loop.legs.Goal"]),
        ("import os, numpy", []),
    ],
)
def test_the_check_finds_what_is_above(tmp_path, text, found):
    (tmp_path / "paths").mkdir()
    (tmp_path / "helping.py").write_text("from helped import Goal\n")
    (tmp_path / "helped.py").write_text("import helping\nfrom vfguide.loop.legs import Goal\n")
    file = tmp_path / "paths" / "test_x.py"
    file.write_text(text)
    assert too_high(file, tmp_path) == found


def test_rooms_of_one_layer_do_not_know_each_other(tmp_path):
    (tmp_path / "sim").mkdir()
    file = tmp_path / "sim" / "test_x.py"
    file.write_text("import vfguide.daemon.udp\nimport vfguide.sim.plant\n")
    assert too_high(file, tmp_path) == ["vfguide.daemon.udp"]
