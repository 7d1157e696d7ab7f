"""One vehicle of a run: the aircraft, its companion, and what is noted of its flight."""

import math
from array import array
from collections.abc import Callable

import numpy as np

from vfguide.companion.companion import Companion
from vfguide.companion.session import Session
from vfguide.geometry.geodesy import place_in_plane
from vfguide.geometry.units import G0, MS, US
from vfguide.geometry.vector import Vec3, sub
from vfguide.link.codec import Encoder
from vfguide.link.messages import SetAttitudeTarget
from vfguide.scenario.crew import simulate
from vfguide.scenario.load import LoadedScenario
from vfguide.scenario.passes import Legs, Sample
from vfguide.scenario.plans import plan_of
from vfguide.scenario.record import FlightRecord
from vfguide.scenario.resolve import place_of
from vfguide.scenario.resolved import Vehicle
from vfguide.scenario.result import TOUCH
from vfguide.scenario.steps import STEPS, Steps
from vfguide.scenario.truth_log import TRUTH_COMPONENT, truth_message
from vfguide.sim.delay_line import DelayLine
from vfguide.sim.port import ONBOARD
from vfguide.sim.truth import Truth

Write = Callable[[int, bytes], None]
"""Takes a time [us since 1970] and the bytes of one frame."""

ROUNDS = 4
"""Messages go back and forth at most this often at one instant; the rest waits for the next."""
COLUMNS = 36
"""Numbers that are noted of one instant, see `_row`."""
NOTHING_YET = (math.nan, math.nan, math.nan, math.nan)


class Member:
    """One vehicle, flown."""

    def __init__(
        self,
        loaded: LoadedScenario,
        vehicle: Vehicle,
        write_own: Write,
        write_truth: Write,
        steps: Steps = STEPS,
    ) -> None:
        """The vehicle at its start.

        Args:
            loaded: the scenario.
            vehicle: which of its vehicles.
            write_own: takes every frame between the companion and its autopilot.
            write_truth: takes the frames that tell the truth.
            steps: that its companion calls.

        Raises:
            InputError: the aircraft's model cannot be flown.
        """
        self.vehicle = vehicle
        self.sim = simulate(loaded, vehicle)
        self.companion = Companion(
            vehicle.id, plan_of(loaded, vehicle), engage=True, step=steps.measured
        )
        self.legs = Legs(vehicle.goals)
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
        for _ in range(ROUNDS):
            if down := self._down.arrived(now):
                self._up.send(now, self._session.receive(now, down))
            if up := self._up.arrived(now):
                self._down.send(now, self.sim.receive(self._port, up))
            if not (down or up):
                break

    def note(self) -> None:
        """Note the truth of this instant."""
        now, truth = self.sim.now, self.sim.truth
        self._write_truth(now, self._truth_encoder.encode(truth_message(now, truth)))
        p_n, v_n = place_in_plane(
            self._origin, truth.latitude, truth.longitude, truth.altitude, truth.v_n
        )
        sample = Sample(truth.time, p_n, v_n)
        if self.companion.route.is_testing:
            self._goals_from = math.inf
        else:
            self._goals_from = min(self._goals_from, truth.time)
            self.legs.feed(sample)
        flown = _row(truth, sample, self.sim.autopilot.setpoint)
        self._noted.extend((*flown, *self._position_error(p_n), *self.companion.route.noted))

    def _position_error(self, p_n: Vec3) -> Vec3:
        """Position that the autopilot tells less the true one, scenario frame [m]."""
        if self._exact:
            return (0.0, 0.0, 0.0)
        told = self.sim.autopilot.estimate
        place = (told.latitude, told.longitude, told.altitude)
        there, _ = place_in_plane(self._origin, *place, told.v_n)
        return sub(there, p_n)

    def record(self) -> FlightRecord:
        """What was noted."""
        rows = np.array(self._noted).reshape(-1, COLUMNS)
        rows, error, air, airspeed, guard = np.split(rows, np.cumsum([24, 3, 3, 2]), axis=1)
        time, p_n, v_n, euler, omega, wanted, thrust, speed, load, wind, altitude, height = (
            np.split(rows, np.cumsum([1, 3, 3, 3, 3, 3, 1, 1, 1, 3, 1]), axis=1)
        )
        return FlightRecord(
            self.vehicle,
            time[:, 0],
            p_n,
            v_n,
            euler,
            omega,
            wanted,
            thrust[:, 0],
            speed[:, 0],
            load[:, 0],
            wind,
            altitude[:, 0],
            height[:, 0],
            self.companion.setpoints,
            position_error_n=error,
            wind_believed=air,
            airspeed_believed=airspeed,
            goals_from=self._goals_from,
            identified=self.companion.route.identified,
            guard=guard if self.companion.route.plan.is_assured else None,
        )


def _row(truth: Truth, at: Sample, setpoint: SetAttitudeTarget | None) -> tuple[float, ...]:
    """The numbers of one instant, in the order of a FlightRecord's columns."""
    return (
        at.time,
        *at.p_n,
        *at.v_n,
        truth.roll,
        truth.pitch,
        truth.yaw,
        *truth.omega_b,
        *_commanded(setpoint),
        truth.airspeed,
        -truth.force_b[2] / G0,
        *truth.wind_n,
        truth.altitude,
        truth.height_above_ground,
    )


def _commanded(sp: SetAttitudeTarget | None) -> tuple[float, float, float, float]:
    """Body rates and thrust of the latest setpoint."""
    if sp is None:
        return NOTHING_YET
    return (sp.body_roll_rate, sp.body_pitch_rate, sp.body_yaw_rate, sp.thrust)
