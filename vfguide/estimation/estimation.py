"""The stage of estimation: from the measurements of the autopilot to the state for guidance.

What contradicts the rest is replaced, a Kalman filter estimates wind and airspeed, the lift shows
the vertical wind, and position resets are let in slowly.
"""

from typing import NamedTuple

from vfguide.aircraft.state import FlightState
from vfguide.aircraft.vehicle import Vehicle
from vfguide.earth.atmosphere import DENSITY_0
from vfguide.estimation.air_data import sense_air
from vfguide.estimation.air_state import AIRSPEED, AirState, fresh_air, sigma
from vfguide.estimation.consistency import Consistency, as_flown, follow, fresh_consistency
from vfguide.estimation.flow_angles import FlowAngles, follow_flow, fresh_flow
from vfguide.estimation.position_resets import (
    PositionResets,
    follow_resets,
    no_resets,
    settled,
    smoothed,
)
from vfguide.estimation.vertical_wind import feel_rise
from vfguide.geometry.vector import ZERO, Vec3
from vfguide.kernels.compiled import compiled

FIRST_STEP = 0.02
"""Time step that the first step counts as [s]: that of 50 Hz."""
SHORTEST_STEP = 1e-3
"""Least time between two steps that filters and rate limits take [s]; chosen."""
LONGEST_STEP = 0.2
"""Largest time between two steps that filters and rate limits take [s]; chosen."""


class Inputs(NamedTuple):
    """The states from which one step is made."""

    predicted: FlightState
    """State at the time when the setpoint will act, in the frame of the plan."""
    measured: FlightState
    """State at the time of the attitude, in the same frame; airspeed and wind are not numbers where
    they are not measured."""
    omega_b: Vec3
    """Measured body rates [rad/s]."""
    is_exact: bool
    """Whether the predicted state is known exactly, as of a kinematic body."""
    lead: float
    """Time of the predicted state less that of the attitude [s], which follows the link's delay."""
    density: float = DENSITY_0
    """Density of the air [kg/m^3]."""


@compiled
def exact_inputs(state: FlightState) -> Inputs:
    """The inputs of a vehicle whose state is known exactly; it flies in air of its own density."""
    return Inputs(state, state, ZERO, True, 0.0, DENSITY_0)


class EstimationState(NamedTuple):
    """What estimation keeps from one step to the next."""

    time: float
    """Time of the step before [s]; negative before the first."""
    is_continuous: bool
    """Whether there was a step before on this leg."""
    p_n: Vec3
    """Position at the step before, NED [m]."""
    v_n: Vec3
    """Velocity over ground at the step before, NED [m/s]."""
    resets: PositionResets
    """The position resets that are being let in."""
    air: AirState
    """The estimate of wind, airspeed and vertical wind."""
    consistency: Consistency
    """What the autopilot reports but is doubted."""
    lead: float
    """Time by which the state was predicted at the step before [s]."""
    flow: FlowAngles
    """Angle of attack and sideslip by roll, pitch and body rates."""


class NavState(NamedTuple):
    """The state that the other stages use, and how well it is known."""

    state: FlightState
    """State of the vehicle at the time when the setpoint will act."""
    elapsed: float
    """Time since the step before [s]; without meaning at the first step."""
    is_first: bool
    """Whether there was no step before."""
    is_continuous: bool
    """Whether there was a step before on this leg."""
    p_n_before: Vec3
    """Position at that step, NED [m]."""
    v_n_before: Vec3
    """Velocity over ground at that step, NED [m/s]."""
    is_settled: bool
    """Whether the position is the measured one, and no position reset is being let in."""
    trusts_sensor: bool
    """Whether the airspeed is a measured one."""
    airspeed: float
    """Estimate of the true airspeed [m/s]."""
    airspeed_sigma: float
    """Standard deviation of that estimate [m/s]."""
    flow: FlowAngles
    """Angle of attack and sideslip by roll, pitch and body rates."""


@compiled
def fresh_estimation() -> EstimationState:
    """The state of estimation before the first step."""
    zero = (0.0, 0.0, 0.0)
    air, consistency, flow = fresh_air(), fresh_consistency(), fresh_flow()
    return EstimationState(-1.0, False, zero, zero, no_resets(), air, consistency, 0.0, flow)


@compiled
def known_state(state: FlightState, before: float) -> NavState:
    """A state that is known exactly; `before`: time of the step before [s], negative for none."""
    zero, elapsed = (0.0, 0.0, 0.0), state.time - before
    airspeed = state.airspeed
    return NavState(
        state, elapsed, before < 0.0, False, zero, zero, True, True, airspeed, 0.0, fresh_flow()
    )


@compiled
def update(
    inputs: Inputs, thrust: float, s: EstimationState, vehicle: Vehicle
) -> tuple[NavState, EstimationState]:
    """The state for the other stages, in the frame of the plan, and the next state of estimation.

    Args:
        inputs: predicted and measured state.
        thrust: thrust setpoint of the step before, 0 to 1.
        s: state of estimation at the step before.
        vehicle: its aircraft, and the true airspeed to fly.
    """
    unsmoothed, elapsed = inputs.predicted, inputs.predicted.time - s.time
    air, checked, flow = s.air, s.consistency, s.flow
    if not inputs.is_exact:
        checked = follow(inputs.measured, inputs.omega_b, thrust, checked, air, vehicle.aircraft)
        unsmoothed, air = sense(inputs, checked, thrust, air, vehicle)
        R_nb, omega_b, aircraft = inputs.measured.R_nb, inputs.omega_b, vehicle.aircraft
        flow = follow_flow(flow, R_nb, omega_b, unsmoothed.airspeed, aircraft, elapsed)
    dt, farther = (elapsed, inputs.lead - s.lead) if s.is_continuous else (0.0, 0.0)
    resets = follow_resets(s.resets, (s.p_n, s.v_n), unsmoothed, dt, farther)
    state = smoothed(unsmoothed, resets)
    nav = NavState(
        state,
        elapsed,
        s.time < 0.0,
        s.is_continuous,
        s.p_n,
        s.v_n,
        settled(resets),
        inputs.is_exact or air.sensor.trusted,
        air.estimate.x[AIRSPEED],
        sigma(air.estimate.P[AIRSPEED, AIRSPEED]),
        flow,
    )
    flown = state.p_n, state.v_n
    return nav, EstimationState(state.time, True, *flown, resets, air, checked, inputs.lead, flow)


@compiled
def sense(
    inputs: Inputs, checked: Consistency, thrust: float, air: AirState, vehicle: Vehicle
) -> tuple[FlightState, AirState]:
    """The state with airspeed and wind as they are used, and the estimate of the air.

    Args:
        inputs: predicted and measured state.
        checked: what is doubted of them.
        thrust: thrust setpoint of the step before, 0 to 1.
        air: estimate of the air at the step before.
        vehicle: its aircraft, and the airspeed to fly.
    """
    aircraft, gains, _ = vehicle
    air = fresh_air() if checked.was_misled else air
    air = feel_rise(as_flown(inputs.measured, checked), air, aircraft)
    predicted = as_flown(inputs.predicted, checked)
    return sense_air(predicted, air, thrust, aircraft, gains.airspeed)


@compiled
def step_time(nav: NavState) -> float:
    """Time since the step before, between SHORTEST_STEP and LONGEST_STEP [s]."""
    return FIRST_STEP if nav.is_first else min(max(nav.elapsed, SHORTEST_STEP), LONGEST_STEP)
