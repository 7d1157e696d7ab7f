"""Which modules of tests are left out by `pytest -m fast`, told without importing them."""

from pathlib import Path

MARK = "\npytestmark = pytest.mark.slow\n"


def is_slow(module: Path) -> bool:
    """Whether a module of tests is marked slow at its head."""
    return MARK in module.read_text()
