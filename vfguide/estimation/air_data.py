"""Air data: measured airspeed and wind where they can be trusted, else estimated ones.

`sense_air` is called once a step. A value that is not a number counts as not measured.
"""

import math

from vfguide.aircraft.flight_model import modelled_flight, smoothed_side_force, specific_force
from vfguide.aircraft.performance import Performance
from vfguide.aircraft.state import FlightState
from vfguide.estimation.air_state import AIRSPEED, EAST, NORTH, AirState, SensorWatch, VerticalWind
from vfguide.estimation.wind_filter import (
    copied,
    first_estimate,
    fuse_airspeed,
    fuse_ground_velocity,
    fuse_wind,
    model_airspeed,
    time_update,
)
from vfguide.kernels.compiled import compiled
from vfguide.kernels.rows import replacing

RESTART_PAUSE = 1.0
"""Time without a step after which the estimate starts anew [s]; chosen."""
LEAST_DURATION = 1e-3
"""Shortest time that a measurement stands for, also the first one [s]; chosen: noise is given per
second."""
IMPLAUSIBLE_ERROR = 7.0
"""Difference of the airspeed sensor from the airspeed that pitch and thrust ask for above which it
is not used [m/s]; chosen above the errors of the model in turbulence."""
STILL_CHANGE = 0.02
"""Change of the measured airspeed below which it counts as unchanged [m/s]; chosen: where the
calibrated airspeed is frozen, the true one still changes a little with height."""
STUCK_TIME = 3.0
"""Time without change after which an airspeed sensor may be stuck [s]; chosen. In still air without
noise an aircraft in trim reads the same for long."""
STUCK_ERROR = 1.0
"""Difference from the airspeed that pitch and thrust ask for above which a sensor without change
has failed [m/s]; chosen."""
FAILURE_TIME = 2.0
"""Time of implausible measurements after which the sensor has failed [s]; chosen."""
RECOVERY_TIME = 5.0
"""Time of plausible measurements after which the sensor is used again [s]; chosen."""
with_estimate = replacing(AirState, "estimate", "sensor")
with_step = replacing(AirState, "time", "estimate", "v_n", "side_force", "sensor")
with_model_airspeed = replacing(SensorWatch, "model_airspeed")


@compiled
def sense_air(
    state: FlightState, air: AirState, thrust: float, aircraft: Performance, cruise: float
) -> tuple[FlightState, AirState]:
    """The state with the airspeed and the wind to use, and the estimate of the air.

    Args:
        state: the state with measured airspeed and wind; not a number where not measured.
        air: estimate of the step before.
        thrust: thrust setpoint of the step before, 0 to 1.
        aircraft: its lift and drag.
        cruise: airspeed to fly, the first guess where none is measured [m/s].
    """
    dt = state.time - air.time
    if air.time < 0.0 or not 0.0 <= dt < RESTART_PAUSE:
        air, dt = first_air(state, aircraft, cruise), LEAST_DURATION
    elif dt > 0.0:
        air = moved_on(state, air, thrust, aircraft, dt)
    else:
        air = with_estimate(air, copied(air.estimate), air.sensor)
    return fused(state, air, dt)


@compiled
def first_air(state: FlightState, aircraft: Performance, cruise: float) -> AirState:
    """The first estimate of the air, from one state; `cruise` [m/s] as for `sense_air`."""
    measured = state.airspeed
    airspeed = cruise if math.isnan(measured) or measured < 0.5 * cruise else measured
    flight = modelled_flight(state.R_nb, airspeed, aircraft.thrust_trim, 0.0, aircraft)
    estimate = first_estimate(state.v_n, airspeed, flight.d_n)
    sensor = SensorWatch(airspeed, 0.0, 0.0, 0.0, not math.isnan(measured))
    vertical = VerticalWind(0.0, state.v_n, 0.0)
    return AirState(state.time, estimate, state.v_n, 0.0, sensor, vertical)


@compiled
def moved_on(
    state: FlightState, air: AirState, thrust: float, aircraft: Performance, dt: float
) -> AirState:
    """The estimate `dt` [s] later, from attitude and velocity over ground alone."""
    before, R_nb = air.estimate, state.R_nb
    force_n = specific_force(air.v_n, state.v_n, dt)
    side_force = smoothed_side_force(air.side_force, force_n, R_nb, dt)
    flight = modelled_flight(R_nb, before.x[AIRSPEED], thrust, side_force, aircraft)
    model = model_airspeed(air.sensor.model_airspeed, before, flight, dt)
    estimate = time_update(before, flight, dt)
    fuse_ground_velocity(estimate, state.v_n, flight.d_n, dt)
    sensor = with_model_airspeed(air.sensor, model)
    return with_step(air, state.time, estimate, state.v_n, side_force, sensor)


@compiled
def fused(state: FlightState, air: AirState, dt: float) -> tuple[FlightState, AirState]:
    """The state and the estimate after the airspeed sensor and the autopilot's wind are fused."""
    sensor, estimate = watched(air.sensor, state.airspeed, dt), air.estimate
    plausible = sensor.fault_time <= 0.0 and sensor.trusted
    if plausible:
        fuse_airspeed(estimate, state.airspeed, max(dt, LEAST_DURATION))
    wind_n = (estimate.x[NORTH], estimate.x[EAST], -air.vertical.rise)
    if not math.isnan(state.wind_n[0]):
        wind_n = (state.wind_n[0], state.wind_n[1], -air.vertical.rise)
        fuse_wind(estimate, wind_n, max(dt, LEAST_DURATION))
    speed = state.airspeed if plausible else estimate.x[AIRSPEED]
    flown_on = FlightState(state.time, state.p_n, state.v_n, state.R_nb, speed, wind_n)
    return flown_on, with_estimate(air, estimate, sensor)


@compiled
def watched(sensor: SensorWatch, measured: float, dt: float) -> SensorWatch:
    """The watch over the sensor `dt` [s] later, with the measured airspeed [m/s].

    An airspeed that is not a number counts as implausible.
    """
    last, stuck_time = sensor.measured, sensor.stuck_time + dt
    if not abs(measured - last) < STILL_CHANGE:  # not-a-number too
        last, stuck_time = measured, 0.0
    off = abs(measured - sensor.model_airspeed)
    stuck = stuck_time > STUCK_TIME and off > STUCK_ERROR
    if off < IMPLAUSIBLE_ERROR and not stuck:  # false for not-a-number
        fault_time = min(sensor.fault_time, 0.0) - dt
    else:
        fault_time = max(sensor.fault_time, 0.0) + dt
    trusted = sensor.trusted
    if stuck or fault_time > FAILURE_TIME:
        trusted = False
    elif fault_time < -RECOVERY_TIME and stuck_time < STUCK_TIME:
        trusted = True
    return SensorWatch(sensor.model_airspeed, last, stuck_time, fault_time, trusted)
