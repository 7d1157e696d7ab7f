"""The stage of control: body rates and thrust that fly a bank, load factor and path angle.

The attitude reference flies the air velocity's azimuth, so that the turn is coordinated; Lemma 4
of the paper leads the attitude to it, and the rates keep bank and load factor in their limits.

The rate law takes back only a small sideslip at once, and the load factor is computed without any.
A wrong wind or yaw looks like sideslip: if all of that were taken back, the aircraft would be yawed
into a real one, which a roll turns into angle of attack.
"""

from typing import NamedTuple

from vfguide.aircraft.command import GuidanceCommand
from vfguide.aircraft.coordinated_turn import attitude_for_lift, attitude_rate_for_lift
from vfguide.aircraft.flight_model import flight_direction, sideslip_about_vertical
from vfguide.aircraft.performance import Gains, alpha_of_load, nonzero_airspeed
from vfguide.aircraft.state import FlightState, RateSetpoint
from vfguide.aircraft.vehicle import Vehicle
from vfguide.control.airspeed_control import integrate_error, thrust_for
from vfguide.control.envelope_protection import load_of, within_envelope
from vfguide.estimation.estimation import SHORTEST_STEP, NavState, step_time
from vfguide.field.rate_law import rate_law
from vfguide.geometry.blending import low_pass_share
from vfguide.geometry.so3 import IDENTITY, from_euler, log, rot_z, to_quaternion
from vfguide.geometry.units import DEG
from vfguide.geometry.vector import Mat3, Vec3, add, matmul, matvec, norm, scale, sub, transpose
from vfguide.geometry.velocity import azimuth_of, path_of
from vfguide.kernels.compiled import compiled

MAX_REFERENCE_RATE = 1.5
"""Largest angular velocity of the reference attitude that is fed forward [rad/s]; chosen, so that a
jump of the reference is not."""
MOST_SIDESLIP_ASKED = 4.0 * DEG
"""Largest sideslip that the rate law takes back at once [rad]; chosen with `tools/measure_lies.py`:
with 10 degrees, three times as many sequences leave the limits of the load factor."""
ALPHA_BIAS_MAX = 0.05
"""Largest learned correction of the angle of attack [rad]; chosen, 2.9 degrees."""


class ControlState(NamedTuple):
    """What control keeps from one step to the next."""

    R_na: Mat3
    """Reference attitude of the last step, to NED."""
    omega_a: Vec3
    """Its angular velocity in its own axes, smoothed [rad/s]."""
    thrust_integral: float
    """Integral of the airspeed error, as thrust setpoint."""
    alpha_bias: float
    """Learned correction of the angle of attack [rad]."""


class Reference(NamedTuple):
    """The reference attitude, and two of the angles that make it."""

    R_na: Mat3
    """To NED."""
    alpha: float
    """Angle of attack [rad]."""
    elevation: float
    """Elevation of the air velocity that it asks for [rad]."""


@compiled
def fresh_control() -> ControlState:
    """The state of control before the first step."""
    return ControlState(IDENTITY, (0.0, 0.0, 0.0), 0.0, 0.0)


@compiled
def update(
    nav: NavState, command: GuidanceCommand, s: ControlState, vehicle: Vehicle
) -> tuple[RateSetpoint, ControlState]:
    """Body rates and thrust that fly a command, before the last limits, and the next state.

    The reference attitude has the elevation gamma + k_elevation (gamma - path angle), the command's
    bank about it, and alpha = alpha_zero + alpha_load n / V^2 + the learned correction. Omega is
    that of Lemma 4 (`rate_law`) towards this reference; where it would take back more sideslip than
    MOST_SIDESLIP_ASKED, the reference is turned about the vertical by the rest.
    """
    if vehicle.is_rigid_body:
        return point_nose(nav, command, s, vehicle)
    state, (aircraft, gains, _) = nav.state, vehicle
    air, dt = sub(state.v_n, state.wind_n), step_time(nav)
    speed = nonzero_airspeed(state.airspeed, aircraft)
    climbing = command.gamma - path_of(air, speed)
    alpha_bias = learn_alpha(s.alpha_bias, climbing, gains, dt)
    reference = reference_of(state, command, alpha_bias, vehicle)
    R_na, alpha, _ = reference
    omega_a = (0.0, 0.0, 0.0)
    if command.rates.are_known:
        omega_a = commanded_rate(command, reference, speed, vehicle)
    elif not nav.is_first:
        omega_a = reference_rate(s, R_na, gains.smoothing, dt)
    sideslip = sideslip_about_vertical(air, flight_direction(state.R_nb, alpha, 0.0))
    beyond = sideslip - max(-MOST_SIDESLIP_ASKED, min(MOST_SIDESLIP_ASKED, sideslip))
    omega = rate_law(state.R_nb, matmul(rot_z(-beyond), R_na), omega_a, gains.k_w)
    load = load_of(state.R_nb, matvec(rot_z(-sideslip), air), speed, aircraft)
    omega = within_envelope(omega, state.R_nb, load, nav.flow, speed, gains.bank_max, aircraft)

    error = gains.airspeed - state.airspeed
    thrust = thrust_for(aircraft, error, command.climb, command.load, s.thrust_integral)
    integral = integrate_error(aircraft, error, thrust, s.thrust_integral, dt)
    setpoint = RateSetpoint(omega, thrust, to_quaternion(R_na))
    return setpoint, ControlState(R_na, omega_a, integral, alpha_bias)


@compiled
def reference_of(
    state: FlightState, command: GuidanceCommand, alpha_bias: float, vehicle: Vehicle
) -> Reference:
    """The reference attitude of a command; `alpha_bias` corrects the angle of attack [rad]."""
    aircraft, gains, _ = vehicle
    air, speed = sub(state.v_n, state.wind_n), nonzero_airspeed(state.airspeed, aircraft)
    alpha = alpha_of_load(command.load, speed, aircraft) + alpha_bias
    elevation = command.gamma + gains.k_elevation * (command.gamma - path_of(air, speed))
    R_na = attitude_for_lift(azimuth_of(air), elevation, command.bank, alpha)
    return Reference(R_na, alpha, elevation)


@compiled
def point_nose(
    nav: NavState, command: GuidanceCommand, s: ControlState, vehicle: Vehicle
) -> tuple[RateSetpoint, ControlState]:
    """Body rates for the paper's rigid body: R_na = Rz(azimuth) Ry(gamma) Rx(bank), no thrust.

    An aeroplane turns because its lift is tilted; this body flies where its nose points. It is
    banked only as the aeroplane would be.
    """
    gains = vehicle.gains
    R_na = from_euler(command.bank, command.gamma, command.azimuth)
    omega_a = (0.0, 0.0, 0.0)
    if not nav.is_first:
        omega_a = reference_rate(s, R_na, gains.smoothing, max(nav.elapsed, SHORTEST_STEP))
    omega = rate_law(nav.state.R_nb, R_na, omega_a, gains.k_w)
    setpoint = RateSetpoint(omega, 0.0, to_quaternion(R_na))
    return setpoint, ControlState(R_na, omega_a, s.thrust_integral, s.alpha_bias)


@compiled
def learn_alpha(bias: float, error: float, gains: Gains, dt: float) -> float:
    """Next correction of the angle of attack [rad] from the error of the path angle [rad].

    `bias` is the present one [rad], `dt` the time step [s].
    """
    return max(-ALPHA_BIAS_MAX, min(ALPHA_BIAS_MAX, bias + gains.k_alpha * error * dt))


@compiled
def reference_rate(s: ControlState, R_na: Mat3, smoothing: float, dt: float) -> Vec3:
    """Angular velocity of the reference attitude in its own axes, smoothed [rad/s].

    `smoothing` is the time constant, `dt` the time since the last reference attitude [s].
    """
    turned = limited(scale(1.0 / dt, log(matmul(transpose(s.R_na), R_na))))
    return add(s.omega_a, scale(low_pass_share(smoothing, dt), sub(turned, s.omega_a)))


@compiled
def commanded_rate(
    command: GuidanceCommand, reference: Reference, speed: float, vehicle: Vehicle
) -> Vec3:
    """Angular velocity of the reference attitude in its own axes by the command's rates [rad/s].

    The learned correction of the angle of attack counts as constant. At most MAX_REFERENCE_RATE.

    Args:
        command: the command; its rates are known.
        reference: its reference attitude.
        speed: true airspeed [m/s].
        vehicle: its aircraft and gains.
    """
    rates, (aircraft, gains, _) = command.rates, vehicle
    climbing = rates.gamma + gains.k_elevation * (rates.gamma - rates.path)
    pitching = alpha_of_load(rates.load, speed, aircraft) - aircraft.alpha_zero
    turning = (rates.bank, climbing, rates.azimuth)
    _, alpha, elevation = reference
    return limited(attitude_rate_for_lift(elevation, command.bank, alpha, turning, pitching))


@compiled
def limited(omega_a: Vec3) -> Vec3:
    """An angular velocity [rad/s], at most MAX_REFERENCE_RATE."""
    size = norm(omega_a)
    return scale(MAX_REFERENCE_RATE / size, omega_a) if size > MAX_REFERENCE_RATE else omega_a
