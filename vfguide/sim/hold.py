"""What the software autopilot flies by itself: level circles."""

import math

from vfguide.flight.memory import Memory, Target, fresh_memory
from vfguide.flight.performance import Gains, Performance, packed, turn_length
from vfguide.flight.state import FlightState, RateSetpoint
from vfguide.geometry.geodesy import TangentPlane, geodetic_to_ned, tangent_plane
from vfguide.geometry.so3 import from_euler
from vfguide.safety.limits import guide_within_limits
from vfguide.sim.estimate import Estimate, Origin

RADIUS = 1.57
"""Of the circle, in turn lengths: 100 m at 25 m/s; more where wind and bank ask for it. On PX4
the operator sets NAV_LOITER_RAD for his aircraft."""


class Hold:
    """A level right-hand circle."""

    def __init__(self, aircraft: Performance, airspeed: float) -> None:
        """A hold for `aircraft` at the true `airspeed` [m/s]."""
        self._law = packed(aircraft, Gains(airspeed))
        self._plane: TangentPlane = tangent_plane(0.0, 0.0, 0.0)
        self._radius = RADIUS * turn_length(airspeed)
        self._target = Target((0.0, 0.0, 0.0), 0.0, 0.0, 1.0, self._radius)
        self._memory: Memory = fresh_memory()

    def begin_here(self, estimate: Estimate) -> None:
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
        self._target = Target(p_n, course, 0.0, 1.0, self._radius)
        self._memory = fresh_memory()

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
        wanted, self._memory, _ = guide_within_limits(state, self._target, self._law, self._memory)
        return wanted
