"""What is recorded of a flight: the truth at the guidance rate, and what was commanded."""

from dataclasses import dataclass

import numpy as np
from numpy.typing import NDArray

from vfguide.flight.identification import Identified
from vfguide.scenario.arrivals import Arrivals
from vfguide.scenario.passes import Legs, Sample
from vfguide.scenario.resolved import Vehicle

Array = NDArray[np.float64]


@dataclass(frozen=True)
class FlightRecord:
    """One vehicle's flight: n samples at equal steps, SI units and radians.

    What a plant does not have, such as the load factor of a kinematic body, is NaN.
    """

    vehicle: Vehicle
    time: Array
    """(n,) since the start of the run."""
    p_n: Array
    """(n, 3) in the scenario frame."""
    v_n: Array
    """(n, 3) velocity over ground in the scenario frame."""
    euler: Array
    """(n, 3) roll, pitch, yaw."""
    omega_b: Array
    """(n, 3) body rates."""
    omega_wanted_b: Array
    """(n, 3) body rates of the latest setpoint; NaN before the first."""
    thrust: Array
    """(n,) thrust of the latest setpoint, 0 to 1; NaN before the first."""
    airspeed: Array
    """(n,) true airspeed."""
    load_factor: Array
    """(n,) lift over weight."""
    wind_n: Array
    """(n, 3) the direction the air moves toward, gusts included."""
    altitude: Array
    """(n,) above the ellipsoid."""
    height_above_ground: Array
    """(n,)."""
    setpoints: int
    """How many were sent."""

    R_nb: Array | None = None
    """(n, 3, 3) attitude of a rigid body, whose speed and body rates are held from one sample to
    the next: those that brought it to the later one. None: an aeroplane."""
    position_error_n: Array | None = None
    """(n, 3) position that the autopilot tells less the true one; None: they are the same."""
    wind_believed: Array | None = None
    """(n, 3) what the companion makes of the wind: north, east, standard deviation [m/s]."""
    airspeed_believed: Array | None = None
    """(n, 2) of the airspeed: true airspeed, standard deviation [m/s]."""
    guard: Array | None = None
    """(n, 4) what the assurance decided: its `Reason`, least clearance of the way out [m], time
    to the conflict that it saw [s], number of the hazard; None: nothing to keep clear of."""
    goals_from: float = 0.0
    """The goals are flown to from this time on; a test flight goes before."""
    identified: Identified | None = None
    """The aircraft as that test flight has shown it."""
    arrives: bool = False
    """It slows down towards its goals, and stands still at the last one."""

    def legs(self) -> Legs:
        """The legs that were flown."""
        legs = Arrivals(self.vehicle.goals) if self.arrives else Legs(self.vehicle.goals)
        directions = self.R_nb[:, :, 0] if self.arrives and self.R_nb is not None else self.v_n
        rows = zip(self.time.tolist(), self.p_n.tolist(), directions.tolist(), strict=True)
        for time, p_n, v_n in rows:
            if time >= self.goals_from:
                legs.feed(Sample(time, tuple(p_n), tuple(v_n)))
        return legs
