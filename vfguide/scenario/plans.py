"""From a scenario to the plans of its companions."""

from vfguide.companion.plan import Plan
from vfguide.field.goal_frame import GoalFrame, goal_frame
from vfguide.files.errors import InputError
from vfguide.geometry.units import DEG
from vfguide.guidance.laws import FIELD_LAW, LAWS_BY_NAME, Law
from vfguide.guidance.remedies import Remedies
from vfguide.scenario.hazards import hazard_names, hazards_of, keep_out_zones_of
from vfguide.scenario.legs import circle_radius, circle_side, goal_of
from vfguide.scenario.loaded import LoadedScenario
from vfguide.scenario.resolve import place_of
from vfguide.scenario.resolved import Goal as ScenarioGoal
from vfguide.scenario.resolved import Scenario, Vehicle, start_us
from vfguide.scenario.traffic import volume_from


def vehicle_of(scenario: Scenario, sysid: int) -> Vehicle:
    """The vehicle with an id.

    Raises:
        InputError: there is none.
    """
    for vehicle in scenario.vehicles:
        if vehicle.id == sysid:
            return vehicle
    known = ", ".join(str(vehicle.id) for vehicle in scenario.vehicles)
    raise InputError(f"--vehicle {sysid}: no such vehicle in {scenario.name}, allowed {known}")


def plan_of(loaded: LoadedScenario, vehicle: Vehicle) -> Plan:
    """The plan of the companion of a vehicle."""
    return Plan(
        place_of(loaded.scenario.origin),
        tuple(goal_of(goal) for goal in vehicle.goals),
        circle_side(loaded.scenario),
        circle_radius(loaded.scenario, vehicle),
        loaded.scenario.guidance.rate_hz,
        loaded.performance(vehicle),
        loaded.untuned(vehicle),
        loaded.roll_time(vehicle),
        vehicle.identify,
        hazards_of(loaded.scenario),
        hazard_names(loaded.scenario),
        keep_out_zones_of(loaded.scenario.fence),
        start_us(loaded.scenario),
        loaded.scenario.start_time != Scenario.model_fields["start_time"].default,
        loaded.scenario.duration_s,
        volume_from(loaded.scenario.avoidance),
        int(vehicle.icao or "0", 16),
        law_from(loaded.scenario),
    )


def law_from(scenario: Scenario) -> Law:
    """The law of a scenario, with its remedies."""
    remedies = scenario.guidance.remedies
    if scenario.law == "field" and remedies is not None:
        return FIELD_LAW._replace(remedies=Remedies(**remedies.model_dump()))
    return LAWS_BY_NAME[scenario.law]


def frame_of(goal: ScenarioGoal) -> GoalFrame:
    """The frame of a goal, for the paper's fields."""
    return goal_frame(goal.position_m, goal.heading_deg * DEG, goal.climb_deg * DEG)
