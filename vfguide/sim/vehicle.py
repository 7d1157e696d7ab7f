"""One simulated vehicle: its plant and its autopilot, advancing together."""

from dataclasses import dataclass

from vfguide.aircraft.performance import Performance
from vfguide.geometry.units import US
from vfguide.geometry.vector import Vec3
from vfguide.sim.autopilot.autopilot import Autopilot
from vfguide.sim.autopilot.command_server import receive
from vfguide.sim.autopilot.instruments import EXACT, Instruments
from vfguide.sim.autopilot.mavlink_channel import MavlinkChannel
from vfguide.sim.autopilot.motor import SOUND, Motor
from vfguide.sim.condition import Model, Start, Weather
from vfguide.sim.inner_loop.airframe_model import identify
from vfguide.sim.plant import STEP, Plant
from vfguide.sim.traffic import Receiver, Transponder
from vfguide.sim.truth import Truth

STEP_US = round(STEP / US)
"""Time step of the plant in whole microseconds [us]."""
SLOWEST_UPDATE = 0.02
"""Longest time between two updates of the autopilot's estimate and streams [s]; chosen, 50 Hz."""


def steps_between_updates(rate: float) -> int:
    """Steps of the plant between two looks of the autopilot, for guidance at `rate` [Hz]."""
    return max(1, int(min(1.0 / rate, SLOWEST_UPDATE) / STEP + 1e-9))


@dataclass(frozen=True)
class Setup:
    """Everything a simulated vehicle begins with."""

    sysid: int
    model: Model
    aircraft: Performance
    """The aircraft at sea-level density."""
    airspeed: float
    """True airspeed of the autopilot's own flight [m/s]."""
    start: Start
    weather: Weather
    ground_altitude: float
    """Altitude of the ground above mean sea level [m]."""
    instruments: Instruments = EXACT
    """What the autopilot measures with."""
    motor: Motor = SOUND
    transponders: tuple[Transponder, ...] = ()
    """The other aircraft that its receiver may hear."""
    receiver_range: float = 0.0
    """Distance within which the receiver hears [m]."""
    frame_origin: Vec3 = (0.0, 0.0, 0.0)
    """Latitude, longitude [rad], altitude [m] of the frame of their paths."""


class Vehicle:
    """A plant and its autopilot; airborne, armed and in hold."""

    def __init__(self, setup: Setup, start_us: int) -> None:
        """A vehicle at its start.

        Args:
            setup: what it begins with.
            start_us: the date of its time zero [us since 1970].

        Raises:
            ModelError: the model cannot be flown.
        """
        self.sysid = setup.sysid
        self.plant = Plant(setup.model, setup.start, setup.weather, setup.ground_altitude)
        self.truth: Truth = self.plant.truth()
        airframe = identify(setup.model, setup.aircraft.airspeed_cruise)
        self.autopilot = Autopilot(
            setup.sysid,
            airframe,
            setup.aircraft,
            setup.airspeed,
            self.truth,
            setup.instruments,
            setup.motor,
        )
        self._start_us = start_us
        self._receiver = Receiver(setup.transponders, setup.frame_origin, setup.receiver_range)
        self.renew()

    @property
    def now(self) -> int:
        """The date [us since 1970]."""
        return self._start_us + self.plant.steps * STEP_US

    def advance(self, steps: int) -> None:
        """Fly on: the rate loop at every step of the plant, then the autopilot's slower part."""
        self.fly(steps)
        self.renew()

    def fly(self, steps: int) -> None:
        """Fly on with the rate loop alone.

        Raises:
            ModelError: the model fails in flight.
        """
        plant, control = self.plant, self.autopilot.control
        for _ in range(steps):
            plant.advance(control(plant.inner(), STEP))

    def renew(self) -> None:
        """Update the autopilot with the truth, and pass reports of traffic on."""
        self.truth = self.plant.truth()
        self.autopilot.update(self.now, self.truth)
        if self.autopilot.ports:
            for report in self._receiver.hear(self.truth):
                self.autopilot.pass_on(report)

    def connect(self, rates: dict[int, float]) -> MavlinkChannel:
        """A new MAVLink channel with these streams [Hz]."""
        port = MavlinkChannel(self.sysid, rates, self.now)
        self.autopilot.ports.append(port)
        return port

    def transmit(self, port: MavlinkChannel) -> list[bytes]:
        """The frames that are due on a channel."""
        return self.autopilot.streams(port)

    def receive(self, port: MavlinkChannel, data: bytes) -> list[bytes]:
        """Takes a datagram that arrived on a channel; returns the frames that answer it."""
        self.autopilot.now = self.now
        return receive(self.autopilot, port, data)
