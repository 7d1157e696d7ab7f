"""Notes of heights that cannot be compared with those of the ownship."""

from vfguide.geometry.units import MM
from vfguide.link.boot_time import elapsed
from vfguide.link.enums import AdsbFlags
from vfguide.link.messages import AdsbVehicle
from vfguide.link.plausibility import LARGEST_UNDULATION
from vfguide.surveillance.heights import HeightDatum, is_by_pressure, weather

ANSWER_TIME = 3.0
"""Time that the autopilot has, from the first report that cannot be compared, to report its
pressure, which is asked for then, or its height above the ellipsoid [s]; chosen."""
NO_PRESSURE = (
    "the autopilot tells no pressure (SCALED_PRESSURE): traffic that reports a pressure altitude "
    "is kept clear of from {below:.0f} m below it to {above:.0f} m above"
)
"""Note where pressure altitudes cannot be compared."""
NO_UNDULATION = (
    "the autopilot tells no height above the ellipsoid (GPS_RAW_INT): traffic that reports a "
    "geometric height is kept clear of from {doubt:.0f} m below it to {doubt:.0f} m above"
)
"""Note where geometric heights cannot be compared."""


class HeightNotes:
    """Makes the notes, each once."""

    def __init__(self) -> None:
        self._since: dict[bool, int] = {}
        """Time of the first report that could not be compared [ms]: by pressure, geometric."""
        self._told: set[bool] = set()

    def notes(self, said: AdsbVehicle, datum: HeightDatum, now_ms: int) -> list[str]:
        """The notes of a report that arrives at the time_boot_ms `now_ms` [ms]."""
        if not said.flags & AdsbFlags.VALID_ALTITUDE:
            return []
        pressure = is_by_pressure(said)
        needed = datum.pressure_offset if pressure else datum.undulation
        if needed is not None:
            self._since.pop(pressure, None)
            return []
        since = self._since.setdefault(pressure, now_ms)
        if pressure in self._told or elapsed(since, now_ms) < ANSWER_TIME:
            return []
        self._told.add(pressure)
        return [pressure_note(said.altitude * MM) if pressure else undulation_note()]


def pressure_note(altitude: float) -> str:
    """The note for a pressure altitude [m]."""
    least, greatest = weather(altitude)
    return NO_PRESSURE.format(below=greatest, above=-least)


def undulation_note() -> str:
    """The note for geometric heights."""
    return NO_UNDULATION.format(doubt=LARGEST_UNDULATION)
