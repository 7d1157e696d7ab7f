"""A test flight before the first goal: the companion finds out what its aircraft is like.

A closed circuit of straight legs and two turns, with a climb, a descent, a fast and a slow leg.
What it shows is flown by from then on.
"""

import math
from collections.abc import Sequence
from dataclasses import replace
from typing import NamedTuple

import numpy as np

from vfguide.aircraft.envelope import flyable_radius, usable_bank
from vfguide.aircraft.identification import Identified, identify
from vfguide.aircraft.samples import Sample, Samples, samples_of
from vfguide.aircraft.state import FlightState, RateSetpoint
from vfguide.aircraft.vehicle import Vehicle, vehicle_numbers
from vfguide.airspace.detection import in_sight
from vfguide.airspace.hazards import Hazards, hazard_count, hazard_distance
from vfguide.companion.plan import Plan
from vfguide.estimation.local_frame import Measurement, place_measured
from vfguide.geometry.rows import Row
from vfguide.geometry.so3 import from_euler
from vfguide.geometry.units import DEG
from vfguide.geometry.vector import Vec3
from vfguide.loop.legs import Goal

BANK = 30.0 * DEG
"""The turns are for this bank [rad]."""
PATH = 4.0 * DEG
"""Path angle of climb and descent on average [rad]: between level ends they are steeper."""
CHANGE = 0.15
"""The airspeed goes up and down by this part of it."""
STRAIGHT = 8.0
"""A straight leg takes this time [s]."""
SETTLING = 3.0
"""The first leg, which nothing goes before, takes this time [s]."""
END = 0.7
"""A turn has a straight end, so many radii long."""
CAREFUL = 0.3
"""As long as the roll response is not known, the gains are for one that is at least so slow [s]."""
MET = 10.0
"""A leg that ends this close to its pose is reached [m]; one that does not is left all the same."""
MET_ANGLE = 30.0 * DEG
"""Course and climb may be this far off where a leg counts as reached [rad]."""
NEEDED = 50.0
"""Without so much room round the circuit nothing is tested [m]."""
SPACING = 25.0
"""Room is looked for at places on the circuit that are no farther apart than this [m]."""
PATIENCE = 3.0
"""A leg may take so many times what it takes in still air, if something is in its way."""
SPARE = 10.0
"""A leg may take so much longer than that [s]."""


class Manoeuvre(NamedTuple):
    """One leg of the test flight."""

    name: str
    goal: Goal
    airspeed: float
    """To fly [m/s]."""
    longest: float
    """It is left after this time [s]."""
    places: tuple[Vec3, ...]
    """On its way, no farther than SPACING apart, NED [m]."""


class IdentificationFlight:
    """The test flight of one vehicle."""

    def __init__(self, plan: Plan) -> None:
        """Before it: `plan` is what follows."""
        self.plan = plan
        """What is flown now."""
        self._known = plan
        self._then = replace(plan, roll_time=max(plan.roll_time, CAREFUL), identify=False)
        self._legs: tuple[Manoeuvre, ...] = ()
        self._vehicles: tuple[Row, ...] = ()
        self._flown: list[Sample] = []
        self._leg, self._began = 0, 0.0
        # Compiled on the ground, not in flight:
        identify(nothing_flown(), plan.aircraft, plan.roll_time)
        if plan.hazards is not None:
            unknown = np.zeros(len(plan.hazards.obstacles))
            room((0.0, 0.0, 0.0), in_sight(plan.hazards, unknown, (0.0, 0.0, 0.0), 0.0), 0.0)

    def begin(self, heard: Measurement, hazards: Hazards | None, t: float) -> str | None:
        """Lay out the legs from where the vehicle is; returns what is flown first.

        The turns go to the side with more room among what is known of the `hazards` at the time
        `t` [s]; None: there is too little on both.
        """
        state, wide = place_measured(heard, self._then.origin), with_wide_turns(self._then)
        layouts = [circuit(state, wide, side) for side in (1.0, -1.0)]
        rooms = [least_room(legs, hazards, t) for legs in layouts]
        if max(rooms) < NEEDED + 0.5 * SPACING:
            return None
        self._legs = layouts[rooms.index(max(rooms))]
        self.plan = replace(wide, goals=tuple(leg.goal for leg in self._legs))
        self._vehicles = tuple(at_airspeed(self.plan.vehicle, leg.airspeed) for leg in self._legs)
        self._flown.clear()
        self._leg, self._began = 0, state.time
        return self._legs[0].name

    def vehicle_row(self, leg: int) -> Row:
        """Aircraft and gains of a leg."""
        rows = self._vehicles
        return rows[min(leg, len(rows) - 1)] if rows else self.plan.vehicle_row

    def take(self, heard: Measurement, setpoint: RateSetpoint, delay: float, trusts: bool) -> None:
        """Note a state and the setpoint that answers it, which acts `delay` [s] later.

        The airspeed counts only if the companion `trusts` its sensor.
        """
        told = place_measured(heard, self._then.origin)
        airspeed = told.airspeed if trusts else math.nan
        (roll_rate, _, _), (roll_rate_asked, _, _) = heard.omega_b, setpoint.omega_b
        asked = (roll_rate_asked, setpoint.thrust, delay)
        self._flown.append(Sample(told.time, told.R_nb, told.v_n, airspeed, roll_rate, *asked))

    def enters(self, leg: int) -> str | None:
        """The name of a leg that begins now; None: the one before goes on, or it is over."""
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
        """What is flown after it; `found` None: it has shown nothing."""
        if found is None:
            return self._then
        seen = any(finding.key == "roll_s" and finding.used for finding in found.estimates)
        roll_time = found.roll_time if seen else self._then.roll_time
        return replace(self._then, aircraft=found.aircraft, roll_time=roll_time)


def with_wide_turns(plan: Plan) -> Plan:
    """The plan with turns for a bank of BANK; escapes may take all that there is."""
    bank = usable_bank(plan.aircraft, plan.tuned, plan.gains.airspeed)
    wider = max(1.0, math.tan(bank) / math.tan(BANK))
    gains = plan.gains._replace(turn_margin=wider * plan.gains.turn_margin)
    return replace(plan, gains=gains)


def nothing_flown() -> Samples:
    """Half a minute in which nothing changes."""
    level, ahead = from_euler(0.0, 0.0, 0.0), (1.0, 0.0, 0.0)
    return samples_of(Sample(0.25 * k, level, ahead, 1.0, 0.0, 0.0, 0.0, 0.0) for k in range(120))


def circuit(state: FlightState, plan: Plan, side: float) -> tuple[Manoeuvre, ...]:
    """The legs of a test flight that begins and ends at `state`, its turns right (+1) or left."""
    gains, aircraft = plan.tuned, plan.aircraft
    speed = gains.airspeed
    fast = max(speed, min((1.0 + CHANGE) * speed, 0.95 * aircraft.airspeed_max))
    slow = min(speed, max((1.0 - CHANGE) * speed, 1.1 * aircraft.airspeed_min))
    still = state._replace(wind_n=tuple(0.0 if math.isnan(w) else w for w in state.wind_n))
    radius = flyable_radius(still, usable_bank(aircraft, gains, speed), gains)
    course = math.atan2(state.v_n[1], state.v_n[0])
    up = min(PATH, 0.4 * aircraft.climb_max)
    down = min(up, 0.4 * aircraft.descent_max)
    long, turn, end = STRAIGHT * speed, side * math.pi, END * radius
    legs = (  # name, airspeed, turn, length after it and height on it [m]
        ("level flight", speed, 0.0, SETTLING * speed, 0.0),
        ("a climb", speed, 0.0, long, long * math.tan(up)),
        ("a descent", speed, 0.0, long, -long * math.tan(down)),
        ("a turn", speed, turn, end, 0.0),
        ("fast flight", fast, 0.0, STRAIGHT * fast, 0.0),
        ("slow flight", slow, 0.0, STRAIGHT * fast, 0.0),
        ("a turn back", speed, turn, end, 0.0),
    )
    at, manoeuvres = state.p_n, list[Manoeuvre]()
    for name, airspeed, turned, length, height in legs:
        places = way(at, course, radius, turned, length, height)
        at, course = places[-1], course + turned
        longest = PATIENCE * (radius * abs(turned) + length) / airspeed + SPARE
        goal = Goal(at, course, 0.0, MET, MET_ANGLE, attempts=1)
        manoeuvres.append(Manoeuvre(name, goal, airspeed, longest, places))
    return tuple(manoeuvres)


def way(
    p_n: Vec3, course: float, radius: float, turned: float, length: float, height: float
) -> tuple[Vec3, ...]:
    """Places on an arc that turns by `turned` [rad], right positive, and on the straight after it.

    They are no farther than SPACING apart; the height [m] is gained on the straight.
    """
    places: list[Vec3] = []
    steps = math.ceil(radius * abs(turned) / SPACING)
    side = math.copysign(radius, turned)
    for k in range(1, steps + 1):
        angle = abs(turned) * k / steps
        across = side * (1.0 - math.cos(angle))
        places.append(moved(p_n, course, radius * math.sin(angle), across, 0.0))
    at = places[-1] if places else p_n
    steps = math.ceil(math.hypot(length, height) / SPACING)
    for k in range(1, steps + 1):
        share = k / steps
        places.append(moved(at, course + turned, share * length, 0.0, share * height))
    return tuple(places)


def least_room(legs: Sequence[Manoeuvre], hazards: Hazards | None, t: float) -> float:
    """Least distance of the legs from a hazard at the time `t` [s] [m]."""
    return min(room(place, hazards, t) for leg in legs for place in leg.places)


def room(p_n: Vec3, hazards: Hazards | None, t: float) -> float:
    """Distance of a place from the nearest hazard at the time `t` [s] [m]."""
    if hazards is None:
        return math.inf
    return min(hazard_distance(hazards, i, p_n, t) for i in range(hazard_count(hazards)))


def moved(p_n: Vec3, course: float, ahead: float, right: float, up: float) -> Vec3:
    """A place from another one, in the directions of a course [m]."""
    c, s = math.cos(course), math.sin(course)
    return (p_n[0] + c * ahead - s * right, p_n[1] + s * ahead + c * right, p_n[2] - up)


def at_airspeed(vehicle: Vehicle, airspeed: float) -> Row:
    """The row of the same vehicle at another airspeed [m/s]."""
    gains = vehicle.gains._replace(airspeed=airspeed)
    return np.array(vehicle_numbers(vehicle._replace(gains=gains)))
