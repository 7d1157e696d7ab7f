"""Who flies: the companion's phase, the mode that it follows from, the mode that it asks for."""

from enum import IntEnum

from vfguide.autopilots.makes import ASSUMED, autopilot_of
from vfguide.companion.annunciations import SILENT_UNTIL_CHANGE, phase_note
from vfguide.companion.engagement import SENDING, TRANSITIONS, Event, Phase
from vfguide.companion.requests import ModeRequest
from vfguide.link.messages import CommandAck, CommandLong, Heartbeat

ASKING_PHASES = (Phase.OFFERING, Phase.ASKING, Phase.RETURNING)
"""Phases in which another mode is asked for, or soon will be."""


class Control:
    """What the companion may do with one autopilot."""

    def __init__(self, sysid: int, *, engage: bool) -> None:
        """Control of nothing yet.

        Args:
            sysid: MAVLink system of the vehicle.
            engage: ask for the follow mode by itself; else wait for the operator to do it.
        """
        self.autopilot = ASSUMED
        """Whose modes they are."""
        self.phase = Phase.SEARCHING
        self.engage = engage
        self.follows = False
        """Whether the autopilot says that it follows setpoints."""
        self.notes: list[str] = []
        """What the operator should read; the caller takes it away."""
        self._sysid = sysid
        self._mode: int | None = None
        self._offered: int | None = None
        self._request = self._ask_for(self.autopilot.follow_mode)

    @property
    def may_send(self) -> bool:
        """Whether setpoints may go out."""
        return self.phase in SENDING

    def hear_heartbeat(self, heartbeat: Heartbeat) -> None:
        """Follow the mode of an autopilot; while one is searched for its make counts, too."""
        if self.phase is Phase.SEARCHING:
            self.autopilot = autopilot_of(heartbeat.autopilot)
        self.hear_mode(heartbeat.custom_mode)

    def hear_mode(self, custom_mode: int) -> None:
        """Follow the autopilot's mode, `custom_mode` in its own encoding."""
        before, self._mode = self._mode, custom_mode
        self.follows = custom_mode == self.autopilot.follow_mode
        if before not in (None, custom_mode) and not self.follows:
            name = self.autopilot.mode_name(custom_mode)
            self._leave_choice(f"the mode was changed to {name}")
        self.happen(Event.FOLLOWING_SEEN if self.follows else Event.OTHER_MODE_SEEN)
        if self.follows and self.phase is Phase.SEARCHING and before != custom_mode:
            self.notes.append(SILENT_UNTIL_CHANGE)

    def lose_link(self) -> None:
        """Record that the link to the autopilot is lost."""
        self.happen(Event.LINK_LOST)
        self._mode, self.follows = None, False

    def offer(self, now: int) -> None:
        """A setpoint goes out at `now` [us]."""
        if self._offered is None:
            self._offered = now

    def request(self, now: int) -> CommandLong | None:
        """The mode change to ask for at `now` [us], if any."""
        if self.phase not in ASKING_PHASES:
            return None
        offered = self._offered is not None and now - self._offered >= self.autopilot.offer
        if self.phase is Phase.OFFERING and self.engage and offered:
            self.happen(Event.FOLLOWING_ASKED)
        if self.phase is Phase.ASKING and self._request.in_vain(now):
            name = self.autopilot.follow_mode.name
            self._leave_choice(f"the autopilot accepted {name} and does not fly it")
        return None if self.phase is Phase.OFFERING else self._request.due(now)

    def answer(self, ack: CommandAck) -> None:
        """Note the answer to a change of mode."""
        if complaint := self._request.answer(ack):
            self.notes.append(complaint)

    def happen(self, event: Event) -> None:
        """Go on in the table; say so."""
        before, after = self.phase, TRANSITIONS[self.phase, event]
        if after is before:
            return
        self.phase = after
        self.notes.append(phase_note(before, after, self.autopilot, self._mode, self.engage))
        self._offered = None
        if after is Phase.ASKING:
            self._request = self._ask_for(self.autopilot.follow_mode)
        elif after is Phase.RETURNING:
            self._request = self._ask_for(self.autopilot.hold_mode)

    def _ask_for(self, mode: IntEnum) -> ModeRequest:
        return ModeRequest(self._sysid, self.autopilot, mode)

    def _leave_choice(self, reason: str) -> None:
        """Somebody else decides on the mode: do not ask for the follow mode any more."""
        if self.engage and self.phase in (Phase.OFFERING, Phase.ASKING):
            self.engage = False
            self.notes.append(f"{reason}: it is not asked again")
            self.happen(Event.ASKING_GIVEN_UP)
