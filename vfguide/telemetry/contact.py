"""Contact: when the autopilot was heard, and whether this program itself ran all the time.

Nothing here has a clock. The time since the last message in or out is what a log has too, so that a
replay finds the same gaps.
"""

from vfguide.geometry.units import SECOND, US

LINK_TIMEOUT = 3 * SECOND
"""Time without any message about the vehicle's state or mode after which the link is lost [us];
chosen."""
MODE_UNKNOWN = 10 * SECOND
"""Time without a heartbeat after which the link counts as lost, for the mode is unknown [us];
chosen: where 30 % of the messages are lost, ten in a row are lost once in two days."""
LONGEST_HICCUP = 500_000
"""Time without a message in or out above which this program stood still [us]; chosen as the age
above which no state is flown on. It asks the autopilot for the time five times a second."""

LONGEST_WAIT = SECOND
"""Time after this program stood still within which what arrives may have waited meanwhile [us];
chosen as the time between two heartbeats, which show the mode again."""


class Contact:
    """The times of one link."""

    def __init__(self, now: int = 0) -> None:
        """The times of an autopilot that was found at `now` [us]."""
        self._heard = now
        self._beaten = now
        self._active = now
        self._woke: int | None = None

    def hear(self, now: int) -> None:
        """Record that the vehicle's state or mode was heard at `now` [us]."""
        self._heard = now

    def hear_heartbeat(self, now: int) -> None:
        """Record that its heartbeat was heard at `now` [us]."""
        self._heard = self._beaten = now

    def act(self, now: int) -> None:
        """Record that something came in or went out at `now` [us]."""
        self._active = max(now, self._active)

    def goes_on(self, now: int) -> bool:
        """Record that something came in or went out at `now` [us]; returns whether all goes on.

        False where this program stood still or the link is silent: then nothing is recorded.
        """
        if (
            now - self._active > LONGEST_HICCUP
            or now - self._heard > LINK_TIMEOUT
            or now - self._beaten > MODE_UNKNOWN
        ):
            return False
        self._active = max(now, self._active)
        return True

    def wake(self, now: int) -> int:
        """For how long this program stood still until `now` [us], 0 where it did not [us].

        Meanwhile nobody was silent.
        """
        gap = now - self._active
        if gap <= LONGEST_HICCUP:
            return 0
        self._woke = self._active = now
        self._heard, self._beaten = self._heard + gap, self._beaten + gap
        return gap

    def waited(self, now: int) -> bool:
        """Whether what is taken at `now` [us] waited while this program stood still."""
        return now == self._woke

    def may_have_waited(self, now: int) -> bool:
        """Whether what is taken at `now` [us] may have waited meanwhile, be it at a router."""
        return self._woke is not None and now - self._woke <= LONGEST_WAIT

    def silence(self, now: int) -> str | None:
        """Why the link counts as lost at `now` [us], if it does."""
        if now - self._heard > LINK_TIMEOUT:
            return f"nothing heard for {LINK_TIMEOUT * US:.0f} s"
        if now - self._beaten > MODE_UNKNOWN:
            return f"no heartbeat for {MODE_UNKNOWN * US:.0f} s"
        return None
