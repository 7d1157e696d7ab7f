"""The International Standard Atmosphere (ISO 2533), and true and calibrated airspeed."""

import math

from vfguide.kernels.compiled import compiled

DENSITY_0 = 1.225
"""Air density at sea level in the standard atmosphere [kg/m^3] (ISO 2533)."""
TEMPERATURE_0 = 288.15
"""Temperature at sea level in the standard atmosphere [K] (ISO 2533)."""
LAPSE = 0.0065
"""Decrease of temperature with height below the tropopause [K/m] (ISO 2533)."""
EXPONENT = 4.255876
"""Exponent of the temperature that density follows below the tropopause, g0 / (R_air LAPSE) - 1
(ISO 2533)."""
TROPOPAUSE = 11_000.0
"""Height of the tropopause [m] (ISO 2533)."""
SCALE_HEIGHT = 6341.62
"""Height over which density decreases by the factor e above the tropopause [m]: R_air T / g0 at
216.65 K (ISO 2533)."""


@compiled
def isa_density(altitude: float) -> float:
    """Air density [kg/m^3] at `altitude` [m] above mean sea level, up to 20 km.

    ISO 2533: rho = rho_0 (T / T_0)^(g / (R L) - 1), exponential above the tropopause.
    """
    temperature = TEMPERATURE_0 - LAPSE * min(altitude, TROPOPAUSE)
    stratospheric = math.exp(-max(altitude - TROPOPAUSE, 0.0) / SCALE_HEIGHT)
    return DENSITY_0 * (temperature / TEMPERATURE_0) ** EXPONENT * stratospheric


@compiled
def true_airspeed(calibrated: float, density: float) -> float:
    """True airspeed of a calibrated one [m/s] in air of `density` [kg/m^3].

    V = V_c sqrt(rho_0 / rho), without compressibility: under 0.2 % below 100 m/s.
    """
    return calibrated * math.sqrt(DENSITY_0 / density)


@compiled
def calibrated_airspeed(true: float, density: float) -> float:
    """Calibrated airspeed of a true one [m/s], the inverse of `true_airspeed`."""
    return true * math.sqrt(density / DENSITY_0)
