"""The other aircraft of a scenario: for the simulation, the companion and the result."""

from vfguide.files.scenario_file import Avoidance
from vfguide.files.source import Source
from vfguide.files.toml_types import in_words
from vfguide.scenario.resolved import Scenario, Traffic
from vfguide.sim.traffic import Flight, Turn, flight_of
from vfguide.surveillance.report import SMALL_AIRCRAFT, Volume


def avoids_traffic(scenario: Scenario) -> bool:
    """Whether reported traffic is avoided."""
    return bool(scenario.traffic) or scenario.avoidance.traffic


def volume_from(avoidance: Avoidance) -> Volume:
    """The volume to keep out of around other aircraft, and its growth with age."""
    return SMALL_AIRCRAFT._replace(
        radius=avoidance.traffic_radius_m,
        half_height=avoidance.traffic_half_height_m,
        uncertainty_rate=avoidance.traffic_growth_mps,
        uncertainty_rate_up=avoidance.traffic_growth_up_mps,
    )


def path_of(each: Traffic) -> Flight:
    """The path of another aircraft in the scenario frame, NED."""
    turns = [Turn(change.time_s, change.within_s, change.velocity_mps) for change in each.change]
    return flight_of(each.position_m, each.velocity_mps, turns)


def check_traffic(scenario: Scenario, source: Source) -> None:
    """Check that addresses and names differ, that changes are in order, and that it is heard.

    Raises:
        InputError: two are the same, two changes overlap, or the plant has no autopilot to hear it.
    """
    if scenario.traffic and scenario.plant != "jsbsim":
        raise source.error(("traffic",), 'plant = "kinematic" hears none, allowed none')
    source.check_distinct("traffic", "name", [each.name for each in scenario.traffic])
    source.check_distinct("traffic", "icao", [each.icao for each in scenario.traffic])
    for index, each in enumerate(scenario.traffic):
        for number in range(1, len(each.change)):
            before = each.change[number - 1]
            end = before.time_s + before.within_s
            if each.change[number].time_s < end:
                rule = f"before the end of the change before it, allowed from {in_words(end)} on"
                at = ("traffic", index, "change", number, "time_s")
                raise source.error(at, rule, each.change[number].time_s)
