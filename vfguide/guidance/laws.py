"""Dispatch of the laws: by the type of the law's record, when the step is compiled.

A law is a record of its settings and a module whose `update` turns state and route into a command.
To add one: write both, and name them here.
"""

from collections.abc import Callable
from typing import Any, NamedTuple

from numba import types
from numba.extending import overload

from vfguide.aircraft.command import GuidanceCommand
from vfguide.aircraft.vehicle import Vehicle
from vfguide.airspace.detection import Airspace
from vfguide.estimation.estimation import NavState
from vfguide.guidance import field_law, flight_law, paper_law
from vfguide.guidance.guidance_state import GuidanceState, Leader
from vfguide.guidance.remedies import ALL_REMEDIES, Remedies
from vfguide.planning.objective import Objective
from vfguide.planning.route import Route


class FlightLaw(NamedTuple):
    """Law `flight`: planned paths on the navigation field."""

    plans: bool = True
    """Whether routes are planned."""
    is_assured: bool = True
    """Whether the run-time assurance guards the law."""


class PaperLaw(NamedTuple):
    """Law `paper`: the composite field as printed, to see what it does on an aeroplane."""

    plans: bool = False
    """Whether routes are planned."""
    is_assured: bool = False
    """Whether the run-time assurance guards the law."""


class FieldLaw(NamedTuple):
    """Law `field`: the paper's avoidance field, made flyable."""

    plans: bool = True
    """Whether routes are planned."""
    is_assured: bool = True
    """Whether the run-time assurance guards the law."""
    remedies: Remedies = ALL_REMEDIES
    """What it does beyond the print."""


Law = FlightLaw | PaperLaw | FieldLaw
FLIGHT = FlightLaw()
"""Law `flight` with its default settings."""
PAPER = PaperLaw()
"""Law `paper` with its default settings."""
FIELD_LAW = FieldLaw()
"""Law `field` with its default settings."""
LAWS_BY_NAME: dict[str, Law] = {"flight": FLIGHT, "field": FIELD_LAW, "paper": PAPER}
"""The laws by the names that they have in scenario files."""


def crossing(law: Law) -> Law | None:
    """A law as it crosses into compiled code: None for law `flight`, which is quicker.

    It saves half a microsecond. `law_of` is the inverse.
    """
    return None if law == FLIGHT and isinstance(law, FlightLaw) else law


def law_of(crossed: Law | None) -> Law:
    """The law that `crossing` has turned into `crossed`."""
    return FLIGHT if crossed is None else crossed


@overload(law_of)
def _compiled_law_of(crossed: Any) -> Any:
    """`law_of` in compiled code, where a function has one type of result."""

    def flight(crossed: Any) -> Any:
        return FlightLaw(True, True)

    def itself(crossed: Any) -> Any:
        return crossed

    return flight if isinstance(crossed, types.NoneType) else itself


def update(
    law: Law,
    nav: NavState,
    goal: Objective,
    route: Route,
    airspace: Airspace | None,
    s: GuidanceState,
    vehicle: Vehicle,
) -> tuple[GuidanceCommand, GuidanceState]:
    """The law's command: bank, load factor and path angle; and the next state of guidance.

    Args:
        law: the record of the law.
        nav: state of the vehicle.
        goal: objective of the mission.
        route: the planned route.
        airspace: the known hazards; None: there are none.
        s: state of guidance at the step before.
        vehicle: its aircraft and gains.
    """
    return LAWS[type(law)](law, nav, goal, route, airspace, s, vehicle)


def _fly_flight(
    law: Any, nav: Any, goal: Any, route: Any, airspace: Any, s: Any, vehicle: Any
) -> Any:
    return flight_law.update(nav, goal, route, airspace, s, vehicle)


def _fly_field(
    law: Any, nav: Any, goal: Any, route: Any, airspace: Any, s: Any, vehicle: Any
) -> Any:
    return field_law.update(law.remedies, nav, goal, route, airspace, s, vehicle)


def _fly_paper(
    law: Any, nav: Any, goal: Any, route: Any, airspace: Any, s: Any, vehicle: Any
) -> Any:
    return paper_law.update(nav, goal, route, airspace, s, vehicle)


LAWS: dict[type, Callable[..., tuple[GuidanceCommand, GuidanceState]]] = {
    FlightLaw: _fly_flight,
    FieldLaw: _fly_field,
    PaperLaw: _fly_paper,
}
"""How each law is flown, by the type of its record."""


@overload(update)
def _compiled_update(
    law: Any, nav: Any, goal: Any, route: Any, airspace: Any, s: Any, vehicle: Any
) -> Any:
    """How a law is flown in compiled code, chosen by the type of its record."""
    return LAWS[law.instance_class]


def wants_route(law: Law, s: GuidanceState) -> bool:
    """Whether the law follows a route at this step."""
    return law.plans and not (isinstance(law, FieldLaw) and s.progress.leader == Leader.FIELD)


@overload(wants_route)
def _compiled_wants_route(law: Any, s: Any) -> Any:
    """The same in compiled code."""

    def field(law: Any, s: Any) -> Any:
        return law.plans and s.progress.leader != Leader.FIELD.value

    def others(law: Any, s: Any) -> Any:
        return law.plans

    return field if law.instance_class is FieldLaw else others
