"""What the operator reads of the airspeed: whether it is heard, and whether it is believed."""

NOT_HEARD = "no airspeed is heard"
"""Note where a flight begins without an airspeed, as without a sensor."""
HEARD_NO_MORE = "no airspeed is heard any more"
"""Note where the airspeed ends in flight."""
NOT_BELIEVED = "the airspeed sensor is not believed"
"""Note where a flight begins with an airspeed that cannot be true."""
BELIEVED_NO_MORE = "the airspeed sensor is not believed any more"
"""Note where the airspeed sensor has failed."""
ESTIMATED = "airspeed is estimated, it flies faster and with less bank"
"""Note where the airspeed is estimated."""
BELIEVED_AT_LAST = "the airspeed sensor is believed from now on"
"""Note where the airspeed sensor works for the first time."""
BELIEVED_AGAIN = "the airspeed sensor is believed again"
"""Note where the airspeed sensor works again."""


class AirspeedAnnunciator:
    """Makes notes of the airspeed sensor, and remembers what the operator knows of it."""

    def __init__(self) -> None:
        self._is_believed: bool | None = None
        """Whether it is believed; None: no step has been flown yet."""
        self._was_believed = False
        """Whether it ever was believed."""

    def notes(self, is_believed: bool, is_heard: bool) -> list[str]:
        """The notes of a step; none where a flight begins with a good sensor.

        Args:
            is_believed: whether the measured airspeed is flown on.
            is_heard: whether the autopilot reports one.
        """
        before, was_believed = self._is_believed, self._was_believed
        self._is_believed, self._was_believed = is_believed, was_believed or is_believed
        if is_believed == before:
            return []
        if not is_believed:
            return [f"{reason(was_believed, is_heard)}: {ESTIMATED}"]
        if before is None:
            return []
        return [BELIEVED_AGAIN if was_believed else BELIEVED_AT_LAST]


def reason(was_believed: bool, is_heard: bool) -> str:
    """Why the airspeed is estimated: what changed, or how it is from the beginning."""
    if is_heard:
        return BELIEVED_NO_MORE if was_believed else NOT_BELIEVED
    return HEARD_NO_MORE if was_believed else NOT_HEARD
