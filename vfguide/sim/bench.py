"""A JSBSim model in a virtual wind tunnel: accelerations and thrust at any flight condition."""

from vfguide.geometry.units import DEG
from vfguide.geometry.vector import Mat3
from vfguide.sim.condition import FlightCondition, Model, Start
from vfguide.sim.plant import Plant
from vfguide.sim.readings import Accelerations

_CLEAR_OF_GROUND = 1000.0
"""Height of the bench above the ground [m], where the ground has no effect."""
_FIRST_AIRSPEED = 50.0
"""Airspeed with which the model is loaded [m/s]; every condition replaces it."""
_LATITUDE = 45.0 * DEG
"""Latitude of the bench [rad], where gravity is near the standard one."""


class Bench:
    """`model` at `altitude` [m] above mean sea level, which sets the density of the air.

    JSBSim keeps rounding errors of one condition into the next: the same questions in the same
    order have identical answers, in another order they may differ in the last digit.

    Raises:
        ModelError: the model is missing, unreadable or broken.
    """

    def __init__(self, model: Model, altitude: float = 0.0) -> None:
        self.model = model
        self._altitude = altitude
        start = self._start(FlightCondition(_FIRST_AIRSPEED))
        self._plant = Plant(model, start, ground_altitude=altitude - _CLEAR_OF_GROUND)
        self.density = self._plant.truth().density
        """Air density [kg/m^3]."""

    @property
    def mass(self) -> float:
        """Mass [kg]."""
        return self._plant.readings.mass()

    @property
    def inertia(self) -> Mat3:
        """Inertia tensor, body FRD [kg m^2]."""
        return self._plant.readings.inertia()

    def accelerations(self, condition: FlightCondition) -> Accelerations:
        """The accelerations at a flight condition."""
        self._plant.place(self._start(condition))
        return self._plant.readings.accelerations()

    def thrust(self, condition: FlightCondition) -> float:
        """Steady thrust along body x [N]."""
        self._plant.place(self._start(condition))
        return self._plant.readings.thrust()

    def _start(self, condition: FlightCondition) -> Start:
        return Start(_LATITUDE, 0.0, self._altitude, 0.0, condition)
