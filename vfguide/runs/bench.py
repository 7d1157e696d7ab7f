"""Benchmark: the parts of the program and a whole run against bare JSBSim, in one process."""

import tempfile
import time
from collections.abc import Callable
from dataclasses import dataclass
from functools import partial
from pathlib import Path
from statistics import median
from typing import Any, NamedTuple

from vfguide.companion.plan import Plan
from vfguide.earth.projection import Projection
from vfguide.estimation.local_frame import Measurement
from vfguide.geometry.so3 import quaternion_from_euler
from vfguide.guidance.laws import crossing
from vfguide.link.codec import Encoder, Parser, decode
from vfguide.link.enums import AttitudeTypeMask, MavComponent
from vfguide.link.messages import SetAttitudeTarget
from vfguide.loop.rows import step_measured
from vfguide.loop.state import fresh_state, row_of_state
from vfguide.preflight.load import load_scenario
from vfguide.runs.lockstep import fly_scenario
from vfguide.runs.vehicle_setup import simulate
from vfguide.runs.warm_up import warm_up
from vfguide.scenario.plans import plan_of
from vfguide.sim.plant import STEP

BENCH_SCENARIO = "first-flight"
"""Name of the shipped scenario that is flown."""
REPEATS = 7
"""Number of repeats whose median every figure is, taken in turn, so that a slow moment of the
machine affects all figures; chosen."""
GUIDANCE_STEPS = 500
"""Number of guidance steps in one repeat; chosen."""
GUIDANCE_PERIOD = 0.02
"""Time between two guidance steps [s]; chosen, as at 50 Hz."""
MESSAGES = 1000
"""Number of setpoints in one repeat; chosen."""
SAMPLE_MEASUREMENT = Measurement(
    0.0,
    (0.0, 0.0, 0.0),
    (-300.0, 50.0, -120.0),
    (25.0, 2.0, 0.0),
    0.0,
    quaternion_from_euler(0.1, 0.05, 0.0),
    24.0,
    608.0,
    1.156,
    (1.0, 2.0, 0.0),
    (0.1, 0.02, 0.03),
    0.02,
    int(Projection.AZIMUTHAL_EQUIDISTANT),
)
"""A measurement of an autopilot in flight, in the units of `Measurement`; its time and its origin
are replaced."""
SAMPLE_SETPOINT = SetAttitudeTarget(
    1000, 1, 1, AttitudeTypeMask.ATTITUDE_IGNORE, (1.0, 0.0, 0.0, 0.0), 0.1, 0.02, 0.03, 0.4
)
"""The setpoint whose encoding and decoding is measured, in the units of its message."""


@dataclass(frozen=True)
class Bench:
    """Times of the parts and of the whole."""

    guidance_step_us: float
    """One step of the companion, from a measurement to the setpoint."""
    message_turnaround_us: float
    """One setpoint encoded, found in the stream and decoded."""
    jsbsim_steps_per_s: float
    """Bare JSBSim at the time step of a run, controls held."""
    jsbsim_realtime_factor: float
    """Ratio of simulated to real time of bare JSBSim."""
    run_realtime_factor: float
    """A whole run of one aircraft: all traffic as bytes, logs written."""
    run_over_bare: float
    """Time of a whole run over the time of bare JSBSim for the same steps."""


class Times(NamedTuple):
    """Times of one repeat."""

    guidance: float
    """Time of a guidance step [s]."""
    message: float
    """Time to encode and decode a setpoint [s]."""
    bare: float
    """Time of bare JSBSim for a second of flight [s]."""
    run: float
    """Time of a whole run for a second of flight [s]."""


def measure() -> Bench:
    """Measure everything, the repeats in turn."""
    loaded = load_scenario(BENCH_SCENARIO)
    vehicle = loaded.scenario.vehicles[0]
    plan = plan_of(loaded, vehicle)
    warm_up(loaded)
    times: list[Times] = []
    for _ in range(REPEATS):
        with tempfile.TemporaryDirectory() as folder:
            flight = fly_scenario(loaded, Path(folder))
        steps = round(flight.sim_s / STEP)
        plant = simulate(loaded, vehicle).plant
        times.append(
            Times(
                guidance=seconds(partial(guide_often, plan)) / GUIDANCE_STEPS,
                message=seconds(turn_messages) / MESSAGES,
                bare=seconds(partial(plant.run_bare, steps)) / flight.sim_s,
                run=flight.wall_s / flight.sim_s,
            )
        )
    middle = Times(*(median(column) for column in zip(*times, strict=True)))
    ratio = median(time.run / time.bare for time in times)
    return Bench(
        guidance_step_us=round(middle.guidance * 1e6, 2),
        message_turnaround_us=round(middle.message * 1e6, 2),
        jsbsim_steps_per_s=round(1.0 / (middle.bare * STEP)),
        jsbsim_realtime_factor=round(1.0 / middle.bare, 1),
        run_realtime_factor=round(1.0 / middle.run, 1),
        run_over_bare=round(ratio, 2),
    )


def seconds(work: Callable[[], None]) -> float:
    """Time that the work takes [s]."""
    started = time.perf_counter()
    work()
    return time.perf_counter() - started


def guide_often(plan: Plan) -> None:
    """Guidance steps in flight, each with the state of the step before."""
    state = row_of_state(fresh_state())
    _, *rest = SAMPLE_MEASUREMENT._replace(origin=plan.origin)
    for k in range(GUIDANCE_STEPS):
        measured: Any = (GUIDANCE_PERIOD * k, *rest)
        *_, state, _ = step_measured(
            measured, plan.origin, state, plan.legs, None, crossing(plan.law), plan.vehicle_row
        )


def turn_messages() -> None:
    """Setpoints to bytes and back."""
    encoder, parser = Encoder(1, MavComponent.PATHPLANNER), Parser()
    for _ in range(MESSAGES):
        for frame in parser.feed(encoder.encode(SAMPLE_SETPOINT)):
            decode(frame)
