"""What is recorded of a flight: the truth at the guidance rate, and what was commanded."""

from collections.abc import Iterator
from dataclasses import dataclass
from typing import NamedTuple

import numpy as np
from numpy.typing import NDArray

from vfguide.aircraft.identification import Identified
from vfguide.geometry.vector import Matrices, Series, Vec3, Vectors
from vfguide.loop.loop_report import Noted
from vfguide.results.announced_legs import TimedAnnouncement, announced_legs
from vfguide.results.arrivals import Arrivals
from vfguide.results.goal_passages import Legs, Sample
from vfguide.scenario.resolved import Vehicle

Array = NDArray[np.float64]


class Instant(NamedTuple):
    """What is recorded of an aeroplane at one instant; the fields are those of a `FlightRecord`."""

    time: float
    p_n: Vec3
    v_n: Vec3
    euler: Vec3
    omega_b: Vec3
    omega_wanted_b: Vec3
    thrust: float
    airspeed: float
    load_factor: float
    wind_n: Vec3
    altitude: float
    height_above_ground: float
    position_error_n: Vec3
    step: Noted
    """What the companion noted of its latest step."""


class AirBelief(NamedTuple):
    """The companion's estimate of the air at n instants, (n,) each [m/s].

    All are zero before the first step.
    """

    wind_north: Series
    """Component of the wind toward the north."""
    wind_east: Series
    """Component of the wind toward the east."""
    wind_sigma: Series
    """Standard deviation of each component of the wind."""
    airspeed: Series
    """True airspeed."""
    airspeed_sigma: Series
    """Standard deviation of the true airspeed."""


class Decisions(NamedTuple):
    """What the run-time assurance decided at n instants, (n,) each; zero before it decided."""

    reason: Series
    """The value of a `Reason`."""
    margin: Series
    """Least clearance along the escape [m]."""
    conflict: Series
    """Time to the conflict that was seen [s]; infinite: none was."""
    hazard: Series
    """Number of the hazard that the command would have met; -1: none."""


@dataclass(frozen=True)
class FlightRecord:
    """One vehicle's flight: n samples at equal steps, SI units and radians.

    What a plant does not have, such as the load factor of a kinematic body, is NaN.
    """

    vehicle: Vehicle
    time: Series
    """(n,) time since the start of the run [s]."""
    p_n: Vectors
    """(n, 3) position in the scenario frame, NED [m]."""
    v_n: Vectors
    """(n, 3) velocity over ground, NED [m/s]."""
    euler: Vectors
    """(n, 3) roll, pitch and yaw of the body against NED [rad]."""
    omega_b: Vectors
    """(n, 3) body rates, FRD [rad/s]."""
    omega_wanted_b: Vectors
    """(n, 3) body rates of the latest setpoint, FRD [rad/s]; NaN before the first."""
    thrust: Series
    """(n,) thrust of the latest setpoint, 0 to 1; NaN before the first."""
    airspeed: Series
    """(n,) true airspeed [m/s]."""
    load_factor: Series
    """(n,) load factor: lift over weight, dimensionless."""
    wind_n: Vectors
    """(n, 3) velocity of the air over ground, gusts included, NED [m/s]."""
    altitude: Series
    """(n,) altitude above mean sea level [m]."""
    height_above_ground: Series
    """(n,) height above the ground [m]."""
    setpoints: int
    """Number of setpoints that were sent."""

    R_nb: Matrices | None = None
    """(n, 3, 3) attitude of a rigid body, body FRD to NED; None: an aeroplane. The speed and the
    body rates of a sample are those with which the body came there from the sample before."""
    position_error_n: Vectors | None = None
    """(n, 3) position that the autopilot reports less the true one, NED [m]; None: it reports the
    true one."""
    air: AirBelief | None = None
    """The companion's estimate of the air; None: there is no air."""
    decisions: Decisions | None = None
    """What the run-time assurance decided; None: there was nothing to keep clear of."""
    leaders: Series | None = None
    """(n,) what law `field` followed, as the value of a `Leader`; None: another law was flown."""
    goals_from: float = 0.0
    """Time from which the goals are flown to, since the start of the run [s]; a test flight may
    come before."""
    identified: Identified | None = None
    """The aircraft as the test flight has shown it; None: there was no test flight, or it is not
    over."""
    arrives: bool = False
    """Whether the vehicle slows down towards its goals, and stops at the last one."""
    announced: tuple[TimedAnnouncement, ...] | None = None
    """What the vehicle announced of its goals; None: it announces nothing, and the true path alone
    tells which goal it flies to."""

    def legs(self) -> Legs:
        """The legs that were flown."""
        if self.announced is not None:
            return announced_legs(self.vehicle.goals, self._samples(self.v_n), self.announced)
        legs = Arrivals(self.vehicle.goals) if self.arrives else Legs(self.vehicle.goals)
        directions = self.R_nb[:, :, 0] if self.arrives and self.R_nb is not None else self.v_n
        for sample in self._samples(directions):
            legs.feed(sample)
        return legs

    def _samples(self, v_n: Vectors) -> Iterator[Sample]:
        """The samples on which the goals are judged, with (n, 3) `v_n` as their velocities."""
        rows = zip(self.time.tolist(), self.p_n.tolist(), v_n.tolist(), strict=True)
        for time, place, velocity in rows:
            if time >= self.goals_from:
                yield Sample(time, tuple(place), tuple(velocity))
