"""From a scenario to what flies it: the simulated vehicles at their starts."""

import math

import numpy as np

from vfguide.geometry.geodesy import ned_to_geodetic
from vfguide.geometry.units import DEG, US
from vfguide.geometry.vector import Vec3
from vfguide.scenario.errors import InputError
from vfguide.scenario.load import LoadedScenario
from vfguide.scenario.models import model_of
from vfguide.scenario.resolve import plane_of
from vfguide.scenario.resolved import Scenario, Vehicle
from vfguide.sim.bench import Bench
from vfguide.sim.condition import Start, Turbulence, Weather
from vfguide.sim.fdm import ModelError
from vfguide.sim.identify import IdentifyError
from vfguide.sim.trim import TrimError, trim
from vfguide.sim.vehicle import Setup
from vfguide.sim.vehicle import Vehicle as SimVehicle

GUSTS = 1
"""Purpose of a random stream."""


def start_us(scenario: Scenario) -> int:
    """The date of time zero [us since 1970]."""
    return round(scenario.start_time.timestamp() / US)


def simulate(loaded: LoadedScenario, vehicle: Vehicle) -> SimVehicle:
    """The simulated vehicle at its start, trimmed for level flight.

    Raises:
        InputError: its model cannot be flown.
    """
    try:
        return SimVehicle(setup_of(loaded, vehicle), start_us(loaded.scenario))
    except (ModelError, TrimError, IdentifyError) as error:
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
        Weather(
            wind_of(scenario),
            Turbulence[scenario.wind.turbulence.upper()],
            random_seed(scenario.seed, vehicle.id, GUSTS),
        ),
        scenario.origin.altitude_m,
    )


def wind_of(scenario: Scenario) -> Vec3:
    """The steady wind, the direction it blows toward, NED [m/s]."""
    toward = scenario.wind.from_deg * DEG + math.pi
    return (
        scenario.wind.speed_mps * math.cos(toward),
        scenario.wind.speed_mps * math.sin(toward),
        0.0,
    )


def random_seed(seed: int, sysid: int, purpose: int) -> int:
    """The seed of one random stream: nothing else changes it, no other vehicle either."""
    return int(np.random.SeedSequence([seed, sysid, purpose]).generate_state(1)[0])
