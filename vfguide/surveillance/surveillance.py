"""Surveillance of traffic: rows for the step, alerts for the operator."""

from collections.abc import Sequence

from vfguide.airspace.hazards import Hazards, traffic_rows
from vfguide.field.obstacle import Rows
from vfguide.geometry.vector import norm, sub
from vfguide.link.boot_time import elapsed
from vfguide.link.messages import AdsbVehicle
from vfguide.surveillance.alerts import Alert, look
from vfguide.surveillance.heights import UNKNOWN_DATUM, HeightDatum
from vfguide.surveillance.picture import Picture
from vfguide.surveillance.report import Ownship, Report, placed_at

LOOK_INTERVAL = 0.5
"""Time between two looks at the traffic [s]; chosen."""
REACH = 40.0
"""Time within which an aircraft must be able to meet the vehicle to be in the step [s]; chosen
above the lookahead of alerts."""
MAX_INTRUDERS = 8
"""Largest number of aircraft in the step, those in conflict before the nearest ones; chosen for the
time they take."""


class Surveillance:
    """The traffic picture, looked at twice a second."""

    def __init__(self, picture: Picture) -> None:
        """Surveillance before the first report."""
        self._picture = picture
        self._alerts: dict[int, Alert] = {}
        self._near: tuple[int, ...] = ()
        self._looked: int | None = None

    @property
    def is_listening(self) -> bool:
        """Whether there is traffic, so that the ownship's track matters."""
        return not self._picture.is_empty

    def follow(self, ownship: Ownship) -> None:
        """Take the ownship's state, later than before."""
        self._picture.follow(ownship)

    def hear(
        self,
        said: AdsbVehicle,
        now_ms: int,
        ownship: Ownship | None = None,
        datum: HeightDatum = UNKNOWN_DATUM,
    ) -> list[str]:
        """Take a report as `Picture.hear` does; returns notes for the operator."""
        return self._picture.hear(said, now_ms, ownship, datum)

    def is_due(self, now_ms: int) -> bool:
        """Whether there is traffic, and LOOK_INTERVAL has passed by `now_ms` [ms] since a look."""
        if self._picture.is_empty:
            return False
        return self._looked is None or not 0.0 <= elapsed(self._looked, now_ms) < LOOK_INTERVAL

    def look(self, ownship: Ownship) -> list[str]:
        """Look at all others; returns notes for the operator."""
        self._looked = ownship.time_ms
        self._picture.forget(ownship.time_ms)
        tracks = self._picture.others(ownship)
        others = [each for each in tracks if within_reach(each.report, ownship)]
        before, self._alerts = self._alerts, {}
        notes: list[str] = []
        for number, report, *_ in others:
            self._alerts[number], note = look(before.get(number, Alert()), report, ownship)
            notes += [note] if note else []
        others.sort(key=lambda each: not self._alerts[each.number].near[-1])
        self._near = tuple(each.number for each in others[:MAX_INTRUDERS])
        return notes

    def among(self, hazards: Hazards, now_ms: int, t: float) -> Hazards:
        """The hazards with the aircraft in reach as their traffic; unchanged if there are none.

        The time is `now_ms` [ms] on the clock of the autopilot, `t` [s] on that of the obstacles.
        """
        return hazards._replace(traffic=self.rows(now_ms, t)) if self._near else hazards

    def rows(self, now_ms: int, t: float) -> Rows:
        """The rows of `Intruder` of the aircraft in reach, at the times of `among`."""
        reports = (self._picture.newest(number) for number in self._near)
        return rows_of([each for each in reports if each is not None], now_ms, t)


def rows_of(reports: Sequence[Report], now_ms: int, t: float) -> Rows:
    """The rows of `Intruder` of reports, whose times are on the clock of the obstacles.

    It is at `t` [s] when the autopilot's is at `now_ms` [ms].
    """
    return traffic_rows(
        [each.intruder._replace(time=t - elapsed(each.time_ms, now_ms)) for each in reports]
    )


def within_reach(each: Report, ownship: Ownship) -> bool:
    """Whether an aircraft can meet the ownship within REACH."""
    apart = norm(sub(placed_at(each, ownship.time_ms), ownship.p_n)) - each.intruder.radius
    closing = norm(each.intruder.v_n) + each.intruder.uncertainty_rate + norm(ownship.v_n)
    return apart <= REACH * closing
