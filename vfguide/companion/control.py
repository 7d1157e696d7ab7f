"""Who flies: the companion's phase, the mode that it follows from, the mode that it asks for."""

from vfguide.companion.annunciations import SILENT_UNTIL_CHANGE, mode_name, phase_note
from vfguide.companion.engagement import NEXT, SENDING, Event, Phase
from vfguide.companion.requests import ModeRequest
from vfguide.link.messages import CommandAck, CommandLong
from vfguide.link.px4 import Px4Mode

OFFER = 200_000
"""Setpoints go out for this long before the mode is asked for [us]."""
WISHING = (Phase.OFFERING, Phase.ASKING, Phase.RETURNING)
"""Phases in which another mode is asked for, or soon will be."""


class Control:
    """What the companion may do with one autopilot."""

    def __init__(self, sysid: int, *, engage: bool) -> None:
        """Control of nothing yet.

        Args:
            sysid: MAVLink system of the vehicle.
            engage: ask for OFFBOARD by itself; else wait for the operator to do it.
        """
        self.phase = Phase.SEARCHING
        self.engage = engage
        self.follows = False
        """Whether the autopilot says that it follows setpoints."""
        self.notes: list[str] = []
        """What the operator should read; the caller takes it away."""
        self._sysid = sysid
        self._mode: int | None = None
        self._offered: int | None = None
        self._request = ModeRequest(sysid, Px4Mode.OFFBOARD)

    @property
    def may_send(self) -> bool:
        """Whether setpoints may go out."""
        return self.phase in SENDING

    def hear_mode(self, custom_mode: int) -> None:
        """Follow the autopilot's mode."""
        before, self._mode = self._mode, custom_mode
        self.follows = custom_mode == Px4Mode.OFFBOARD
        if before not in (None, custom_mode) and not self.follows:
            self._leave_choice(f"the mode was changed to {mode_name(custom_mode)}")
        self.happen(Event.OFFBOARD_SEEN if self.follows else Event.OTHER_MODE_SEEN)
        if self.follows and self.phase is Phase.SEARCHING and before != custom_mode:
            self.notes.append(SILENT_UNTIL_CHANGE)

    def lose_link(self) -> None:
        """The autopilot is not heard any more."""
        self.happen(Event.LINK_LOST)
        self._mode, self.follows = None, False

    def offer(self, now: int) -> None:
        """A setpoint goes out at `now` [us]."""
        if self._offered is None:
            self._offered = now

    def request(self, now: int) -> CommandLong | None:
        """The mode change to ask for at `now` [us], if any."""
        if self.phase not in WISHING:
            return None
        offered = self._offered is not None and now - self._offered >= OFFER
        if self.phase is Phase.OFFERING and self.engage and offered:
            self.happen(Event.OFFBOARD_ASKED)
        if self.phase is Phase.ASKING and self._request.in_vain(now):
            self._leave_choice("the autopilot accepted OFFBOARD and does not fly it")
        return None if self.phase is Phase.OFFERING else self._request.due(now)

    def answer(self, ack: CommandAck) -> None:
        """Note the answer to a change of mode."""
        if complaint := self._request.answer(ack):
            self.notes.append(complaint)

    def happen(self, event: Event) -> None:
        """Go on in the table; say so."""
        before, after = self.phase, NEXT[self.phase, event]
        if after is before:
            return
        self.phase = after
        self.notes.append(phase_note(before, after, self._mode, self.engage))
        self._offered = None
        wanted = {Phase.ASKING: Px4Mode.OFFBOARD, Phase.RETURNING: Px4Mode.HOLD}
        if after in wanted:
            self._request = ModeRequest(self._sysid, wanted[after])

    def _leave_choice(self, reason: str) -> None:
        """Somebody else decides on the mode: do not ask for OFFBOARD any more."""
        if self.engage and self.phase in (Phase.OFFERING, Phase.ASKING):
            self.engage = False
            self.notes.append(f"{reason}: it is not asked again")
            self.happen(Event.ASKING_GIVEN_UP)
