"""Who flies: the companion's phase, the mode that it follows from, the mode that it asks for."""

from enum import IntEnum

from vfguide.annunciations.phase_notes import (
    FALLEN_BACK,
    FOREIGN_HEARTBEAT,
    NOT_ARMED,
    SILENT_UNTIL_CHANGE,
    STRANGER,
    phase_notes,
)
from vfguide.autopilots.engagement import SENDING, TRANSITIONS, Event, Phase
from vfguide.autopilots.makes import ASSUMED, autopilot_of, describe, flown
from vfguide.companion.requests import ModeRequest
from vfguide.geometry.units import SECOND
from vfguide.link.enums import MavAutopilot, MavState
from vfguide.link.messages import CommandAck, CommandLong, CurrentMode, Heartbeat

ASKING_PHASES = (Phase.OFFERING, Phase.ASKING, Phase.YIELDING, Phase.RETURNING)
"""Phases in which another mode is asked for, or soon will be."""
HEARTBEAT_INTERVAL = SECOND
"""Time after which every mode has shown in a heartbeat [us] (MAVLink's heartbeat protocol)."""
OFFER_GAP = 500_000
"""Longest time between two setpoints of one offer [us]; chosen as half of the shortest time after
which an autopilot misses them."""
DISARMED = (MavState.UNINIT, MavState.BOOT, MavState.CALIBRATING, MavState.STANDBY)
"""States of an autopilot that is not armed, as after a restart: nobody chose the mode that it flies
then."""
NEVER = 2**63
"""A time that does not come [us], beyond all dates; a choice."""
MAX_TOLD = 5
"""Largest number of strangers of whom the operator is told; chosen."""


class ModeControl:
    """What the companion may do with one autopilot."""

    def __init__(self, sysid: int, *, engage: bool) -> None:
        """Control of nothing yet.

        Args:
            sysid: MAVLink system of the vehicle.
            engage: ask for the follow mode by itself; else wait for the operator to do it.
        """
        self.autopilot = ASSUMED
        """The autopilot whose modes are meant; before one is found, the one to expect."""
        self.phase = Phase.SEARCHING
        self.engage = engage
        self.follows = False
        """Whether the autopilot says that it follows setpoints."""
        self.hindrance: str | None = None
        """Why the companion cannot guide; None: it can."""
        self.is_alone = True
        """Whether no other autopilot speaks with the same address: else a mode may be another's,
        and another would be asked for one."""
        self.notes: list[str] = []
        """What the operator should read; the caller takes it away."""
        self.sysid = sysid
        """MAVLink system of the vehicle."""
        self._mode: int | None = None
        self._falls_back = False
        self._is_new = True
        self._is_armed = False
        self._hold_from = 0
        self._strangers: set[str] = set()
        self._offered: int | None = None
        self._offered_last = 0
        self._request = self._ask_for(self.autopilot.follow_mode)

    @property
    def may_send(self) -> bool:
        """Whether setpoints may go out."""
        return self.phase in SENDING and self.hindrance is None

    @property
    def is_followed(self) -> bool:
        """Whether the autopilot follows setpoints, and they are ours."""
        return self.follows and self.phase in SENDING

    def is_vehicle(self, said: Heartbeat) -> bool:
        """Whether a heartbeat is that of the vehicle's autopilot; the operator is told of others.

        The first autopilot that can be flown with is taken to be the vehicle's.
        """
        found = autopilot_of(said)
        if found is None or (self.phase is not Phase.SEARCHING and found is not self.autopilot):
            self._tell_of(said)
            return False
        self.autopilot = found
        return True

    def hear_heartbeat(self, said: Heartbeat, *, is_new: bool) -> None:
        """Follow the mode in a heartbeat of the vehicle's autopilot.

        `is_new` is false where it may have waited while this program stood still: then nothing is
        asked for because of it.
        """
        self._is_new = is_new
        was_armed, self._is_armed = self._is_armed, said.system_status not in DISARMED
        if was_armed and not self._is_armed and self.phase in (Phase.FLYING, Phase.INTERRUPTED):
            self.begin_anew(NOT_ARMED)
        self._hear_mode(said.custom_mode, said.system_status == MavState.CRITICAL)

    def hear_current_mode(self, said: CurrentMode, *, is_new: bool) -> None:
        """Follow the mode in a CURRENT_MODE, which `is_new` or may have waited.

        Where it intends the follow mode and flies another, the failsafe acts. It does not say which
        autopilot flies, so that none is found by it.
        """
        self._is_new = is_new
        intended = said.intended_custom_mode == self.autopilot.follow_mode
        self._hear_mode(
            said.custom_mode, intended and said.custom_mode != self.autopilot.follow_mode
        )

    def _hear_mode(self, custom_mode: int, falls_back: bool) -> None:
        """Follow the mode, and whether the autopilot's failsafe has chosen it."""
        if not self.is_alone and self.phase is not Phase.SEARCHING:
            self._mode, self.follows = None, False
            return
        before, self._mode, self._falls_back = self._mode, custom_mode, falls_back
        self.follows = custom_mode == self.autopilot.follow_mode
        if before not in (None, custom_mode) and not self.follows:
            name = self.autopilot.mode_name(custom_mode)
            self._leave_choice(f"the mode was changed to {name}")
        self.happen(
            self._mode_event(), FALLEN_BACK.format(mode=self.autopilot.mode_name(custom_mode))
        )
        if self.follows and self.phase is Phase.SEARCHING and before != custom_mode:
            self.notes.append(SILENT_UNTIL_CHANGE)

    def _mode_event(self) -> Event:
        """The event of the mode that was heard last."""
        if self.follows:
            return Event.FOLLOWING_SEEN
        return Event.FALLBACK_SEEN if self._falls_back else Event.OTHER_MODE_SEEN

    def lose_link(self, why: str) -> None:
        """Record that the link to the autopilot is lost."""
        self.happen(Event.LINK_LOST, why)
        self._mode, self.follows = None, False

    def hinder(self, now: int, hindrance: str | None) -> None:
        """Record at `now` [us] why the companion cannot guide, so that it asks for hold at once.

        None: it can.
        """
        before, self.hindrance = self.hindrance, hindrance
        if (before is None) == (hindrance is None):
            return
        if hindrance is not None:
            self._yield(now, hindrance)

    def stand_still(self, now: int, why: str) -> None:
        """Record that until `now` [us] it did not guide for longer than the autopilot waits.

        The autopilot's failsafe has acted by then, or somebody has chosen a mode, which its
        heartbeats show. Hold is asked for only if they do not.
        """
        self._is_new = False
        self._yield(now + self.autopilot.loss_time + HEARTBEAT_INTERVAL, why)

    def begin_anew(self, why: str) -> None:
        """Record that the autopilot may be another one: it is not guided, nor asked for a mode."""
        self._yield(NEVER, why)

    def _yield(self, hold_from: int, why: str) -> None:
        self._hold_from = hold_from
        self.happen(Event.UNABLE, why)

    def stop(self) -> None:
        """The operator ends it; where the autopilot flies another mode, nothing is handed over."""
        if self.phase is Phase.YIELDING and self._mode is not None and not self.follows:
            self.happen(Event.STOP_ASKED_OF_OTHER_MODE)
        else:
            self.happen(Event.STOP_ASKED)

    def offer(self, now: int) -> None:
        """Record that a setpoint goes out at `now` [us]."""
        if self._offered is None or now - self._offered_last > OFFER_GAP:
            self._offered = now
        self._offered_last = now

    def request(self, now: int) -> CommandLong | None:
        """The mode change to ask for at `now` [us], if any."""
        if self.phase is Phase.YIELDING:
            return self._request_hold(now) if self.is_alone else None
        if self.phase not in ASKING_PHASES:
            return None
        if self.phase is Phase.OFFERING and self.engage and self._has_offered(now):
            self.happen(Event.FOLLOWING_ASKED)
        if self.phase is Phase.ASKING and self._request.in_vain(now):
            name = self.autopilot.follow_mode.name
            self._leave_choice(f"the autopilot accepted {name} and does not fly it")
        return None if self.phase is Phase.OFFERING else self._request.due(now)

    def _has_offered(self, now: int) -> bool:
        """Whether setpoints go out at `now` [us], and have for as long as the autopilot asks."""
        return (
            self.hindrance is None
            and self._offered is not None
            and now - self._offered_last <= OFFER_GAP
            and now - self._offered >= self.autopilot.offer
        )

    def _request_hold(self, now: int) -> CommandLong | None:
        """The request for hold at `now` [us], while the companion cannot guide.

        It is made where the autopilot still follows setpoints, and where its failsafe holds and
        would follow them again by itself. A mode that somebody chose is left alone, and so is any
        other mode of the failsafe.
        """
        if self._mode is None or not self._is_new:
            return None
        if not (self.follows or self._falls_back):
            if self.hindrance is None:
                self.happen(Event.ABLE_AGAIN)
            return None
        if not (self.follows and now >= self._hold_from) and self._mode != self.autopilot.hold_mode:
            return None
        if self._request.in_vain(now):
            self._request = self._ask_for(self.autopilot.hold_mode)
        return self._request.due(now)

    def answer(self, ack: CommandAck) -> None:
        """Note the answer to a change of mode."""
        if complaint := self._request.answer(ack):
            self.notes.append(complaint)

    def happen(self, event: Event, why: str = "") -> None:
        """Change the phase by the table of transitions; tell the operator so, and `why`."""
        before, after = self.phase, TRANSITIONS[self.phase, event]
        if after is before:
            return
        self.phase = after
        self.notes += phase_notes(before, after, self.autopilot, self._mode, why)
        self._offered = None
        self.engage = self.engage and after is not Phase.YIELDING
        if after is Phase.ASKING:
            self._request = self._ask_for(self.autopilot.follow_mode)
        elif after in (Phase.YIELDING, Phase.RETURNING):
            self._request = self._ask_for(self.autopilot.hold_mode)

    def _ask_for(self, mode: IntEnum) -> ModeRequest:
        return ModeRequest(self.sysid, self.autopilot, mode)

    def _tell_of(self, said: Heartbeat) -> None:
        """Tell the operator once of each of the first who are not the vehicle's autopilot."""
        searching = self.phase is Phase.SEARCHING and said.autopilot != MavAutopilot.INVALID
        text = STRANGER if searching else FOREIGN_HEARTBEAT
        note = text.format(sysid=self.sysid, who=describe(said), flown=flown())
        if note not in self._strangers and len(self._strangers) < MAX_TOLD:
            self._strangers.add(note)
            self.notes.append(note)

    def _leave_choice(self, reason: str) -> None:
        """Somebody else decides on the mode: do not ask for the follow mode any more."""
        if self.engage and self.phase in (Phase.OFFERING, Phase.ASKING):
            self.engage = False
            self.notes.append(f"{reason}: it is not asked again")
            self.happen(Event.ASKING_GIVEN_UP)
