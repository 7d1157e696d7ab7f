"""A companion with somebody who plays its autopilot."""

from plans import FIRST_FLIGHT

from vfguide.autopilots.engagement import Phase
from vfguide.autopilots.px4 import Px4Mode, main_and_sub
from vfguide.companion.companion import Companion
from vfguide.companion.guided_flight import GuidedFlight
from vfguide.companion.plan import Plan
from vfguide.geometry.units import DEG_E7, MM
from vfguide.link.enums import MavAutopilot, MavCmd, MavResult, MavState, MavType
from vfguide.link.messages import (
    AttitudeQuaternion,
    CommandAck,
    CommandLong,
    GpsGlobalOrigin,
    Heartbeat,
    LocalPositionNed,
    SetAttitudeTarget,
    Timesync,
    VfrHud,
)

SECOND = 1_000_000
TICK = 20_000
START = 1_767_225_600 * SECOND


def plan() -> Plan:
    return FIRST_FLIGHT


def heartbeat(mode: int = Px4Mode.HOLD) -> Heartbeat:
    return Heartbeat(MavType.FIXED_WING, MavAutopilot.PX4, 0, mode, MavState.ACTIVE)


def state(time_boot_ms: int, north: float = 0.0) -> list:
    """Level flight to the north, all that the companion needs of one instant."""
    latitude, longitude, altitude = plan().origin
    origin = (round(latitude / DEG_E7), round(longitude / DEG_E7), round(altitude / MM))
    return [
        GpsGlobalOrigin(*origin),
        LocalPositionNed(time_boot_ms, north, -300.0, -120.0, 25.0, 0.0, 0.0),
        VfrHud(24.0, 25.0, 0, 30, altitude + 120.0, 0.0),
        AttitudeQuaternion(time_boot_ms, 1.0, 0.0, 0.0, 0.0, 0.0, 0.0, 0.0),
    ]


class Conversation:
    """Time goes on by itself; what the companion says is kept."""

    answers_timesync = True

    def __init__(self, *, engage: bool = True, sysid: int = 1) -> None:
        self.companion = Companion(sysid, plan(), engage=engage)
        self.now = START
        self.boot_ms = 5000
        self.said: list = []
        self.told: list[str] = []

    def hear(self, *messages) -> list:
        """What the companion answers."""
        out = [answer for m in messages for answer in self.companion.receive(self.now, m)]
        return self.keep(out)

    def keep(self, out: list) -> list:
        """Keep what the companion says; the autopilot answers at once how late it is."""
        if self.answers_timesync:
            for question in [m for m in out if isinstance(m, Timesync)]:
                answer = question._replace(tc1=1000 * self.boot_ms)
                out = [*out, *self.companion.receive(self.now, answer)]
        self.said += out
        self.told += self.companion.news()
        return out

    def fly(self, seconds: float, mode: int | None = Px4Mode.HOLD, *, flying: bool = True) -> list:
        """So many seconds of states and heartbeats; None: no heartbeats."""
        out = []
        for tick in range(round(seconds * SECOND / TICK)):
            self.now += TICK
            self.boot_ms += TICK // 1000
            if mode is not None and tick % 50 == 0:
                out += self.hear(heartbeat(mode))
            if flying:
                out += self.hear(*state(self.boot_ms, 0.025 * self.boot_ms))
            out += self.poll()
        return out

    def poll(self) -> list:
        return self.keep(self.companion.poll(self.now))

    def stop(self) -> list:
        out = self.companion.stop(self.now)
        self.told += self.companion.news()
        return out

    def acknowledge(self, result: int = MavResult.ACCEPTED) -> None:
        self.hear(CommandAck(MavCmd.DO_SET_MODE, result))


class Testing(Conversation):
    """The companion of a plan with a test flight."""

    __test__ = False

    def __init__(self, its: Plan) -> None:
        super().__init__()
        self.companion = type(self.companion)(1, its, engage=True)

    def engage(self) -> None:
        self.fly(1.0)
        self.fly(1.0, Px4Mode.OFFBOARD)

    @property
    def flight(self) -> GuidedFlight:
        return self.companion.flight


def setpoints(messages: list) -> list[SetAttitudeTarget]:
    return [m for m in messages if isinstance(m, SetAttitudeTarget)]


def modes_asked(messages: list) -> list[int]:
    """The modes of all DO_SET_MODE."""
    asked = []
    for m in messages:
        if isinstance(m, CommandLong) and m.command == MavCmd.DO_SET_MODE:
            asked += [mode for mode in Px4Mode if main_and_sub(mode) == (m.param2, m.param3)]
    return asked


def flying(**options) -> Conversation:
    """A companion whose setpoints are followed."""
    talk = Conversation(**options)
    talk.fly(1.0)
    talk.fly(1.0, Px4Mode.OFFBOARD)
    assert talk.companion.phase is Phase.FLYING
    return talk
