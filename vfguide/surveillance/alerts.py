"""Alerts: which of the others comes too near, said once, and not withdrawn at the first doubt."""

import math
from typing import NamedTuple

from vfguide.geometry.vector import Vec3, sub
from vfguide.link.boot_time import elapsed
from vfguide.surveillance.report import Ownship, Report, placed_at

HORIZON = 30.0
"""Conflicts are looked for so far ahead [s]."""
LOOKS, ENOUGH = 5, 3
"""An alert begins when so many of the last looks saw a conflict ..."""
WIDER = 1.5
"""... and ends when none of them sees one with a volume so much larger."""


class Encounter(NamedTuple):
    """How two that fly straight on come nearest."""

    time: float
    """Until they are nearest horizontally [s]."""
    miss: float
    """Horizontal distance then [m]."""
    violates: bool
    """Whether one enters the volume of the other before the horizon."""


class Alert(NamedTuple):
    """The last looks at one aircraft."""

    conflicts: tuple[bool, ...] = ()
    near: tuple[bool, ...] = ()
    """The same for the wider volume."""
    is_on: bool = False


def encounter(x_n: Vec3, v_n: Vec3, radius: float, half_height: float) -> Encounter:
    """How an aircraft at `x_n` [m] that moves with `v_n` [m/s], both relative, comes nearest.

    It is inside the cylinder of `radius` and `half_height` while it is so near horizontally and
    vertically at the same time.
    """
    square = v_n[0] * v_n[0] + v_n[1] * v_n[1]
    closing = -(x_n[0] * v_n[0] + x_n[1] * v_n[1])
    time = min(max(closing / square, 0.0), HORIZON) if square > 1e-9 else 0.0
    miss = math.hypot(x_n[0] + time * v_n[0], x_n[1] + time * v_n[1])
    beside = _beside(x_n, v_n, radius)
    level = _level(x_n[2], v_n[2], half_height)
    begin, end = max(beside[0], level[0], 0.0), min(beside[1], level[1], HORIZON)
    return Encounter(time, miss, begin <= end)


def _beside(x_n: Vec3, v_n: Vec3, radius: float) -> tuple[float, float]:
    """From when until when it is nearer than `radius` horizontally [s]; turned round: never."""
    a = v_n[0] * v_n[0] + v_n[1] * v_n[1]
    b = x_n[0] * v_n[0] + x_n[1] * v_n[1]
    c = x_n[0] * x_n[0] + x_n[1] * x_n[1] - radius * radius
    if a < 1e-9:
        return (-math.inf, math.inf) if c <= 0.0 else (math.inf, -math.inf)
    root = b * b - a * c
    if root < 0.0:
        return (math.inf, -math.inf)
    return ((-b - math.sqrt(root)) / a, (-b + math.sqrt(root)) / a)


def _level(z: float, v_z: float, half_height: float) -> tuple[float, float]:
    """From when until when it is no farther than `half_height` above or below [s]."""
    if abs(v_z) < 1e-9:
        return (-math.inf, math.inf) if abs(z) <= half_height else (math.inf, -math.inf)
    one, other = (-half_height - z) / v_z, (half_height - z) / v_z
    return (min(one, other), max(one, other))


def look(alert: Alert, report: Report, ownship: Ownship) -> tuple[Alert, str]:
    """The alert after another look, and what the operator should read; empty: nothing new."""
    each = report.intruder
    age = max(0.0, elapsed(report.time_ms, ownship.time_ms))
    radius, half_height = (
        each.radius + age * each.uncertainty_rate,
        each.half_height + age * each.uncertainty_rate_up,
    )
    x_n, v_n = sub(placed_at(report, ownship.time_ms), ownship.p_n), sub(each.v_n, ownship.v_n)
    met = encounter(x_n, v_n, radius, half_height)
    wide = encounter(x_n, v_n, WIDER * radius, WIDER * half_height)
    conflicts = (*alert.conflicts, met.violates)[-LOOKS:]
    near = (*alert.near, wide.violates)[-LOOKS:]
    is_on = any(near) if alert.is_on else sum(conflicts) >= ENOUGH
    note = ""
    if is_on and not alert.is_on:
        note = f"traffic {report.name} in {met.time:.0f} s, {met.miss:.0f} m"
    if alert.is_on and not is_on:
        note = f"traffic {report.name} is no conflict any more"
    return Alert(conflicts, near, is_on), note
