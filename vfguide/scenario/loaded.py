"""A scenario with its aircraft."""

import shutil
from collections.abc import Mapping
from dataclasses import dataclass
from pathlib import Path

from vfguide import __version__
from vfguide.aircraft.air_density import in_air
from vfguide.aircraft.gain_scheduling import suited
from vfguide.aircraft.identification import Identified
from vfguide.aircraft.performance import Gains, Performance
from vfguide.files.aircraft_file import Aircraft, load_aircraft
from vfguide.files.atomic import write_atomically
from vfguide.files.data import AircraftFiles, data_folder, find_aircraft
from vfguide.files.errors import InputError
from vfguide.files.scenario_file import ScenarioFile
from vfguide.files.source import Source
from vfguide.geometry.units import DEG
from vfguide.scenario.resolve import air_of, aircraft_of, resolve
from vfguide.scenario.resolved import Scenario, Vehicle


@dataclass(frozen=True)
class LoadedScenario:
    """A scenario that can be flown, and the aircraft that fly it, by their names."""

    scenario: Scenario
    path: Path
    """The file of the scenario."""
    files: Mapping[str, AircraftFiles]
    """Files of the aircraft, by name."""
    aircraft: Mapping[str, Aircraft]
    """What these files say, by name."""
    warnings: tuple[str, ...] = ()
    """Warnings about the scenario, one message each."""

    def performance(self, vehicle: Vehicle) -> Performance:
        """The performance of the aircraft of `vehicle` at sea-level density."""
        return self.aircraft[vehicle.aircraft].performance()

    def performance_aloft(self, vehicle: Vehicle) -> Performance:
        """The performance of `vehicle` in the air of its highest start or goal, the thinnest."""
        density = air_of(self.scenario, vehicle).thinnest
        return in_air(self.performance(vehicle), density, self.scenario.airspeed_of(vehicle))

    def gains(self, vehicle: Vehicle) -> Gains:
        """The gains of `vehicle` that suit its roll response."""
        roll_rate = self.performance(vehicle).rate_max[0]
        return suited(self.untuned(vehicle), self.roll_time(vehicle), roll_rate)

    def roll_time(self, vehicle: Vehicle) -> float:
        """Roll response time of `vehicle`: from a step of roll rate to 63 % of it [s]."""
        return self.aircraft[vehicle.aircraft].response.roll_s

    def untuned(self, vehicle: Vehicle) -> Gains:
        """The gains of `vehicle` before they are suited to its roll response."""
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
        """Make sure that the vehicles of the scenario speak MAVLink.

        Raises:
            InputError: they do not, by their plant.
        """
        if self.scenario.plant != "jsbsim":
            plant = self.scenario.plant
            rule = 'it has no autopilot and no MAVLink, only vfguide run flies it; allowed "jsbsim"'
            raise InputError(f'{self.path}: plant = "{plant}": {rule}')

    def require_assured_law(self) -> None:
        """Make sure that the law of the scenario is one for real aircraft.

        Raises:
            InputError: it is not.
        """
        if self.scenario.law == "paper":
            rule = 'only vfguide run flies it, allowed "flight", "field"'
            raise InputError(f'{self.path}: law = "{self.scenario.law}": {rule}')

    def write_resolved(self, path: Path) -> None:
        """Write the resolved scenario to `path`, and the user's own aircraft beside it.

        The flight of what is written is the same.
        """
        for files in self.files.values():
            if files.root != data_folder() / "aircraft":
                _copy_aircraft(files, path.parent / "aircraft")
        write_atomically(path, self.scenario.to_toml())

    def write_identified(self, vehicle: Vehicle, found: Identified, folder: Path) -> None:
        """Write the aircraft file of `vehicle` with what a test flight found, below `folder`."""
        each = self.aircraft[vehicle.aircraft]
        how = f"Measured in flight by vfguide {__version__}"
        path = folder / f"aircraft-{vehicle.id}" / f"{each.name}.toml"
        path.parent.mkdir(exist_ok=True)
        write_atomically(path, each.as_identified(found, how).to_toml())


def resolved_from(entry: ScenarioFile, source: Source) -> LoadedScenario:
    """The scenario of a file that was read, with its aircraft; they are not checked further here.

    Raises:
        InputError: an aircraft is not found or cannot be flown, or a goal is not given in exactly
            one way.
    """
    files = _find_all(entry, source)
    aircraft = {name: load_aircraft(each) for name, each in files.items()}
    return LoadedScenario(resolve(entry, aircraft, source), source.path, files, aircraft)


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
