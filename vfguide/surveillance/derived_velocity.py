"""Velocity of an aircraft that reports none, from where it was."""

from collections.abc import Sequence

from vfguide.geometry.vector import scale, sub
from vfguide.link.boot_time import elapsed
from vfguide.surveillance.report import ASSUMED_CLIMB, ASSUMED_SPEED, Report, Volume

PAST_TIME = 4.0
"""Time over which a velocity is derived [s]; chosen: within it an aircraft turns little."""
LEAST_PAST_TIME = 1.0
"""Least time over which a velocity is derived [s]; chosen, the interval of reports."""
POSITION_STEP = 20.0
"""Error of the difference of two reported positions [m]; chosen: 10 m for each."""
HEIGHT_STEP = 8.0
"""Error of the difference of two reported heights [m]; chosen, the 25 ft in which they come."""


def past_reports(before: Sequence[Report], report: Report) -> tuple[Report, ...]:
    """The last reports of an aircraft with one more, not older than PAST_TIME."""
    kept = [each for each in before if elapsed(each.time_ms, report.time_ms) <= PAST_TIME]
    return (*kept, report)


def with_derived_velocity(report: Report, past: Sequence[Report], volume: Volume) -> Report:
    """The report with a velocity from the oldest of the past ones, where it tells none.

    Its doubt grows by the error of that velocity instead of that of a standing aircraft.
    """
    time = elapsed(past[0].time_ms, report.time_ms) if past else 0.0
    if time < LEAST_PAST_TIME or (report.tells_velocity and report.tells_climb):
        return report
    each = report.intruder
    vx, vy, vz = each.v_n
    north, east, down = scale(1.0 / time, sub(each.p_n, past[0].intruder.p_n))
    rate, rate_up = each.uncertainty_rate, each.uncertainty_rate_up
    if not report.tells_velocity:
        vx, vy = north, east
        rate = volume.uncertainty_rate + min(POSITION_STEP / time, ASSUMED_SPEED)
    if not report.tells_climb and abs(report.height_doubt - past[0].height_doubt) < HEIGHT_STEP:
        vz = down
        rate_up = volume.uncertainty_rate_up + min(HEIGHT_STEP / time, ASSUMED_CLIMB)
    return report._replace(
        intruder=each._replace(v_n=(vx, vy, vz), uncertainty_rate=rate, uncertainty_rate_up=rate_up)
    )
