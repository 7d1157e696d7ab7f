"""Settings of every test run."""

import os
import sys
import tempfile
from pathlib import Path

import pytest
from hypothesis import settings
from slow_modules import is_slow

from vfguide.kernels.compiled import cache_home


def keep_machine_code() -> None:
    """Without a folder for it, as with HOME=/dev/null, the run and its programs share a new one."""
    folder = cache_home()
    try:
        folder.mkdir(parents=True, exist_ok=True)
        usable = os.access(folder, os.W_OK)
    except OSError:
        usable = False
    if not usable:
        os.environ["XDG_CACHE_HOME"] = tempfile.mkdtemp(prefix="vfguide-machine-code-")


def keep_bytecode() -> None:
    """Keep it even if the environment says not to: each worker and program would make it anew."""
    sys.dont_write_bytecode = False
    os.environ.pop("PYTHONDONTWRITEBYTECODE", None)


keep_machine_code()
keep_bytecode()
# No deadline: the first call of a compiled function compiles it.
settings.register_profile("vfguide", deadline=None, derandomize=True)
settings.load_profile("vfguide")


def pytest_ignore_collect(collection_path: Path, config: pytest.Config) -> bool | None:
    """`pytest -m fast` does not even import what is marked slow."""
    is_module = collection_path.match("test_*.py")
    is_left_out = config.option.markexpr == "fast" and is_module and is_slow(collection_path)
    return True if is_left_out else None


@pytest.hookimpl(tryfirst=True)  # before `-m` chooses
def pytest_collection_modifyitems(items):
    """Whatever is not marked slow is fast: `pytest -m fast`."""
    for item in items:
        if not item.get_closest_marker("slow"):
            item.add_marker(pytest.mark.fast)
