"""What a motor gives of the thrust that its map says, while its battery runs down."""

from typing import NamedTuple


class Motor(NamedTuple):
    """Shares of the thrust in the map; the defaults give all of it for ever."""

    scale: float = 1.0
    """At the start."""
    sag: float = 0.0
    """Lost in a minute."""
    floor: float = 0.0
    """The sag ends here."""

    def share(self, time: float) -> float:
        """The share at a time [s] after the start."""
        return max(self.scale - self.sag * time / 60.0, min(self.floor, self.scale))


SOUND = Motor()
"""A motor that gives the thrust of its map."""
