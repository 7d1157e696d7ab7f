"""The choice of the law: by the type of its record, in Python as in compiled code."""

import math

import pytest
from flight_states import VEHICLE, state
from guidance_targets import GOAL
from hazard_samples import ball, hazards

from vfguide.aircraft.command import GuidanceCommand
from vfguide.aircraft.state import FlightState
from vfguide.aircraft.vehicle import Vehicle
from vfguide.airspace.detection import Airspace
from vfguide.airspace.hazards import Intruder
from vfguide.airspace.keep_out import NO_FENCE
from vfguide.estimation.estimation import NavState, known_state
from vfguide.guidance import field_law, flight_law, laws, paper_law
from vfguide.guidance.guidance_state import GuidanceState, leg_begins
from vfguide.guidance.laws import (
    FIELD_LAW,
    FLIGHT,
    LAWS,
    PAPER,
    FieldLaw,
    FlightLaw,
    Law,
    PaperLaw,
    crossing,
    law_of,
)
from vfguide.kernels.compiled import compiled
from vfguide.planning import planning
from vfguide.planning.objective import GuidanceTarget, Objective, objective_at
from vfguide.planning.route import Route, fresh_route


def update_field(*given):
    return field_law.update(FIELD_LAW.remedies, *given)


UPDATES = {FlightLaw: flight_law.update, PaperLaw: paper_law.update, FieldLaw: update_field}
CIRCLE = GOAL._replace(circle=1.0, radius=120.0)
HERE = state((-300.0, 20.0, -140.0), 0.4, wind=(3.0, -4.0, 0.5), time=1.02)
CROSSING = Intruder((-200.0, 150.0, -140.0), (0.0, -10.0, 0.0), 0.0, 50.0, 30.0, 1.0, 1.0)
AMONG = Airspace(
    hazards([ball((-150.0, 60.0, -150.0))], [CROSSING], floor=100.0), NO_FENCE, 2.0, 1.0
)


@compiled
def in_compiled_code(
    law: Law,
    nav: NavState,
    goal: Objective,
    route: Route,
    airspace: Airspace | None,
    s: GuidanceState,
    vehicle: Vehicle,
) -> tuple[GuidanceCommand, GuidanceState]:
    return laws.update(law, nav, goal, route, airspace, s, vehicle)


def arguments(law: Law, here: FlightState, target: GuidanceTarget, airspace: Airspace | None):
    """All that a law is given in the middle of a flight."""
    nav, goal, s = (
        known_state(here, 1.0),
        objective_at(target, here),
        GuidanceState(0.02, -1.0, leg_begins(0.0)),
    )
    route = planning.update(nav, goal, None, law.plans, fresh_route(), s.slope, VEHICLE)
    return nav, goal, route, airspace, s, VEHICLE


@pytest.mark.parametrize("law", [FLIGHT, PAPER, FIELD_LAW], ids=["flight", "paper", "field"])
@pytest.mark.parametrize("target", [GOAL, CIRCLE], ids=["goal", "circle"])
@pytest.mark.parametrize("airspace", [None, AMONG], ids=["free", "among"])
def test_the_law_that_is_chosen_is_flown(law, target, airspace):
    given = arguments(law, HERE, target, airspace)
    wanted = UPDATES[type(law)](*given)
    assert laws.update(law, *given) == wanted
    assert in_compiled_code(law, *given) == wanted
    command, after = wanted
    assert not any(map(math.isnan, (*command[:-1], *command.rates, *after[:-1], *after.progress)))


def test_the_laws_differ_but_on_the_circle():
    def both(target):
        return [
            in_compiled_code(law, *arguments(law, HERE, target, None)) for law in (FLIGHT, PAPER)
        ]

    (flight, _), (paper, _) = both(GOAL)
    assert flight != paper
    (flight, _), (paper, _) = both(CIRCLE)
    assert flight == paper, "the paper says nothing of it"


def test_the_paper_deflects_by_what_is_in_the_way():
    free, _ = laws.update(PAPER, *arguments(PAPER, HERE, GOAL, None))
    among, _ = laws.update(PAPER, *arguments(PAPER, HERE, GOAL, AMONG))
    assert abs(free.course - among.course) > 0.01


def test_settings_of_a_law_choose_no_other():
    plain = FlightLaw(plans=True, is_assured=False)
    assert in_compiled_code(plain, *arguments(plain, HERE, GOAL, None)) == in_compiled_code(
        FLIGHT, *arguments(FLIGHT, HERE, GOAL, None)
    )
    assert set(LAWS) == {FlightLaw, FieldLaw, PaperLaw}


@compiled
def crossed(law: Law | None) -> Law:
    return law_of(law)


@pytest.mark.parametrize("law", [FLIGHT, PAPER, FIELD_LAW])
@pytest.mark.parametrize("cross", [law_of, crossed])
def test_a_law_crosses_as_itself(law, cross):
    assert type(cross(crossing(law))) is type(law)
    assert cross(crossing(law)) == law


def test_law_flight_with_other_settings_crosses_as_a_record():
    other = FLIGHT._replace(is_assured=False)
    assert crossing(other) == other
    assert crossing(FLIGHT) is None
