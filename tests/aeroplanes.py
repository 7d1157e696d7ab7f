"""The aeroplanes that are flown in tests, as their files describe them: at sea-level density.

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
    thrust_fade=(1.0 - 0.475) / 7.0,
)
EASYSTAR = Performance(
    airspeed_min=7.0,
    airspeed_cruise=11.0,
    airspeed_max=14.0,
    bank_max=45.0 * DEG,
    load_max=1.7,
    load_min=0.3,
    climb_max=10.0 * DEG,
    descent_max=7.0 * DEG,
    rate_max=(100.0 * DEG, 60.0 * DEG, 45.0 * DEG),
    alpha_zero=-3.42 * DEG,
    alpha_load=527.0 * DEG,
    thrust_trim=0.195,
    thrust_per_climb=1.58,
    thrust_per_load=0.030,
    thrust_per_airspeed=0.129,
    thrust_integral=0.025,
    thrust_fade=(1.0 - 0.91) / 3.0,
)
CESSNA = Performance(
    airspeed_min=25.2,
    airspeed_cruise=45.0,
    airspeed_max=58.0,
    bank_max=45.0 * DEG,
    load_max=1.7,
    load_min=0.3,
    climb_max=5.0 * DEG,
    descent_max=5.0 * DEG,
    rate_max=(30.0 * DEG, 12.0 * DEG, 10.0 * DEG),
    alpha_zero=-3.44 * DEG,
    alpha_load=10150.0 * DEG,
    thrust_trim=0.367,
    thrust_per_climb=3.54,
    thrust_per_load=0.096,
    thrust_per_airspeed=0.144,
    thrust_integral=0.019,
    thrust_fade=(1.0 - 0.85) / 13.0,
)
