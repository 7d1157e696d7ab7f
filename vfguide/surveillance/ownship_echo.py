"""Recognition of the ownship's own transponder among the reports.

Every report of an echo agrees with the ownship's track, late by a time that may change. Two things
tell an echo from another aircraft. By the age that it reports, it is where the ownship was then,
and nothing else can have been there. Or it is later than it says, and a turn shows that it flies
where the ownship has flown: on a straight, an aircraft behind would report the same. An address
that was ever seen elsewhere has to agree for much longer.
"""

import math

from vfguide.geometry.vector import Vec3
from vfguide.link.boot_time import elapsed
from vfguide.surveillance.own_track import (
    POSITION_TOLERANCE,
    TRACK_TIME,
    OwnTrack,
    match,
    may_precede,
    own_at,
)
from vfguide.surveillance.recognition import (
    LATE_TURN,
    SPEED_SMOOTHING,
    SPEED_TOLERANCE,
    Recognition,
    is_shown,
)
from vfguide.surveillance.report import Ownship, Report

HEIGHT_TOLERANCE = 25.0
"""Difference of the heights within which reports agree, without the doubt of the reported one [m];
chosen as twice the error of a satellite receiver's height."""
CLIMB_TOLERANCE = 4.0
"""Difference of the vertical speeds within which reports agree [m/s]; chosen as that of the
horizontal ones."""
CLEAR_MISS = 1.5
"""Miss of a match beyond which one report shows that it is another aircraft, as a ratio to the
tolerances; chosen: for an echo six standard deviations of errors of 3 m in each axis."""


def after_report(
    was: Recognition, report: Report, ownship: Ownship, track: OwnTrack
) -> Recognition:
    """What the reports have shown after one more; `ownship` is the state when it arrives."""
    if elapsed(report.time_ms, ownship.time_ms) > TRACK_TIME or not report.tells_velocity:
        return was
    found = match(track, ownship, report.intruder.p_n, report.intruder.v_n)
    if found.miss <= 1.0 and is_level_with(report, found.own):
        return _agreed(was, report, ownship, track, found.own)
    if may_precede(track, ownship, report.intruder.p_n):
        return was._replace(always_agreed=False)
    return _missed(was, found.miss > CLEAR_MISS)


def is_level_with(report: Report, own: Ownship) -> bool:
    """Whether height and vertical speed of a report agree with the ownship's."""
    each = report.intruder
    height, climb = each.p_n[2] - own.p_n[2], each.v_n[2] - own.v_n[2]
    near = abs(height) <= HEIGHT_TOLERANCE + report.height_doubt
    return near and (abs(climb) <= CLIMB_TOLERANCE or not report.tells_climb)


def _agreed(
    was: Recognition, report: Report, ownship: Ownship, track: OwnTrack, own: Ownship
) -> Recognition:
    """What the reports have shown after one that agrees with the ownship as it was at `own`."""
    seen, said = own.v_n, report.intruder.v_n
    course = was.course + math.remainder(math.atan2(seen[1], seen[0]) - was.course, math.tau)
    if not was.reports:
        was = was._replace(since_ms=ownship.time_ms, least_course=course, greatest_course=course)
    turned_since = abs(angle_between(seen, ownship.v_n))
    faster = math.hypot(said[0], said[1]) - math.hypot(seen[0], seen[1])
    weight = max(SPEED_SMOOTHING, 1.0 / (was.reports + 1))
    now = was._replace(
        reports=was.reports + 1,
        course=course,
        least_course=min(course, was.least_course),
        greatest_course=max(course, was.greatest_course),
        late_turns=was.late_turns + (turned_since >= LATE_TURN),
        speed_error=was.speed_error + weight * (faster - was.speed_error),
        is_where_told=was.is_where_told and is_where_told(report, ownship, track),
        misses=0,
    )
    if was.is_own and abs(now.speed_error) > SPEED_TOLERANCE:
        return Recognition(always_agreed=False, never_missed=False, was_elsewhere=True)
    return now._replace(is_own=was.is_own or is_shown(now, ownship.time_ms))


def angle_between(v_n: Vec3, w_n: Vec3) -> float:
    """Angle from the course of one velocity to that of another, -pi to pi [rad]."""
    return math.remainder(math.atan2(w_n[1], w_n[0]) - math.atan2(v_n[1], v_n[0]), math.tau)


def is_where_told(report: Report, ownship: Ownship, track: OwnTrack) -> bool:
    """Whether a report is where the ownship was at the age that it reports."""
    there, own = report.intruder.p_n, own_at(track, ownship, report.time_ms).p_n
    return math.hypot(there[0] - own[0], there[1] - own[1]) <= POSITION_TOLERANCE


def _missed(was: Recognition, clearly: bool) -> Recognition:
    """What the reports have shown after one that disagrees.

    A recognised address is given up at the second one in a row, or at one that disagrees clearly.
    """
    if was.is_own and not clearly and not was.misses:
        return was._replace(misses=1)
    was_own = was.is_own or was.was_own
    elsewhere = was.was_elsewhere or (clearly and not was_own)
    return Recognition(
        always_agreed=False, never_missed=False, was_own=was_own, was_elsewhere=elsewhere
    )
