"""Heights of other aircraft: what they report, made comparable with heights above mean sea level.

Transponders report the pressure altitude of the standard atmosphere (QNE). MAVLink calls the same
field a height by the pressure of the day (QNH), some senders do convert it, and nothing on the
wire tells which was done. So a pressure altitude is doubted by the difference of the two, which is
the ownship's pressure altitude less the own height. Geometric heights are above the ellipsoid.
"""

from typing import NamedTuple

from vfguide.earth.pressure_altitude import pressure_altitude
from vfguide.geometry.units import HPA, MM
from vfguide.link.enums import AdsbAltitudeType, AdsbFlags
from vfguide.link.messages import AdsbVehicle
from vfguide.link.plausibility import LARGEST_UNDULATION
from vfguide.surveillance.height_difference import HeightDifference

PRESSURE_ERROR = 20.0
"""Doubt of a height by pressure where weather has no part in it [m]; chosen: errors of two
pressure sensors, and the steps of 25 ft in which transponders report."""
LOW_QNH = 950.0 * HPA
"""Least pressure at sea level that is allowed for [Pa]; chosen: lower ones are those of tropical
cyclones, down to 870 hPa (World Meteorological Organization)."""
HIGH_QNH = 1050.0 * HPA
"""Greatest pressure at sea level that is allowed for [Pa]; chosen: higher ones are those of
Siberian winters, up to 1085 hPa (World Meteorological Organization)."""
TEMPERATURE_SHARE = 0.1
"""Error of a pressure altitude by the temperature of the air, as a ratio to the height; chosen:
30 K of the 288 K of the standard atmosphere."""
ANY_HEIGHT = 20_000.0
"""Half height of the volume of an aircraft that reports no altitude [m]; chosen, so that every
height is in it."""


class HeightDatum(NamedTuple):
    """How heights that others report relate to heights above mean sea level."""

    pressure_offset: float | None = None
    """The ownship's pressure altitude less its height above mean sea level [m]; None: the autopilot
    reports no pressure."""
    undulation: float | None = None
    """Height of mean sea level above the ellipsoid [m]; None: the autopilot does not report it."""
    pressure_doubt: float = 0.0
    """By how much the pressure offset may be wrong [m]."""
    undulation_doubt: float = 0.0
    """By how much the undulation may be wrong [m]."""


UNKNOWN_DATUM = HeightDatum()
"""The datum where the autopilot reports neither."""


def datum_of(
    pressure_offset: HeightDifference | None, undulation: HeightDifference | None
) -> HeightDatum:
    """The datum from the two differences that the autopilot reports; None: it does not."""
    return HeightDatum(
        None if pressure_offset is None else pressure_offset.middle,
        None if undulation is None else undulation.middle,
        0.0 if pressure_offset is None else pressure_offset.doubt,
        0.0 if undulation is None else undulation.doubt,
    )


class Height(NamedTuple):
    """What a reported height means."""

    altitude: float
    """Above mean sea level, the middle of what it may be [m]."""
    doubt: float
    """Half the range of what it may be [m]."""


def is_by_pressure(said: AdsbVehicle) -> bool:
    """Whether a report has a height, and by pressure."""
    has = bool(said.flags & AdsbFlags.VALID_ALTITUDE)
    return has and said.altitude_type == AdsbAltitudeType.PRESSURE_QNH


def height_of(said: AdsbVehicle, datum: HeightDatum, own: float) -> Height:
    """What the height of a report means; `own` stands for one that is not reported [m]."""
    if not said.flags & AdsbFlags.VALID_ALTITUDE:
        return Height(own, ANY_HEIGHT)
    altitude = said.altitude * MM
    if not is_by_pressure(said):
        if datum.undulation is None:
            return Height(altitude, LARGEST_UNDULATION)
        return Height(altitude - datum.undulation, datum.undulation_doubt)
    least, greatest = offsets(datum, altitude)
    return Height(altitude - 0.5 * (least + greatest), PRESSURE_ERROR + 0.5 * (greatest - least))


def offsets(datum: HeightDatum, altitude: float) -> tuple[float, float]:
    """Least and greatest error of an `altitude` by pressure, as a height above sea level [m].

    Zero is in between: the sender may have converted it already.
    """
    if datum.pressure_offset is None:
        return weather(altitude)
    least, greatest = (
        datum.pressure_offset - datum.pressure_doubt,
        datum.pressure_offset + datum.pressure_doubt,
    )
    return min(least, 0.0), max(greatest, 0.0)


def weather(altitude: float) -> tuple[float, float]:
    """Least and greatest difference that weather makes, pressure altitude less `altitude` [m]."""
    temperature = TEMPERATURE_SHARE * max(altitude, 0.0)
    return pressure_altitude(HIGH_QNH) - temperature, pressure_altitude(LOW_QNH) + temperature


def pressure_offset(pressure: float, altitude: float) -> float | None:
    """Pressure altitude of a pressure [Pa] less the altitude [m] at which it was measured.

    None where no weather makes such a difference: the sensor is wrong.
    """
    if not pressure > 0.0:  # not-a-number too
        return None
    offset = pressure_altitude(pressure) - altitude
    least, greatest = weather(altitude)
    return offset if least <= offset <= greatest else None
