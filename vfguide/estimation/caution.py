"""Caution where the airspeed is only estimated: faster flight with less bank."""

from vfguide.aircraft.envelope import FASTEST_SHARE, bank_of_turn, carried_load
from vfguide.aircraft.performance import Gains
from vfguide.aircraft.vehicle import Vehicle
from vfguide.estimation.estimation import NavState
from vfguide.kernels.compiled import compiled
from vfguide.kernels.rows import replacing

AIRSPEED_MARGIN = 1.2
"""Ratio of the airspeed to fly without a sensor, less two standard deviations of the estimate, to
the slowest airspeed; chosen."""

with_gains = replacing(Vehicle, "gains")
with_airspeed_and_bank = replacing(Gains, "airspeed", "bank_max")


@compiled
def cautious(nav: NavState, vehicle: Vehicle) -> Vehicle:
    """The vehicle with the airspeed and the largest bank to fly now.

    Without a trusted sensor, two standard deviations are kept between the airspeed and what the
    wing needs.
    """
    if nav.trusts_sensor:
        return vehicle
    aircraft, gains, _ = vehicle
    unsure = 2.0 * nav.airspeed_sigma
    least = max(nav.airspeed - unsure, aircraft.airspeed_min)
    load = carried_load(aircraft, least)
    fast = min(
        AIRSPEED_MARGIN * aircraft.airspeed_min + unsure, FASTEST_SHARE * aircraft.airspeed_max
    )
    airspeed, bank_max = max(gains.airspeed, fast), min(gains.bank_max, bank_of_turn(load))
    return with_gains(vehicle, with_airspeed_and_bank(gains, airspeed, bank_max))
