"""Traffic alerts: which other aircraft comes too near, with hysteresis.

Conflicts are found at the closest point of approach of two straight flights (CPA), as in DO-365.
"""

import math
from typing import NamedTuple

from vfguide.geometry.vector import Vec3, sub
from vfguide.link.boot_time import elapsed
from vfguide.surveillance.report import Ownship, Report, placed_at

LOOKAHEAD = 30.0
"""Time ahead within which conflicts are looked for [s]; chosen."""
LOOKS = 5
"""Number of the last looks that an alert depends on: N of the M-of-N filter of NASA DAIDALUS, the
reference implementation of DO-365; chosen."""
ENOUGH = 3
"""Number of the last looks with a conflict at which an alert begins: M of the M-of-N filter;
chosen."""
RELEASE_FACTOR = 1.5
"""Factor of the volume whose conflicts keep an alert on; chosen as hysteresis."""


class Encounter(NamedTuple):
    """The closest point of approach of two aircraft that fly straight on."""

    time: float
    """Time until their horizontal distance is least [s]."""
    miss: float
    """Horizontal distance at that time [m]."""
    violates: bool
    """Whether one enters the volume of the other within LOOKAHEAD."""


class Alert(NamedTuple):
    """The last looks at one aircraft."""

    conflicts: tuple[bool, ...] = ()
    """Whether each look saw a conflict."""
    near: tuple[bool, ...] = ()
    """Whether each look saw a conflict with the volume of RELEASE_FACTOR."""
    is_on: bool = False
    """Whether the operator has been alerted."""


def encounter(x_n: Vec3, v_n: Vec3, radius: float, half_height: float) -> Encounter:
    """The encounter with an aircraft at `x_n` [m] that moves with `v_n` [m/s], both relative, NED.

    It violates the volume while it is within `radius` horizontally and within `half_height`
    vertically [m] at the same time.
    """
    square = v_n[0] * v_n[0] + v_n[1] * v_n[1]
    closing = -(x_n[0] * v_n[0] + x_n[1] * v_n[1])
    time = min(max(closing / square, 0.0), LOOKAHEAD) if square > 1e-9 else 0.0
    miss = math.hypot(x_n[0] + time * v_n[0], x_n[1] + time * v_n[1])
    beside = _beside(x_n, v_n, radius)
    level = _level(x_n[2], v_n[2], half_height)
    begin, end = max(beside[0], level[0], 0.0), min(beside[1], level[1], LOOKAHEAD)
    return Encounter(time, miss, begin <= end)


def _beside(x_n: Vec3, v_n: Vec3, radius: float) -> tuple[float, float]:
    """First and last time within `radius` horizontally [s]; where never, the first is later."""
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
    """First and last time within `half_height` vertically [s]; where never, the first is later."""
    if abs(v_z) < 1e-9:
        return (-math.inf, math.inf) if abs(z) <= half_height else (math.inf, -math.inf)
    one, other = (-half_height - z) / v_z, (half_height - z) / v_z
    return (min(one, other), max(one, other))


def look(alert: Alert, report: Report, ownship: Ownship) -> tuple[Alert, str]:
    """The alert after another look, and a note to the operator, empty if there is none.

    Args:
        alert: the alert after the look before.
        report: the newest report of the aircraft.
        ownship: the ownship now.
    """
    each = report.intruder
    age = max(0.0, elapsed(report.time_ms, ownship.time_ms))
    radius, half_height = (
        each.radius + age * each.uncertainty_rate,
        each.half_height + age * each.uncertainty_rate_up,
    )
    x_n, v_n = sub(placed_at(report, ownship.time_ms), ownship.p_n), sub(each.v_n, ownship.v_n)
    met = encounter(x_n, v_n, radius, half_height)
    wide = encounter(x_n, v_n, RELEASE_FACTOR * radius, RELEASE_FACTOR * half_height)
    conflicts = (*alert.conflicts, met.violates)[-LOOKS:]
    near = (*alert.near, wide.violates)[-LOOKS:]
    is_on = any(near) if alert.is_on else sum(conflicts) >= ENOUGH
    note = ""
    if is_on and not alert.is_on:
        note = f"traffic {report.name} in {met.time:.0f} s, {met.miss:.0f} m"
    if alert.is_on and not is_on:
        note = f"traffic {report.name} is no conflict any more"
    return Alert(conflicts, near, is_on), note
