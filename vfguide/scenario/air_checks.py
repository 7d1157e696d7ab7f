"""Whether an aircraft can fly in the air of its plan: its airspeeds, its thrust, its ceiling."""

import math
from typing import NamedTuple

import numpy as np

from vfguide.aircraft.air_density import excess_thrust, in_air
from vfguide.aircraft.envelope import usable_bank
from vfguide.aircraft.performance import Gains, Performance
from vfguide.files.source import Location, Source
from vfguide.scenario.air import Air

CEILING_CLIMB = 0.5
"""Rate of climb that is left at the service ceiling [m/s]: the 100 ft/min of its definition."""
SHOWN_STEP = 0.1
"""Step to which the limits of an airspeed are shown [m/s]; chosen, inside the limits."""
CEILING_STEP = 50.0
"""Step to which a ceiling is shown [m]; chosen."""
NO_CEILING = 12_000.0
"""Height up to which a ceiling is looked for [m]; chosen above what scenarios allow."""


class Flown(NamedTuple):
    """An aircraft in the air of its plan."""

    name: str
    """Its name."""
    aircraft: Performance
    """The aircraft at sea-level density."""
    gains: Gains
    """Gains with which it is flown."""
    air: Air
    """The air between its start and its goals."""


def airspeed_limits(aircraft: Performance, air: Air) -> tuple[float, float]:
    """Least and largest true airspeed [m/s] that its limits allow everywhere in the air."""
    least = in_air(aircraft, air.thinnest, aircraft.airspeed_cruise).airspeed_min
    return least, in_air(aircraft, air.thickest, aircraft.airspeed_cruise).airspeed_max


def check_airspeed(speed: float, flown: Flown, source: Source, at: Location) -> None:
    """A true airspeed [m/s] is within the limits at every height of the plan.

    Raises:
        InputError: it is not.
    """
    low, high = airspeed_limits(flown.aircraft, flown.air)
    if low > high:
        rule = (
            f"the least airspeed of {flown.name} at {flown.air.highest:.0f} m is above its largest "
            f"at {flown.air.lowest:.0f} m; allowed are goals at heights that differ less"
        )
        raise source.error(at, rule, speed)
    if not low <= speed <= high:
        side = "below the minimum" if speed < low else "above the maximum"
        rule = f"{side} of {flown.name} {_where(flown.air)}, allowed {shown_range(low, high)}"
        raise source.error(at, rule, speed)


def check_thrust(flown: Flown, source: Source, at: Location) -> None:
    """The thrust holds the airspeed to fly at the highest place, in a climb and in turns.

    Raises:
        InputError: it does not.
    """
    speed = flown.gains.airspeed
    if is_held(speed, flown, flown.air.thinnest):
        return
    low, high = airspeed_limits(flown.aircraft, flown.air)
    speeds = np.arange(math.ceil(low / SHOWN_STEP), math.floor(high / SHOWN_STEP) + 1) * SHOWN_STEP
    held = [each for each in speeds.tolist() if is_held(each, flown, flown.air.thinnest)]
    what = f"not held by the thrust of {flown.name} at {flown.air.highest:.0f} m"
    if held:
        raise source.error(at, f"{what}, allowed {shown_range(held[0], held[-1])}", speed)
    rule = f"{what}, nor any other airspeed; allowed are goals up to {ceiling(flown):.0f} m"
    raise source.error(at, rule, speed)


def is_held(speed: float, flown: Flown, density: float) -> bool:
    """Whether full thrust holds a true airspeed [m/s] in air of a density [kg/m^3].

    It has to leave CEILING_CLIMB, and to hold a level turn at the bank that is asked for.
    """
    here = in_air(flown.aircraft, density, speed)
    load = 1.0 / math.cos(usable_bank(here, flown.gains, speed))
    climbs = speed * excess_thrust(flown.aircraft, density, speed, 1.0) >= CEILING_CLIMB
    return climbs and excess_thrust(flown.aircraft, density, speed, load) >= 0.0


def ceiling(flown: Flown) -> float:
    """Height up to which some airspeed is held [m]; 0 where none is at sea level."""
    heights = np.arange(0.0, NO_CEILING + CEILING_STEP, CEILING_STEP)
    reached = [0.0]
    for height in heights.tolist():
        air = Air(height, height)
        low, high = airspeed_limits(flown.aircraft, air)
        speeds = np.arange(low, high, SHOWN_STEP).tolist()
        if not any(is_held(each, flown, air.thinnest) for each in speeds):
            break
        reached.append(height)
    return reached[-1]


def shown_range(low: float, high: float) -> str:
    """Limits of a true airspeed [m/s] in words, rounded inside."""
    low, high = math.ceil(low / SHOWN_STEP - 1e-9), math.floor(high / SHOWN_STEP + 1e-9)
    return f"{low * SHOWN_STEP:.4g} to {high * SHOWN_STEP:.4g} (true airspeed)"


def _where(air: Air) -> str:
    low, high = f"{air.lowest:.0f}", f"{air.highest:.0f}"
    return f"at {high} m" if low == high else f"between {low} and {high} m"
