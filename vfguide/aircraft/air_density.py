"""The aircraft in the air of the moment: what its equivalent airspeeds are as true airspeeds.

Lift and drag follow the dynamic pressure q = rho V^2 / 2 = rho_0 V_e^2 / 2 (Beard and McLain, Small
Unmanned Aircraft, 2012, chapter 4): what an aircraft does at an equivalent airspeed V_e, it does at
any height at the true airspeed V = V_e sqrt(rho_0 / rho). Thrust at a throttle and a true airspeed
falls with the density. So an aircraft file holds at sea-level density, and everything that flies
takes the aircraft as it is in the present air, with true airspeeds.
"""

import math

from vfguide.aircraft.performance import Gains, Performance
from vfguide.aircraft.vehicle import Vehicle
from vfguide.earth.atmosphere import DENSITY_0
from vfguide.geometry.units import DEG
from vfguide.kernels.compiled import compiled
from vfguide.kernels.rows import replacing

THIN_AIR_SHARE = 0.75
"""Largest share of the sine of the steepest steady climb in thin air that is asked for, unless the
aircraft file has a larger share at sea level; chosen, the share of the Aerosonde's file."""
POWER_SLOPE = 1.132
"""Slope of the power of a piston engine over the air density, both as ratios to sea level,
dimensionless: Gagg and Farrar, *Altitude Performance of Aircraft Engines*, SAE 1934. The thrust of
an electric propeller falls less, in proportion to the density; which of the two an aircraft has is
not known."""
NO_CLIMB = 0.5 * DEG
"""Steepest climb that is asked for where the thrust gives none [rad]; chosen, so that heights stay
within reach of a finite path. The airspeed comes first, see `vfguide.aircraft.path_limits`."""

_in_other_air = replacing(
    Performance,
    "airspeed_min",
    "airspeed_cruise",
    "airspeed_max",
    "climb_max",
    "alpha_load",
    "thrust_trim",
    "thrust_per_climb",
    "thrust_per_load",
    "thrust_per_airspeed",
    "thrust_integral",
)
_flown = replacing(Vehicle, "aircraft", "gains")
_at_airspeed = replacing(Gains, "airspeed")


@compiled
def in_air(aircraft: Performance, density: float, airspeed: float) -> Performance:
    """The aircraft in air of `density` [kg/m^3], flown at a true airspeed [m/s].

    Args:
        aircraft: the aircraft at sea-level density.
        density: air density [kg/m^3].
        airspeed: true airspeed to fly, at which it climbs [m/s].
    """
    thinner = DENSITY_0 / density
    faster = math.sqrt(thinner)
    return _in_other_air(
        aircraft,
        faster * aircraft.airspeed_min,
        faster * aircraft.airspeed_cruise,
        faster * aircraft.airspeed_max,
        steepest_climb(aircraft, density, airspeed),
        thinner * aircraft.alpha_load,
        thinner * aircraft.thrust_trim,
        thinner * aircraft.thrust_per_climb,
        thinner * aircraft.thrust_per_load,
        thinner * aircraft.thrust_per_airspeed,
        thinner * aircraft.thrust_integral,
    )


@compiled
def vehicle_in_air(vehicle: Vehicle, density: float) -> Vehicle:
    """The vehicle in air of `density` [kg/m^3], its airspeed to fly within the limits there.

    The paper's rigid body knows no air.
    """
    aircraft, gains, is_rigid_body = vehicle
    if is_rigid_body:
        return vehicle
    here = in_air(aircraft, density, gains.airspeed)
    airspeed = max(here.airspeed_min, min(here.airspeed_max, gains.airspeed))
    return _flown(vehicle, here, _at_airspeed(gains, airspeed))


@compiled
def steepest_climb(aircraft: Performance, density: float, airspeed: float) -> float:
    """The steepest climb to ask for [rad]: that of the aircraft file, or what thin air leaves.

    The arguments are those of `in_air`.
    """
    if density >= DENSITY_0:
        return aircraft.climb_max
    here = excess_thrust(aircraft, density, airspeed, 1.0)
    equivalent = airspeed * math.sqrt(density / DENSITY_0)
    at_sea_level = excess_thrust(aircraft, DENSITY_0, equivalent, 1.0)
    if here >= at_sea_level:
        return aircraft.climb_max
    left = max(here, 0.0) / max(at_sea_level, 1e-6)
    climb = max(THIN_AIR_SHARE * here, left * math.sin(aircraft.climb_max))
    return min(aircraft.climb_max, max(NO_CLIMB, math.asin(min(climb, 1.0))))


@compiled
def excess_thrust(aircraft: Performance, density: float, airspeed: float, load: float) -> float:
    """Full thrust less drag, over weight: the sine of the steepest steady climb.

    Args:
        aircraft: the aircraft at sea-level density.
        density: air density [kg/m^3].
        airspeed: true airspeed [m/s].
        load: load factor.
    """
    ratio = density / DENSITY_0
    q_ratio = ratio * (airspeed / aircraft.airspeed_cruise) ** 2
    parasitic = (aircraft.thrust_trim - aircraft.thrust_per_load) * q_ratio
    induced = aircraft.thrust_per_load * load * load / q_ratio
    faster = max(0.0, airspeed - aircraft.airspeed_cruise)
    power = max(0.0, POWER_SLOPE * (ratio - 1.0) + 1.0)
    full = power * max(0.0, 1.0 - aircraft.thrust_fade * faster)
    return (full - parasitic - induced) / aircraft.thrust_per_climb
