"""The setpoints that go out: how many, when the last one did, and what follows where none can."""

import math

from vfguide.aircraft.state import RateSetpoint
from vfguide.autopilots.autopilot import Autopilot
from vfguide.companion.plan import Plan
from vfguide.control.coasting import coast
from vfguide.control.limits import limit_rates
from vfguide.earth.atmosphere import DENSITY_0, isa_density
from vfguide.geometry.units import US
from vfguide.link.messages import SetAttitudeTarget
from vfguide.telemetry.knowledge import Knowledge

COAST_AFTER = 0.2
"""Time without a new attitude after which a coordinated turn is flown [s]; chosen, a roll at 60
degrees a second goes on for 12 degrees."""
COAST_PERIODS = 3.0
"""Least number of guidance periods without a new attitude before a coordinated turn is flown;
chosen."""


class Setpoints:
    """The setpoints to one vehicle."""

    def __init__(self, sysid: int) -> None:
        """None has gone out to the vehicle with a MAVLink system number."""
        self.count = 0
        """Number of setpoints sent."""
        self.sent_at = 0
        """When the last one went out [us]."""
        self._sysid = sysid
        self._flown: SetAttitudeTarget | None = None

    def send(
        self, now: int, time_boot_ms: int, setpoint: RateSetpoint, autopilot: Autopilot
    ) -> SetAttitudeTarget:
        """The message of a setpoint that goes out at `now` [us].

        Args:
            now: the time [us].
            time_boot_ms: time of the attitude for which it is made [ms].
            setpoint: what it says.
            autopilot: its type mask says which fields count.
        """
        ((p, q, r), thrust, q_nb), mask = setpoint, autopilot.type_mask
        self.count += 1
        self.sent_at = now
        self._flown = said = SetAttitudeTarget(
            time_boot_ms, self._sysid, 1, mask, q_nb, p, q, r, thrust
        )
        return said

    def coast(self, now: int, known: Knowledge, plan: Plan) -> RateSetpoint | None:
        """The setpoint at `now` [us] that ends a roll when no attitude arrives; None: not due.

        One may follow each setpoint that was made for an attitude. The roll has gone on since that
        one went out, or since an attitude that arrived later.
        """
        flown, attitude, clock = self._flown, known.attitude, known.clock
        age = (now - self.sent_at) * US
        if flown is None or attitude is None or clock is None:
            return None
        if age < max(COAST_AFTER, COAST_PERIODS / plan.rate):
            return None
        q_nb = (attitude.q1, attitude.q2, attitude.q3, attitude.q4)
        rates = (flown.body_roll_rate, flown.body_pitch_rate, flown.body_yaw_rate)
        since = (now - max(self.sent_at, clock.heard)) * US
        omega_b, q = coast(q_nb, rates, since, true_cruise(known, plan), plan.tuned.bank_max)
        return RateSetpoint(limit_rates(omega_b, plan.aircraft.rate_max), flown.thrust, q)

    def end(self) -> None:
        """Record that the last setpoint is not held any more, so that nothing follows it."""
        self._flown = None


def true_cruise(known: Knowledge, plan: Plan) -> float:
    """True airspeed to fly at the height of the vehicle [m/s]: that of the plan is equivalent."""
    density = DENSITY_0 if known.hud is None else isa_density(known.hud.alt)
    return plan.tuned.airspeed * math.sqrt(DENSITY_0 / density)
