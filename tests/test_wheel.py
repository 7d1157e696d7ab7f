"""The wheel, installed elsewhere, flies: what is shipped is complete."""

import json
import os
import subprocess
import sys
import sysconfig
import tarfile
import venv
import zipfile
from pathlib import Path

import pytest
from pages import ROOT

from vfguide import __version__

pytestmark = pytest.mark.slow

NEEDED = {
    "vfguide/cli/main.py",
    "vfguide/report/report.html.j2",
    "vfguide/report/style.css.j2",
    "vfguide/campaign/results/report.html.j2",
    "vfguide/_data/scenarios/first-flight.toml",
    *(f"vfguide/_data/scenarios/paper/example-{number}.toml" for number in (1, 2, 3)),
    "vfguide/_data/scenarios/easystar.toml",
    "vfguide/_data/scenarios/cessna.toml",
    "vfguide/_data/aircraft/aerosonde/aerosonde.toml",
    "vfguide/_data/aircraft/easystar/easystar.toml",
    "vfguide/_data/aircraft/easystar/easystar.xml",
    "vfguide/_data/aircraft/c172p/c172p.toml",
    "vfguide/_data/aircraft/aerosonde/aerosonde.xml",
}


@pytest.fixture(scope="module")
def built(tmp_path_factory) -> Path:
    """A folder with the sdist, and the wheel that was built from it."""
    folder = tmp_path_factory.mktemp("dist")
    command = [sys.executable, "-m", "build", "--no-isolation", "--outdir", folder, ROOT]
    done = subprocess.run(command, capture_output=True, text=True, check=False)
    assert done.returncode == 0, done.stdout + done.stderr
    return folder


@pytest.fixture(scope="module")
def wheel(built) -> Path:
    (path,) = built.glob("*.whl")
    return path


@pytest.fixture(scope="module")
def program(wheel, tmp_path_factory) -> Path:
    """The program of the wheel in an environment of its own, without the checkout.

    The dependencies are those of this environment. A folder in a .pth file is searched for
    packages, its own .pth files are not read: one of them would lead to the checkout.
    """
    folder = tmp_path_factory.mktemp("elsewhere") / "venv"
    venv.create(folder, with_pip=False, symlinks=True)
    packages = Path(sysconfig.get_path("purelib", vars={"base": str(folder)}))
    (packages / "dependencies.pth").write_text(sysconfig.get_path("purelib") + "\n")
    command = [sys.executable, "-m", "pip", "--python", folder / "bin" / "python", "install"]
    subprocess.run(
        [*command, "--quiet", "--no-deps", "--no-index", "--disable-pip-version-check", wheel],
        check=True,
    )
    return folder / "bin" / "vfguide"


def run(*command: str | Path, cwd: Path) -> subprocess.CompletedProcess[str]:
    surroundings = {name: value for name, value in os.environ.items() if name != "PYTHONPATH"}
    return subprocess.run(
        command, cwd=cwd, env=surroundings, capture_output=True, text=True, check=False
    )


def test_the_wheel_holds_what_it_needs_and_nothing_else(wheel):
    names = set(zipfile.ZipFile(wheel).namelist())
    assert names >= NEEDED
    info = f"vfguide-{__version__}.dist-info/"
    assert all(name.startswith(("vfguide/", info)) for name in names)
    assert not any("__pycache__" in name for name in names)


def test_the_sdist_holds_the_tests_and_the_pages(built):
    (path,) = built.glob("*.tar.gz")
    with tarfile.open(path) as archive:
        names = {name.partition("/")[2] for name in archive.getnames()}
    expected = {
        *("README.md", "LICENSE", "mkdocs.yml", "pyproject.toml", "docs/index.md"),
        *("tests/test_wheel.py", "tools/test", "aircraft/aerosonde/aerosonde.xml"),
    }
    assert names >= expected


def test_it_is_the_wheel_that_is_installed(program, tmp_path):
    where = "import vfguide; print(vfguide.__file__)"
    done = run(program.parent / "python", "-c", where, cwd=tmp_path)
    assert Path(done.stdout.strip()).is_relative_to(program.parents[1])


def test_the_wheel_flies_the_first_scenario(program, tmp_path):
    done = run(program, "run", "first-flight", "--out", "results", cwd=tmp_path)
    assert done.returncode == 0, done.stdout + done.stderr
    result = json.loads((tmp_path / "results" / "result.json").read_text())
    assert result["verdict"] == "good"
    assert result["version"] == __version__
    assert (tmp_path / "results" / "report.html").stat().st_size > 100_000
    assert (tmp_path / "results" / "figures" / "path-plan.png").is_file()
    assert not (tmp_path / "results" / "aircraft").exists()
