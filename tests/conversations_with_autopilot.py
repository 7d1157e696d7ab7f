"""The software autopilot as its peers see it: bytes in, bytes out."""

import math

from aeroplanes import AEROSONDE
from sim_flights import AEROSONDE as MODEL

from vfguide.autopilots.px4 import main_and_sub
from vfguide.earth.geodesy import ned_to_geodetic, tangent_plane
from vfguide.geometry.units import DEG
from vfguide.link.codec import Encoder, Parser, decode
from vfguide.link.enums import AttitudeTypeMask, MavAutopilot, MavCmd, MavState, MavType, ModeFlag
from vfguide.link.messages import CommandAck, CommandLong, Heartbeat, SetAttitudeTarget
from vfguide.sim.autopilot.mavlink_channel import ONBOARD
from vfguide.sim.bench import Bench
from vfguide.sim.condition import Start, Weather
from vfguide.sim.trim import trim
from vfguide.sim.vehicle import Setup, Vehicle

UPDATE = 4
"""Steps of the plant between two updates of the autopilot."""
COMPANION = (1, 195)
LEVEL = (1.0, 0.0, 0.0, 0.0)
RATES = AttitudeTypeMask.ATTITUDE_IGNORE
ATTITUDES = (
    AttitudeTypeMask.BODY_ROLL_RATE_IGNORE
    | AttitudeTypeMask.BODY_PITCH_RATE_IGNORE
    | AttitudeTypeMask.BODY_YAW_RATE_IGNORE
)


def new_vehicle() -> Vehicle:
    """That of the first flight, at its start."""
    origin, speed = (47.397742 * DEG, 8.545594 * DEG, 488.0), 25.0
    latitude, longitude, altitude = ned_to_geodetic(
        tangent_plane(*origin), (-450.0, -350.0, -120.0)
    )
    start = Start(latitude, longitude, altitude, 0.0, trim(Bench(MODEL, altitude), speed))
    wind = Weather((3.0 * math.cos(120.0 * DEG), 3.0 * math.sin(120.0 * DEG), 0.0))
    setup = Setup(1, MODEL, AEROSONDE, speed, start, wind, origin[2], frame_origin=origin)
    return Vehicle(setup, 1_767_225_600_000_000)


class Dialogue:
    """One peer and one vehicle."""

    def __init__(self, vehicle: Vehicle, speaker: tuple[int, int] = COMPANION, rates=None) -> None:
        self.vehicle = vehicle
        self.port = vehicle.connect(ONBOARD if rates is None else rates)
        self._encoder = Encoder(*speaker)
        self._parser = Parser()

    def send(self, *messages) -> list:
        """The answers to messages, at once."""
        return self.send_bytes(*map(self._encoder.encode, messages))

    def send_bytes(self, *datagrams: bytes) -> list:
        answers = [raw for data in datagrams for raw in self.vehicle.receive(self.port, data)]
        return self._read(answers)

    def fly(self, seconds: float, setpoint: SetAttitudeTarget | None = None) -> list:
        """What the vehicle sends meanwhile; with a setpoint sent at each update."""
        heard = []
        for _ in range(round(seconds / 0.02)):
            if setpoint is not None:
                heard += self.send(setpoint)
            self.vehicle.advance(UPDATE)
            heard += self._read(self.vehicle.transmit(self.port))
        return heard

    def command(self, number: int, *parameters: float, target: tuple[int, int] = (1, 1)) -> list:
        p = [*parameters, *[0.0] * (7 - len(parameters))]
        return self.send(CommandLong(*target, number, 0, *p))

    def set_mode(self, mode) -> list:
        main, sub = main_and_sub(mode)
        return self.command(MavCmd.DO_SET_MODE, ModeFlag.CUSTOM_MODE_ENABLED, main, sub)

    def greet_as_ground_station(self) -> None:
        self.send(Heartbeat(MavType.GCS, MavAutopilot.INVALID, 0, 0, MavState.ACTIVE))

    def _read(self, frames: list[bytes]) -> list:
        return [decode(frame) for raw in frames for frame in self._parser.feed(raw)]


def of(messages: list, kind: type) -> list:
    return [message for message in messages if isinstance(message, kind)]


def results(messages: list) -> list[int]:
    return [ack.result for ack in of(messages, CommandAck)]


def setpoint(p=0.0, q=0.0, r=0.0, thrust=0.3, *, mask=RATES, attitude=LEVEL, target=1):
    return SetAttitudeTarget(0, target, 1, mask, attitude, p, q, r, thrust)
