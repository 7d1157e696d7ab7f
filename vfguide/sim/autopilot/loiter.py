"""What the software autopilot flies by itself: level circles.

It flies them with the stages of the companion's loop, without estimation, mission and assurance.
"""

import math
from typing import NamedTuple

from vfguide.aircraft.performance import Gains, Performance, turn_length
from vfguide.aircraft.state import FlightState, RateSetpoint
from vfguide.aircraft.vehicle import Vehicle
from vfguide.control import control, limits
from vfguide.control.control import ControlState, fresh_control
from vfguide.estimation.estimation import known_state
from vfguide.geometry.compiled import compiled
from vfguide.geometry.geodesy import TangentPlane, geodetic_to_ned, tangent_plane
from vfguide.geometry.so3 import from_euler
from vfguide.guidance import flight_law
from vfguide.guidance.guidance_state import GuidanceState, fresh_guidance
from vfguide.planning import planning
from vfguide.planning.objective import GuidanceTarget, objective_at
from vfguide.planning.route import Route, fresh_route
from vfguide.sim.autopilot.estimate import Estimate, Origin

HOLD_RADIUS = 1.57
"""Radius of the circle of a hold [turn lengths]; chosen, 100 m at 25 m/s. Wind and bank may make it
larger. On PX4 the operator sets NAV_LOITER_RAD for his aircraft."""


class LoiterState(NamedTuple):
    """What one step of the hold leaves for the next."""

    time: float
    """Of the step before [s]; negative before the first."""
    route: Route
    guidance: GuidanceState
    control: ControlState


@compiled
def fresh_loiter() -> LoiterState:
    """Nothing is flown yet."""
    return LoiterState(-1.0, fresh_route(), fresh_guidance(), fresh_control())


@compiled
def step_loiter(
    state: FlightState, target: GuidanceTarget, vehicle: Vehicle, s: LoiterState
) -> tuple[RateSetpoint, LoiterState]:
    """Body rates and thrust that fly the circle of a target."""
    nav, goal = known_state(state, s.time), objective_at(target, state)
    route = planning.update(nav, goal, None, True, s.route, s.guidance.slope, vehicle)
    command, guidance = flight_law.update(nav, goal, route, None, s.guidance, vehicle)
    asked, controlled = control.update(nav, command, s.control, vehicle)
    return limits.apply(asked, vehicle), LoiterState(state.time, route, guidance, controlled)


class Loiter:
    """A level right-hand circle."""

    def __init__(self, aircraft: Performance, airspeed: float) -> None:
        """A hold for `aircraft` at the true `airspeed` [m/s]."""
        self._vehicle = Vehicle(aircraft, Gains(airspeed))
        self._plane: TangentPlane = tangent_plane(0.0, 0.0, 0.0)
        self._radius = HOLD_RADIUS * turn_length(airspeed)
        self._target = GuidanceTarget((0.0, 0.0, 0.0), 0.0, 0.0, 1.0, self._radius)
        self._state: LoiterState = fresh_loiter()

    def start_here(self, estimate: Estimate) -> None:
        """Turn off the present path to the right, at this height."""
        north, east, _ = estimate.v_n
        place = (estimate.latitude, estimate.longitude, estimate.altitude)
        self._begin(place, (0.0, 0.0, 0.0), math.atan2(east, north))

    def begin_about(self, origin: Origin) -> None:
        """Fly to a circle about `origin`, at its height."""
        self._begin(
            (origin.latitude, origin.longitude, origin.altitude), (0.0, -self._radius, 0.0), 0.0
        )

    def _begin(
        self,
        place: tuple[float, float, float],
        p_n: tuple[float, float, float],
        course: float,
    ) -> None:
        self._plane = tangent_plane(*place)
        self._target = GuidanceTarget(p_n, course, 0.0, 1.0, self._radius)
        self._state = fresh_loiter()

    def step(self, estimate: Estimate) -> RateSetpoint:
        """Body rates and thrust for the next while."""
        p_n = geodetic_to_ned(self._plane, estimate.latitude, estimate.longitude, estimate.altitude)
        state = FlightState(
            estimate.time,
            p_n,
            estimate.v_n,
            from_euler(*estimate.euler),
            estimate.true_airspeed,
            estimate.wind_n,
        )
        setpoint, self._state = step_loiter(state, self._target, self._vehicle, self._state)
        return setpoint
