"""The air in which a plan is flown: its density at the heights of start and goals."""

from collections.abc import Sequence
from typing import NamedTuple

from vfguide.earth.atmosphere import isa_density
from vfguide.earth.geodesy import TangentPlane, ned_to_geodetic
from vfguide.geometry.vector import Vec3


class Air(NamedTuple):
    """The standard atmosphere between the lowest and the highest place of a plan."""

    lowest: float
    """Height of the lowest place above mean sea level [m]."""
    highest: float
    """Height of the highest place above mean sea level [m]."""

    @property
    def thickest(self) -> float:
        """Density at the lowest place [kg/m^3]: true airspeeds are the smallest there."""
        return isa_density(self.lowest)

    @property
    def thinnest(self) -> float:
        """Density at the highest place [kg/m^3]: the true airspeed of the stall is the largest."""
        return isa_density(self.highest)


NO_AIR = Air(0.0, 0.0)
"""The air of rigid bodies, which fly in none: at sea level [m], where true and equivalent airspeed
are the same."""


def air_between(plane: TangentPlane, places: Sequence[Vec3]) -> Air:
    """The air between the lowest and the highest of some places, NED in the tangent plane [m]."""
    altitudes = [altitude for *_, altitude in (ned_to_geodetic(plane, each) for each in places)]
    return Air(min(altitudes), max(altitudes))
