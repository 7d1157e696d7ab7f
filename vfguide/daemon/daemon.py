"""The companion on a real link: the one loop of a flight with a clock and a socket."""

import selectors
from collections.abc import Callable
from enum import Enum, auto

from vfguide.aircraft.identification import Identified
from vfguide.autopilots.engagement import FINAL_PHASES, Phase
from vfguide.companion.session import Session
from vfguide.daemon.clock import Clock
from vfguide.daemon.flight_log import FlightLog
from vfguide.daemon.transport import Transport

POLL_INTERVAL = 0.05
"""Longest time between two polls of the companion [s]; chosen."""
HOLD_TIMEOUT = 5_000_000
"""Time in which the autopilot must confirm its hold [us]; chosen."""


class HandoverResult(Enum):
    """How a flight of the daemon ended."""

    HANDED_OVER = auto()
    """The autopilot flies in a mode of its own, as its heartbeat says."""
    UNCONFIRMED = auto()
    """It is unknown what the autopilot flies: it did not answer within HOLD_TIMEOUT."""
    UNLINKED = auto()
    """It is unknown what the autopilot flies: the link was lost, as the last note says."""
    CUT_SHORT = auto()
    """It is unknown what the autopilot flies: the operator asked again and did not wait."""


class Daemon:
    """One companion, its link and its log, until it is stopped."""

    def __init__(
        self,
        session: Session,
        transport: Transport,
        log: FlightLog,
        clock: Clock,
        say: Callable[[str], None],
        save: Callable[[Identified], None],
    ) -> None:
        """A daemon that has not started.

        Args:
            session: the companion behind bytes; it records to `log`.
            transport: its link to the autopilot.
            log: the log of what it receives and sends.
            clock: the clock of the process.
            say: prints one line for the operator.
            save: writes the aircraft as a test flight has shown it, once.
        """
        self._session = session
        self._companion = session.companion
        self._transport = transport
        self._log = log
        self._clock = clock
        self._say = say
        self._save: Callable[[Identified], None] | None = save
        self._stopped_at: int | None = None

    def run(self, stops: Callable[[], int]) -> HandoverResult:
        """Fly until the operator asks for an end, or the companion has ended; returns how.

        `stops` is the number of times that the operator has asked: after the first request the
        companion hands over, after the second the flight ends at once.
        """
        with selectors.SelectSelector() as selector:
            selector.register(self._transport, selectors.EVENT_READ)
            while (outcome := self._outcome(stops())) is None:
                selector.select(POLL_INTERVAL)
                self._take_all()
                if self._companion.phase not in FINAL_PHASES:
                    self._send(self._session.poll(self._clock.now()))
                self._tell()
                if self._save and (found := self._companion.flight.identified) is not None:
                    self._save(found)
                    self._save = None
                self._log.flush(self._clock.now())
        self._tell()
        return outcome

    def _outcome(self, stops: int) -> HandoverResult | None:
        """How the flight ended; None: it goes on. At the first request the companion hands over."""
        now = self._clock.now()
        if stops and self._stopped_at is None:
            self._stopped_at = now
            self._send(self._session.stop(now))
        if self._companion.phase is Phase.ENDED:
            return HandoverResult.HANDED_OVER
        if self._companion.phase is Phase.UNCONFIRMED:
            return HandoverResult.UNLINKED
        if stops > 1:
            return HandoverResult.CUT_SHORT
        waited = 0 if self._stopped_at is None else now - self._stopped_at
        return HandoverResult.UNCONFIRMED if waited > HOLD_TIMEOUT else None

    def _take_all(self) -> None:
        """Pass on all frames that have arrived; answers are sent at once."""
        now = self._clock.now()
        for frame in self._transport.receive(now):
            if self._companion.phase in FINAL_PHASES:
                return
            self._send(self._session.take(now, frame))

    def _send(self, frames: list[bytes]) -> None:
        for frame in frames:
            self._transport.send(frame)

    def _tell(self) -> None:
        """Print new notes and warnings for the operator."""
        warnings = self._transport.warnings + self._log.warnings
        for line in self._companion.news() + warnings:
            self._say(line)
        self._transport.warnings.clear()
        self._log.warnings.clear()
