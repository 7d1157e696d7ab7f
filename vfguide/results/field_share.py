"""The shares of a flight in which law `field` followed its field, and a route."""

from dataclasses import dataclass

import numpy as np

from vfguide.assurance.decision import Reason
from vfguide.geometry.vector import Series
from vfguide.guidance.guidance_state import Leader
from vfguide.results.record import FlightRecord


@dataclass(frozen=True)
class FieldResult:
    """What law `field` followed, by time, as result.json has it; None where no time was flown.

    The field leads where its command was flown, and no escape of the assurance in its place. The
    circle after the last goal is left out.
    """

    leading_share: float | None
    """Share of the time outside the approach in which the field led."""
    leading_share_of_flight: float | None
    """Share of all the time, the approach included, in which the field led."""
    route_share: float | None
    """Share of the time outside the approach in which a route was flown."""
    routes: int
    """Number of times that a route began."""


def field_result(record: FlightRecord) -> FieldResult | None:
    """What law `field` followed in a flight; None where another law was flown."""
    if record.leaders is None:
        return None
    has_setpoint = ~np.isnan(record.thrust) & (record.time >= record.goals_from)
    flown = has_setpoint & (record.leaders != Leader.CIRCLE)
    leading = flown & (record.leaders == Leader.FIELD)
    if record.decisions is not None:
        leading &= record.decisions.reason == Reason.NOMINAL
    outside = flown & (record.leaders != Leader.APPROACH)
    on_route = flown & (record.leaders == Leader.ROUTE)
    starts = on_route & (np.roll(record.leaders, 1) != Leader.ROUTE)
    return FieldResult(
        leading_share=_share(leading, outside),
        leading_share_of_flight=_share(leading, flown),
        route_share=_share(on_route, outside),
        routes=int(starts.sum()),
    )


def _share(part: Series, whole: Series) -> float | None:
    """Number of samples in `part`, over that in `whole`; None where `whole` has none."""
    count = int(whole.sum())
    return round(int(part.sum()) / count, 6) if count else None
