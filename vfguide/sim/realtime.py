"""Simulated vehicles in real time: the schedule and the sockets served by one loop."""

import selectors
import time
from collections.abc import Callable, Sequence

from vfguide.geometry.units import MS
from vfguide.link.enums import AttitudeTypeMask
from vfguide.link.messages import SetAttitudeTarget
from vfguide.sim.autopilot.flight_mode import Event
from vfguide.sim.autopilot.mavlink_channel import ONBOARD
from vfguide.sim.fdm import ModelError
from vfguide.sim.plant import STEP
from vfguide.sim.real_time_pacing import RealTimePacing
from vfguide.sim.udp import Channel
from vfguide.sim.vehicle import Vehicle

LATE = 0.1
"""Delay of a step behind its schedule above which the user is warned [s]; chosen."""
SHORT_NAP = 0.05
"""Longest wait for sockets before a request to stop is looked for [s]; chosen."""
RATE_MASK = AttitudeTypeMask.ATTITUDE_IGNORE
"""Type mask of a setpoint of body rates."""
ATTITUDE_MASK = (
    AttitudeTypeMask.BODY_ROLL_RATE_IGNORE
    | AttitudeTypeMask.BODY_PITCH_RATE_IGNORE
    | AttitudeTypeMask.BODY_YAW_RATE_IGNORE
)
"""Type mask of a setpoint of an attitude."""
LEVEL_QUATERNION = (1.0, 0.0, 0.0, 0.0)
"""Level attitude towards north as a quaternion w, x, y, z, dimensionless."""
WARM_UP_THRUST = 0.3
"""Thrust of the setpoints of the warm-up, a share of full thrust; chosen."""

Say = Callable[[str], None]


def warm_up(scratch: Vehicle) -> None:
    """Fly `scratch` in every mode: all code is compiled before the clock runs."""
    port = scratch.connect(ONBOARD)
    for mask in (RATE_MASK, ATTITUDE_MASK):
        setpoint = SetAttitudeTarget(
            0, scratch.sysid, 1, mask, LEVEL_QUATERNION, 0.0, 0.0, 0.0, WARM_UP_THRUST
        )
        scratch.autopilot.take_setpoint(setpoint)
        scratch.autopilot.happen(Event.OFFBOARD_ASKED)
        scratch.advance(1)
        scratch.transmit(port)
    for asked in (Event.RETURN_ASKED, Event.HOLD_ASKED):
        scratch.autopilot.happen(asked)
        scratch.advance(1)


class Station:
    """A vehicle and its channels."""

    def __init__(self, vehicle: Vehicle, channels: Sequence[Channel]) -> None:
        self.vehicle = vehicle
        self.channels = tuple(channels)

    def fly_step(self) -> str | None:
        """Fly one step of the plant; returns why it was the last, if it was."""
        try:
            self.vehicle.fly(1)
        except ModelError as error:
            return str(error)
        return None

    def speak(self) -> str | None:
        """The autopilot's slower part, and what it sends; returns why it was the last, if so."""
        self.vehicle.renew()
        if self.vehicle.truth.height_above_ground <= 0.0:
            return "it has hit the ground"
        for channel in self.channels:
            channel.transmit()
        return None


class RealtimeFlight:
    """Vehicles that fly in real time until they are stopped."""

    def __init__(
        self,
        stations: Sequence[Station],
        speed: float,
        steps: int,
        observe: Callable[[Vehicle], None],
        warn: Say,
    ) -> None:
        """A flight of `stations`, all at their starts.

        Args:
            stations: the vehicles.
            speed: ratio of simulated to real time.
            steps: number of steps of the plant between two updates of the autopilots.
            observe: called with a vehicle at each of its updates.
            warn: takes messages for the user.
        """
        self.flying = list(stations)
        self.pace = RealTimePacing(time.monotonic(), STEP / speed)
        self._steps = steps
        self._observe = observe
        self._warn = warn
        self._warned = False

    @property
    def sim_s(self) -> float:
        """Simulated time so far [s]."""
        return self.pace.taken * STEP

    def run(self, stopped: Callable[[], bool]) -> None:
        """Fly until `stopped` is true, or no vehicle flies any more."""
        # select() waits to the microsecond; epoll, in Python, to the next millisecond.
        with selectors.SelectSelector() as selector:
            for station in self.flying:
                for channel in station.channels:
                    selector.register(channel.socket, selectors.EVENT_READ, channel)
            while self.flying and not stopped():
                wait = min(self.pace.wait(time.monotonic()), SHORT_NAP)
                for key, _ in selector.select(wait):
                    key.data.receive()
                self._catch_up()

    def _catch_up(self) -> None:
        """Take the steps that are due, but no more than to the next update: then look again."""
        for _ in range(min(self.pace.due(time.monotonic()), self._steps)):
            number = self.pace.take()
            self._for_all(Station.fly_step)
            if number % self._steps == 0:
                self._for_all(Station.speak)
                for station in self.flying:
                    self._observe(station.vehicle)
                break
        self._complain()

    def _for_all(self, action: Callable[[Station], str | None]) -> None:
        for station in tuple(self.flying):
            if end := action(station):
                self.flying.remove(station)
                seconds = station.vehicle.plant.time
                self._warn(f"vehicle {station.vehicle.sysid} ends after {seconds:.1f} s: {end}")

    def _complain(self) -> None:
        """Say once that this machine is too slow."""
        if self.pace.worst > LATE and not self._warned:
            self._warned = True
            self._warn(
                f"this machine is too slow or too busy: {self.pace.worst / MS:.0f} ms behind the "
                "clock; the flight goes on and catches up where it can"
            )
