"""Settings of every test run."""

import os
import tempfile

import pytest
from hypothesis import settings

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


keep_machine_code()
# No deadline: the first call of a compiled function compiles it.
settings.register_profile("vfguide", deadline=None, derandomize=True)
settings.load_profile("vfguide")


@pytest.hookimpl(tryfirst=True)  # before `-m` chooses
def pytest_collection_modifyitems(items):
    """Whatever is not marked slow is fast: `pytest -m fast`."""
    for item in items:
        if not item.get_closest_marker("slow"):
            item.add_marker(pytest.mark.fast)
