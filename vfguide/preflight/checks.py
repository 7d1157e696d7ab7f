"""Checks of values of a scenario against each other and against its aircraft."""

import math
from collections.abc import Mapping
from itertools import combinations

from vfguide.files.aircraft_file import Aircraft
from vfguide.files.scenario_file import LEAST_BANK_DEG, ScenarioFile
from vfguide.files.simulation_entry import Autopilot, Link, Weather
from vfguide.files.source import Location, Source
from vfguide.files.toml_types import in_words
from vfguide.scenario.resolved import Scenario


def check_law(entry: ScenarioFile, source: Source) -> None:
    """Check that plant, law, obstacles and test flights go together.

    Raises:
        InputError: they do not.
    """
    if entry.law == "flight" and entry.plant == "kinematic" and entry.obstacle:
        rule = 'law = "flight" avoids them on plant = "jsbsim" only, allowed with law = "paper"'
        raise source.error(("obstacle",), rule)
    if entry.law == "field" and entry.plant == "kinematic":
        rule = 'only plant = "jsbsim" flies it, allowed here "flight", "paper"'
        raise source.error(("law",), rule, entry.law)
    for index, vehicle in enumerate(entry.vehicle):
        if vehicle.identify and entry.plant == "kinematic":
            rule = 'only plant = "jsbsim" has anything to be found out, allowed here false'
            raise source.error(("vehicle", index, "identify"), rule, vehicle.identify)
        if vehicle.identify and entry.law != "flight":
            rule = 'only law = "flight" flies a test flight, allowed here false'
            raise source.error(("vehicle", index, "identify"), rule, vehicle.identify)
    if entry.law == "paper":
        _check_single_attempts(entry, source)


def _check_single_attempts(entry: ScenarioFile, source: Source) -> None:
    """Check that law `paper` is not asked for more than one attempt, since it passes a goal once.

    Raises:
        InputError: it is.
    """
    for index, vehicle in enumerate(entry.vehicle):
        for number, goal in enumerate(vehicle.goal):
            if goal.attempts > 1:
                at: Location = ("vehicle", index, "goal", number, "attempts")
                rule = 'law = "paper" passes a goal once, allowed 0 to 1'
                raise source.error(at, rule, goal.attempts)


PAPER_LAW_WARNING = (
    'law = "paper" on plant = "jsbsim" is the paper\'s field as printed, to see what it does: no '
    "route is planned, nothing assures that obstacles are kept clear of, and it knows no fence"
)
"""Warning of a scenario that flies law `paper` on an aeroplane."""


def law_warnings(scenario: Scenario) -> tuple[str, ...]:
    """The warnings about the law of a scenario."""
    told = list[str]()
    if scenario.law == "paper" and scenario.plant == "jsbsim":
        told.append(PAPER_LAW_WARNING)
    if scenario.law != "field" and scenario.guidance.remedies is not None:
        told.append(f'guidance.remedies: law = "{scenario.law}" takes no notice of them')
    return tuple(told)


def check_aircraft(
    scenario: Scenario, entry: ScenarioFile, aircraft: Mapping[str, Aircraft], source: Source
) -> None:
    """Check that no vehicle is asked for a bank or a climb that its aircraft cannot fly.

    Raises:
        InputError: one is.
    """
    for index, vehicle in enumerate(scenario.vehicles):
        each, at = aircraft[vehicle.aircraft], ("vehicle", index)
        limits = each.limits
        bank = scenario.guidance.bank_max_deg or limits.bank_max_deg
        place = ("guidance", "bank_max_deg")
        _check_range(bank, (LEAST_BANK_DEG, limits.bank_max_deg), each.name, source, place)
        steepest = (-limits.descent_max_deg, limits.climb_max_deg)
        for number, goal in enumerate(vehicle.goals):
            place = (*at, "goal", number)
            direction = entry.vehicle[index].goal[number].direction
            if direction is None:
                _check_range(goal.climb_deg, steepest, each.name, source, (*place, "climb_deg"))
            elif rule := _outside(goal.climb_deg, steepest, each.name):
                rule = f"climbs by {goal.climb_deg:.1f} degrees, {rule}"
                raise source.error((*place, "direction"), rule, direction)


def check_ground(scenario: Scenario, entry: ScenarioFile, source: Source) -> None:
    """Check that every start and goal is above the ground, the plane z = 0 of the scenario frame.

    Raises:
        InputError: one is not.
    """
    height = in_words(scenario.origin.altitude_m)
    rule = f"not above the ground; z points down, allowed z < 0 (above the origin's {height} m)"
    for index, vehicle in enumerate(scenario.vehicles):
        if vehicle.position_m[2] >= 0.0:
            raise source.error(("vehicle", index, "position_m"), rule, vehicle.position_m)
        for number, goal in enumerate(vehicle.goals):
            if goal.position_m[2] < 0.0:
                continue
            at: Location = ("vehicle", index, "goal", number)
            altitude = entry.vehicle[index].goal[number].altitude_m
            if altitude is None:
                raise source.error((*at, "position_m"), rule, goal.position_m)
            lowest = f"allowed above {altitude + goal.position_m[2]:.1f} (see [origin])"
            raise source.error((*at, "altitude_m"), f"not above the ground, {lowest}", altitude)


def check_still_air(scenario: Scenario, source: Source) -> None:
    """Check that plant `kinematic` is given no wind, weather, sensors, autopilot or link.

    Raises:
        InputError: it is.
    """
    wind, rule = scenario.wind, 'plant = "kinematic" has no wind'
    if wind.speed_mps != 0.0:
        raise source.error(("wind", "speed_mps"), f"{rule}, allowed 0", wind.speed_mps)
    if wind.turbulence != "none":
        raise source.error(("wind", "turbulence"), f'{rule}, allowed "none"', wind.turbulence)
    if wind.shear_mps_per_100m != 0.0:
        at = ("wind", "shear_mps_per_100m")
        raise source.error(at, f"{rule}, allowed 0", wind.shear_mps_per_100m)
    if wind.change:
        raise source.error(("wind", "change"), f"{rule}, allowed none")
    if scenario.weather != Weather():
        raise source.error(("weather",), 'plant = "kinematic" has no air, allowed none')
    for table, unused in (("sensors", None), ("autopilot", Autopilot()), ("link", Link())):
        if getattr(scenario, table) != unused:
            raise source.error((table,), 'plant = "kinematic" has no autopilot, allowed none')


def check_changes(scenario: Scenario, source: Source) -> None:
    """Check that the changes of the wind are in the order of time.

    Raises:
        InputError: they are not.
    """
    times = [change.time_s for change in scenario.wind.change]
    for index in range(1, len(times)):
        if times[index] <= times[index - 1]:
            rule = f"not after the change before it, allowed above {in_words(times[index - 1])}"
            raise source.error(("wind", "change", index, "time_s"), rule, times[index])


def check_room(scenario: Scenario, source: Source) -> None:
    """Check that vehicles start apart, and are detected before they are too close.

    Raises:
        InputError: the detection range is not beyond two safety radii; or two vehicles that are to
            keep apart start within two safety radii.
    """
    avoidance = scenario.avoidance
    apart = 2.0 * avoidance.safety_radius_m
    if avoidance.detection_range_m <= apart:
        rule = f"not beyond two safety radii, allowed above {in_words(apart)}"
        at: Location = ("avoidance", "detection_range_m")
        raise source.error(at, rule, avoidance.detection_range_m)
    pairs = combinations(enumerate(scenario.vehicles), 2) if avoidance.between_vehicles else ()
    for (first, one), (second, other) in pairs:
        distance = math.dist(one.position_m, other.position_m)
        if distance <= apart:
            rule = (
                f"{distance:.1f} m from vehicle[{first}], "
                f"allowed more than {in_words(apart)} (two safety_radius_m)"
            )
            raise source.error(("vehicle", second, "position_m"), rule, other.position_m)


def _check_range(
    value: float, allowed: tuple[float, float], aircraft: str, source: Source, at: Location
) -> None:
    if rule := _outside(value, allowed, aircraft):
        raise source.error(at, rule, value)


def _outside(value: float, allowed: tuple[float, float], aircraft: str) -> str:
    """The rule that a value outside the limits of an aircraft breaks; empty if it is within."""
    low, high = allowed
    if low <= value <= high:
        return ""
    side = "below the minimum" if value < low else "above the maximum"
    return f"{side} of {aircraft}, allowed {in_words(low)} to {in_words(high)}"
