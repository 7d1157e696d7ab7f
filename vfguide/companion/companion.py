"""The companion: messages of one autopilot in, messages to it out.

No socket, clock or thread: every call carries the time. What it sends as setpoints follows
from what it received alone, so that a recording gives the same setpoints again.
"""

from vfguide.companion.engagement import NEXT, SENDING, Event, Phase
from vfguide.companion.knowledge import STALE, Knowledge, elapsed, flight_state, lacking, observe
from vfguide.companion.notes import (
    SILENT_UNTIL_CHANGE,
    mode_name,
    pass_note,
    phase_note,
    route_note,
)
from vfguide.companion.plan import Plan
from vfguide.companion.requests import ModeRequest, Requests, request_origin, requested_streams
from vfguide.companion.step import RouteMemory, fresh_route, step
from vfguide.flight.guidance import Wish
from vfguide.flight.state import RateSetpoint
from vfguide.link.enums import AttitudeTypeMask, MavAutopilot, MavState, MavType
from vfguide.link.messages import (
    AttitudeQuaternion,
    CommandAck,
    CurrentMode,
    Heartbeat,
    Message,
    SetAttitudeTarget,
)
from vfguide.link.px4 import Px4Mode

SECOND = 1_000_000
"""[us]."""
LOST = 3 * SECOND
"""Without a heartbeat for this long the link is lost."""
OFFER = SECOND // 5
"""Setpoints go out for this long before the mode is asked for."""
ORIGIN_RETRY = SECOND
"""The origin of the local frame is asked for again after this."""
OUGHT_TO_SEND = SECOND
"""Without a setpoint for this long the operator is told why."""


class Companion:
    """The companion of one vehicle."""

    def __init__(self, sysid: int, plan: Plan, *, engage: bool) -> None:
        """A companion that has heard nothing yet.

        Args:
            sysid: MAVLink system of the vehicle, and of the companion.
            plan: what to do.
            engage: ask for OFFBOARD by itself; else wait for the operator to do it.
        """
        self.sysid = sysid
        self.plan = plan
        self.engage = engage
        self.phase = Phase.SEARCHING
        self.known = Knowledge()
        self.route: RouteMemory = fresh_route()
        self.wish: Wish | None = None
        self.setpoints = 0
        """Number of setpoints sent."""
        self.notes: list[str] = []
        """What the operator should read; the caller takes it away."""
        self._requests = Requests()
        self._mode_request = ModeRequest(sysid, Px4Mode.OFFBOARD)
        self._mode: int | None = None
        self._followed = False
        self._heard = 0
        self._beat: int | None = None
        self._offered: int | None = None
        self._origin_asked = 0
        self._stepped: int | None = None
        self._sent_at = 0
        self._complaint: str | None = None

    def receive(self, now: int, message: Message) -> list[Message]:
        """Takes one message of the autopilot at the time `now` [us]; returns what to send."""
        self._watch_link(now)
        self.known = observe(self.known, message)
        out: list[Message] = []
        match message:
            case Heartbeat():
                self._heartbeat(now, message)
            case CurrentMode() if self.phase is not Phase.SEARCHING:
                self._see_mode(now, message.custom_mode)
            case AttitudeQuaternion():
                out += self._guide(now, message)
            case CommandAck():
                self._note(self._requests.answer(message))
                self._note(self._mode_request.answer(message))
            case _:
                pass
        return out + self._housekeeping(now)

    def poll(self, now: int) -> list[Message]:
        """What is due at the time `now` [us] without anything received."""
        self._watch_link(now)
        return self._housekeeping(now)

    def stop(self, now: int) -> list[Message]:
        """The operator ends the companion at `now` [us]: it hands over first if it flies."""
        self._happen(now, Event.STOP_ASKED)
        return self._housekeeping(now)

    def _watch_link(self, now: int) -> None:
        """Note that the autopilot is not heard any more."""
        if self.phase is not Phase.SEARCHING and now - self._heard > LOST:
            self._happen(now, Event.LINK_LOST)

    def _housekeeping(self, now: int) -> list[Message]:
        """Heartbeat, requests and mode changes that are due."""
        out: list[Message] = []
        if self._beat is None or now - self._beat >= SECOND:
            self._beat = now
            out.append(self._own_heartbeat())
        if self.phase is Phase.SEARCHING or self.phase is Phase.ENDED:
            return out
        if self.known.origin is None and now - self._origin_asked >= ORIGIN_RETRY:
            self._origin_asked = now
            self._requests.ask([request_origin(self.sysid)])
        if request := self._requests.due(now):
            out.append(request)
        self._complain(now)
        return out + self._mode_wanted(now)

    def _mode_wanted(self, now: int) -> list[Message]:
        """The mode change to ask for now, if any."""
        offered = self._offered is not None and now - self._offered >= OFFER
        if self.phase is Phase.OFFERING and self.engage and offered:
            self._happen(now, Event.OFFBOARD_ASKED)
        if self.phase is Phase.ASKING and self._mode_request.in_vain(now):
            self._leave_choice(now, "the autopilot accepted OFFBOARD and does not fly it")
        if self.phase not in (Phase.ASKING, Phase.RETURNING):
            return []
        request = self._mode_request.due(now)
        return [request] if request else []

    def _heartbeat(self, now: int, heartbeat: Heartbeat) -> None:
        """Note that the autopilot lives, follow its mode, introduce ourselves to a new one."""
        new = self.phase is Phase.SEARCHING
        self._heard = now
        self._see_mode(now, heartbeat.custom_mode)
        if new and self.phase is Phase.OFFERING:
            self.known = Knowledge()
            self._origin_asked = now - ORIGIN_RETRY
            self._requests = Requests()
            self._requests.ask(requested_streams(self.sysid, self.plan.rate))

    def _see_mode(self, now: int, custom_mode: int) -> None:
        """Follow the autopilot's mode."""
        before, self._mode = self._mode, custom_mode
        follows = custom_mode == Px4Mode.OFFBOARD
        if follows and not self._followed:
            self.route = self.route._replace(before=None, flight=fresh_route().flight)
        self._followed = follows
        changed = before is not None and before != custom_mode
        if changed and not follows and self.phase in (Phase.OFFERING, Phase.ASKING):
            self._leave_choice(now, f"the mode was changed to {mode_name(custom_mode)}")
        self._happen(now, Event.OFFBOARD_SEEN if follows else Event.OTHER_MODE_SEEN)
        if follows and self.phase is Phase.SEARCHING and before != custom_mode:
            self._note(SILENT_UNTIL_CHANGE)

    def _leave_choice(self, now: int, reason: str) -> None:
        """Somebody else decides on the mode: do not ask for OFFBOARD any more."""
        if self.engage:
            self.engage = False
            self._note(f"{reason}: it is not asked again")
        self._happen(now, Event.ASKING_GIVEN_UP)

    def _happen(self, now: int, event: Event) -> None:
        """Go on in the table; say so."""
        before, after = self.phase, NEXT[self.phase, event]
        if after is before:
            return
        self.phase = after
        mode = mode_name(self._mode or 0)
        route = route_note(self.route.goal, self.plan)
        self._note(phase_note(before, after, mode, self.engage, route))
        self._offered = None
        self._sent_at = now
        if after is Phase.ASKING or after is Phase.RETURNING:
            wanted = Px4Mode.OFFBOARD if after is Phase.ASKING else Px4Mode.HOLD
            self._mode_request = ModeRequest(self.sysid, wanted)
        if event is Event.LINK_LOST:
            self._mode, self._followed = None, False

    def _guide(self, now: int, attitude: AttitudeQuaternion) -> list[Message]:
        """The setpoint for the state at a new attitude."""
        if self.phase not in SENDING or not self._due(attitude.time_boot_ms):
            return []
        state = flight_state(self.known, self.plan.frame)
        if state is None:
            return []
        setpoint, route, self.wish = step(state, self.plan, self.route)
        if self._followed:
            self._note(pass_note(self.route, route, state, self.plan))
            self.route = route
        self.setpoints += 1
        self._sent_at = now
        self._offered = now if self._offered is None else self._offered
        return [self._setpoint(attitude.time_boot_ms, setpoint)]

    def _due(self, time_boot_ms: int) -> bool:
        """Whether the next guidance step is due at the autopilot's time."""
        before = self._stepped
        if before is not None:
            since = elapsed(before, time_boot_ms)
            if -STALE < since < 0.9 / self.plan.rate:  # farther back: it has started anew
                return False
        self._stepped = time_boot_ms
        return True

    def _setpoint(self, time_boot_ms: int, setpoint: RateSetpoint) -> SetAttitudeTarget:
        """SET_ATTITUDE_TARGET with body rates and thrust."""
        p, q, r = setpoint.omega_b
        return SetAttitudeTarget(
            time_boot_ms,
            self.sysid,
            1,
            AttitudeTypeMask.ATTITUDE_IGNORE,
            setpoint.q_nb,
            p,
            q,
            r,
            setpoint.thrust,
        )

    def _own_heartbeat(self) -> Heartbeat:
        """Who we are; CRITICAL while the link to the autopilot is lost."""
        status = {
            Phase.FLYING: MavState.ACTIVE,
            Phase.RETURNING: MavState.ACTIVE,
            Phase.INTERRUPTED: MavState.CRITICAL,
        }.get(self.phase, MavState.STANDBY)
        return Heartbeat(MavType.ONBOARD_CONTROLLER, MavAutopilot.INVALID, 0, 0, status)

    def _complain(self, now: int) -> None:
        """Tell why no setpoints go out, once for each reason, and when they do again."""
        silent = self.phase in SENDING and now - self._sent_at > OUGHT_TO_SEND
        why = lacking(self.known) or "no new attitude" if silent else None
        if why == self._complaint:
            return
        self._complaint = why
        if self.phase in SENDING:
            self._note(f"no setpoints: {why}" if why else "setpoints go out again")

    def _note(self, text: str | None) -> None:
        """Tell the operator."""
        if text:
            self.notes.append(text)
