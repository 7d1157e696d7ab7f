"""Which law guides: one dispatch, by the type of the law's record, decided when it is compiled.

A law is a record with its settings, and a module whose `update` turns a route and what is known
into a command. To add one: write both, and name them here.
"""

from collections.abc import Callable
from typing import Any, NamedTuple

from numba.extending import overload

from vfguide.aircraft.command import GuidanceCommand
from vfguide.aircraft.vehicle import Vehicle
from vfguide.airspace.detection import Airspace
from vfguide.estimation.estimation import NavState
from vfguide.guidance import flight_law, paper_law
from vfguide.guidance.guidance_state import GuidanceState
from vfguide.planning.objective import Objective
from vfguide.planning.route import Route


class FlightLaw(NamedTuple):
    """Law `flight`: planned paths on the navigation field."""

    plans: bool = True
    """Whether routes are planned."""
    is_assured: bool = True
    """Whether the run-time assurance stands above the law."""


class PaperLaw(NamedTuple):
    """Law `paper`: the composite field as printed, to see what it does on an aeroplane."""

    plans: bool = False
    is_assured: bool = False
    """As of `FlightLaw`."""


Law = FlightLaw | PaperLaw
FLIGHT, PAPER = FlightLaw(), PaperLaw()
LAWS_BY_NAME: dict[str, Law] = {"flight": FLIGHT, "paper": PAPER}
"""The laws as a scenario names them."""

LAWS: dict[type, Callable[..., tuple[GuidanceCommand, GuidanceState]]] = {
    FlightLaw: flight_law.update,
    PaperLaw: paper_law.update,
}
"""The function that flies each law."""


def update(
    law: Law,
    nav: NavState,
    goal: Objective,
    route: Route,
    airspace: Airspace | None,
    s: GuidanceState,
    vehicle: Vehicle,
) -> tuple[GuidanceCommand, GuidanceState]:
    """What the law commands: bank, load factor and path angle.

    Args:
        law: that guides.
        nav: the vehicle.
        goal: what is flown to.
        route: how.
        airspace: what is known to be in the way; None: there is nothing.
        s: what the step before left.
        vehicle: its aircraft and gains.
    """
    return LAWS[type(law)](nav, goal, route, airspace, s, vehicle)


@overload(update)
def _compiled_update(
    law: Any, nav: Any, goal: Any, route: Any, airspace: Any, s: Any, vehicle: Any
) -> Any:
    """The same in compiled code."""
    chosen: Any = LAWS[law.instance_class]

    def fly(law: Any, nav: Any, goal: Any, route: Any, airspace: Any, s: Any, vehicle: Any) -> Any:
        return chosen(nav, goal, route, airspace, s, vehicle)

    return fly
