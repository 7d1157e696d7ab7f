"""Velocity of an aircraft, derived from its positions where it reports none, or a wrong one.

Receivers are known that call a velocity valid which they do not have: north, or zero.
"""

from collections.abc import Sequence
from itertools import pairwise

from vfguide.geometry.vector import Vec3, add, dot, norm, scale, sub
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
CONTRADICTION_TIME = 2.0
"""Least time over which reported velocities are compared with positions [s]; chosen."""
REPORT_DELAY = 3.0
"""Error of the time between two reports that does not count against a velocity [s]; chosen, since
receivers pass reports on up to 3 s late."""
PLACE_MISS = 30.0
"""Distance by which reported velocities may miss a later position [m]; chosen above errors of 10 m
in each of two reports."""
CLIMB_MISS = 16.0
"""Height by which reported vertical speeds may miss a later height [m]; chosen, two steps of
heights."""


def past_reports(before: Sequence[Report], report: Report) -> tuple[Report, ...]:
    """The last reports of an aircraft with one more, not older than PAST_TIME."""
    kept = [each for each in before if elapsed(each.time_ms, report.time_ms) <= PAST_TIME]
    return (*kept, report)


def with_derived_velocity(report: Report, past: Sequence[Report], volume: Volume) -> Report:
    """The report with a velocity derived from the oldest past one, where its own is none or wrong.

    Its volume grows by the error of that velocity, not by ASSUMED_SPEED or ASSUMED_CLIMB.
    """
    time = elapsed(past[0].time_ms, report.time_ms) if past else 0.0
    if time < LEAST_PAST_TIME:
        return report
    same_height = abs(report.height_doubt - past[0].height_doubt) < HEIGHT_STEP
    is_told, climb_is_told = report.tells_velocity, report.tells_climb
    if time >= CONTRADICTION_TIME:
        is_told = is_told and miss_of_velocity(report, past) <= allowed_miss(report, past)
        climb_is_told = climb_is_told and miss_of_climb(report, past) <= CLIMB_MISS
    each = report.intruder
    vx, vy, vz = each.v_n
    north, east, down = scale(1.0 / time, sub(each.p_n, past[0].intruder.p_n))
    rate, rate_up = each.uncertainty_rate, each.uncertainty_rate_up
    if not is_told:
        vx, vy = north, east
        rate = volume.uncertainty_rate + min(POSITION_STEP / time, ASSUMED_SPEED)
    if not climb_is_told and same_height:
        vz = down
        rate_up = volume.uncertainty_rate_up + min(HEIGHT_STEP / time, ASSUMED_CLIMB)
    return report._replace(
        intruder=each._replace(v_n=(vx, vy, vz), uncertainty_rate=rate, uncertainty_rate_up=rate_up)
    )


def miss_of_velocity(report: Report, past: Sequence[Report]) -> float:
    """Distance by which the reported velocities since the oldest report miss the newest place [m].

    The time between the two may be wrong by REPORT_DELAY, but not negative.
    """
    time = elapsed(past[0].time_ms, report.time_ms)
    moved = level(sub(report.intruder.p_n, past[0].intruder.p_n))
    by_velocity = level(told_motion(report, past))
    along, square = dot(moved, by_velocity), dot(by_velocity, by_velocity)
    least, most = max(0.0, 1.0 - REPORT_DELAY / time), 1.0 + REPORT_DELAY / time
    share = min(max(along / square, least), most) if square > 0.0 else 1.0
    return norm(sub(moved, scale(share, by_velocity)))


def allowed_miss(report: Report, past: Sequence[Report]) -> float:
    """The miss of reported velocities up to which they are believed [m].

    In a turn, an error of the time moves the place by that time, times the change of the velocity.
    """
    turned = sub(report.intruder.v_n, past[0].intruder.v_n)
    return PLACE_MISS + REPORT_DELAY * norm(level(turned))


def miss_of_climb(report: Report, past: Sequence[Report]) -> float:
    """Height by which the reported vertical speeds since the oldest report miss the newest [m]."""
    moved = sub(report.intruder.p_n, past[0].intruder.p_n)
    return abs(moved[2] - told_motion(report, past)[2])


def told_motion(report: Report, past: Sequence[Report]) -> Vec3:
    """The motion since the oldest report by the reported velocities (trapezoidal rule), NED [m]."""
    motion = (0.0, 0.0, 0.0)
    for one, after in pairwise((*past, report)):
        half = 0.5 * elapsed(one.time_ms, after.time_ms)
        motion = add(motion, scale(half, add(one.intruder.v_n, after.intruder.v_n)))
    return motion


def level(x_n: Vec3) -> Vec3:
    """The horizontal part of a vector, NED."""
    return (x_n[0], x_n[1], 0.0)
