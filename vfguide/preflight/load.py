"""A scenario with its aircraft: found, read, resolved and checked."""

from collections.abc import Sequence
from dataclasses import replace
from pathlib import Path

from vfguide.files.aircraft_file import load_aircraft
from vfguide.files.data import AircraftFiles, find_scenario
from vfguide.files.overrides import Override, parse_override
from vfguide.files.scenario_file import ScenarioFile
from vfguide.files.source import Location, Source, read_toml
from vfguide.preflight import air_checks, checks
from vfguide.preflight.air_checks import AircraftInAir, AskedAirspeed
from vfguide.preflight.detection_range import check_detection, with_detection_range
from vfguide.preflight.encounter_checks import check_encounters
from vfguide.preflight.route_checks import GuidedAircraft, check_routes
from vfguide.scenario.hazards import check_fence
from vfguide.scenario.loaded import LoadedScenario, resolved_from
from vfguide.scenario.obstacles import check_obstacles
from vfguide.scenario.resolve import air_of
from vfguide.scenario.traffic import check_traffic


def load_scenario(
    name_or_path: str | Path, overrides: Sequence[str] = (), drawn: Sequence[Override] = ()
) -> LoadedScenario:
    """The scenario at a path or of a shipped name, with `overrides` such as `wind.speed_mps=5`.

    Those `drawn` for a campaign replace values after them.

    Raises:
        InputError: it cannot be flown; the message says what is wrong and what is allowed.
    """
    given = (*map(parse_override, overrides), *drawn)
    source = Source(find_scenario(name_or_path), given)
    entry = source.parse(ScenarioFile)
    checks.check_law(entry, source)
    loaded = resolved_from(entry, source)
    scenario = loaded.scenario
    source.check_distinct("vehicle", "id", [vehicle.id for vehicle in scenario.vehicles])
    if scenario.law != "paper" or scenario.plant == "jsbsim":
        checks.check_aircraft(scenario, entry, loaded.aircraft, source)
    if scenario.plant == "jsbsim":
        checks.check_ground(scenario, entry, source)
        checks.check_changes(scenario, source)
    else:
        checks.check_still_air(scenario, source)
    checks.check_room(scenario, source)
    check_obstacles(scenario, source)
    check_fence(scenario, source)
    check_traffic(scenario, source)
    thin_air = _check_air(loaded, entry, source) if scenario.plant == "jsbsim" else []
    guided = [
        GuidedAircraft(loaded.performance_aloft(each), loaded.gains(each))
        for each in scenario.vehicles
    ]
    scenario = with_detection_range(scenario, entry, guided)
    warnings = (
        *checks.law_warnings(scenario),
        *thin_air,
        *check_detection(scenario, guided, source),
        *check_routes(scenario, guided, source),
        *check_encounters(scenario, guided, source),
    )
    return replace(loaded, scenario=scenario, warnings=warnings)


def _check_air(loaded: LoadedScenario, entry: ScenarioFile, source: Source) -> list[str]:
    """Warnings of vehicles that perhaps cannot fly in the air of their plan.

    Raises:
        InputError: one cannot.
    """
    scenario, warnings = loaded.scenario, list[str]()
    for index, vehicle in enumerate(scenario.vehicles):
        aircraft, gains = loaded.performance(vehicle), loaded.gains(vehicle)
        measured = loaded.aircraft[vehicle.aircraft].thrust.per_climb is not None
        air, sure = air_of(scenario, vehicle), measured and not vehicle.identify
        flown = AircraftInAir(vehicle.aircraft, aircraft, gains, air, sure)
        at: Location = ("vehicle", index, "airspeed_mps")
        written = entry.vehicle[index].airspeed_mps is not None
        start = asked = AskedAirspeed(vehicle.airspeed_mps, at, written)
        if scenario.guidance.airspeed_mps is not None:
            asked = AskedAirspeed(gains.airspeed, ("guidance", "airspeed_mps"), True)
        for each in (start, asked):
            air_checks.check_airspeed(each, flown, source)
        found = air_checks.check_thrust(asked, flown, source)
        warnings += found or air_checks.check_start(start, flown, source)
    return warnings


def check_file(path: Path) -> tuple[str, ...]:
    """Check a scenario or an aircraft file; returns the warnings, of which an aircraft has none.

    Raises:
        InputError: it says something that is not allowed.
    """
    if "airspeed" in read_toml(path):
        load_aircraft(AircraftFiles(path.stem, path.parent, path, None))
        return ()
    return load_scenario(path).warnings
