"""What the loop knows of the vehicle that it flies."""

from typing import NamedTuple

from vfguide.aircraft.performance import Gains, Performance
from vfguide.geometry.rows import flattener, reader


class Vehicle(NamedTuple):
    """An aircraft, and how it is to be flown."""

    aircraft: Performance
    gains: Gains
    """As they suit its roll response."""
    is_point: bool = False
    """Whether it is the paper's rigid body without weight, which flies where its nose points."""


read_vehicle = reader(Vehicle)
vehicle_numbers = flattener(Vehicle)
