"""What the software autopilot flies by itself: level right-hand circles.

Directional guidance gives the bank, energy control pitch and thrust, attitude control turns these
into body rates. None of them is shared with the companion: its faults would not show against an
autopilot that had them too.
"""

import math
from typing import NamedTuple

from vfguide.aircraft.air_density import in_air
from vfguide.aircraft.performance import Performance
from vfguide.earth.atmosphere import isa_density
from vfguide.earth.geodesy import geodetic_to_ned, tangent_plane
from vfguide.geometry.units import G0
from vfguide.geometry.vector import Vec3
from vfguide.kernels.compiled import compiled
from vfguide.sim.autopilot.attitude_control import rates_for_attitude, within_limits
from vfguide.sim.autopilot.directional_guidance import lateral_acceleration
from vfguide.sim.autopilot.energy_control import (
    EnergyState,
    Longitudinal,
    fresh_energy,
    pitch_and_thrust,
)
from vfguide.sim.autopilot.estimate import Estimate, Origin
from vfguide.sim.autopilot.loiter_circle import Circle, largest_bank, radius_in

RADIUS_TIME = 60.0
"""Time constant with which the radius follows the wind [s]; chosen, since gusts would swing the
circle."""
HOLD_STEP_MAX = 0.1
"""Largest time step of integrals and radius [s]; chosen."""


class LoiterState(NamedTuple):
    """What one step of the hold leaves for the next."""

    time: float
    """Time of the step before [s]; negative before the first."""
    radius: float
    """Radius of the circle [m]."""
    energy: EnergyState
    """Integrals of energy control."""


@compiled
def fresh_loiter(radius: float) -> LoiterState:
    """The state before the first step on a circle of this radius [m]."""
    return LoiterState(-1.0, radius, fresh_energy())


@compiled
def wanted_bank(
    estimate: Estimate, circle: Circle, radius: float, airspeed: float, aircraft: Performance
) -> float:
    """Bank that leads clockwise round a circle of a radius [m], at an airspeed [m/s], in [rad]."""
    p_n = geodetic_to_ned(circle.plane, estimate.latitude, estimate.longitude, estimate.altitude)
    (north, east, _), (wind_north, wind_east, _) = estimate.v_n, estimate.wind_n
    place = (p_n[0] - circle.north, p_n[1] - circle.east)
    lateral = lateral_acceleration(place, (north, east), (wind_north, wind_east), airspeed, radius)
    most = largest_bank(aircraft, airspeed)
    return max(-most, min(most, math.atan(lateral / G0)))


@compiled
def step_loiter(
    estimate: Estimate, circle: Circle, aircraft: Performance, s: LoiterState
) -> tuple[Vec3, float, LoiterState]:
    """Body rates, FRD [rad/s], and thrust (0 to 1) that fly a circle, and the next state.

    `aircraft` is the one at sea-level density.
    """
    aircraft = in_air(aircraft, isa_density(estimate.altitude), circle.airspeed)
    airspeed = max(estimate.true_airspeed, 0.5 * aircraft.airspeed_min)
    now = Longitudinal(
        circle.plane.alt - estimate.altitude,
        circle.airspeed - estimate.true_airspeed,
        airspeed,
        -estimate.v_n[2] / airspeed,
        estimate.euler[0],
    )
    dt = 0.0 if s.time < 0.0 else max(0.0, min(estimate.time - s.time, HOLD_STEP_MAX))
    fits = radius_in(estimate.wind_n, circle.airspeed, aircraft)
    radius = s.radius + dt / RADIUS_TIME * (fits - s.radius)
    roll = wanted_bank(estimate, circle, radius, airspeed, aircraft)
    pitch, thrust, energy = pitch_and_thrust(now, s.energy, aircraft, dt)
    omega_b = rates_for_attitude(roll, pitch, estimate.euler, airspeed)
    omega_b = within_limits(omega_b, estimate.euler, airspeed, aircraft)
    return omega_b, thrust, LoiterState(estimate.time, radius, energy)


class Loiter:
    """A level right-hand circle."""

    def __init__(self, aircraft: Performance, airspeed: float, estimate: Estimate) -> None:
        """A hold for `aircraft`, as at sea level, at the true `airspeed` [m/s], begun at once."""
        self._aircraft = aircraft
        self._airspeed = airspeed
        self._circle: Circle
        self._state: LoiterState
        self.start_here(estimate)

    def start_here(self, estimate: Estimate) -> None:
        """Turn off the present path to the right, at this height."""
        radius = self._radius(estimate)
        north, east, _ = estimate.v_n
        course = math.atan2(east, north)
        here = tangent_plane(estimate.latitude, estimate.longitude, estimate.altitude)
        beside = (-radius * math.sin(course), radius * math.cos(course))
        self._circle = Circle(here, *beside, self._airspeed)
        self._state = fresh_loiter(radius)

    def begin_about(self, origin: Origin, estimate: Estimate) -> None:
        """Fly to a circle about `origin`, at its height."""
        self._circle = Circle(tangent_plane(*origin), 0.0, 0.0, self._airspeed)
        self._state = fresh_loiter(self._radius(estimate))

    def step(self, estimate: Estimate) -> tuple[Vec3, float]:
        """Body rates, FRD [rad/s], and thrust (0 to 1) until the next step."""
        omega_b, thrust, self._state = step_loiter(
            estimate, self._circle, self._aircraft, self._state
        )
        return omega_b, thrust

    def _radius(self, estimate: Estimate) -> float:
        here = in_air(self._aircraft, isa_density(estimate.altitude), self._airspeed)
        return radius_in(estimate.wind_n, self._airspeed, here)
