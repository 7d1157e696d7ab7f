"""The air that is flown in: what is told where it can be trusted, else what is estimated.

One call of `sense_air` for each step of guidance. It never raises a doubt by itself: what is not
a number counts as not told.
"""

import math

from vfguide.flight.air_state import (
    AIRSPEED,
    DOUBT,
    EAST,
    MODEL,
    NORTH,
    RISE,
    SAME,
    SIDE,
    THRUST,
    TIME,
    TOLD,
    TRUST,
    AirState,
    X,
    trusts_sensor,
)
from vfguide.flight.performance import Performance
from vfguide.flight.state import FlightState
from vfguide.flight.wind_estimate import (
    begin,
    feel_side,
    felt_force,
    flown,
    follow_model,
    predict,
    watch_sensor,
    watch_triangle,
    watch_wind,
)
from vfguide.geometry.compiled import compiled

GAP = 1.0
"""After a pause longer than this the estimate begins anew [s]."""
IMPLAUSIBLE = 7.0
"""A sensor this far from what pitch and thrust ask for is not flown on [m/s]."""
STILL = 0.02
FROZEN_TIME = 3.0
FROZEN = 1.0
"""One that has not moved by STILL [m/s] for FROZEN_TIME [s] has failed when it is FROZEN off [m/s].
The true airspeed of a number that stands still moves a little with the height; and in still air
without noise an aircraft in trim tells the same number for long."""
FAILED = 2.0
"""It has failed when it has been implausible for this long, ... [s]"""
RECOVERED = 5.0
"""... and works again when it has been plausible for this long [s]."""
SLOWEST = 1.2
"""Without a sensor the airspeed is kept above this times the slowest, and two deviations."""


@compiled
def sense_air(
    state: FlightState, air: AirState, aircraft: Performance, cruise: float
) -> tuple[FlightState, AirState]:
    """The state with the airspeed and the wind to fly on, and what is believed of the air.

    Args:
        state: airspeed and wind as they were told; not a number: not told.
        air: what was believed at the step before, with the thrust that was set then.
        aircraft: what flies.
        cruise: the airspeed that is flown to, the first guess where none is told [m/s].
    """
    air = air.copy()
    before, dt = air[TIME], state.time - air[TIME]
    told = state.airspeed
    if before < 0.0 or not 0.0 <= dt < GAP:
        speed = cruise if math.isnan(told) or told < 0.5 * cruise else told
        d_n = flown(state.R_nb, speed, aircraft.thrust_trim, 0.0, aircraft).d_n
        begin(air, state.time, state.v_n, speed, d_n)
        air[TRUST] = 0.0 if math.isnan(told) else 1.0
        dt = 1e-3
    elif dt > 0.0:
        force_n = felt_force(air, state.v_n, dt)
        feel_side(air, force_n, state.R_nb, dt)
        how = flown(state.R_nb, air[X + AIRSPEED], air[THRUST], air[SIDE], aircraft)
        follow_model(air, how, dt)
        predict(air, how, dt)
        watch_triangle(air, state.v_n, how.d_n, dt)
    air[TIME] = state.time
    doubt_sensor(air, told, dt)
    plausible = air[DOUBT] <= 0.0 and trusts_sensor(air)
    if plausible:
        watch_sensor(air, told, max(dt, 1e-3))
    wind_n = (air[X + NORTH], air[X + EAST], -air[RISE])
    if not math.isnan(state.wind_n[0]):
        wind_n = (state.wind_n[0], state.wind_n[1], -air[RISE])
        watch_wind(air, wind_n, max(dt, 1e-3))
    speed = told if plausible else air[X + AIRSPEED]
    return FlightState(state.time, state.p_n, state.v_n, state.R_nb, speed, wind_n), air


@compiled
def doubt_sensor(air: AirState, told: float, dt: float) -> None:
    """Judge what the sensor tells [m/s], and whether it is trusted."""
    air[SAME] += dt
    if not abs(told - air[TOLD]) < STILL:  # not-a-number too
        air[TOLD], air[SAME] = told, 0.0
    off = abs(told - air[MODEL])
    frozen = air[SAME] > FROZEN_TIME and off > FROZEN
    if off < IMPLAUSIBLE and not frozen:  # false for not-a-number
        air[DOUBT] = min(air[DOUBT], 0.0) - dt
    else:
        air[DOUBT] = max(air[DOUBT], 0.0) + dt
    if frozen or air[DOUBT] > FAILED:
        air[TRUST] = 0.0
    elif air[DOUBT] < -RECOVERED and air[SAME] < FROZEN_TIME:
        air[TRUST] = 1.0
