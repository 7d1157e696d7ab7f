"""From a scenario to what its software autopilots measure with, and the motors they have."""

import math

from vfguide.files.simulation_entry import Autopilot, Sensors
from vfguide.geometry.units import in_si
from vfguide.sim.autopilot.instruments import AirspeedFault, Errors, Instruments, Reset
from vfguide.sim.autopilot.motor import Motor


def instruments_from(
    sensors: Sensors | None,
    autopilot: Autopilot,
    seed: int,
    rate_seed: int,
    undulation: float,
    qnh: float,
) -> Instruments:
    """What one autopilot measures with.

    Args:
        sensors: sizes of the errors; None: it knows its state exactly.
        autopilot: what fails when.
        seed: seed of the errors of its estimate.
        rate_seed: seed of the errors of its body rates.
        undulation: height of mean sea level above the ellipsoid [m].
        qnh: pressure of the air at mean sea level [Pa].
    """
    fails = autopilot.airspeed_fails_at_s
    resets = (Reset(each.time_s, each.position_m, each.origin_m) for each in autopilot.reset)
    return Instruments(
        None if sensors is None else errors_from(sensors),
        seed,
        rate_seed,
        math.inf if fails is None else fails,
        AirspeedFault(autopilot.airspeed_fault),
        autopilot.wind_message,
        tuple(sorted(resets, key=lambda reset: reset.time)),
        undulation,
        qnh,
        autopilot.pressure_message,
    )


def motor_from(autopilot: Autopilot) -> Motor:
    """What the motor of each aircraft gives."""
    return Motor(autopilot.thrust_scale, autopilot.thrust_sag_per_min, autopilot.thrust_floor)


def errors_from(sensors: Sensors) -> Errors:
    """The sizes of the errors in SI units and radians: each field by the key of its name."""
    return Errors(**dict(in_si(key, value) for key, value in sensors.model_dump().items()))
