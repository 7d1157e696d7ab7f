"""A scenario with its aircraft: found, read, resolved and checked."""

import shutil
from collections.abc import Mapping, Sequence
from dataclasses import dataclass, replace
from pathlib import Path

from vfguide import __version__
from vfguide.aircraft.air_density import in_air
from vfguide.aircraft.gain_scheduling import suited
from vfguide.aircraft.identification import Identified
from vfguide.aircraft.performance import Gains, Performance
from vfguide.files.aircraft_file import Aircraft, load_aircraft
from vfguide.files.atomic import write_atomically
from vfguide.files.data import AircraftFiles, data_folder, find_aircraft, find_scenario
from vfguide.files.errors import InputError
from vfguide.files.overrides import parse_override
from vfguide.files.scenario_file import ScenarioFile
from vfguide.files.source import Location, Source, read_toml
from vfguide.geometry.units import DEG
from vfguide.scenario import air_checks, checks
from vfguide.scenario.air_checks import Asked, Flown
from vfguide.scenario.detection_range import check_detection, with_detection_range
from vfguide.scenario.encounter_checks import check_encounters
from vfguide.scenario.hazards import check_fence
from vfguide.scenario.obstacles import check_obstacles
from vfguide.scenario.resolve import air_of, aircraft_of, resolve
from vfguide.scenario.resolved import Scenario, Vehicle
from vfguide.scenario.route_checks import Flies, check_routes
from vfguide.scenario.traffic import check_traffic


@dataclass(frozen=True)
class LoadedScenario:
    """A scenario that can be flown, and the aircraft that fly it, by their names."""

    scenario: Scenario
    path: Path
    """The file it came from."""
    files: Mapping[str, AircraftFiles]
    aircraft: Mapping[str, Aircraft]
    warnings: tuple[str, ...] = ()
    """Warnings about it, one message each."""

    def performance(self, vehicle: Vehicle) -> Performance:
        """The performance of the aircraft of `vehicle` at sea-level density."""
        return self.aircraft[vehicle.aircraft].performance()

    def performance_aloft(self, vehicle: Vehicle) -> Performance:
        """The performance at its highest start or goal, where the stall is at its fastest."""
        density = air_of(self.scenario, vehicle).thinnest
        return in_air(self.performance(vehicle), density, self.scenario.airspeed_of(vehicle))

    def gains(self, vehicle: Vehicle) -> Gains:
        """The gains of `vehicle` that suit its roll response."""
        roll_rate = self.performance(vehicle).rate_max[0]
        return suited(self.untuned(vehicle), self.roll_time(vehicle), roll_rate)

    def roll_time(self, vehicle: Vehicle) -> float:
        """Roll response time of `vehicle`: 63 % of a step of the roll rate [s]."""
        return self.aircraft[vehicle.aircraft].response.roll_s

    def untuned(self, vehicle: Vehicle) -> Gains:
        """The gains of `vehicle` for a roll response within FAST_ROLL."""
        guidance = self.scenario.guidance
        bank = guidance.bank_max_deg or self.aircraft[vehicle.aircraft].limits.bank_max_deg
        return Gains(
            airspeed=self.scenario.airspeed_of(vehicle),
            k_w=guidance.k_w,
            k_lateral=guidance.k_lateral,
            k_elevation=guidance.k_elevation,
            bank_max=bank * DEG,
        )

    def require_mavlink(self) -> None:
        """Make sure that its vehicles speak MAVLink.

        Raises:
            InputError: the plant is one without.
        """
        if self.scenario.plant != "jsbsim":
            plant = self.scenario.plant
            rule = 'it has no autopilot and no MAVLink, only vfguide run flies it; allowed "jsbsim"'
            raise InputError(f'{self.path}: plant = "{plant}": {rule}')

    def require_flight_law(self) -> None:
        """Make sure that its law is one for a real aircraft.

        Raises:
            InputError: it is not.
        """
        if self.scenario.law != "flight":
            rule = 'only vfguide run flies it, allowed "flight"'
            raise InputError(f'{self.path}: law = "{self.scenario.law}": {rule}')

    def write_resolved(self, path: Path) -> None:
        """Write the scenario whose flight is the same, and beside it aircraft of the user's own."""
        for files in self.files.values():
            if files.root != data_folder() / "aircraft":
                _copy_aircraft(files, path.parent / "aircraft")
        write_atomically(path, self.scenario.to_toml())

    def write_identified(self, vehicle: Vehicle, found: Identified, folder: Path) -> None:
        """Write the aircraft file that a test flight of `vehicle` makes of its present one."""
        each = self.aircraft[vehicle.aircraft]
        how = f"Measured in flight by vfguide {__version__}"
        path = folder / f"aircraft-{vehicle.id}" / f"{each.name}.toml"
        path.parent.mkdir(exist_ok=True)
        write_atomically(path, each.as_identified(found, how).to_toml())


def load_scenario(name_or_path: str | Path, overrides: Sequence[str] = ()) -> LoadedScenario:
    """The scenario of a file or of a shipped name, with `overrides` such as `wind.speed_mps=5`.

    Raises:
        InputError: it cannot be flown; the message says what is wrong and what is allowed.
    """
    source = Source(find_scenario(name_or_path), tuple(map(parse_override, overrides)))
    entry = source.parse(ScenarioFile)
    checks.check_law(entry, source)
    files = _find_all(entry, source)
    aircraft = {name: load_aircraft(each) for name, each in files.items()}
    scenario = resolve(entry, aircraft, source)
    checks.check_ids(scenario, source)
    if scenario.law == "flight" or scenario.plant == "jsbsim":
        checks.check_aircraft(scenario, entry, aircraft, source)
    if scenario.plant == "jsbsim":
        checks.check_ground(scenario, entry, source)
        checks.check_changes(scenario, source)
    else:
        checks.check_still_air(scenario, source)
    checks.check_room(scenario, source)
    check_obstacles(scenario, source)
    check_fence(scenario, source)
    check_traffic(scenario, source)
    loaded = LoadedScenario(scenario, source.path, files, aircraft)
    thin_air = _check_air(loaded, entry, source) if scenario.plant == "jsbsim" else []
    flies = [
        Flies(loaded.performance_aloft(each), loaded.gains(each)) for each in scenario.vehicles
    ]
    scenario = with_detection_range(scenario, entry, flies)
    warnings = (
        *checks.told_of_law(scenario),
        *thin_air,
        *check_detection(scenario, flies, source),
        *check_routes(scenario, flies, source),
        *check_encounters(scenario, flies, source),
    )
    return replace(loaded, scenario=scenario, warnings=warnings)


def _check_air(loaded: LoadedScenario, entry: ScenarioFile, source: Source) -> list[str]:
    """Warnings of vehicles that may not be flown in the air of their plan.

    Raises:
        InputError: one cannot.
    """
    scenario, warnings = loaded.scenario, list[str]()
    for index, vehicle in enumerate(scenario.vehicles):
        aircraft, gains = loaded.performance(vehicle), loaded.gains(vehicle)
        measured = loaded.aircraft[vehicle.aircraft].thrust.per_climb is not None
        air, sure = air_of(scenario, vehicle), measured and not vehicle.identify
        flown = Flown(vehicle.aircraft, aircraft, gains, air, sure)
        at: Location = ("vehicle", index, "airspeed_mps")
        written = entry.vehicle[index].airspeed_mps is not None
        start = asked = Asked(vehicle.airspeed_mps, at, written)
        if scenario.guidance.airspeed_mps is not None:
            asked = Asked(gains.airspeed, ("guidance", "airspeed_mps"), True)
        for each in (start, asked):
            air_checks.check_airspeed(each, flown, source)
        found = air_checks.check_thrust(asked, flown, source)
        warnings += found or air_checks.check_start(start, flown, source)
    return warnings


def check_file(path: Path) -> tuple[str, ...]:
    """Check a scenario or an aircraft file; returns warnings.

    Raises:
        InputError: it says something that is not allowed.
    """
    if "airspeed" in read_toml(path):
        load_aircraft(AircraftFiles(path.stem, path.parent, path, None))
        return ()
    return load_scenario(path).warnings


def _find_all(entry: ScenarioFile, source: Source) -> dict[str, AircraftFiles]:
    files: dict[str, AircraftFiles] = {}
    for index, vehicle in enumerate(entry.vehicle):
        try:
            name = aircraft_of(entry, vehicle)
            files[name] = find_aircraft(name, beside=source.path)
        except InputError as error:
            at = ("vehicle", index, "aircraft")
            raise source.error(at, str(error), vehicle.aircraft) from None
    return files


def _copy_aircraft(files: AircraftFiles, root: Path) -> None:
    """Copy the files of one aircraft into the `aircraft` folder `root`."""
    if root.resolve() == files.root.resolve():
        return
    folder = root / files.name
    folder.mkdir(parents=True, exist_ok=True)
    if files.model is not None:
        shutil.copytree(files.model.parent, folder, dirs_exist_ok=True)
    shutil.copy(files.performance, folder)
