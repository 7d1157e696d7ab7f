"""The reports of one aircraft: which of them are used."""

from typing import NamedTuple

from vfguide.geometry.vector import norm, sub
from vfguide.link.boot_time import elapsed
from vfguide.surveillance.derived_velocity import past_reports, with_derived_velocity
from vfguide.surveillance.recognition import Recognition
from vfguide.surveillance.report import Report, Volume, placed_at

JUMP_DISTANCE = 300.0
"""Distance from the prediction of the last report beyond which a report is used only if the next
one agrees with it [m]; chosen."""
JUMP_SPEED = 100.0
"""Growth of that distance with the time between the reports [m/s]; chosen."""


class Heard(NamedTuple):
    """The reports that are kept of one aircraft."""

    report: Report
    """The newest one that is used."""
    odd: Report | None = None
    """A later one that did not fit; None: none since."""
    past: tuple[Report, ...] = ()
    """The used ones from which a velocity is derived."""
    recognition: Recognition = Recognition()
    """Whether it is the ownship's own transponder."""


def fits(before: Report, after: Report) -> bool:
    """Whether both reports can come from one aircraft."""
    apart = norm(sub(placed_at(before, after.time_ms), after.intruder.p_n))
    return apart <= JUMP_DISTANCE + JUMP_SPEED * abs(elapsed(before.time_ms, after.time_ms))


def taken(known: Heard, report: Report, volume: Volume) -> Heard:
    """What is kept after one more report that can be true; an older one changes nothing.

    `volume` is what to keep out of around an aircraft that reports everything.
    """
    if elapsed(known.report.time_ms, report.time_ms) < 0.0:
        return known
    if fits(known.report, report):
        newest = with_derived_velocity(report, known.past, volume)
        return known._replace(report=newest, odd=None, past=past_reports(known.past, report))
    if known.odd is not None and fits(known.odd, report):
        return known._replace(report=report, odd=None, past=(report,))
    return known._replace(odd=report)
