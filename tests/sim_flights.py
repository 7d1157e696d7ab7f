"""The Aerosonde in the air, under its rate loop alone."""

from functools import cache
from pathlib import Path

import jsbsim

from vfguide.geometry.units import DEG, FT
from vfguide.geometry.vector import Vec3
from vfguide.kernels.rows import columns
from vfguide.sim.bench import Bench
from vfguide.sim.condition import FlightCondition, Model, Start, Weather
from vfguide.sim.inner_loop.airframe_model import Airframe, identify
from vfguide.sim.inner_loop.inner_loop import inner_loop
from vfguide.sim.inner_loop.rate_loop import Axis, RateTable
from vfguide.sim.plant import STEP, Plant
from vfguide.sim.trim import trim
from vfguide.sim.truth import Truth

AIRCRAFT = Path(__file__).parents[1] / "aircraft"
AEROSONDE = Model(AIRCRAFT, "aerosonde")
EASYSTAR = Model(AIRCRAFT, "easystar")
CESSNA = Model(Path(jsbsim.get_default_root_dir()) / "aircraft", "c172p")
"""A stock model, with engine and propeller of JSBSim's own, in a folder of engines."""
MODELS = {"aerosonde": AEROSONDE, "easystar": EASYSTAR, "c172p": CESSNA}
GROUND = 488.0
ALTITUDE = 638.0
STEPS_PER_S = round(1.0 / STEP)


@cache
def bench(altitude: float = ALTITUDE) -> Bench:
    return Bench(AEROSONDE, altitude)


@cache
def steady(airspeed: float = 25.0, climb: float = 0.0) -> FlightCondition:
    return trim(Bench(AEROSONDE, ALTITUDE), airspeed, climb)


def airframe() -> Airframe:
    return identify(AEROSONDE, 25.0, ALTITUDE)


def start(condition: FlightCondition | None = None, yaw: float = 0.0) -> Start:
    return Start(47.4 * DEG, 8.5 * DEG, ALTITUDE, yaw, condition or steady())


def airborne(airspeed: float = 25.0, yaw: float = 0.0, weather: Weather | None = None) -> Plant:
    return Plant(AEROSONDE, start(steady(airspeed), yaw), weather, GROUND)


def plain_jsbsim(
    name: str, forward: float, pitch: float, downward: float = 0.0
) -> jsbsim.FGFDMExec:
    """A model as any user of JSBSim would load it, in flight at these body velocities [m/s]."""
    fdm = jsbsim.FGFDMExec(str(AIRCRAFT.parent))
    fdm.set_debug_level(0)
    fdm.set_dt(0.005)
    assert fdm.load_model(name)
    fdm["ic/h-sl-ft"] = ALTITUDE / FT
    fdm["ic/theta-rad"] = pitch
    fdm["ic/u-fps"] = forward / FT
    fdm["ic/w-fps"] = downward / FT
    assert fdm.run_ic()
    return fdm


def thrust_in(condition: FlightCondition) -> float:
    """Thrust setpoint that holds a steady flight."""
    return bench().thrust(condition) / airframe().thrust.full_thrust


def fly(
    plant: Plant, omega_b: Vec3, seconds: float, thrust: float = 0.3, every: int = 1
) -> list[Truth]:
    """The truth before the first step and after each `every`-th, at constant setpoints."""
    tables, memory, truths = airframe().tables, (0.0, 0.0, 0.0), [plant.truth()]
    for step in range(1, round(seconds * STEPS_PER_S) + 1):
        controls, memory = inner_loop(tables, plant.inner(), (*omega_b, thrust), memory, STEP)
        plant.advance(controls)
        if step % every == 0:
            truths.append(plant.truth())
    return truths


def terms(rates: RateTable) -> Axis:
    """The terms of a rate loop's table about roll, pitch and yaw: (3,) or (3, 3), as views."""
    return columns(Axis, rates.reshape(3, -1))
