"""Pressure altitude: the height at which the standard atmosphere (ISO 2533) has a pressure."""

from vfguide.earth.atmosphere import EXPONENT, LAPSE, TEMPERATURE_0

PRESSURE_0 = 101_325.0
"""Pressure at sea level in the standard atmosphere [Pa] (ISO 2533)."""
PRESSURE_EXPONENT = EXPONENT + 1.0
"""Exponent of the temperature that pressure follows below the tropopause, g0 / (R_air LAPSE)
(ISO 2533)."""


def pressure_altitude(pressure: float) -> float:
    """Pressure altitude [m] of a pressure [Pa] of the troposphere.

    ISO 2533: H = (T_0 / L) (1 - (p / p_0)^(R L / g)).
    """
    return TEMPERATURE_0 / LAPSE * (1.0 - (pressure / PRESSURE_0) ** (1.0 / PRESSURE_EXPONENT))


def isa_pressure(altitude: float) -> float:
    """Pressure [Pa] at a pressure altitude [m] of the troposphere, inverse of the other."""
    return PRESSURE_0 * (1.0 - LAPSE / TEMPERATURE_0 * altitude) ** PRESSURE_EXPONENT
