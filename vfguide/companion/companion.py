"""The companion: messages of one autopilot in, messages to it out.

No socket, clock or thread: every call carries the time. What it sends as setpoints follows
from what it received, and from when it sent something, so that a recording gives the same again.
"""

from vfguide.aircraft.state import RateSetpoint
from vfguide.companion.annunciations import RESTARTED, STOOD_STILL, TOO_SLOW, choice_note
from vfguide.companion.contact import LINK_TIMEOUT, Contact
from vfguide.companion.control import Control
from vfguide.companion.engagement import FINAL_PHASES, SENDING, Phase
from vfguide.companion.knowledge import OBSERVED, Knowledge, lacking, observe
from vfguide.companion.place import PlaceWatch
from vfguide.companion.plan import Plan
from vfguide.companion.requests import (
    Requests,
    request_origin,
    request_pressure,
    requested_streams,
)
from vfguide.companion.round_trip import UNANSWERED, RoundTrip
from vfguide.companion.route import Route, Step
from vfguide.companion.setpoint_annunciations import SetpointAnnunciator
from vfguide.companion.setpoints import Setpoints
from vfguide.companion.speakers import TWO_SPEAK, Speakers
from vfguide.companion.time_annunciations import TimeAnnunciator
from vfguide.geometry.units import SECOND, US
from vfguide.link.boot_time import BootClock
from vfguide.link.enums import MavAutopilot, MavState, MavType
from vfguide.link.messages import (
    AdsbVehicle,
    AttitudeQuaternion,
    CommandAck,
    CommandLong,
    CurrentMode,
    GlobalPositionInt,
    GpsGlobalOrigin,
    GpsRawInt,
    Heartbeat,
    LocalPositionNed,
    Message,
    SetAttitudeTarget,
    Timesync,
    VfrHud,
    WindCov,
)
from vfguide.loop.rows import step_measured
from vfguide.surveillance.heights import is_by_pressure

ORIGIN_RETRY = SECOND
"""Time after which the origin of the local frame is asked for again [us]; chosen."""
UNFIT_TIME = 10 * SECOND
"""Time after which a state that could not be flown on is tried again, if the operator chooses the
follow mode [us]; chosen."""
NO_ATTITUDE = "no new attitude (ATTITUDE_QUATERNION)"
"""Reason for silence where nothing is missing but the attitude that a step begins with."""
HANDLED = frozenset(
    message.MSGID
    for message in (
        *OBSERVED,
        AdsbVehicle,
        Heartbeat,
        CurrentMode,
        AttitudeQuaternion,
        CommandAck,
        Timesync,
    )
)
"""Ids of the messages that `Companion.receive` handles."""
STATUS = {
    Phase.FLYING: MavState.ACTIVE,
    Phase.RETURNING: MavState.ACTIVE,
    Phase.INTERRUPTED: MavState.CRITICAL,
}
"""State in our heartbeat by the phase, STANDBY in all others."""


class Companion:
    """The companion of one vehicle."""

    def __init__(self, sysid: int, plan: Plan, *, engage: bool, step: Step = step_measured) -> None:
        """A companion that has heard nothing yet.

        Args:
            sysid: MAVLink system of the vehicle, and of the companion.
            plan: what to do.
            engage: ask for the follow mode by itself; else wait for the operator to do it.
            step: of the control loop.
        """
        self.sysid = sysid
        self.route = Route(plan, step)
        """The flight along the plan."""
        self._control = Control(sysid, engage=engage)
        self._setpoints = Setpoints(sysid)
        self._known = Knowledge()
        self._requests = Requests()
        self._pressure_asked = False
        self._round_trip = RoundTrip()
        self._time_notes = TimeAnnunciator()
        self._setpoint_notes = SetpointAnnunciator()
        self._news: list[str] = []
        self.route.notes = self._control.notes = self._news  # in the order of what happens
        self._slow: str | None = None
        self._unfit: str | None = None
        self._unfit_until = 0
        self._place = self._new_place_watch()
        self._contact = Contact()
        self._speakers = Speakers()
        self._beat: int | None = None
        self._origin_asked = 0

    @property
    def setpoints(self) -> int:
        """Number of setpoints sent."""
        return self._setpoints.count

    @property
    def phase(self) -> Phase:
        """Whether it flies, and what it does else."""
        return self._control.phase

    def receive(self, now: int, message: Message) -> list[Message]:
        """Takes one message of the autopilot at `now` [us since 1970]; returns what to send."""
        self._wake(now)
        self._contact.act(now)
        self._watch_link(now)
        if isinstance(message, Heartbeat) and not self._control.is_vehicle(message):
            return self._housekeeping(now)
        before, self._known = self._known, observe(self._known, message, now)
        if self._known is not before:
            self._hear_news(now, before)
        out: list[Message] = []
        match message:  # the most frequent first
            case LocalPositionNed() | VfrHud() | WindCov() | GlobalPositionInt() | GpsRawInt():
                return out
            case AttitudeQuaternion():
                out += self._guide(now)
            case Heartbeat():
                self._hear_heartbeat(now, message)
            case CurrentMode() if not self._is_searching:
                self._contact.hear(now)
                if self._tells_its_own_mode(now):
                    self._control.hear_current_mode(message)
            case AdsbVehicle():
                self._hear_traffic(message)
            case CommandAck():
                self._control.answer(message)
                if complaint := self._requests.answer(message):
                    self._news.append(complaint)
            case Timesync():
                self._hear_timesync(now, message)
            case GpsGlobalOrigin():
                pass
            case _:
                return out
        return out + self._housekeeping(now)

    def poll(self, now: int) -> list[Message]:
        """What is due at `now` [us since 1970] without anything received."""
        self._wake(now)
        self._watch_link(now)
        out = self._housekeeping(now) + self._coast(now)
        if out:
            self._contact.act(now)
        return out

    def recall(self, now: int, message: Message) -> list[Message]:
        """Takes one message of its own that a log says went out at `now` [us since 1970].

        Returns the setpoint that is due then without anything received, if it is one.
        """
        self._wake(now)
        self._contact.act(now)
        if isinstance(message, Timesync):
            self._round_trip.asked(message)
        return self._coast(now) if isinstance(message, SetAttitudeTarget) else []

    def stop(self, now: int) -> list[Message]:
        """The operator ends it at `now` [us since 1970]; returns what hands over, if it flies."""
        self._control.stop()
        return self._housekeeping(now)

    def news(self) -> list[str]:
        """The new notes to the operator, each once."""
        told = self._news.copy()
        self._news.clear()
        return told

    def _hear_news(self, now: int, before: Knowledge) -> None:
        """Note that something is known that was not before."""
        self._contact.hear(now)
        if self._known.clock is not before.clock:
            self._round_trip.hear_state(now, self._known.time_ms)
            self._speakers.hear(now, before.clock, self._known.clock)
            self._hear_leap(now, before.clock, self._known.clock)
        self._news += self._time_notes.notes(before, self._known)

    def _hear_leap(self, now: int, before: BootClock | None, after: BootClock | None) -> None:
        """After a leap of the counter the origin may be another, and so may the autopilot."""
        if before is None or after is None or before.leaps == after.leaps or self._is_searching:
            return
        self._requests.ask([request_origin(self.sysid)])
        if now - before.heard > LINK_TIMEOUT:
            self._known = self._known._replace(origin=None)
            self._requests.ask(self._streams())
            self._control.begin_anew(RESTARTED)

    def _new_place_watch(self) -> PlaceWatch:
        """A watch over the place that has not looked yet."""
        return PlaceWatch(self.route.plan, self._news)

    @property
    def _is_searching(self) -> bool:
        """Whether no autopilot has been found."""
        return self.phase is Phase.SEARCHING

    def _tells_its_own_mode(self, now: int) -> bool:
        """Whether a mode is of the autopilot that was flown: after a lost link its clock tells."""
        clock = self._known.clock
        is_known = clock is not None and now - clock.heard <= SECOND
        return is_known or self.phase is not Phase.INTERRUPTED

    def _streams(self) -> list[CommandLong]:
        """The commands that make the autopilot send what guidance needs."""
        return requested_streams(self.sysid, self._control.autopilot, self.route.plan.rate)

    @property
    def _needs_origin(self) -> bool:
        """Whether the origin of the local frame is unknown, or may have been a wrong one."""
        return self._known.origin is None or self._place.is_wrong

    def _watch_link(self, now: int) -> None:
        """Record that the link to the autopilot is lost."""
        if self.phase is not Phase.SEARCHING and (why := self._contact.silence(now)):
            self._control.lose_link(why)
            self.route.pause()

    def _wake(self, now: int) -> None:
        """Record that it runs at `now` [us]; what waited while it stood still is not new."""
        gap = self._contact.wake(now)
        if not gap or self._is_searching:
            return
        self._round_trip.forget_questions()
        note, told = STOOD_STILL.format(gap=gap * US), self._control.may_send
        if gap >= self._control.autopilot.loss_time:
            self._control.stand_still(now, note)
        if told and self._control.may_send:
            self._news.append(note)

    def _hear_traffic(self, report: AdsbVehicle) -> None:
        """Take a report; the first pressure altitude makes it ask for the own pressure."""
        if is_by_pressure(report) and not self._pressure_asked:
            self._pressure_asked = True
            self._requests.ask([request_pressure(self.sysid)])
        self.route.hear_traffic(report, self._known)

    def _hear_timesync(self, now: int, message: Timesync) -> None:
        """Take an answer to a question of our own; nothing is guided over too slow a link."""
        self._round_trip.hear(now, message)
        if not self._round_trip.is_too_slow:
            self._slow = None
        elif self._slow is None:
            self._slow = TOO_SLOW.format(delay=self._round_trip.delay)
        self._weigh(now)

    def _weigh(self, now: int) -> None:
        """Record at `now` [us] whether anything keeps the companion from guiding."""
        unfit = self._unfit if now < self._unfit_until else None
        place = self._place.hindrance(follows=self._control.is_followed)
        unknown = UNANSWERED if self._round_trip.is_unanswered else None
        self._control.is_alone = not self._speakers.are_two(now)
        two = None if self._control.is_alone else TWO_SPEAK.format(sysid=self.sysid)
        self._control.hinder(now, two or self._slow or unknown or unfit or place)

    def _hear_heartbeat(self, now: int, heartbeat: Heartbeat) -> None:
        """Note that the autopilot lives, follow its mode, introduce ourselves to a new one."""
        new = self._is_searching
        if new:
            self._contact = Contact(now)
        self._contact.hear_heartbeat(now)
        if self._tells_its_own_mode(now):
            self._control.hear_heartbeat(heartbeat)
        if new and self.phase is Phase.OFFERING:
            autopilot = self._control.autopilot
            self._known = Knowledge(
                projection=int(autopilot.projection), date=self._known.date, clock=self._known.clock
            )
            self._setpoint_notes.find(now)
            self._origin_asked = now - ORIGIN_RETRY
            self._round_trip, self._slow, self._unfit = RoundTrip(), None, None
            self._place = self._new_place_watch()
            self._weigh(now)
            self._requests, self._pressure_asked = Requests(), False
            self._requests.ask(self._streams())

    def _housekeeping(self, now: int) -> list[Message]:
        """Heartbeat, requests and mode changes that are due."""
        out: list[Message] = []
        if self._beat is None or now - self._beat >= SECOND:
            self._beat = now
            out.append(self._own_heartbeat())
        if self._is_searching or self.phase in FINAL_PHASES:
            return out
        self._weigh(now)
        if self._needs_origin and now - self._origin_asked >= ORIGIN_RETRY:
            self._origin_asked = now
            self._requests.ask([request_origin(self.sysid)])
        self._tell_why_silent(now)
        out += self._round_trip.due(now)
        if request := self._requests.due(now):
            out.append(request)
        if request := self._control.request(now):
            out.append(request)
        return out

    def _guide(self, now: int) -> list[Message]:
        """The setpoint for the state at a new attitude."""
        known = self._place.checked(self._known, follows=self._control.is_followed)
        self._weigh(now)
        if not self._control.may_send:
            self.route.pause()
            return []
        if self._contact.waited(now) or not self._round_trip.is_known:
            return []
        setpoint = self.route.guide(known, self._control.follows, self._round_trip.lead)
        if setpoint is None:
            return []
        if self.route.unfit is not None:
            self._unfit, self._unfit_until = self.route.unfit, now + UNFIT_TIME
            self._weigh(now)
            return []
        if self.route.take_jump():  # the origin may have moved: autopilots report that if asked
            self._requests.ask([request_origin(self.sysid)])
        self._news += self._setpoint_notes.send(now, self._choice())
        self._news += self._setpoint_notes.lag(self._round_trip)
        return self._send(now, setpoint)

    def _coast(self, now: int) -> list[Message]:
        """One setpoint at `now` [us] where attitudes have stayed away since the last in flight.

        After it the autopilot's own failsafe acts.
        """
        setpoint = self._setpoints.coast(now, self._known.attitude, self.route.plan)
        if setpoint is None:
            return []
        is_flown = self._control.is_followed and self._control.may_send
        out = self._send(now, setpoint) if is_flown else []
        self._setpoints.end()
        return out

    def _send(self, now: int, setpoint: RateSetpoint) -> list[Message]:
        """A setpoint that goes out at `now` [us]."""
        self._control.offer(now)
        attitude = self._known.attitude
        time_boot_ms = 0 if attitude is None else attitude.time_boot_ms
        return [self._setpoints.send(now, time_boot_ms, setpoint, self._control.autopilot)]

    def _own_heartbeat(self) -> Heartbeat:
        """Who we are; CRITICAL while the link to the autopilot is lost."""
        status = STATUS.get(self.phase, MavState.STANDBY)
        return Heartbeat(MavType.ONBOARD_CONTROLLER, MavAutopilot.INVALID, 0, 0, status)

    def _choice(self) -> str:
        """What the operator reads of who chooses the follow mode."""
        return choice_note(self.phase, self._control.autopilot, self._control.engage)

    def _tell_why_silent(self, now: int) -> None:
        """Tell why no setpoints go out though they should."""
        notes, control = self._setpoint_notes, self._control
        if self.phase not in SENDING:
            notes.rest(now)
        elif control.hindrance is not None:
            self._news += notes.fail(now, control.hindrance)
        elif notes.is_silent(now):
            self._news += notes.fail(now, self._objection())
        if self.phase is Phase.FLYING:
            notes.follow()

    def _objection(self) -> str:
        """Why no setpoint has gone out for a while, though the autopilot may follow."""
        objection = lacking(self._known) or self.route.objection(self._known)
        return objection or self._round_trip.objection or NO_ATTITUDE
