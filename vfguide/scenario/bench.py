"""How fast the program is: its parts and a whole run against bare JSBSim, in one process."""

import tempfile
import time
from collections.abc import Callable
from dataclasses import dataclass
from pathlib import Path

from vfguide.companion.step import fresh_route, step
from vfguide.flight.state import FlightState
from vfguide.geometry.so3 import from_euler
from vfguide.link.codec import Encoder, Parser, decode
from vfguide.link.messages import SetAttitudeTarget
from vfguide.scenario.crew import plan_of, simulate
from vfguide.scenario.load import load_scenario
from vfguide.scenario.lockstep import fly_scenario, warm_up
from vfguide.sim.plant import STEP

SCENARIO = "first-flight"
REPEATS = 7
"""Every figure is the median of this many, taken in turn, so that a slow spell hits them all."""
PLANT_STEPS = 2000
GUIDANCE_STEPS = 500
MESSAGES = 1000


@dataclass(frozen=True)
class Bench:
    """Times of the parts and of the whole."""

    guidance_step_us: float
    """One step of the companion, from flight state to setpoint."""
    message_turnaround_us: float
    """One setpoint encoded, found in the stream and decoded."""
    jsbsim_steps_per_s: float
    """The plant alone, controls held."""
    jsbsim_realtime_factor: float
    """The same as simulated over real time."""
    run_realtime_factor: float
    """A whole run of one aircraft, all traffic as bytes, logs written."""
    run_over_bare: float
    """Time of a whole run over the time of its plant steps alone."""


def measure() -> Bench:
    """Measure everything, repeats in turn."""
    loaded = load_scenario(SCENARIO)
    warm_up(loaded)
    vehicle = loaded.scenario.vehicles[0]
    plan = plan_of(loaded, vehicle)
    guidance, message, plant, run = [], [], [], []
    for _ in range(REPEATS):
        guidance.append(seconds(lambda: guide_often(plan)) / GUIDANCE_STEPS)
        message.append(seconds(turn_messages) / MESSAGES)
        bare = simulate(loaded, vehicle).plant
        controls = vehicle_controls = (0.0, 0.0, 0.0, 0.7)
        plant.append(seconds(lambda: [bare.advance(controls) for _ in range(PLANT_STEPS)]) / PLANT_STEPS)
        with tempfile.TemporaryDirectory() as folder:
            flight = fly_scenario(loaded, Path(folder), lambda *_: None)
        run.append(flight.wall_s / flight.sim_s)
