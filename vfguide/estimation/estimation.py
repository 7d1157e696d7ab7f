"""The stage of estimation: from what the autopilot told to the state that is flown on.

Air that rises is felt, wind and airspeed are filtered, and jumps of the position are let in
slowly.
"""

from typing import NamedTuple

from vfguide.aircraft.state import FlightState
from vfguide.aircraft.vehicle import Vehicle
from vfguide.estimation.air_data import sense_air
from vfguide.estimation.air_state import AIRSPEED, AirState, fresh_air, sigma
from vfguide.estimation.position_resets import (
    PositionResets,
    follow_resets,
    no_resets,
    settled,
    smoothed,
)
from vfguide.estimation.vertical_wind import feel_rise
from vfguide.geometry.compiled import compiled
from vfguide.geometry.vector import Vec3

FIRST_STEP = 0.02
"""The time step that the first step counts as [s]."""
SHORTEST_STEP, LONGEST_STEP = 1e-3, 0.2
"""Bounds of the time between two steps that filters and rate limits take [s]."""


class Inputs(NamedTuple):
    """What one step is made for."""

    predicted: FlightState
    """When the setpoint will act, in the frame of the plan."""
    measured: FlightState
    """At the time of the attitude, in the same frame; airspeed and wind that are not told are no
    numbers."""
    is_exact: bool
    """Whether the predicted state is known exactly, as of a kinematic body."""


class EstimationState(NamedTuple):
    """What one step leaves for the next."""

    time: float
    """Of the step before [s]; negative before the first."""
    is_continuous: bool
    """Whether there was a step before on this leg, from here:"""
    p_n: Vec3
    v_n: Vec3
    """Position [m] and velocity over ground [m/s] at the step before, NED."""
    resets: PositionResets
    air: AirState


class NavState(NamedTuple):
    """What the loop knows at one step."""

    state: FlightState
    """Of the vehicle, when the setpoint will act."""
    elapsed: float
    """Time since the step before [s]; means nothing at the first."""
    is_first: bool
    """Whether there was no step before."""
    is_continuous: bool
    """Whether there was one on this leg, from here:"""
    p_n_before: Vec3
    v_n_before: Vec3
    """Position [m] and velocity over ground [m/s] then, NED."""
    is_settled: bool
    """Whether the position is the one that is told: no jump is being let in."""
    trusts_sensor: bool
    """Whether the airspeed is a measured one."""
    airspeed: float
    airspeed_sigma: float
    """The estimate of the true airspeed and its standard deviation [m/s]."""


@compiled
def fresh_estimation() -> EstimationState:
    """Nothing is known yet."""
    zero = (0.0, 0.0, 0.0)
    return EstimationState(-1.0, False, zero, zero, no_resets(), fresh_air())


@compiled
def known_state(state: FlightState, before: float) -> NavState:
    """A state that is known exactly; `before` is the time of the step before, negative for none."""
    zero, elapsed = (0.0, 0.0, 0.0), state.time - before
    airspeed = state.airspeed
    return NavState(state, elapsed, before < 0.0, False, zero, zero, True, True, airspeed, 0.0)


@compiled
def update(
    inputs: Inputs, thrust: float, s: EstimationState, vehicle: Vehicle
) -> tuple[NavState, EstimationState]:
    """The state to fly on.

    Args:
        inputs: what was told.
        thrust: setpoint of the step before, 0 to 1.
        s: what the step before left.
        vehicle: its aircraft, and the airspeed to fly.
    """
    told, air = inputs.predicted, s.air
    if not inputs.is_exact:
        told, air = sense(inputs, thrust, air, vehicle)
    elapsed = told.time - s.time
    resets = follow_resets(s.resets, (s.p_n, s.v_n), told, elapsed if s.is_continuous else 0.0)
    state = smoothed(told, resets)
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
        sigma(air.estimate, AIRSPEED),
    )
    return nav, EstimationState(state.time, True, state.p_n, state.v_n, resets, air)


@compiled
def sense(
    inputs: Inputs, thrust: float, air: AirState, vehicle: Vehicle
) -> tuple[FlightState, AirState]:
    """The state with airspeed and wind, and what is believed of the air."""
    aircraft, gains, _ = vehicle
    air = feel_rise(inputs.measured, air, aircraft)
    return sense_air(inputs.predicted, air, thrust, aircraft, gains.airspeed)


@compiled
def step_time(nav: NavState) -> float:
    """Time since the step before, bounded [s]."""
    return FIRST_STEP if nav.is_first else min(max(nav.elapsed, SHORTEST_STEP), LONGEST_STEP)
