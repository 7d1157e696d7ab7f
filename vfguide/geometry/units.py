"""The factors from other units to SI and radians: `altitude = altitude_ft * FT`.

This is the only place that holds a scale factor; from SI, divide: `altitude_mm = altitude / MM`.
"""

import math

DEG = math.pi / 180.0
"""One degree [rad]."""
CDEG = 0.01 * DEG
"""One centidegree, the unit of headings in MAVLink [rad]."""
DEG_E7 = 1e-7 * DEG
"""A ten-millionth of a degree, the unit of latitudes and longitudes in MAVLink [rad]."""

KM = 1e3
"""One kilometre [m]."""
MM = 1e-3
"""One millimetre [m]."""
FT = 0.3048
"""One foot [m] (international yard and pound agreement, 1959)."""
NM = 1852.0
"""One nautical mile [m] (First International Extraordinary Hydrographic Conference, 1929)."""

SECOND = 1_000_000
"""One second in the unit of times on MAVLink [us]."""
NS_PER_US = 1000
"""Number of nanoseconds, the unit of TIMESYNC, in a microsecond."""
MINUTE = 60.0
"""One minute [s]."""
HOUR = 3600.0
"""One hour [s]."""
MS = 1e-3
"""One millisecond [s]."""
US = 1e-6
"""One microsecond [s]."""

KT = NM / HOUR
"""One knot [m/s]."""
CM_S = 1e-2
"""One centimetre per second, the unit of velocities in MAVLink [m/s]."""

G0 = 9.80665
"""Standard gravity [m/s^2] (3rd General Conference on Weights and Measures, 1901)."""
MILLI_G = 1e-3 * G0
"""A thousandth of standard gravity, the unit of accelerations in MAVLink [m/s^2]."""

LB = 0.45359237
"""One pound of mass [kg] (international yard and pound agreement, 1959)."""
LBF = LB * G0
"""One pound of force [N]."""
SLUG = LBF / FT
"""One slug [kg]."""
SLUG_FT2 = SLUG * FT**2
"""One slug square foot, of moments of inertia [kg m^2]."""
SLUG_FT3 = SLUG / FT**3
"""One slug per cubic foot, of densities [kg/m^3]."""
HPA = 100.0
"""One hectopascal [Pa]."""

PERCENT = 1e-2
"""One hundredth, as a share."""

SUFFIXES = {"m": 1.0, "s": 1.0, "mps": 1.0, "deg": DEG, "dps": DEG}
"""Scale factors to SI units and radians by the suffixes of keys."""


def in_si(key: str, value: float) -> tuple[str, float]:
    """The name of a key without the suffix that tells its unit, and the value in SI or radians.

    Raises:
        KeyError: the suffix is none of SUFFIXES.
    """
    name, suffix = key.rsplit("_", 1)
    return name, SUFFIXES[suffix] * value
