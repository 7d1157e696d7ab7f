"""The fleet of plant `jsbsim`: each vehicle an aeroplane with its autopilot and companion."""

from collections.abc import Sequence

from vfguide.results.record import FlightRecord
from vfguide.runs.fleet import Ending
from vfguide.runs.jsbsim_vehicle import JsbsimVehicle
from vfguide.runs.logs import Logs
from vfguide.runs.steps import STEPS, Steps
from vfguide.scenario.loaded import LoadedScenario
from vfguide.sim.plant import STEP
from vfguide.sim.vehicle import steps_between_updates


class Aeroplanes:
    """Aeroplanes that fly side by side; nothing but the clock is common to them."""

    def __init__(self, loaded: LoadedScenario, logs: Logs, steps: Steps = STEPS) -> None:
        """All at their starts.

        Raises:
            InputError: an aircraft's model cannot be flown.
            TlogError: a log cannot be written.
        """
        self._steps = steps_between_updates(loaded.scenario.guidance.rate_hz)
        self._members = [
            JsbsimVehicle(loaded, vehicle, logs.write_vehicle(vehicle), logs.write_all, steps)
            for vehicle in loaded.scenario.vehicles
        ]

    @property
    def members(self) -> Sequence[JsbsimVehicle]:
        """The vehicles."""
        return self._members

    @property
    def period(self) -> float:
        """Time from one update to the next [s]."""
        return self._steps * STEP

    @property
    def ending(self) -> Ending | None:
        """A vehicle touched the ground."""
        return Ending.GROUND if any(member.grounded for member in self._members) else None

    def advance(self) -> None:
        """Every vehicle flies on to the next update."""
        for member in self._members:
            member.fly(self._steps)

    def records(self) -> tuple[FlightRecord, ...]:
        """What was noted."""
        return tuple(member.record() for member in self._members)
