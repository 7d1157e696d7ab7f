"""Checks of an aircraft in the air of its plan: its airspeeds, its thrust, its ceiling."""

import math
from collections.abc import Callable
from typing import NamedTuple

import numpy as np

from vfguide.aircraft.air_density import excess_thrust, in_air
from vfguide.aircraft.envelope import usable_bank
from vfguide.aircraft.performance import Gains, Performance
from vfguide.earth.atmosphere import DENSITY_0, calibrated_airspeed
from vfguide.files.errors import InputError
from vfguide.files.source import Location, Source
from vfguide.scenario.air import Air

CEILING_CLIMB = 0.5
"""Rate of climb that is left at the service ceiling [m/s]: about the 100 ft/min that define it."""
THRUST_ERROR = 0.015
"""Error of full thrust less drag by the aircraft file, as a share of the weight; chosen above the
0.012 by which the model of the Cessna 172 has less near its stall at 6400 m."""
SHOWN_STEP = 0.1
"""Step to which shown limits of an airspeed are rounded, inward [m/s]; chosen."""
CEILING_STEP = 50.0
"""Step in which a ceiling is looked for [m]; chosen."""
NO_CEILING = 12_000.0
"""Altitude up to which a ceiling is looked for [m]; chosen above what scenarios allow."""


class AircraftInAir(NamedTuple):
    """An aircraft in the air of its plan."""

    name: str
    """Name of the aircraft."""
    aircraft: Performance
    """The aircraft at sea-level density."""
    gains: Gains
    """Gains with which it is flown."""
    air: Air
    """The air between its start and its goals."""
    is_measured: bool
    """Whether its thrust was measured, so that a flight can be refused for it."""


class AskedAirspeed(NamedTuple):
    """A true airspeed that a scenario asks for."""

    speed: float
    """True airspeed [m/s]."""
    at: Location
    """Key of the scenario file that asks for it, or could."""
    is_written: bool
    """Whether the file has that key; otherwise the airspeed is the cruise of the aircraft."""


Holds = Callable[[float, float], bool]
"""Whether a true airspeed [m/s] is held in air of a density [kg/m^3]."""


def airspeed_limits(aircraft: Performance, air: Air) -> tuple[float, float]:
    """Least and largest true airspeed [m/s] that an aircraft may fly everywhere in the air.

    The first is above the second where no airspeed is within the limits at all heights.
    """
    least = in_air(aircraft, air.thinnest, aircraft.airspeed_cruise).airspeed_min
    return least, in_air(aircraft, air.thickest, aircraft.airspeed_cruise).airspeed_max


def check_airspeed(asked: AskedAirspeed, flown: AircraftInAir, source: Source) -> None:
    """Check that an airspeed is within the limits of the aircraft at every height of the plan.

    Raises:
        InputError: it is not.
    """
    low, high = airspeed_limits(flown.aircraft, flown.air)
    if low > high:
        rule = (
            f"the least airspeed of {flown.name} at {flown.air.highest:.0f} m is above its largest "
            f"at {flown.air.lowest:.0f} m; allowed are goals at heights that differ less"
        )
        raise refused(asked, rule, flown, source)
    if not low <= asked.speed <= high:
        side = "below the minimum" if asked.speed < low else "above the maximum"
        rule = f"{side} of {flown.name} {_where(flown.air)}, allowed {shown_range(low, high)}"
        raise refused(asked, rule, flown, source)


def check_start(asked: AskedAirspeed, flown: AircraftInAir, source: Source) -> list[str]:
    """A warning where the thrust may not hold the airspeed of the start in level flight.

    It is looked at in the thinnest air of the plan.

    Raises:
        InputError: the thrust, which was measured, does not hold it.
    """

    def holds(speed: float, density: float) -> bool:
        return spare_thrust(speed, flown, density, 1.0) >= 0.0

    return _check_held(asked, flown, in_thin_air(holds, flown), source)


def check_thrust(asked: AskedAirspeed, flown: AircraftInAir, source: Source) -> list[str]:
    """A warning where the thrust may not hold the airspeed to fly, as of `is_held`.

    It is looked at in the thinnest air of the plan.

    Raises:
        InputError: the thrust, which was measured, does not hold it.
    """

    def holds(speed: float, density: float) -> bool:
        return is_held(speed, flown, density)

    return _check_held(asked, flown, in_thin_air(holds, flown), source)


def is_held(speed: float, flown: AircraftInAir, density: float) -> bool:
    """Whether full thrust holds a true airspeed [m/s] in air of a density [kg/m^3].

    It has to leave a climb with CEILING_CLIMB, and to hold a level turn at the largest bank that
    guidance asks for.
    """
    here = in_air(flown.aircraft, density, speed)
    load = 1.0 / math.cos(usable_bank(here, flown.gains, speed))
    climbs = speed * spare_thrust(speed, flown, density, 1.0) >= CEILING_CLIMB
    return climbs and spare_thrust(speed, flown, density, load) >= 0.0


def spare_thrust(speed: float, flown: AircraftInAir, density: float, load: float) -> float:
    """Full thrust less drag at a load factor, less its error, over the weight, dimensionless.

    `speed` is a true airspeed [m/s], `density` that of the air [kg/m^3].
    """
    return excess_thrust(flown.aircraft, density, speed, load) - THRUST_ERROR


def in_thin_air(holds: Holds, flown: AircraftInAir) -> Holds:
    """A function as `holds` that finds fault only with what thin air takes away.

    An airspeed that does not pass `holds` even at sea level, at the same equivalent airspeed, has
    only to be held in level flight, without an allowance for errors: the thrust in the aircraft
    file is a guess then, or the airspeed is near the fastest.
    """

    def holds_here(speed: float, density: float) -> bool:
        if holds(speed, density):
            return True
        equivalent = calibrated_airspeed(speed, density)
        is_held_below = holds(equivalent, DENSITY_0)
        return not is_held_below and excess_thrust(flown.aircraft, density, speed, 1.0) >= 0.0

    return holds_here


def _check_held(
    asked: AskedAirspeed, flown: AircraftInAir, holds: Holds, source: Source
) -> list[str]:
    density, what = flown.air.thinnest, f"not held by the thrust of {flown.name}"
    if holds(asked.speed, density):
        return []
    what = f"{what} at {flown.air.highest:.0f} m"
    if held := held_airspeeds(flown, flown.air.highest, holds):
        rule = f"{what}, allowed {shown_range(held[0], held[-1])}"
    else:
        rule = f"{what}, nor any other one; allowed are goals up to {ceiling(flown, holds):.0f} m"
    error = refused(asked, rule, flown, source)
    if flown.is_measured:
        raise error
    return [f"{error}; by the thrust of its file, which was not measured"]


def held_airspeeds(flown: AircraftInAir, altitude: float, holds: Holds) -> list[float]:
    """The true airspeeds within the limits that are held at an altitude [m], in [m/s]."""
    air = Air(altitude, altitude)
    low, high = airspeed_limits(flown.aircraft, air)
    speeds = np.arange(math.ceil(low / SHOWN_STEP), math.floor(high / SHOWN_STEP) + 1) * SHOWN_STEP
    return [each for each in speeds.tolist() if holds(each, air.thinnest)]


def ceiling(flown: AircraftInAir, holds: Holds) -> float:
    """Altitude up to which some airspeed within the limits is held [m]; 0 where none is."""
    reached = 0.0
    for height in np.arange(0.0, NO_CEILING, CEILING_STEP).tolist():
        if not held_airspeeds(flown, height, holds):
            break
        reached = height
    return reached


def refused(asked: AskedAirspeed, rule: str, flown: AircraftInAir, source: Source) -> InputError:
    """The error of an airspeed that breaks a rule; it says so where the airspeed is the cruise."""
    if asked.is_written:
        return source.error(asked.at, rule, asked.speed)
    cruise = f"the cruise of {flown.name}, true airspeed {asked.speed:.1f}"
    return source.error(asked.at, f"{cruise}, is {rule}")


def shown_range(low: float, high: float) -> str:
    """Limits of a true airspeed [m/s] in words, rounded inward to SHOWN_STEP."""
    low, high = math.ceil(low / SHOWN_STEP - 1e-9), math.floor(high / SHOWN_STEP + 1e-9)
    return f"{low * SHOWN_STEP:.4g} to {high * SHOWN_STEP:.4g} (true airspeed)"


def _where(air: Air) -> str:
    low, high = f"{air.lowest:.0f}", f"{air.highest:.0f}"
    return f"at {high} m" if low == high else f"between {low} and {high} m"
