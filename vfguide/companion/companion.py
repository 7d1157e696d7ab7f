"""The companion: messages of one autopilot in, messages to it out.

No socket, clock or thread: every call carries the time. What it sends as setpoints follows
from what it received alone, so that a recording gives the same setpoints again.
"""

from vfguide.companion.engagement import NEXT, SENDING, Event, Phase
from vfguide.companion.knowledge import Knowledge, elapsed, flight_state, observe
from vfguide.companion.plan import Plan
from vfguide.companion.requests import Requests, request_origin, requested_streams, set_mode
from vfguide.companion.step import RouteMemory, fresh_route, step
from vfguide.flight.guidance import Wish
from vfguide.flight.state import RateSetpoint
from vfguide.link.enums import AttitudeTypeMask, MavAutopilot, MavState, MavType
from vfguide.link.messages import (
    AttitudeQuaternion,
    CommandAck,
    CommandLong,
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
INSIST = SECOND
"""A mode that was asked for and is not flown is asked for again after this."""
ORIGIN_RETRY = SECOND
"""The origin of the local frame is asked for again after this."""


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
        self._heard = 0
        self._beat: int | None = None
        self._offered: int | None = None
        self._asked = -INSIST
        self._origin_asked = 0
        self._stepped: int | None = None

    def receive(self, now: int, message: Message) -> list[Message]:
        """Takes one message of the autopilot at the time `now` [us]; returns what to send."""
        self._watch_link(now)
        self.known = observe(self.known, message)
        out: list[Message] = []
        match message:
            case Heartbeat():
                self._heartbeat(now, message)
            case CurrentMode() if self.phase is not Phase.SEARCHING:
                self._see_mode(message.custom_mode)
            case AttitudeQuaternion():
                out += self._guide(now, message)
            case CommandAck():
                if complaint := self._requests.answer(message):
                    self.notes.append(complaint)
            case _:
                pass
        return out + self._housekeeping(now)

    def poll(self, now: int) -> list[Message]:
        """What is due at the time `now` [us] without anything received."""
        self._watch_link(now)
        return self._housekeeping(now)

    def stop(self) -> None:
        """The operator ends the companion: it hands over first if it flies."""
        self._happen(Event.STOP_ASKED)
        self._asked = -INSIST

    def _watch_link(self, now: int) -> None:
        """Note that the autopilot is not heard any more."""
        if self.phase is not Phase.SEARCHING and now - self._heard > LOST:
            self._happen(Event.LINK_LOST)

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
        if mode := self._mode_wanted(now):
            self._asked = now
            out.append(mode)
        return out

    def _mode_wanted(self, now: int) -> CommandLong | None:
        """The mode change to ask for now, if any."""
        if now - self._asked < INSIST:
            return None
        if self.phase is Phase.RETURNING:
            return set_mode(self.sysid, Px4Mode.HOLD)
        offered = self._offered is not None and now - self._offered >= OFFER
        if self.phase is Phase.OFFERING and self.engage and offered:
            return set_mode(self.sysid, Px4Mode.OFFBOARD)
        return None

    def _heartbeat(self, now: int, heartbeat: Heartbeat) -> None:
        """Note that the autopilot lives, follow its mode, introduce ourselves to a new one."""
        new = self.phase is Phase.SEARCHING
        self._heard = now
        self._see_mode(heartbeat.custom_mode)
        if new and self.phase is Phase.OFFERING:
            self.known = Knowledge()
            self._origin_asked = now - ORIGIN_RETRY
            self._requests = Requests()
            self._requests.ask(requested_streams(self.sysid, self.plan.rate))

    def _see_mode(self, custom_mode: int) -> None:
        """Follow the autopilot's mode."""
        follows = custom_mode == Px4Mode.OFFBOARD
        self._happen(Event.OFFBOARD_SEEN if follows else Event.OTHER_MODE_SEEN)

    def _happen(self, event: Event) -> None:
        """Go on in the table; say so."""
        after = NEXT[self.phase, event]
        if after is self.phase:
            return
        self.notes.append(f"{self.phase.name.lower()} -> {after.name.lower()}")
        self.phase = after
        self._offered = None
        if after is Phase.FLYING:
            self.route = self.route._replace(before=None, flight=fresh_route().flight)

    def _guide(self, now: int, attitude: AttitudeQuaternion) -> list[Message]:
        """The setpoint for the state at a new attitude."""
        if self.phase not in SENDING or not self._due(attitude.time_boot_ms):
            return []
        state = flight_state(self.known, self.plan.frame)
        if state is None:
            return []
        setpoint, route, self.wish = step(state, self.plan, self.route)
        if self.phase is Phase.OFFERING:
            route = self.route
        self.route = route
        self.setpoints += 1
        self._offered = now if self._offered is None else self._offered
        return [self._setpoint(attitude.time_boot_ms, setpoint)]

    def _due(self, time_boot_ms: int) -> bool:
        """Whether the next guidance step is due at the autopilot's time."""
        before = self._stepped
        if before is not None and elapsed(before, time_boot_ms) < 0.9 / self.plan.rate:
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
