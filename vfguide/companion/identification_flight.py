"""The identification flight before the first goal: it shows what the aircraft is like.

The estimates that its circuit yields are used from then on.
"""

import math
from dataclasses import replace

import numpy as np

from vfguide.aircraft.air_density import vehicle_in_air
from vfguide.aircraft.envelope import usable_bank
from vfguide.aircraft.identification import Identified, identify
from vfguide.aircraft.samples import Sample, Samples, samples_of
from vfguide.aircraft.state import RateSetpoint
from vfguide.aircraft.vehicle import Vehicle, vehicle_numbers
from vfguide.airspace.detection import in_sight
from vfguide.airspace.hazards import Hazards
from vfguide.companion.circuit import ROOM_SPACING, CircuitLeg, circuit, least_room, room
from vfguide.companion.plan import Plan
from vfguide.earth.atmosphere import DENSITY_0
from vfguide.estimation.local_frame import Measurement, place_measured
from vfguide.geometry.so3 import from_euler
from vfguide.geometry.units import DEG
from vfguide.kernels.rows import Row

TEST_BANK = 30.0 * DEG
"""Bank of the turns of a test flight [rad]; chosen, so that the load factor changes enough to be
seen."""
CAREFUL_ROLL = 0.3
"""Roll response time for which the gains are made while it is unknown [s]; chosen on the slow
side."""
NEEDED_ROOM = 50.0
"""Least distance of the circuit from hazards with which a test is flown [m]; chosen."""
IDLE_SAMPLES = 120
"""Number of samples with which the identification is compiled on the ground; chosen, half a minute
is enough for it to run."""
IDLE_INTERVAL = 0.25
"""Time between two samples with which the identification is compiled [s]; chosen."""


class IdentificationFlight:
    """The test flight of one vehicle."""

    def __init__(self, plan: Plan) -> None:
        """A test flight that has not begun; `plan` is what is flown after it."""
        self.plan = plan
        """What is flown now."""
        self._known = plan
        self._then = replace(plan, roll_time=max(plan.roll_time, CAREFUL_ROLL), identify=False)
        self._legs: tuple[CircuitLeg, ...] = ()
        self._vehicles: tuple[Row, ...] = ()
        self._flown: list[Sample] = []
        self._leg, self._began = 0, 0.0
        # Compiled on the ground, not in flight:
        identify(nothing_flown(), plan.aircraft, plan.roll_time)
        if plan.hazards is not None:
            unknown = np.zeros(len(plan.hazards.obstacles))
            room((0.0, 0.0, 0.0), in_sight(plan.hazards, unknown, (0.0, 0.0, 0.0), 0.0), 0.0)

    def begin(self, measured: Measurement, hazards: Hazards | None, t: float) -> str | None:
        """Lay out the legs from where the vehicle is; returns what is flown first.

        The turns go to the side with more room among what is known of the `hazards` at the time
        `t` [s]; None: there is too little on both.
        """
        state = place_measured(measured, self._then.origin)
        wide = with_wide_turns(self._then, measured.density)
        flown = vehicle_in_air(wide.vehicle, measured.density)
        layouts = [circuit(state, flown, side) for side in (1.0, -1.0)]
        rooms = [least_room(legs, hazards, t) for legs in layouts]
        if max(rooms) < NEEDED_ROOM + 0.5 * ROOM_SPACING:
            return None
        self._legs = layouts[rooms.index(max(rooms))]
        self.plan = replace(wide, goals=tuple(leg.goal for leg in self._legs))
        self._vehicles = tuple(at_airspeed(self.plan.vehicle, leg.airspeed) for leg in self._legs)
        self._flown.clear()
        self._leg, self._began = 0, state.time
        return self._legs[0].name

    def vehicle_row(self, leg: int) -> Row:
        """The row of `Vehicle` of a leg, by its index from 0."""
        rows = self._vehicles
        return rows[min(leg, len(rows) - 1)] if rows else self.plan.vehicle_row

    def take(
        self, measured: Measurement, setpoint: RateSetpoint, delay: float, trusts: bool
    ) -> None:
        """Note a state and the setpoint that answers it, which acts `delay` [s] later.

        The airspeed counts only if the companion `trusts` its sensor.
        """
        state = place_measured(measured, self._then.origin)
        airspeed = state.airspeed if trusts else math.nan
        (roll_rate, _, _), (roll_rate_asked, _, _) = measured.omega_b, setpoint.omega_b
        air, asked = (airspeed, measured.density), (roll_rate_asked, setpoint.thrust, delay)
        self._flown.append(Sample(state.time, state.R_nb, state.v_n, *air, roll_rate, *asked))

    def enters(self, leg: int) -> str | None:
        """The name of a leg that begins now; None: the one before goes on, or all are flown."""
        if leg == self._leg:
            return None
        self._leg, self._began = leg, self._flown[-1].time
        return None if self.is_over(leg) else self._legs[leg].name

    def is_stuck(self, leg: int) -> bool:
        """Whether `leg` takes too long; one that begins now does not."""
        if leg != self._leg or self.is_over(leg):
            return False
        return self._flown[-1].time - self._began > self._legs[leg].longest

    def is_over(self, leg: int) -> bool:
        """Whether `leg` comes after the last one."""
        return leg >= len(self._legs)

    def identify(self) -> Identified:
        """What the flight has shown."""
        return identify(samples_of(self._flown), self._known.aircraft, self._known.roll_time)

    def plan_after(self, found: Identified | None) -> Plan:
        """What is flown after the test flight, with what it `found`; None: it found nothing."""
        if found is None:
            return self._then
        seen = any(estimate.key == "roll_s" and estimate.used for estimate in found.estimates)
        roll_time = found.roll_time if seen else self._then.roll_time
        return replace(self._then, aircraft=found.aircraft, roll_time=roll_time)


def with_wide_turns(plan: Plan, density: float) -> Plan:
    """The plan with turns for a bank of TEST_BANK; escapes may take all that there is.

    `density` is that of the air [kg/m^3].
    """
    aircraft, gains, _ = vehicle_in_air(plan.vehicle, density)
    bank = usable_bank(aircraft, gains, gains.airspeed)
    factor = max(1.0, math.tan(bank) / math.tan(TEST_BANK))
    wide = plan.gains._replace(turn_margin=factor * plan.gains.turn_margin)
    return replace(plan, gains=wide)


def nothing_flown() -> Samples:
    """The samples of half a minute in which nothing changes."""
    level, ahead = from_euler(0.0, 0.0, 0.0), (1.0, 0.0, 0.0)
    return samples_of(
        Sample(IDLE_INTERVAL * k, level, ahead, 1.0, DENSITY_0, 0.0, 0.0, 0.0, 0.0)
        for k in range(IDLE_SAMPLES)
    )


def at_airspeed(vehicle: Vehicle, airspeed: float) -> Row:
    """The row of the same vehicle at another airspeed [m/s]."""
    gains = vehicle.gains._replace(airspeed=airspeed)
    return np.array(vehicle_numbers(vehicle._replace(gains=gains)))
