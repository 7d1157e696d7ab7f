"""What a motor gives of the thrust that its map says, while its battery runs down."""

from typing import NamedTuple

from vfguide.geometry.units import MINUTE


class Motor(NamedTuple):
    """Shares of the thrust in the map; the defaults give all of it for ever."""

    scale: float = 1.0
    """Share at the start."""
    sag: float = 0.0
    """Share that is lost in a minute [1/min]."""
    floor: float = 0.0
    """Share at which the sag ends."""

    def share(self, time: float) -> float:
        """The share of the thrust at a time [s] after the start, dimensionless."""
        return max(self.scale - self.sag * time / MINUTE, min(self.floor, self.scale))


SOUND = Motor()
"""A motor that gives the thrust of its map."""
