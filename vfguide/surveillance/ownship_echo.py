"""Recognition of the ownship's own transponder among the reports.

An echo agrees with the ownship's track, late by a time that may change, in every report since the
first. Two things tell it from another aircraft. At the age that it tells it is where the ownship
was then: nothing else can be there. Or it is late, and a turn shows that it flies where the ownship
has flown: on a straight an aircraft behind would report the same. An address that was ever seen
elsewhere has to agree for much longer.
"""

import math
from typing import NamedTuple

from vfguide.geometry.units import DEG
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
from vfguide.surveillance.report import Ownship, Report

LEAST_REPORTS = 4
"""Number of successive reports that have to agree; chosen."""
LEAST_TIME = 3.0
"""Time from the first to the last of them [s]; chosen."""
LEAST_TURN = 45.0 * DEG
"""Turn of the ownship on those parts of its track that late reports agree with [rad]; chosen: an
aircraft that holds its place behind has left the track by then."""
LATE_TURN = 20.0 * DEG
"""Turn of the ownship since it was where a report agrees with it, from which the report shows that
it is late, and not of an aircraft that turns with the ownship [rad]; chosen: 5 m/s at 15 m/s."""
LEAST_LATE_TURNS = 3
"""Number of such reports that do as well as LEAST_TURN; chosen: an aircraft behind that flies
straight on has left the track by then."""
LEAST_TIME_IF_SEEN_ELSEWHERE = 60.0
"""The same time for an address that was seen elsewhere before [s]; chosen."""
LEAST_TURN_IF_SEEN_ELSEWHERE = 360.0 * DEG
"""The same turn for such an address [rad]; chosen, a full circle."""
SPEED_TOLERANCE = 0.6
"""Mean difference of the speeds over ground within which reports agree [m/s]; chosen: one that
overtakes, or follows outside in a turn, is faster."""
SPEED_SMOOTHING = 0.1
"""Weight of a report in that mean, once there are enough; chosen, ten reports."""
HEIGHT_TOLERANCE = 25.0
"""Difference of the heights within which reports agree, without the doubt of the reported one [m];
chosen as twice the error of a satellite receiver's height."""
CLIMB_TOLERANCE = 4.0
"""Difference of the vertical speeds within which reports agree [m/s]; chosen as that of the
horizontal ones."""
CLEAR_MISS = 1.5
"""Miss of a match beyond which one report shows that it is another aircraft; chosen: for an echo
six standard deviations of the errors that POSITION_TOLERANCE is for."""


class Recognition(NamedTuple):
    """What the reports of one address have shown."""

    reports: int = 0
    """Number of successive reports that agreed."""
    since_ms: int = 0
    """Arrival of the first of them, as time_boot_ms [ms]."""
    course: float = 0.0
    """Course of the ownship where the last one agreed, without leaps [rad]."""
    least_course: float = 0.0
    """Least of those courses [rad]."""
    greatest_course: float = 0.0
    """Greatest of those courses [rad]."""
    late_turns: int = 0
    """Number of them that were late in a turn, as LATE_TURN says."""
    speed_error: float = 0.0
    """Mean of the reported speeds less those of the ownship [m/s]."""
    is_where_told: bool = True
    """Whether each of them was where the ownship was at the age that it told."""
    misses: int = 0
    """Number of successive reports that did not agree."""
    always_agreed: bool = True
    """Whether each report that was ever heard agreed."""
    never_missed: bool = True
    """Whether none has shown that it does not: it may have been of a time before the track."""
    was_own: bool = False
    """Whether it was recognised before."""
    was_elsewhere: bool = False
    """Whether it was clearly elsewhere before it was recognised."""
    is_own: bool = False
    """Whether it is recognised."""

    @property
    def is_ignored(self) -> bool:
        """Whether its reports are not traffic: it is recognised, or new and at the ownship."""
        is_new = 0 < self.reports <= LEAST_REPORTS and self.always_agreed
        return self.is_own or (is_new and self.is_where_told)

    @property
    def turned(self) -> float:
        """The turn that the reports have shown [rad]."""
        return self.greatest_course - self.least_course


def after_report(
    was: Recognition, report: Report, ownship: Ownship, track: OwnTrack
) -> Recognition:
    """What is shown after one more report, that arrives while the ownship is at `ownship`."""
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
    """After a report that agrees with the ownship as it was at `own`."""
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


def is_shown(now: Recognition, now_ms: int) -> bool:
    """Whether the reports up to `now_ms` [ms] can be of nothing but the ownship."""
    lasted = elapsed(now.since_ms, now_ms)
    if now.reports < LEAST_REPORTS or abs(now.speed_error) > SPEED_TOLERANCE:
        return False
    if now.was_elsewhere:
        return lasted >= LEAST_TIME_IF_SEEN_ELSEWHERE and now.turned >= LEAST_TURN_IF_SEEN_ELSEWHERE
    is_near = now.is_where_told and (now.never_missed or now.was_own)
    shows_turn = now.turned >= LEAST_TURN or now.late_turns >= LEAST_LATE_TURNS
    return lasted >= LEAST_TIME and (is_near or shows_turn)


def angle_between(v_n: Vec3, w_n: Vec3) -> float:
    """Angle from the course of one velocity to that of another, -pi to pi [rad]."""
    return math.remainder(math.atan2(w_n[1], w_n[0]) - math.atan2(v_n[1], v_n[0]), math.tau)


def is_where_told(report: Report, ownship: Ownship, track: OwnTrack) -> bool:
    """Whether a report is where the ownship was at the age that it tells."""
    there, own = report.intruder.p_n, own_at(track, ownship, report.time_ms).p_n
    return math.hypot(there[0] - own[0], there[1] - own[1]) <= POSITION_TOLERANCE


def _missed(was: Recognition, clearly: bool) -> Recognition:
    """After a report that disagrees.

    A recognised address is given up at the second one in a row, or where it disagrees clearly.
    """
    if was.is_own and not clearly and not was.misses:
        return was._replace(misses=1)
    was_own = was.is_own or was.was_own
    elsewhere = was.was_elsewhere or (clearly and not was_own)
    return Recognition(
        always_agreed=False, never_missed=False, was_own=was_own, was_elsewhere=elsewhere
    )
