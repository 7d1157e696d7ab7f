"""One vehicle of a run: the aircraft, its companion, and what is noted of its flight."""

import math
from array import array
from collections.abc import Callable
from typing import Any

import numpy as np

from vfguide.companion.companion import Companion
from vfguide.companion.session import Record, Session
from vfguide.earth.geodesy import place_in_plane
from vfguide.geometry.units import G0, MS, US
from vfguide.geometry.vector import Vec3, sub
from vfguide.guidance.laws import FieldLaw
from vfguide.kernels.rows import columns, flattener, width
from vfguide.link.codec import Encoder
from vfguide.link.delay_line import DelayLine
from vfguide.link.messages import SetAttitudeTarget
from vfguide.results.announced_legs import AnnouncedLegs
from vfguide.results.goal_passages import Sample
from vfguide.results.record import AirBelief, Decisions, FlightRecord, Instant
from vfguide.results.verdict import TOUCH
from vfguide.runs.steps import STEPS, Steps
from vfguide.runs.truth_log import TRUTH_COMPONENT, truth_message
from vfguide.runs.vehicle_setup import simulate
from vfguide.scenario.loaded import LoadedScenario
from vfguide.scenario.plans import plan_of
from vfguide.scenario.resolve import place_of
from vfguide.scenario.resolved import Vehicle
from vfguide.sim.autopilot.mavlink_channel import ONBOARD
from vfguide.sim.truth import Truth

Write = Callable[[int, bytes], None]
"""Takes a time [us since 1970] and the bytes of one frame."""

ROUNDS = 4
"""Largest number of exchanges between autopilot and companion at one instant; chosen, later
messages wait for the next."""
numbers_of = flattener(Instant)


class JsbsimVehicle:
    """One vehicle, flown."""

    def __init__(
        self,
        loaded: LoadedScenario,
        vehicle: Vehicle,
        write_own: Record,
        write_truth: Write,
        steps: Steps = STEPS,
    ) -> None:
        """The vehicle at its start.

        Args:
            loaded: the scenario.
            vehicle: which of its vehicles.
            write_own: takes the frames between the companion and its autopilot.
            write_truth: takes the frames of the truth.
            steps: the compiled steps that its companion calls.

        Raises:
            InputError: the aircraft's model cannot be flown.
        """
        self.vehicle = vehicle
        self.sim = simulate(loaded, vehicle)
        self.companion = Companion(
            vehicle.id, plan_of(loaded, vehicle), engage=True, step=steps.measured
        )
        self.legs = AnnouncedLegs(vehicle.goals)
        scenario = loaded.scenario
        self._exact = scenario.sensors is None and not scenario.autopilot.reset
        self._origin = place_of(loaded.scenario.origin)
        self._port = self.sim.connect(ONBOARD)
        self._session = Session(self.companion, write_own)
        self._write_truth = write_truth
        self._truth_encoder = Encoder(vehicle.id, TRUTH_COMPONENT)
        self._down = DelayLine(round(scenario.link.delay_ms * MS / US))
        self._up = DelayLine(round(scenario.link.delay_back_ms * MS / US))
        self._goals_from = math.inf
        self._noted = array("d")  # records by the thousand would crowd the caches
        self.exchange()
        self.note()

    @property
    def grounded(self) -> bool:
        """Whether the flight has ended on the ground."""
        return self.sim.truth.height_above_ground <= TOUCH

    def fly(self, steps: int) -> None:
        """Fly on for some steps of the plant, then let autopilot and companion speak."""
        self.sim.advance(steps)
        self.exchange()
        self.note()

    def exchange(self) -> None:
        """Carry bytes between autopilot and companion until nothing more arrives now."""
        now = self.sim.now
        self._down.send(now, self.sim.transmit(self._port))
        for turn in range(ROUNDS):
            if down := self._down.arrived(now):
                self._up.send(now, self._session.receive(now, down))
            elif turn == 0:
                self._up.send(now, self._session.poll(now))
            if up := self._up.arrived(now):
                self._down.send(now, self.sim.receive(self._port, up))
            if not (down or up):
                break

    def note(self) -> None:
        """Note the truth of this instant."""
        now, truth, flight = self.sim.now, self.sim.truth, self.companion.flight
        self._write_truth(now, self._truth_encoder.encode(truth_message(now, truth)))
        p_n, v_n = place_in_plane(
            self._origin, truth.latitude, truth.longitude, truth.altitude, truth.v_n
        )
        sample = Sample(truth.time, p_n, v_n)
        if flight.is_testing:
            self._goals_from = math.inf
        else:
            self._goals_from = min(self._goals_from, truth.time)
            self.legs.feed(sample)
            for said in flight.announced[len(self.legs.announced) :]:
                self.legs.announce(said)
        self._noted.extend(numbers_of(self._instant(truth, sample)))

    def _instant(self, truth: Truth, at: Sample) -> Instant:
        """What is noted of this instant."""
        omega_wanted_b, thrust = _commanded(self.sim.autopilot.setpoint)
        _, _, down = truth.force_b
        return Instant(
            time=at.time,
            p_n=at.p_n,
            v_n=at.v_n,
            euler=(truth.roll, truth.pitch, truth.yaw),
            omega_b=truth.omega_b,
            omega_wanted_b=omega_wanted_b,
            thrust=thrust,
            airspeed=truth.airspeed,
            load_factor=-down / G0,
            wind_n=truth.wind_n,
            altitude=truth.altitude,
            height_above_ground=truth.height_above_ground,
            position_error_n=self._position_error(at.p_n),
            step=self.companion.flight.noted,
        )

    def _position_error(self, p_n: Vec3) -> Vec3:
        """Position that the autopilot reports less the true one, scenario frame [m]."""
        if self._exact:
            return (0.0, 0.0, 0.0)
        estimate = self.sim.autopilot.estimate
        place = (estimate.latitude, estimate.longitude, estimate.altitude)
        there, _ = place_in_plane(self._origin, *place, estimate.v_n)
        return sub(there, p_n)

    def record(self) -> FlightRecord:
        """What was noted."""
        table = np.array(self._noted).reshape(-1, width(Instant))
        flown: Any = columns(Instant, table)
        step: Any = flown.step
        plan = self.companion.flight.plan
        decided = Decisions(step.reason, step.margin, step.conflict, step.hazard)
        return FlightRecord(
            vehicle=self.vehicle,
            time=flown.time,
            p_n=flown.p_n,
            v_n=flown.v_n,
            euler=flown.euler,
            omega_b=flown.omega_b,
            omega_wanted_b=flown.omega_wanted_b,
            thrust=flown.thrust,
            airspeed=flown.airspeed,
            load_factor=flown.load_factor,
            wind_n=flown.wind_n,
            altitude=flown.altitude,
            height_above_ground=flown.height_above_ground,
            setpoints=self.companion.setpoints,
            position_error_n=flown.position_error_n,
            air=AirBelief(
                wind_north=step.wind_north,
                wind_east=step.wind_east,
                wind_sigma=step.wind_sigma,
                airspeed=step.airspeed,
                airspeed_sigma=step.airspeed_sigma,
            ),
            goals_from=self._goals_from,
            announced=tuple(self.legs.announced),
            identified=self.companion.flight.identified,
            decisions=decided if plan.is_assured else None,
            leaders=step.leader if isinstance(plan.law, FieldLaw) else None,
        )


def _commanded(sp: SetAttitudeTarget | None) -> tuple[Vec3, float]:
    """Body rates [rad/s] and thrust of the latest setpoint; not numbers before the first."""
    if sp is None:
        return (math.nan, math.nan, math.nan), math.nan
    _, _, _, _, _, p, q, r, thrust, *_ = sp
    return (p, q, r), thrust
