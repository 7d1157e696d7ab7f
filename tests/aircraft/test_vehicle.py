"""The vehicle as a row, which crosses into compiled code."""

import numpy as np
import pytest

from vfguide.aircraft.performance import Gains, Performance
from vfguide.aircraft.vehicle import Vehicle, read_vehicle, vehicle_numbers
from vfguide.kernels.rows import width


@pytest.mark.parametrize("is_rigid_body", [False, True])
def test_the_row_of_a_vehicle_holds_every_number_in_its_place(is_rigid_body):
    numbers = iter(range(1, 100))
    aircraft = Performance(
        *(
            tuple(float(next(numbers)) for _ in range(3)) if name == "rate_max" else next(numbers)
            for name in Performance._fields
        )
    )
    gains = Gains(*(float(next(numbers)) for _ in Gains._fields))
    vehicle = Vehicle(aircraft, gains, is_rigid_body)
    row = np.array(vehicle_numbers(vehicle))
    assert read_vehicle(row) == vehicle
    assert len(row) == width(Vehicle)
    assert row.tolist() == [*range(1, len(row)), float(is_rigid_body)]
