"""Machine code on disk is a convenience: whatever happens to it, what is called is right."""

import os
import random
import shutil
import stat
import subprocess
import sys

import pytest

pytestmark = pytest.mark.slow

PROGRAM = """
import sys, warnings
sys.path.insert(0, {folder!r})
with warnings.catch_warnings(record=True) as seen:
    warnings.simplefilter("always")
    from kernels import added, over
    assert added(2.0, 3.0) == 8.0
    assert over([[1.0, 2.0], [3.0, 4.0]]).tolist() == [[2.0, 4.0], [6.0, 8.0]]
    hits = sum(added._cache_hits.values())
print(hits)
for each in seen:
    print(each.message)
"""
KERNELS = """
from vfguide.kernels.compiled import compiled
from vfguide.kernels.over_points import over_points

@compiled
def root(x):
    return x + 3.0

@compiled
def added(x, y):
    return root(x) + y

@over_points("(n)->(n)")
def over(p, q):
    for i in range(len(p)):
        q[i] = 2.0 * p[i]
"""


@pytest.fixture
def folder(tmp_path):
    (tmp_path / "kernels.py").write_text(KERNELS)
    return tmp_path


@pytest.fixture(scope="module")
def first(tmp_path_factory):
    """A folder in which the program was started once, and what that start said."""
    folder = tmp_path_factory.mktemp("first")
    (folder / "kernels.py").write_text(KERNELS)
    return folder, call(folder)


@pytest.fixture
def started(first, folder):
    """A folder with the machine code that the first start kept."""
    shutil.copytree(first[0] / "cache", folder / "cache")
    return folder


def start(folder, **surroundings):
    """What a new process says: how often it found machine code, and its warnings."""
    env = {**os.environ, "XDG_CACHE_HOME": str(folder / "cache"), **surroundings}
    return subprocess.Popen(
        [sys.executable, "-c", PROGRAM.format(folder=str(folder))],
        env={name: value for name, value in env.items() if value},
        stdout=subprocess.PIPE,
        stderr=subprocess.STDOUT,
        text=True,
    )


def call(folder, **surroundings):
    process = start(folder, **surroundings)
    text, _ = process.communicate(timeout=300)
    assert process.returncode == 0, text
    hits, *said = text.splitlines()
    return int(hits), said


def kept(folder):
    return sorted(path for path in (folder / "cache").rglob("*") if path.is_file())


def test_the_second_start_finds_what_the_first_one_compiled(first):
    folder, said = first
    assert said == (0, [])
    files = kept(folder)
    assert files
    assert not [path for path in files if path.suffix == ".part"]
    assert call(folder) == (1, [])
    assert kept(folder) == files


def halved(path):
    path.write_bytes(path.read_bytes()[: path.stat().st_size // 2])


def emptied(path):
    path.write_bytes(b"")


def shortened(path):
    path.write_bytes(path.read_bytes()[:-1])


def flipped(path):
    data = bytearray(path.read_bytes())
    at = random.Random(path.name).randrange(len(data))
    data[at] ^= 0x10
    path.write_bytes(data)


def filled_with_zeros(path):
    path.write_bytes(bytes(path.stat().st_size))


def exchanged(path):
    path.write_bytes(b"another file altogether")


@pytest.mark.parametrize(
    "damage", [halved, emptied, shortened, flipped, filled_with_zeros, exchanged]
)
def test_damaged_files_are_compiled_anew_and_told_once(started, damage):
    for path in kept(started):
        damage(path)
    hits, said = call(started)
    assert hits == 0
    (line,) = said
    assert "damaged" in line
    assert str(started / "cache") in line
    assert call(started) == (1, [])


def test_files_of_two_functions_that_were_exchanged_are_of_no_use_and_do_no_harm(started):
    files = kept(started)
    contents = [path.read_bytes() for path in files]
    for path, content in zip(files, contents[1:] + contents[:1], strict=True):
        path.write_bytes(content)
    assert call(started) == (0, [])


@pytest.mark.parametrize(
    "surroundings",
    [
        {"XDG_CACHE_HOME": "/dev/null"},
        {"XDG_CACHE_HOME": "", "HOME": "/dev/null"},
        {"XDG_CACHE_HOME": "/proc/nowhere"},
        {"XDG_CACHE_HOME": "/dev/full"},
    ],
)
def test_without_a_folder_every_start_compiles_and_says_so_once(folder, surroundings):
    hits, said = call(folder, **surroundings)
    assert hits == 0
    (line,) = said
    assert "machine code cannot be kept" in line


@pytest.mark.skipif(os.geteuid() == 0, reason="root may write anywhere")
def test_a_folder_that_may_only_be_read(folder):
    (folder / "cache").mkdir()
    (folder / "cache").chmod(stat.S_IRUSR | stat.S_IXUSR)
    hits, said = call(folder)
    assert hits == 0
    assert len(said) == 1


def test_a_full_disk(folder):
    limit = "import resource, signal; signal.signal(signal.SIGXFSZ, signal.SIG_IGN); "
    limit += "resource.setrlimit(resource.RLIMIT_FSIZE, (1000, 1000))\n"
    done = subprocess.run(
        [sys.executable, "-c", limit + PROGRAM.format(folder=str(folder))],
        env={**os.environ, "XDG_CACHE_HOME": str(folder / "cache")},
        capture_output=True,
        text=True,
        check=False,
    )
    assert done.returncode == 0, done.stderr
    hits, *said = done.stdout.splitlines()
    assert hits == "0"
    (line,) = said
    assert "machine code cannot be kept" in line
    assert kept(folder) == []


def test_another_processor_has_machine_code_of_its_own(started):
    assert call(started, NUMBA_CPU_NAME="generic") == (0, [])
    assert call(started, NUMBA_CPU_NAME="generic") == (1, [])
    assert call(started) == (1, [])


def test_four_first_starts_at_once(folder):
    processes = [start(folder) for _ in range(4)]
    for process in processes:
        text, _ = process.communicate(timeout=300)
        assert process.returncode == 0, text
        assert len(text.splitlines()) == 1
    assert call(folder) == (1, [])
