"""Setpoint control: whether setpoints go out to one vehicle, which, and if none do, why not.

They go out while the phase allows it and nothing keeps the companion from guiding: neither the
delay of the link, nor the place of the vehicle, nor the state that the autopilot reports.
"""

from vfguide.aircraft.state import RateSetpoint
from vfguide.annunciations.phase_notes import STOOD_STILL, TOO_SLOW, choice_note
from vfguide.annunciations.setpoint_notes import SetpointAnnunciator
from vfguide.autopilots.engagement import SENDING, Phase
from vfguide.companion.guided_flight import GuidedFlight, Step
from vfguide.companion.mode_control import ModeControl
from vfguide.companion.place import PlaceWatch
from vfguide.companion.plan import Plan
from vfguide.companion.setpoints import Setpoints
from vfguide.geometry.units import SECOND, US
from vfguide.link.messages import Message
from vfguide.telemetry.knowledge import Knowledge, lacking
from vfguide.telemetry.round_trip import UNANSWERED, RoundTrip
from vfguide.telemetry.speakers import TWO_SPEAK, Speakers

UNFIT_TIME = 10 * SECOND
"""Time after which a state that could not be flown on is tried again, if the operator chooses the
follow mode [us]; chosen."""
NO_ATTITUDE = "no new attitude (ATTITUDE_QUATERNION)"
"""Reason for silence where nothing is missing but the attitude that a step begins with."""


class SetpointControl:
    """The setpoints that go out to one vehicle, and what keeps them back."""

    def __init__(
        self, sysid: int, plan: Plan, notes: list[str], *, engage: bool, step: Step
    ) -> None:
        """Control of nothing yet.

        Args:
            sysid: MAVLink system of the vehicle.
            plan: what to do.
            notes: takes what the operator should read, in the order of what happens.
            engage: ask for the follow mode by itself; else wait for the operator to do it.
            step: of the control loop.
        """
        self.flight = GuidedFlight(plan, step)
        """The flight along the plan."""
        self.mode = ModeControl(sysid, engage=engage)
        """Who flies."""
        self.flight.notes = self.mode.notes = self._notes = notes
        self._setpoints = Setpoints(sysid)
        self._setpoint_notes = SetpointAnnunciator()
        self._place = PlaceWatch(plan, notes)
        self._slow: str | None = None
        self._unknown: str | None = None
        self._shared: str | None = None
        self._unfit: str | None = None
        self._unfit_until = 0

    @property
    def setpoints(self) -> int:
        """Number of setpoints sent."""
        return self._setpoints.count

    @property
    def doubts_place(self) -> bool:
        """Whether the place is wrong, as after a wrong origin of the local frame."""
        return self._place.wrong is not None

    def begin(self, now: int) -> None:
        """An autopilot was found at `now` [us]: what kept the companion from guiding is over."""
        self._setpoint_notes.find(now)
        self._slow = self._unfit = None
        self._place = PlaceWatch(self.flight.plan, self._notes)
        self.weigh(now)

    def lose_link(self, why: str) -> None:
        """Record that the link to the autopilot is lost."""
        self.mode.lose_link(why)
        self.flight.pause()

    def stand_still(self, now: int, gap: int) -> None:
        """Record that this program stood still for `gap` until `now` [us]."""
        note, could_send = STOOD_STILL.format(gap=gap * US), self.mode.may_send
        self._setpoint_notes.stand_still(now)
        if gap >= self.mode.autopilot.loss_time:
            self.mode.stand_still(now, note)
            self._setpoints.end()
        if could_send and self.mode.may_send:
            self._notes.append(note)

    def watch(self, now: int, link: RoundTrip, speakers: Speakers) -> None:
        """Take what is known of the link at `now` [us]: a slow or shared one forbids guidance."""
        self.mode.is_alone = not speakers.are_two(now)
        self._shared = None
        if not self.mode.is_alone:
            self._shared = TWO_SPEAK.format(sysid=self.mode.sysid, what=speakers.what)
        self._unknown = UNANSWERED if link.is_unanswered else None
        if not link.is_too_slow:
            self._slow = None
        elif self._slow is None:
            self._slow = TOO_SLOW.format(delay=link.delay)
        self.weigh(now)

    def weigh(self, now: int) -> None:
        """Record at `now` [us] whether anything keeps the companion from guiding."""
        unfit = self._unfit if now < self._unfit_until else None
        why = self._shared or self._slow or self._unknown or unfit
        if why is None and self._place.wrong is not None:
            why = self._place.hindrance(follows=self.mode.is_followed)
        if why is not self.mode.hindrance:
            self.mode.hinder(now, why)

    def guide(self, now: int, known: Knowledge, link: RoundTrip, *, waited: bool) -> list[Message]:
        """The setpoint for a new attitude, if one goes out.

        Args:
            now: the time [us].
            known: what the autopilot has reported.
            link: delay of the link to it.
            waited: whether the attitude waited while this program stood still: it is too old.
        """
        checked = self._place.checked(known, follows=self.mode.is_followed)
        self.weigh(now)
        if not self.mode.may_send:
            self.flight.pause()
            return []
        if waited or not link.is_known:
            return []
        setpoint = self.flight.guide(checked, self.mode.follows, link.lead)
        if setpoint is None:
            return []
        if self.flight.unfit is not None:
            self._unfit, self._unfit_until = self.flight.unfit, now + UNFIT_TIME
            self.weigh(now)
            return []
        self._notes += self._setpoint_notes.send(now, self._choice)
        self._notes += self._setpoint_notes.lag(link)
        return self._send(now, known, setpoint)

    def _choice(self) -> str:
        """What the operator reads of who chooses the follow mode."""
        return choice_note(self.mode.phase, self.mode.autopilot, self.mode.engage)

    def coast(self, now: int, known: Knowledge) -> list[Message]:
        """The one setpoint that goes out at `now` [us] when attitudes have stopped.

        After it the autopilot's own failsafe acts. It goes out wherever setpoints do, since the
        autopilot may have begun to follow unheard.
        """
        setpoint = self._setpoints.coast(now, known, self.flight.plan)
        if setpoint is None:
            return []
        out = self._send(now, known, setpoint) if self.mode.may_send else []
        self._setpoints.end()
        return out

    def tell_why_silent(self, now: int, known: Knowledge, link: RoundTrip) -> None:
        """Tell at `now` [us] why no setpoints go out though they should."""
        notes, mode = self._setpoint_notes, self.mode
        if mode.phase not in SENDING:
            notes.rest(now)
        elif mode.hindrance is not None:
            self._notes += notes.fail(now, mode.hindrance)
        elif notes.is_silent(now):
            objection = lacking(known) or self.flight.objection(known) or link.objection
            self._notes += notes.fail(now, objection or NO_ATTITUDE)
        if mode.phase is Phase.FLYING:
            notes.follow()

    def _send(self, now: int, known: Knowledge, setpoint: RateSetpoint) -> list[Message]:
        """A setpoint that goes out at `now` [us]."""
        self.mode.offer(now)
        time_boot_ms = 0 if known.attitude is None else known.attitude.time_boot_ms
        return [self._setpoints.send(now, time_boot_ms, setpoint, self.mode.autopilot)]
