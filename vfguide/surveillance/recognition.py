"""What the reports of one address have shown of whether it is the ownship's own transponder."""

from typing import NamedTuple

from vfguide.geometry.units import DEG
from vfguide.link.boot_time import elapsed

LEAST_REPORTS = 4
"""Number of successive reports that have to agree with the ownship's track; chosen."""
LEAST_TIME = 3.0
"""Least time from the first to the last report that agrees [s]; chosen."""
LEAST_TURN = 45.0 * DEG
"""Least turn of the ownship over the part of its track that late reports agree with [rad]; chosen:
an aircraft that holds its place behind has left the track by then."""
LATE_TURN = 20.0 * DEG
"""Turn of the ownship since the point of its track that a report agrees with, from which on the
report is late, and not of an aircraft that turns with the ownship [rad]; chosen: the velocities of
the two differ by 5 m/s at 15 m/s."""
LEAST_LATE_TURNS = 3
"""Number of reports that are late in a turn which show as much as LEAST_TURN; chosen: an aircraft
behind that flies straight on has left the track by then."""
LEAST_TIME_IF_SEEN_ELSEWHERE = 60.0
"""Time from the first to the last report for an address that was seen elsewhere before [s];
chosen."""
LEAST_TURN_IF_SEEN_ELSEWHERE = 360.0 * DEG
"""Turn of the ownship over the reports of an address that was seen elsewhere before [rad]; chosen,
a full circle."""
SPEED_TOLERANCE = 0.6
"""Mean difference of the speeds over ground within which reports agree [m/s]; chosen: an aircraft
that overtakes, or follows outside in a turn, is faster."""
SPEED_SMOOTHING = 0.1
"""Weight of a report in the mean difference of the speeds, a share; chosen, ten reports. The first
ten all weigh the same."""


class Recognition(NamedTuple):
    """What the reports of one address have shown."""

    reports: int = 0
    """Number of successive reports that agreed."""
    since_ms: int = 0
    """Arrival of the first of them, as time_boot_ms [ms]."""
    course: float = 0.0
    """Course of the ownship where the last one agreed, not wrapped [rad]."""
    least_course: float = 0.0
    """Least of those courses [rad]."""
    greatest_course: float = 0.0
    """Greatest of those courses [rad]."""
    late_turns: int = 0
    """Number of them that were late in a turn, as LATE_TURN says."""
    speed_error: float = 0.0
    """Mean of the reported speeds less those of the ownship [m/s]."""
    is_where_told: bool = True
    """Whether each of them was where the ownship was at the age that it reported."""
    misses: int = 0
    """Number of successive reports that did not agree."""
    always_agreed: bool = True
    """Whether each report that was ever received agreed."""
    never_missed: bool = True
    """Whether none has disagreed; one that may be from before the track does not count."""
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
