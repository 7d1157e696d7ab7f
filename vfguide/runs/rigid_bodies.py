"""The fleet of plant `kinematic`: the paper's rigid bodies, and what is noted of their flights."""

from collections.abc import Callable, Sequence
from dataclasses import dataclass

import numpy as np

from vfguide.geometry.arrays import euler_angles
from vfguide.geometry.so3 import from_euler
from vfguide.geometry.units import DEG, US
from vfguide.kernels.rows import columns
from vfguide.link.codec import Encoder
from vfguide.results.announced_legs import AnnouncedLegs
from vfguide.results.arrivals import Arrivals
from vfguide.results.goal_passages import Legs, Sample
from vfguide.results.record import Array, FlightRecord
from vfguide.results.verdict import FAR_AWAY
from vfguide.runs.fleet import Ending
from vfguide.runs.kinematic_laws import FlightKinematicLaw, KinematicLaw, PaperKinematicLaw
from vfguide.runs.steps import STEPS, Steps
from vfguide.runs.truth_log import TRUTH_COMPONENT, body_message
from vfguide.scenario.loaded import LoadedScenario
from vfguide.scenario.resolve import place_of
from vfguide.scenario.resolved import Vehicle, start_us
from vfguide.sim.kinematic import Bodies, Commands, Sighting, advance, sightings

Write = Callable[[int, bytes], None]
"""Takes a time [us since 1970] and the bytes of one frame."""


@dataclass(frozen=True)
class RigidBody:
    """One vehicle of the fleet."""

    vehicle: Vehicle
    legs: Legs


class RigidBodies:
    """Rigid bodies that are steered at the guidance rate; inside they are sorted by their ids."""

    def __init__(self, loaded: LoadedScenario, write: Write, steps: Steps = STEPS) -> None:
        """All at their starts; `write` takes the frames of the truth."""
        scenario = loaded.scenario
        self._rate = scenario.guidance.rate_hz
        self._origin = place_of(scenario.origin)
        self._start = start_us(scenario)
        self._write = write
        self._bodies = bodies_at_start(by_id := sorted(scenario.vehicles, key=lambda each: each.id))
        self._law: KinematicLaw
        if scenario.law == "paper":
            arrivals = [Arrivals(vehicle.goals) for vehicle in by_id]
            self._law, legs = PaperKinematicLaw(scenario, arrivals, steps), arrivals
        else:
            announced = [AnnouncedLegs(vehicle.goals) for vehicle in by_id]
            self._law, legs = FlightKinematicLaw(loaded, by_id, announced, steps), announced
        self._sorted = [RigidBody(*each) for each in zip(by_id, legs, strict=True)]
        self._order = [by_id.index(vehicle) for vehicle in scenario.vehicles]
        self._encoders = [Encoder(vehicle.id, TRUTH_COMPONENT) for vehicle in by_id]
        self._updates = 0
        self._noted: list[tuple[Bodies, Commands, Array]] = []
        self._look()
        self._commands = self._law.steer(0.0, self._bodies)
        self._note()

    @property
    def members(self) -> Sequence[RigidBody]:
        """The vehicles in the order of the scenario."""
        return [self._sorted[i] for i in self._order]

    @property
    def period(self) -> float:
        """Time from one update to the next [s]."""
        return 1.0 / self._rate

    @property
    def ending(self) -> Ending | None:
        """A body is far away."""
        return Ending.FAR_AWAY if np.abs(self._bodies.p_n).max() > FAR_AWAY else None

    def advance(self) -> None:
        """Move all bodies on to the next update, then steer them anew.

        The speed and the rates that brought them there are recorded.
        """
        self._bodies = advance(self._bodies, self._commands, self.period)
        self._updates += 1
        self._look()
        self._note()
        self._commands = self._law.steer(self._time, self._bodies)

    def records(self) -> tuple[FlightRecord, ...]:
        """What was noted, in the order of the scenario."""
        bodies, commands, altitude = zip(*self._noted, strict=True)
        flown = Bodies(*map(np.array, zip(*bodies, strict=True)))
        driven = Commands(*map(np.array, zip(*commands, strict=True)))
        heights = np.array(altitude)
        return tuple(self._record(i, flown, driven, heights) for i in self._order)

    @property
    def _time(self) -> float:
        return self._updates / self._rate

    def _look(self) -> None:
        """Pass the positions of the bodies to their legs."""
        courses = self._law.courses(self._bodies).tolist()
        rows = zip(self._sorted, self._bodies.p_n.tolist(), courses, strict=True)
        for body, p_n, course in rows:
            if not body.legs.finished:
                body.legs.feed(Sample(self._time, tuple(p_n), tuple(course)))

    def _note(self) -> None:
        """Note the truth of this instant, in the log too."""
        seen = columns(Sighting, sightings(self._bodies, self._commands, self._origin))
        self._noted.append((self._bodies, self._commands, np.asarray(seen.altitude)))
        now = self._start + round(self._time / US)
        rates = self._commands.omega_b.tolist()
        each = map(Sighting, *(np.asarray(column).tolist() for column in seen))
        for encoder, sighting, omega_b in zip(self._encoders, each, rates, strict=True):
            self._write(now, encoder.encode(body_message(now, sighting, omega_b)))

    def _record(self, i: int, flown: Bodies, driven: Commands, altitude: Array) -> FlightRecord:
        """What was noted of body `i`; the leading axes of the arrays are samples and bodies."""
        legs = self._sorted[i].legs
        R_nb, omega_b = flown.R_nb[:, i].copy(), driven.omega_b[:, i].copy()
        none = np.full(len(R_nb), np.nan)
        return FlightRecord(
            vehicle=self._sorted[i].vehicle,
            time=np.arange(len(R_nb)) / self._rate,
            p_n=flown.p_n[:, i].copy(),
            v_n=driven.speed[:, i, None] * R_nb[:, :, 0],
            euler=euler_angles(R_nb),
            omega_b=omega_b,
            omega_wanted_b=omega_b,
            thrust=none,
            airspeed=none,
            load_factor=none,
            wind_n=np.full_like(omega_b, np.nan),
            altitude=altitude[:, i],
            height_above_ground=none,
            setpoints=self._updates,
            R_nb=R_nb,
            arrives=isinstance(self._law, PaperKinematicLaw),
            announced=tuple(legs.announced) if isinstance(legs, AnnouncedLegs) else None,
        )


def bodies_at_start(vehicles: Sequence[Vehicle]) -> Bodies:
    """The bodies at time zero."""
    attitudes = [from_euler(*(angle * DEG for angle in each.euler_deg)) for each in vehicles]
    return Bodies(np.array([each.position_m for each in vehicles], float), np.array(attitudes))
