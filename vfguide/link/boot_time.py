"""The clock of an autopilot on MAVLink: milliseconds since it booted."""

from vfguide.geometry.units import MS

ROLLOVER = 2**32
"""Number of milliseconds after which time_boot_ms begins again, 49.7 days."""


def elapsed(before_ms: int, after_ms: int) -> float:
    """Time from one time_boot_ms to another [s], also across the rollover."""
    half = ROLLOVER // 2
    return ((after_ms - before_ms + half) % ROLLOVER - half) * MS
