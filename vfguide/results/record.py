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
    """What is noted of one instant of an aeroplane's flight: the fields of a `FlightRecord`."""

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
    """What the companion noted of its last step."""


class AirBelief(NamedTuple):
    """The companion's estimate of the air at n instants [m/s]; zero before the first step."""

    wind_north: Series
    """Wind blowing to the north."""
    wind_east: Series
    """Wind blowing to the east."""
    wind_sigma: Series
    """Standard deviation of either."""
    airspeed: Series
    """True airspeed."""
    airspeed_sigma: Series
    """Standard deviation of the true airspeed."""


class Decisions(NamedTuple):
    """What the run-time assurance decided at n instants; all zero before the first decision."""

    reason: Series
    """The value of a `Reason`."""
    margin: Series
    """Least clearance along the escape [m]."""
    conflict: Series
    """Time to the conflict that was seen [s]."""
    hazard: Series
    """Number of the hazard."""


@dataclass(frozen=True)
class FlightRecord:
    """One vehicle's flight: n samples at equal steps, SI units and radians.

    What a plant does not have, such as the load factor of a kinematic body, is NaN.
    """

    vehicle: Vehicle
    time: Series
    """(n,) since the start of the run."""
    p_n: Vectors
    """(n, 3) in the scenario frame."""
    v_n: Vectors
    """(n, 3) velocity over ground in the scenario frame."""
    euler: Vectors
    """(n, 3) roll, pitch, yaw."""
    omega_b: Vectors
    """(n, 3) body rates."""
    omega_wanted_b: Vectors
    """(n, 3) body rates of the latest setpoint; NaN before the first."""
    thrust: Series
    """(n,) thrust of the latest setpoint, 0 to 1; NaN before the first."""
    airspeed: Series
    """(n,) true airspeed."""
    load_factor: Series
    """(n,) lift over weight."""
    wind_n: Vectors
    """(n, 3) the direction the air moves toward, gusts included."""
    altitude: Series
    """(n,) above mean sea level."""
    height_above_ground: Series
    """(n,)."""
    setpoints: int
    """Number of setpoints that were sent."""

    R_nb: Matrices | None = None
    """(n, 3, 3) attitude of a rigid body, whose speed and body rates are held from one sample to
    the next: those that brought it to the later one. None: an aeroplane."""
    position_error_n: Vectors | None = None
    """(n, 3) position that the autopilot reports less the true one; None: they are the same."""
    air: AirBelief | None = None
    """The companion's estimate of the air; None: there is no air."""
    decisions: Decisions | None = None
    """What the run-time assurance decided; None: nothing to keep clear of."""
    leaders: Series | None = None
    """(n,) the value of a `Leader`: what law `field` followed; None: another law."""
    goals_from: float = 0.0
    """The goals are flown to from this time on; a test flight goes before."""
    identified: Identified | None = None
    """The aircraft as that test flight has shown it."""
    arrives: bool = False
    """Whether it slows down towards its goals, and stops at the last one."""
    announced: tuple[TimedAnnouncement, ...] | None = None
    """What it announced of its goals; None: it announces nothing, and the truth alone tells which
    goal it flies to."""

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
        """The path that the goals are judged on, with the velocities `v_n`."""
        rows = zip(self.time.tolist(), self.p_n.tolist(), v_n.tolist(), strict=True)
        for time, place, velocity in rows:
            if time >= self.goals_from:
                yield Sample(time, tuple(place), tuple(velocity))
