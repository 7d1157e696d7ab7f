"""The vehicle that the control loop flies: aircraft and gains."""

from typing import NamedTuple

from vfguide.aircraft.performance import Gains, Performance
from vfguide.kernels.rows import flattener, reader


class Vehicle(NamedTuple):
    """An aircraft and the gains with which it is flown."""

    aircraft: Performance
    gains: Gains
    """Gains that suit its roll response."""
    is_rigid_body: bool = False
    """Whether it is the paper's rigid body without weight, which flies where its nose points."""


read_vehicle = reader(Vehicle)
vehicle_numbers = flattener(Vehicle)
