"""Place: whether the vehicle is where its plan is, and whether the autopilot reports one place.

An autopilot without a fix reports an origin of its local frame at 0 N 0 E, and the plan of another
airfield is easily loaded. No setpoints are sent there. In flight, an estimator may glitch by any
distance for a few seconds: the flight goes on from the last right place with the reported velocity.
A wrong place that lasts ends the flight.
"""

import math

from vfguide.annunciations.flight_notes import origin_notes
from vfguide.companion.plan import Plan
from vfguide.estimation.local_frame import (
    Measurement,
    distance_from,
    measured_position,
    without_names,
)
from vfguide.geometry.units import DEG_E7, KM, MM, MS
from vfguide.geometry.vector import add, norm, scale, sub
from vfguide.link.boot_time import elapsed
from vfguide.link.messages import GlobalPositionInt, GpsGlobalOrigin, LocalPositionNed, VfrHud
from vfguide.telemetry.knowledge import Knowledge, measurement

PLACE_INTERVAL = 200
"""Time between two looks at the place in flight [ms]; chosen."""
LONGEST_GLITCH = 4000
"""Time for which a wrong place is flown through [ms]; chosen above the 3 s for which estimators
are known to glitch, and short, since a wrong goal is flown to meanwhile."""
RIGHT_LASTS = 1000
"""Time for which the place has to be right again in flight before it is followed [ms]; chosen, so
that one that goes to and fro is wrong all the time."""
RIGHT_BEFORE = 500
"""Time for which the place has to be right again before it is followed where setpoints are only
offered [ms]; chosen, so that nothing goes out where it goes to and fro."""
ORIGIN_NOTE_INTERVAL = 10_000
"""Least time between two notes of an origin that has moved [ms]; chosen."""
IN_FLIGHT = 1.5
"""Ratio of the distance and height at which a plan may be flown to those at which it may be begun;
chosen, so that a flight that begins at the limit may turn round first."""
PLACE_LEAP = 1000.0
"""Step of the position, the sum over its three axes, above which the place is looked at at once
[m]; chosen."""
LEAST_REACH = 10_000.0
"""Distance from the nearest goal that any plan may be begun at [m]; chosen."""
LEAST_CLIMB = 300.0
"""Height from the nearest goal that any plan may be begun at [m]; chosen."""
CONTRADICTION = 100.0
"""Distance between two places that one autopilot reports above which they contradict each other
[m]; chosen, in recorded flights they differ by 0.3 m."""
SAME_TIME = 0.2
"""Longest time between two places that are compared [s]; chosen, 10 m at 50 m/s."""
NOT_FOLLOWED = f"{{why}}: not followed unless it lasts {LONGEST_GLITCH * MS:.0f} s"
"""Note where the place goes wrong in flight."""
RIGHT_AGAIN = "the place told by the autopilot is right again"
"""Note where a wrong place was flown through."""
TOO_FAR = (
    "the autopilot tells a place {distance:.0f} km from the nearest goal, "
    "in the time of the plan {reach:.0f} km can be flown"
)
"""Reason for silence where the vehicle is not where the plan is."""
TOO_HIGH = (
    "the autopilot tells an altitude {distance:.0f} m from the nearest goal's, "
    "in the time of the plan {reach:.0f} m can be climbed or sunk"
)
"""Reason for silence where the vehicle is not at the height of the plan."""
TWO_PLACES = (
    "GPS_GLOBAL_ORIGIN and LOCAL_POSITION_NED tell a place {distance:.0f} m "
    "from the one in GLOBAL_POSITION_INT"
)
"""Reason for silence where the autopilot reports two places."""
TWO_ALTITUDES = (
    "GPS_GLOBAL_ORIGIN and LOCAL_POSITION_NED tell an altitude {distance:.0f} m "
    "from the one in VFR_HUD"
)
"""Reason for silence where the autopilot reports two altitudes."""


class PlaceWatch:
    """Compares the places that the autopilot reports with the plan, and with each other."""

    def __init__(self, plan: Plan, notes: list[str]) -> None:
        """A watch that has not looked yet, of a `plan`; it tells the operator by `notes`."""
        self._notes = notes
        self._plan = plan
        self._looked: int | None = None
        self.wrong: str | None = None
        """Why the place is wrong, so that the origin is asked for again; None: it is right."""
        self._since = 0
        self._wrong_last = 0
        self._right_from: int | None = None
        self._told_origin: int | None = None
        self._origin: GpsGlobalOrigin | None = None
        self._position: LocalPositionNed | None = None
        self._hud: VfrHud | None = None

    def hindrance(self, *, follows: bool) -> str | None:
        """Why the place keeps the companion from guiding; None: it does not.

        In flight, where the autopilot `follows`, it has to be wrong for LONGEST_GLITCH.
        """
        lasts = self._wrong_last - self._since >= LONGEST_GLITCH
        return self.wrong if lasts or not follows else None

    def checked(self, known: Knowledge, *, follows: bool) -> Knowledge:
        """What to guide on: a wrong place is replaced by the motion since the last right one.

        In flight, where the autopilot `follows`, a place that moves on is looked at now and then.
        """
        if not follows or self._is_due(known):
            self._look(known, follows=follows)
        if self.wrong is None:
            if known.origin is not self._origin:
                self._tell_of_origin(known)
            self._origin, self._position, self._hud = known.origin, known.position, known.hud
            return known
        was, hud = self._position, known.hud
        if was is None or known.position is None or hud is None or self._hud is None:
            return known
        self._position = moved_on(was, known.position)
        hud = hud._replace(alt=self._hud.alt)  # the density of the air is that of its height
        return known._replace(origin=self._origin, position=self._position, hud=hud)

    def _tell_of_origin(self, known: Knowledge) -> None:
        """Tell of an origin that has moved, unless that has been told of late."""
        notes, now = origin_notes(self._origin, known.origin), known.time_ms
        if notes and (self._told_origin is None or now - self._told_origin >= ORIGIN_NOTE_INTERVAL):
            self._notes += notes
            self._told_origin = now

    def _is_due(self, known: Knowledge) -> bool:
        """Whether it is time to look, or the place does not go on from the last one."""
        was, now = self._position, known.position
        if self.wrong is not None or self._looked is None or was is None or now is None:
            return True
        (_, x0, y0, z0, *_), (_, x, y, z, *_) = was, now
        leapt = abs(x - x0) + abs(y - y0) + abs(z - z0) > PLACE_LEAP
        return (
            leapt
            or known.origin is not self._origin
            or known.time_ms - self._looked >= PLACE_INTERVAL
        )

    def _look(self, known: Knowledge, *, follows: bool) -> None:
        """Look at the place, and tell where it goes wrong in flight."""
        self._looked = now = known.time_ms
        measured = measurement(known)
        if measured is None:
            return
        wrong = wrong_place(self._plan, known, measured, follows=follows)
        if self._goes_to_and_fro(now, wrong, RIGHT_LASTS if follows else RIGHT_BEFORE):
            return
        if wrong is None or self.wrong is None:
            self._since = self._wrong_last = now
        else:
            self._wrong_last = now
        if follows and (wrong is None) != (self.wrong is None):
            self._notes.append(NOT_FOLLOWED.format(why=wrong) if wrong else RIGHT_AGAIN)
        self.wrong = wrong

    def _goes_to_and_fro(self, now: int, wrong: str | None, lasts: int) -> bool:
        """Whether a wrong place has not been right again for so long at `now`, both [ms]."""
        if wrong is not None or self.wrong is None:
            self._right_from = None
            return False
        if self._right_from is None:
            self._right_from = now
        return now - self._right_from < lasts


def moved_on(position: LocalPositionNed, told: LocalPositionNed) -> LocalPositionNed:
    """A position moved on to the time of a reported one, `told`, with its velocity."""
    dt = max(elapsed(position.time_boot_ms, told.time_boot_ms), 0.0)
    x, y, z = add((position.x, position.y, position.z), scale(dt, (told.vx, told.vy, told.vz)))
    return told._replace(x=x, y=y, z=z)


def wrong_place(plan: Plan, known: Knowledge, m: Measurement, *, follows: bool) -> str | None:
    """Why a measurement cannot be that of a vehicle at the place of `plan`; None: it can."""
    p_n = measured_position(without_names(m), plan.origin)
    factor = IN_FLIGHT if follows else 1.0
    distance, reach = min(norm(sub(goal.p_n, p_n)) for goal in plan.goals), reach_of(plan)
    if not distance <= factor * reach:
        return TOO_FAR.format(distance=distance / KM, reach=reach / KM)
    height, climb = min(abs(goal.p_n[2] - p_n[2]) for goal in plan.goals), climb_of(plan)
    if not height <= factor * climb:
        return TOO_HIGH.format(distance=height, reach=climb)
    return contradiction(known, m)


def contradiction(known: Knowledge, m: Measurement) -> str | None:
    """How the places that the autopilot reports contradict each other; None: they do not."""
    rise = abs(m.altitude - (m.origin[2] - m.p_l[2]))
    if not rise <= CONTRADICTION:
        return TWO_ALTITUDES.format(distance=rise)
    place, position = known.place, known.position
    if place is None or position is None:
        return None
    if abs(elapsed(place.time_boot_ms, position.time_boot_ms)) > SAME_TIME:
        return None
    apart = distance_between(place, m)
    return TWO_PLACES.format(distance=apart) if not apart <= CONTRADICTION else None


def distance_between(told: GlobalPositionInt, m: Measurement) -> float:
    """Horizontal distance of a global position from that of the local frame [m]."""
    return distance_from(without_names(m), (told.lat * DEG_E7, told.lon * DEG_E7, told.alt * MM))


def reach_of(plan: Plan) -> float:
    """Distance from the nearest goal at which a flight may begin [m]."""
    return max(LEAST_REACH, plan.gains.airspeed * plan.longest)


def climb_of(plan: Plan) -> float:
    """Height from the nearest goal at which a flight may begin [m]."""
    angle = max(plan.aircraft.climb_max, plan.aircraft.descent_max)
    return max(LEAST_CLIMB, plan.gains.airspeed * math.sin(angle) * plan.longest)
