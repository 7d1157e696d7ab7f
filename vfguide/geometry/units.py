"""The factors from other units to SI and radians: `altitude = altitude_ft * FT`.

This is the only place that holds a scale factor; from SI, divide: `altitude_mm = altitude / MM`.
"""

import math

DEG = math.pi / 180.0
CDEG = 0.01 * DEG
"""Centidegree, of MAVLink's headings and attitudes."""
DEG_E7 = 1e-7 * DEG
"""1e-7 degree, of MAVLink's latitudes and longitudes."""

KM = 1e3
CM = 1e-2
MM = 1e-3
IN = 0.0254
FT = 0.3048
NM = 1852.0
"""Nautical mile."""

HOUR = 3600.0
MS = 1e-3
US = 1e-6

KT = NM / HOUR
"""Knot."""
CM_S = 1e-2
"""cm/s."""
FPM = FT / 60.0
"""Feet a minute."""

G0 = 9.80665
"""Standard gravity [m/s^2]."""
MILLI_G = 1e-3 * G0

LB = 0.45359237
"""Pound, the mass."""
LBF = LB * G0
"""Pound, the force."""
SLUG = LBF / FT
SLUG_FT2 = SLUG * FT**2
"""Slug square foot, of moments of inertia."""
SLUG_FT3 = SLUG / FT**3
"""Slug a cubic foot, of densities."""
LBF_FT = LBF * FT
"""Pound foot, of moments."""
PSF = LBF / FT**2
"""Pound a square foot, of pressures."""
HPA = 100.0
"""Hectopascal."""

PERCENT = 1e-2
