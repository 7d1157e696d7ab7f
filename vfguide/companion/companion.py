"""The companion: messages of one autopilot in, messages to it out.

A new attitude takes one way to a setpoint: `Companion.receive`, which knows then what the autopilot
tells, `SetpointControl.guide`, which keeps setpoints back where one must not go out,
`GuidedFlight.guide`, which makes the step of the control loop, and back.

No socket, clock or thread: every call carries the time. What it sends as setpoints follows
from what it received, and from when it sent something, so that a recording gives the same again.
"""

from vfguide.annunciations.clock_notes import TimeAnnunciator
from vfguide.annunciations.phase_notes import RESTARTED
from vfguide.autopilots.engagement import FINAL_PHASES, Phase
from vfguide.companion.data_requests import DataRequests
from vfguide.companion.guided_flight import GuidedFlight, Step
from vfguide.companion.own_heartbeat import OwnHeartbeat
from vfguide.companion.plan import Plan
from vfguide.companion.setpoint_control import SetpointControl
from vfguide.geometry.units import SECOND
from vfguide.link.boot_time import BootClock
from vfguide.link.messages import (
    AdsbVehicle,
    AttitudeQuaternion,
    CommandAck,
    CurrentMode,
    GlobalPositionInt,
    GpsGlobalOrigin,
    GpsRawInt,
    Heartbeat,
    LocalPositionNed,
    Message,
    SetAttitudeTarget,
    SystemTime,
    Timesync,
    VfrHud,
    WindCov,
)
from vfguide.loop.rows import step_measured
from vfguide.surveillance.heights import is_by_pressure
from vfguide.telemetry.contact import LINK_TIMEOUT, Contact
from vfguide.telemetry.knowledge import OBSERVED, Knowledge, observe
from vfguide.telemetry.round_trip import RoundTrip
from vfguide.telemetry.speakers import Speakers

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
TIMED = (AttitudeQuaternion, SystemTime)
"""The kinds of messages that change the autopilot's clock or date."""


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
        self._news: list[str] = []
        self._control = SetpointControl(sysid, plan, self._news, engage=engage, step=step)
        self._known = Knowledge()
        self._requests = DataRequests(sysid)
        self._round_trip = RoundTrip()
        self._time_notes = TimeAnnunciator()
        self._contact = Contact()
        self._speakers = Speakers()
        self._heartbeat = OwnHeartbeat()

    @property
    def flight(self) -> GuidedFlight:
        """The flight along the plan."""
        return self._control.flight

    @property
    def setpoints(self) -> int:
        """Number of setpoints sent."""
        return self._control.setpoints

    @property
    def phase(self) -> Phase:
        """The phase of the engagement: whether the companion searches, waits, asks or flies."""
        return self._control.mode.phase

    def receive(self, now: int, message: Message) -> list[Message]:
        """Takes one message of the autopilot at `now` [us since 1970]; returns what to send."""
        if not self._contact.goes_on(now):
            self._wake(now)
            self._contact.act(now)
            self._watch_link(now)
        self._observe(now, message)
        out: list[Message] = []
        match message:  # the most frequent first
            case AttitudeQuaternion():
                return self._guide(now) + self._housekeeping(now, guided=True)
            case LocalPositionNed() | VfrHud() | WindCov() | GlobalPositionInt() | GpsRawInt():
                return out
            case Heartbeat():
                if self._control.mode.is_vehicle(message):
                    self._hear_heartbeat(now, message)
            case CurrentMode() if not self._is_searching:
                self._hear_current_mode(now, message)
            case AdsbVehicle():
                self._hear_traffic(message)
            case CommandAck():
                self._hear_answer(message)
            case Timesync():
                self._hear_timesync(now, message)
            case GpsGlobalOrigin():
                pass
            case _:
                return out
        return out + self._housekeeping(now)

    def _observe(self, now: int, message: Message) -> None:
        """Keep what a message reports; tell the operator of a clock or a date that goes wrong."""
        before = self._known
        self._known = after = observe(before, message, now)
        if after is before:
            return
        self._contact.hear(now)
        if isinstance(message, GlobalPositionInt):
            self._speakers.hear_place(now, before.place, message)
        if (clock := after.clock) is not None and clock is not before.clock:
            self._hear_clock(now, before.clock, clock)
        if isinstance(message, TIMED):
            self._news += self._time_notes.notes(before, after)

    def _guide(self, now: int) -> list[Message]:
        """The setpoint for the state at a new attitude, if one goes out."""
        self._control.watch(now, self._round_trip, self._speakers)
        waited = self._contact.waited(now)
        out = self._control.guide(now, self._known, self._round_trip, waited=waited)
        if out and self.flight.take_jump():  # the origin may have moved: it is told if asked for
            self._requests.ask_origin()
        return out

    def _housekeeping(self, now: int, *, guided: bool = False) -> list[Message]:
        """Heartbeat, requests and mode changes that are due; `guided`: after guidance at `now`."""
        phase, out = self.phase, list[Message]()
        if now >= self._heartbeat.due_at:
            out.append(self._heartbeat.send(now, phase))
        if phase is Phase.SEARCHING or phase in FINAL_PHASES:
            return out
        if not guided:
            self._control.watch(now, self._round_trip, self._speakers)
        if self._needs_origin:
            self._requests.ask_origin_again(now)
        self._control.tell_why_silent(now, self._known, self._round_trip)
        out += self._round_trip.due(now)
        if request := self._requests.due(now):
            out.append(request)
        if request := self._control.mode.request(now):
            out.append(request)
        return out

    def poll(self, now: int) -> list[Message]:
        """The messages that are due at `now` [us since 1970], though nothing was received."""
        self._wake(now)
        self._watch_link(now)
        out = self._housekeeping(now) + self._control.coast(now, self._known)
        if out:
            self._contact.act(now)
        return out

    def recall(self, now: int, message: Message) -> list[Message]:
        """Takes a message that this companion sent at `now` [us since 1970], as a log has it.

        Where it is a setpoint, returns the one that is due then though nothing was received.
        """
        self._wake(now)
        self._contact.act(now)
        if isinstance(message, Timesync):
            self._round_trip.asked(message)
        is_setpoint = isinstance(message, SetAttitudeTarget)
        return self._control.coast(now, self._known) if is_setpoint else []

    def stop(self, now: int) -> list[Message]:
        """The operator ends it at `now` [us since 1970]; returns the messages that hand over."""
        self._control.mode.stop()
        return self._housekeeping(now)

    def news(self) -> list[str]:
        """The new notes to the operator, each once."""
        notes = self._news.copy()
        self._news.clear()
        return notes

    @property
    def _needs_origin(self) -> bool:
        """Whether the origin of the local frame is unknown, or may have been a wrong one."""
        return self._known.origin is None or self._control.doubts_place

    @property
    def _is_searching(self) -> bool:
        """Whether no autopilot has been found."""
        return self.phase is Phase.SEARCHING

    def _hear_leap(self, now: int, before: BootClock, after: BootClock) -> None:
        """After a leap of the counter the origin may be another, and so may the autopilot."""
        self._speakers.hear(now, before, after)
        if self._is_searching:
            return
        self._requests.ask_origin()
        if now - before.heard > LINK_TIMEOUT:
            self._known = self._known._replace(origin=None)
            self._requests.ask_streams(self._control.mode.autopilot, self.flight.plan.rate)
            self._control.mode.begin_anew(RESTARTED)

    def _hear_current_mode(self, now: int, said: CurrentMode) -> None:
        """Follow the mode that the autopilot reports besides its heartbeats."""
        self._contact.hear(now)
        if self._tells_its_own_mode(now):
            is_new = not self._contact.may_have_waited(now)
            self._control.mode.hear_current_mode(said, is_new=is_new)

    def _tells_its_own_mode(self, now: int) -> bool:
        """Whether a mode is that of the autopilot flown so far; after a lost link its clock shows.

        Another autopilot may speak by then.
        """
        clock = self._known.clock
        is_known = clock is not None and now - clock.heard <= SECOND
        return is_known or self.phase is not Phase.INTERRUPTED

    def _hear_answer(self, ack: CommandAck) -> None:
        """Take the answer to a command."""
        self._control.mode.answer(ack)
        if complaint := self._requests.answer(ack):
            self._news.append(complaint)

    def _watch_link(self, now: int) -> None:
        """Record that the link to the autopilot is lost."""
        if self.phase is not Phase.SEARCHING and (why := self._contact.silence(now)):
            self._control.lose_link(why)

    def _wake(self, now: int) -> None:
        """Record that this program runs at `now` [us]; what waited while it stood still is old."""
        gap = self._contact.wake(now)
        if gap and self.phase is not Phase.SEARCHING:
            self._round_trip.forget_questions()
            self._control.stand_still(now, gap)

    def _hear_clock(self, now: int, before: BootClock | None, after: BootClock) -> None:
        """Take a new time of the autopilot: it shows the age of its states, and a leap."""
        self._round_trip.hear_state(now, after.time_ms)
        if before is not None and before.leaps != after.leaps:
            self._hear_leap(now, before, after)

    def _hear_traffic(self, report: AdsbVehicle) -> None:
        """Take a report; the first pressure altitude makes it ask for the own pressure."""
        if is_by_pressure(report):
            self._requests.ask_pressure()
        self.flight.hear_traffic(report, self._known)

    def _hear_timesync(self, now: int, message: Timesync) -> None:
        """Take an answer to a question of our own; it shows the delay of the link."""
        self._round_trip.hear(now, message)
        self._control.watch(now, self._round_trip, self._speakers)

    def _hear_heartbeat(self, now: int, heartbeat: Heartbeat) -> None:
        """Note that the autopilot lives, follow its mode, introduce ourselves to a new one."""
        new = self.phase is Phase.SEARCHING
        if new:
            self._contact = Contact(now)
        self._contact.hear_heartbeat(now)
        if self._tells_its_own_mode(now):
            is_new = not self._contact.may_have_waited(now)
            self._control.mode.hear_heartbeat(heartbeat, is_new=is_new)
        if new and self.phase is Phase.OFFERING:
            autopilot = self._control.mode.autopilot
            self._known = Knowledge(
                projection=int(autopilot.projection), date=self._known.date, clock=self._known.clock
            )
            self._round_trip = RoundTrip()
            self._control.begin(now)
            self._requests.begin(now, autopilot, self.flight.plan.rate)
