"""The aeroplanes that are flown in tests, as their files describe them.

Rooms below the files need none; `tests/files/test_aircraft_file.py` compares these with them.
"""

from vfguide.aircraft.performance import Performance
from vfguide.geometry.units import DEG

AEROSONDE = Performance(
    airspeed_min=18.0,
    airspeed_cruise=25.0,
    airspeed_max=32.0,
    bank_max=50.0 * DEG,
    load_max=1.7,
    load_min=0.3,
    climb_max=10.0 * DEG,
    descent_max=10.0 * DEG,
    rate_max=(80.0 * DEG, 35.0 * DEG, 29.0 * DEG),
    alpha_zero=-2.48 * DEG,
    alpha_load=3493.0 * DEG,
    thrust_trim=0.3,
    thrust_per_climb=3.0,
    thrust_per_load=0.04,
    thrust_per_airspeed=0.24,
    thrust_integral=0.046,
)
EASYSTAR = Performance(
    airspeed_min=7.2,
    airspeed_cruise=11.0,
    airspeed_max=14.0,
    bank_max=45.0 * DEG,
    load_max=1.7,
    load_min=0.3,
    climb_max=10.0 * DEG,
    descent_max=7.0 * DEG,
    rate_max=(100.0 * DEG, 60.0 * DEG, 45.0 * DEG),
    alpha_zero=-3.43 * DEG,
    alpha_load=562.0 * DEG,
    thrust_trim=0.194,
    thrust_per_climb=1.64,
    thrust_per_load=0.032,
    thrust_per_airspeed=0.134,
    thrust_integral=0.026,
)
CESSNA = Performance(
    airspeed_min=26.0,
    airspeed_cruise=45.0,
    airspeed_max=58.0,
    bank_max=45.0 * DEG,
    load_max=1.7,
    load_min=0.3,
    climb_max=5.0 * DEG,
    descent_max=5.0 * DEG,
    rate_max=(30.0 * DEG, 12.0 * DEG, 10.0 * DEG),
    alpha_zero=-3.47 * DEG,
    alpha_load=10830.0 * DEG,
    thrust_trim=0.38,
    thrust_per_climb=3.77,
    thrust_per_load=0.115,
    thrust_per_airspeed=0.15,
    thrust_integral=0.02,
)
