"""Commands that must be answered: sent one at a time, repeated until they are."""

from collections import deque
from enum import IntEnum

from vfguide.autopilots.autopilot import Autopilot
from vfguide.link.enums import MavCmd, MavResult
from vfguide.link.messages import CommandAck, CommandLong

RETRY = 500_000
"""Time after which a command without an answer is sent again [us]; chosen."""
MAX_ATTEMPTS = 5
"""Number of times that a command is sent before it is given up; chosen."""
MODE_RETRY = 1_000_000
"""Time after which a mode that was not accepted is asked for again [us]; chosen."""
MODE_TIMEOUT = 3_000_000
"""Time within which a mode that was accepted shows in the heartbeat [us]; chosen."""


def command(target: int, number: MavCmd, *parameters: float) -> CommandLong:
    """A COMMAND_LONG to the autopilot of system `target`; parameters left out are 0."""
    p = (*parameters, *(0.0,) * (7 - len(parameters)))
    return CommandLong(target, 1, number, 0, p[0], p[1], p[2], p[3], p[4], p[5], p[6])


def set_mode(target: int, autopilot: Autopilot, mode: int) -> CommandLong:
    """The command that changes the flight mode to the custom mode `mode`."""
    return command(target, MavCmd.DO_SET_MODE, *autopilot.mode_parameters(mode))


class Requests:
    """The queue of commands to one autopilot."""

    def __init__(self) -> None:
        self._queue: deque[CommandLong] = deque()
        self._sent_at = 0
        self._tries = 0

    def ask(self, commands: list[CommandLong]) -> None:
        """Append commands to the queue, but those that wait in it already."""
        self._queue.extend(command for command in commands if command not in self._queue)

    def due(self, now: int) -> CommandLong | None:
        """The command to send now [us], if it is time for one."""
        if self._tries >= MAX_ATTEMPTS:
            self._drop()
        if not self._queue or (self._tries and now - self._sent_at < RETRY):
            return None
        self._sent_at = now
        self._tries += 1
        return self._queue[0]._replace(confirmation=self._tries - 1)

    def answer(self, ack: CommandAck) -> str | None:
        """Note an answer; returns a complaint when the autopilot refuses for good."""
        if not self._tries or ack.command != self._queue[0].command:
            return None
        if ack.result in (MavResult.IN_PROGRESS, MavResult.TEMPORARILY_REJECTED):
            return None
        asked = self._queue[0]
        self._drop()
        if ack.result == MavResult.ACCEPTED:
            return None
        answer = result_name(ack.result)
        return f"the autopilot refuses command {asked.command} ({asked.param1:g}): {answer}"

    def _drop(self) -> None:
        self._queue.popleft()
        self._tries = 0


class ModeRequest:
    """The request for one mode, repeated until it is accepted.

    After that the autopilot is not asked any more: if it flies something else then, somebody
    else wants that. An autopilot may acknowledge twice, the last answer is the real one.
    """

    def __init__(self, target: int, autopilot: Autopilot, mode: IntEnum) -> None:
        self._command = set_mode(target, autopilot, mode)
        self._mode = mode
        self._asked_at: int | None = None
        self._result: int | None = None
        self._complained: int | None = None

    def due(self, now: int) -> CommandLong | None:
        """The command to send now [us], if it is time for it."""
        early = self._asked_at is not None and now - self._asked_at < MODE_RETRY
        if early or self._result == MavResult.ACCEPTED:
            return None
        self._asked_at = now
        return self._command

    def in_vain(self, now: int) -> bool:
        """Whether the mode was accepted and should have been seen by `now` [us]."""
        accepted = self._result == MavResult.ACCEPTED
        return accepted and self._asked_at is not None and now - self._asked_at > MODE_TIMEOUT

    def answer(self, ack: CommandAck) -> str | None:
        """Note an answer; returns a complaint when the autopilot refuses for a new reason."""
        if ack.command != MavCmd.DO_SET_MODE or self._asked_at is None:
            return None
        self._result = ack.result
        if ack.result in (MavResult.ACCEPTED, MavResult.IN_PROGRESS, self._complained):
            return None
        self._complained = ack.result
        return f"the autopilot refuses {self._mode.name}: {result_name(ack.result)}; asking again"


def result_name(result: int) -> str:
    """The result of an acknowledgement in words."""
    known = result in set(MavResult)
    return MavResult(result).name.lower().replace("_", " ") if known else f"result {result}"
