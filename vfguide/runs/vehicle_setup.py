"""From a scenario to the simulated vehicles at their starts."""

import numpy as np

from vfguide.earth.geodesy import ned_to_geodetic
from vfguide.earth.pressure_altitude import pressure_altitude
from vfguide.files.errors import InputError
from vfguide.files.traffic_entry import AltitudeType
from vfguide.geometry.units import DEG, HPA
from vfguide.link.enums import AdsbAltitudeType
from vfguide.runs.instruments import instruments_from, motor_from
from vfguide.runs.models import model_of
from vfguide.scenario.loaded import LoadedScenario
from vfguide.scenario.resolve import place_of, plane_of
from vfguide.scenario.resolved import Scenario, Vehicle, start_us
from vfguide.scenario.traffic import path_of
from vfguide.scenario.wind import blowing
from vfguide.sim.bench import Bench
from vfguide.sim.condition import Start, Weather
from vfguide.sim.fdm import ModelError
from vfguide.sim.inner_loop.airframe_model import AirframeModelError
from vfguide.sim.traffic import Transponder
from vfguide.sim.trim import TrimError, trim
from vfguide.sim.turbulence import Turbulence
from vfguide.sim.vehicle import Setup
from vfguide.sim.vehicle import Vehicle as SimVehicle

GUSTS = 1
"""Number of the random stream of a vehicle's gusts."""
STATE_ERRORS = 2
"""Number of the random stream of the errors of a vehicle's state."""
RATE_ERRORS = 3
"""Number of the random stream of the errors of a vehicle's body rates."""
TRAFFIC_ERRORS = 4
"""Number of the random stream of the errors of another aircraft, drawn by its address."""


def simulate(loaded: LoadedScenario, vehicle: Vehicle) -> SimVehicle:
    """The simulated vehicle at its start, trimmed for level flight.

    Raises:
        InputError: its model cannot be flown.
    """
    try:
        return SimVehicle(setup_of(loaded, vehicle), start_us(loaded.scenario))
    except (ModelError, TrimError, AirframeModelError) as error:
        raise InputError(str(error)) from error


def setup_of(loaded: LoadedScenario, vehicle: Vehicle) -> Setup:
    """What a simulated vehicle begins with."""
    scenario = loaded.scenario
    model = model_of(loaded, vehicle.aircraft)
    latitude, longitude, altitude = ned_to_geodetic(plane_of(scenario.origin), vehicle.position_m)
    condition = trim(Bench(model, altitude), vehicle.airspeed_mps)
    return Setup(
        vehicle.id,
        model,
        loaded.performance(vehicle),
        scenario.airspeed_of(vehicle),
        Start(latitude, longitude, altitude, vehicle.euler_deg[2] * DEG, condition),
        weather_of(scenario, vehicle.id),
        scenario.origin.altitude_m,
        instruments_from(
            scenario.sensors,
            scenario.autopilot,
            random_seed(scenario.seed, vehicle.id, STATE_ERRORS),
            random_seed(scenario.seed, vehicle.id, RATE_ERRORS),
            scenario.origin.undulation_m,
            scenario.weather.qnh_hpa * HPA,
        ),
        motor_from(scenario.autopilot),
        transponders_of(scenario),
        scenario.traffic_receiver.range_m,
        place_of(scenario.origin),
    )


def transponders_of(scenario: Scenario) -> tuple[Transponder, ...]:
    """The transponders of the other aircraft; every vehicle receives the same reports."""
    return tuple(
        Transponder(
            int(each.icao, 16),
            each.name,
            path_of(each),
            each.interval_s,
            each.delay_s,
            each.position_error_m,
            random_seed(scenario.seed, int(each.icao, 16), TRAFFIC_ERRORS),
            *told_height(scenario, each.altitude_type),
        )
        for each in scenario.traffic
    )


def told_height(scenario: Scenario, altitude_type: AltitudeType) -> tuple[AdsbAltitudeType, float]:
    """The kind of height that a transponder reports, and that less the altitude [m]."""
    match altitude_type:
        case "geometric":
            return AdsbAltitudeType.GEOMETRIC, scenario.origin.undulation_m
        case "qne":
            return AdsbAltitudeType.PRESSURE_QNH, pressure_altitude(scenario.weather.qnh_hpa * HPA)
        case "qnh":
            return AdsbAltitudeType.PRESSURE_QNH, 0.0


def weather_of(scenario: Scenario, sysid: int) -> Weather:
    """The air that a vehicle flies in."""
    wind = scenario.wind
    north, east, _ = blowing(1.0, wind.from_deg)
    shear = wind.shear_mps_per_100m / 100.0
    return Weather(
        blowing(wind.speed_mps, wind.from_deg),
        Turbulence[wind.turbulence.upper()],
        random_seed(scenario.seed, sysid, GUSTS),
        tuple((time, blowing(speed, from_deg)) for time, speed, from_deg in wind.stages[1:]),
        (shear * north, shear * east, 0.0),
        wind.shear_height_m,
    )


def random_seed(seed: int, sysid: int, purpose: int) -> int:
    """The seed of one random stream: nothing else changes it, no other vehicle either."""
    (state,) = np.random.SeedSequence([seed, sysid, purpose]).generate_state(1).tolist()
    return int(state)
