"""What the companion is asked to do, and with which aircraft."""

from dataclasses import dataclass, field
from typing import NamedTuple

from vfguide.flight.performance import Gains, Law, Performance, packed
from vfguide.geometry.geodesy import TangentPlane
from vfguide.geometry.vector import Vec3


class Goal(NamedTuple):
    """A pose to pass: a position and a direction of flight over ground."""

    p_n: Vec3
    """Position in the plan's frame, NED [m]."""
    course: float
    """Course over ground [rad]."""
    climb: float
    """Angle of climb over ground, positive up [rad]."""
    tolerance: float
    """Largest miss that counts as reached [m]."""
    tolerance_angle: float
    """Largest error of course and climb that counts as reached [rad]."""


@dataclass(frozen=True)
class Plan:
    """The goals of one vehicle, and how to fly to them."""

    frame: TangentPlane
    """The plane of the goals' coordinates: north-east-down at its origin."""
    goals: tuple[Goal, ...]
    loiter_side: float
    """Of the circle after the last goal: +1 right-hand, -1 left-hand."""
    loiter_radius: float
    """Of that circle [m]; it grows where wind and bank ask for more."""
    rate: float
    """Guidance steps in a second [Hz]."""
    aircraft: Performance
    gains: Gains
    law: Law = field(init=False, compare=False)
    """Aircraft and gains, `packed`."""

    def __post_init__(self) -> None:
        object.__setattr__(self, "law", packed(self.aircraft, self.gains))
