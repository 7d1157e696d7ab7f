"""Settings of every test run."""

import pytest
from hypothesis import settings

# No deadline: the first call of a compiled function compiles it.
settings.register_profile("vfguide", deadline=None, derandomize=True)
settings.load_profile("vfguide")


@pytest.hookimpl(tryfirst=True)  # before `-m` chooses
def pytest_collection_modifyitems(items):
    """Whatever is not marked slow is fast: `pytest -m fast`."""
    for item in items:
        if not item.get_closest_marker("slow"):
            item.add_marker(pytest.mark.fast)
