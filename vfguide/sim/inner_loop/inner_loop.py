"""The inner loop of the software autopilot: body rates and thrust to servos and motor."""

from vfguide.geometry.vector import Vec3
from vfguide.kernels.compiled import compiled
from vfguide.sim.inner_loop.rate_loop import RateTable, rate_loop
from vfguide.sim.inner_loop.thrust_map import Axes, AxesTuple, Throttles, throttle_for
from vfguide.sim.signals import ControlTuple, Inner, InnerTuple

Tables = tuple[RateTable, Throttles, AxesTuple]
"""The airframe as the loop knows it: the table of `rate_loop`, then those of `throttle_for`."""


@compiled
def inner_loop(
    tables: Tables,
    inner: InnerTuple,
    setpoint: tuple[float, float, float, float],
    memory: Vec3,
    dt: float,
) -> tuple[ControlTuple, Vec3]:
    """Controls for body rates p, q, r [rad/s] and thrust (0 to 1), and the next memory.

    `memory` is that of `rate_loop`, zero at first; `dt` is the time step [s].
    """
    rates, throttles, axes = tables
    p, q, r, thrust = setpoint
    measured = Inner(*inner)
    surfaces, memory = rate_loop(rates, measured, (p, q, r), memory, dt)
    throttle = throttle_for(throttles, Axes(*axes), thrust, measured.airspeed)
    return (*surfaces, throttle), memory
