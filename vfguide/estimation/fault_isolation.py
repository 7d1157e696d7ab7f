"""Fault isolation: whether yaw, wind or airspeed is wrong, where the wind triangle does not close.

Two of its sides and an angle are measured one by one, so each fault shows in its own way: a wrong
yaw in the direction alone, a wrong wind or airspeed in the length. Of these two the one is wrong
that is farther from what pitch and thrust ask for.

Gertler, Fault Detection and Diagnosis in Engineering Systems, 1998: structured residuals.
"""

import math

from vfguide.aircraft.flight_model import flight_direction
from vfguide.aircraft.performance import Performance, alpha_of_load, nonzero_airspeed
from vfguide.aircraft.state import FlightState
from vfguide.estimation.air_check import (
    LASTING_ERROR,
    AirCheck,
    Triangle,
    doubting_airspeed,
    doubting_wind,
    follow_airspeed_doubt,
    follow_wind_doubt,
    has_jumped,
    is_wrong,
    sideslip_limit,
    sideslip_of,
    smoothed_triangle,
    triangle,
    with_smoothed_slip,
)
from vfguide.estimation.air_state import AirState
from vfguide.estimation.attitude_check import AttitudeCheck, turned_by, uncorrected, with_slip
from vfguide.geometry.vector import sub
from vfguide.kernels.compiled import compiled


@compiled
def check_air(
    state: FlightState,
    m: FlightState,
    attitude: AttitudeCheck,
    s: AirCheck,
    air: AirState,
    aircraft: Performance,
    dt: float,
) -> tuple[AttitudeCheck, AirCheck]:
    """The checks of yaw, wind and airspeed by the wind triangle, `dt` [s] later.

    Args:
        state: the state that is believed.
        m: the measured state.
        attitude: check of the attitude.
        s: check of the air at the step before.
        air: estimate of the air at the step before.
        aircraft: its angle of attack.
        dt: time step [s].
    """
    speed = nonzero_airspeed(state.airspeed, aircraft)
    alpha = alpha_of_load(1.0, speed, aircraft)
    nose_n = flight_direction(state.R_nb, alpha, 0.0)
    seen = triangle(sub(state.v_n, state.wind_n), nose_n, state.airspeed)
    attitude = with_slip(attitude, seen.sideslip, dt)
    if math.isnan(m.wind_n[0]):
        return attitude, s
    if s.wind_doubt > 0.0:
        return attitude, follow_wind_doubt(s, m.wind_n, state.wind_n, dt)
    if has_jumped(s, m.wind_n):
        return attitude, doubting_wind(s, dt)
    return judged(attitude, smoothed_triangle(s, seen, m.wind_n, dt), seen, state, m, air, dt)


@compiled
def judged(
    attitude: AttitudeCheck,
    s: AirCheck,
    seen: Triangle,
    state: FlightState,
    m: FlightState,
    air: AirState,
    dt: float,
) -> tuple[AttitudeCheck, AirCheck]:
    """The checks after the wind triangle `seen` with a wind that is believed.

    A wrong length is not a fault of the yaw; a wrong direction is, as long as the length stays
    right in turns. The other arguments are those of `check_air`.
    """
    if attitude.is_by_wind and abs(s.excess) > LASTING_ERROR:
        return uncorrected(attitude), doubting_wind(s, dt)
    if is_wrong(s):
        return attitude, blamed(s, m.airspeed, state.airspeed, air, dt)
    s = follow_airspeed_doubt(s, seen.excess + state.airspeed - m.airspeed, dt)
    slip = sideslip_of(s)
    if abs(slip) > sideslip_limit(state.airspeed):
        return turned_by(attitude, slip), with_smoothed_slip(s, 1.0, 0.0)
    return attitude, s


@compiled
def blamed(s: AirCheck, measured: float, airspeed: float, air: AirState, dt: float) -> AirCheck:
    """The check after a wind triangle of the wrong length, at a step of `dt` [s].

    Either the `measured` airspeed or the reported wind is wrong. The airspeed by each is compared
    with the one that pitch and thrust ask for, and the one that is farther from it is doubted.
    `airspeed` is the one that is believed so far [m/s].
    """
    model = air.sensor.model_airspeed
    by_wind = airspeed + (s.lasting if abs(s.lasting) > abs(s.excess) else s.excess)
    points_ahead = abs(sideslip_of(s)) < sideslip_limit(airspeed)
    is_told = s.airspeed_doubt == 0.0 and not math.isnan(measured)
    if points_ahead and is_told and abs(measured - model) > abs(by_wind - model):
        return doubting_airspeed(s, dt)
    return doubting_wind(s, dt)
