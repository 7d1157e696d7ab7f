"""A test flight before the first goal: the companion finds out what its aircraft is like.

A closed circuit of straight legs and two turns, with a climb, a descent, a fast and a slow leg.
What it shows is flown by from then on.
"""

import math
from collections.abc import Sequence
from dataclasses import replace
from typing import NamedTuple

import numpy as np

from vfguide.companion.legs import Goal
from vfguide.companion.place import Heard, place_state
from vfguide.companion.plan import Plan
from vfguide.flight.horizontal import flyable_radius, usable_bank
from vfguide.flight.identification import Identified, Samples, first_order, identify
from vfguide.flight.performance import AIRSPEED_GAIN, Law
from vfguide.flight.response import suited
from vfguide.flight.state import FlightState, RateSetpoint
from vfguide.geometry.units import DEG
from vfguide.geometry.vector import Vec3, add, scale
from vfguide.safety.hazards import Hazards, hazard_count, hazard_distance

BANK = 30.0 * DEG
PATH = 4.0 * DEG
"""Of turns, and of climb and descent on average: between level ends they are steeper."""
CHANGE = 0.15
"""Of the airspeed, up and down."""
STRAIGHT = 8.0
"""Time of a straight leg [s]."""
END = 0.7
"""A turn has a straight end, so many radii long."""
CAREFUL = 0.3
"""As long as the roll response is not known, the gains are for one that is at least so slow [s]."""
MET, MET_ANGLE = 10.0, 30.0 * DEG
"""A leg that ends this close to its pose is reached [m]; one that does not is left all the same."""
NEEDED = 50.0
"""Without so much room round the circuit nothing is tested [m]."""
PATIENCE = 3.0
"""A leg may take so many times what it takes in still air, ..."""
SPARE = 10.0
"""... and so much more [s], if something is in its way."""


class Manoeuvre(NamedTuple):
    """One leg of the test flight."""

    name: str
    goal: Goal
    airspeed: float
    """To fly [m/s]."""
    longest: float
    """It is left after this time [s]."""
    bulge: float
    """How far a turn goes beyond the middle between its ends [m]."""


class Trial:
    """The test flight of one vehicle."""

    def __init__(self, plan: Plan) -> None:
        """Before it: `plan` is what follows."""
        self.plan = plan
        """What is flown now."""
        self._then = plan
        self._legs: tuple[Manoeuvre, ...] = ()
        self._laws: tuple[Law, ...] = ()
        self._rows: list[tuple[float, ...]] = []
        self._leg, self._began = 0, 0.0
        nothing = np.zeros(1)
        # Compiled on the ground, not in flight:
        first_order(nothing, nothing, nothing, 1.0)
        room((0.0, 0.0, 0.0), plan.hazards, 0.0)

    def begin(self, heard: Heard, t: float) -> str | None:
        """Lay out the legs from where the vehicle is; returns what is flown first.

        The turns go to the side with more room at the time `t` [s] on the clock of the obstacles;
        None: there is too little on both.
        """
        state = place_state((*heard[:10], 0.0), self._then.origin)
        untuned, aircraft = self._then.untuned or self._then.gains, self._then.aircraft
        gains = suited(untuned, max(self._then.roll_time, CAREFUL), aircraft.rate_max[0])
        gains = gains._replace(bank_max=min(gains.bank_max, BANK))
        layouts = [circuit(state, replace(self._then, gains=gains), side) for side in (1.0, -1.0)]
        rooms = [least_room(state.p_n, legs, self._then.hazards, t) for legs in layouts]
        if max(rooms) < NEEDED:
            return None
        self._legs = layouts[rooms.index(max(rooms))]
        goals = tuple(leg.goal for leg in self._legs)
        self.plan = replace(self._then, goals=goals, gains=gains)
        self._laws = tuple(at_airspeed(self.plan.law, leg.airspeed) for leg in self._legs)
        self._rows.clear()
        self._leg, self._began = 0, state.time
        return self._legs[0].name

    def law(self, leg: int) -> Law:
        """Aircraft and gains of a leg."""
        return self._laws[min(leg, len(self._laws) - 1)] if self._laws else self.plan.law

    def take(self, heard: Heard, setpoint: RateSetpoint, delay: float) -> None:
        """Note a state and the setpoint that answers it, which acts `delay` [s] later."""
        told = place_state((*heard[:10], 0.0), self._then.origin)
        attitude = (*told.R_nb[0], *told.R_nb[1], *told.R_nb[2])
        asked = (heard[9][0], setpoint.omega_b[0], setpoint.thrust, delay)
        self._rows.append((told.time, *attitude, *told.v_n, told.airspeed, *asked))

    def enters(self, leg: int) -> str | None:
        """The name of a leg that begins now; None: the one before goes on, or it is over."""
        if leg == self._leg:
            return None
        self._leg, self._began = leg, self._rows[-1][0]
        return None if self.is_over(leg) else self._legs[leg].name

    def is_stuck(self) -> bool:
        """Whether the present leg takes too long."""
        return self._rows[-1][0] - self._began > self._legs[self._leg].longest

    def is_over(self, leg: int) -> bool:
        """Whether all legs before this one are all."""
        return leg >= len(self._legs)

    def identify(self) -> Identified:
        """What the flight has shown."""
        rows = np.array(self._rows)
        time, R_nb, v_n, last = np.split(rows, np.cumsum([1, 9, 3]), axis=1)
        samples = Samples(time[:, 0], R_nb.reshape(-1, 3, 3), v_n, *last.T)
        return identify(samples, self._then.aircraft, self._then.roll_time)

    def plan_after(self, found: Identified | None) -> Plan:
        """What is flown after it; `found` None: it has shown nothing."""
        then = replace(self._then, untuned=None)
        if found is None:
            return then
        untuned = self._then.untuned or then.gains
        gains = suited(untuned, found.roll_time, found.aircraft.rate_max[0])
        return replace(then, aircraft=found.aircraft, roll_time=found.roll_time, gains=gains)


def circuit(state: FlightState, plan: Plan, side: float) -> tuple[Manoeuvre, ...]:
    """The legs of a test flight that begins and ends at `state`, its turns right (+1) or left."""
    gains, aircraft = plan.gains, plan.aircraft
    speed = gains.airspeed
    fast = min((1.0 + CHANGE) * speed, 0.95 * aircraft.airspeed_max)
    slow = max((1.0 - CHANGE) * speed, 1.1 * aircraft.airspeed_min)
    still = state._replace(wind_n=tuple(0.0 if math.isnan(w) else w for w in state.wind_n))
    radius = flyable_radius(still, usable_bank(aircraft, gains, speed), gains)
    course = math.atan2(state.v_n[1], state.v_n[0])
    up, down = min(PATH, 0.4 * aircraft.climb_max), min(PATH, 0.4 * aircraft.descent_max)
    across, end = side * 2.0 * radius, END * radius
    legs = (  # name, airspeed, ahead, to the right and up [m], course from the first one
        ("level flight", speed, 3.0 * speed, 0.0, 0.0, 0.0),
        ("a climb", speed, STRAIGHT * speed, 0.0, STRAIGHT * speed * math.tan(up), 0.0),
        ("a descent", speed, STRAIGHT * speed, 0.0, -STRAIGHT * speed * math.tan(down), 0.0),
        ("a turn", speed, -end, across, 0.0, math.pi),
        ("fast flight", fast, -STRAIGHT * fast, 0.0, 0.0, math.pi),
        ("slow flight", slow, -STRAIGHT * fast, 0.0, 0.0, math.pi),
        ("a turn back", speed, end, -across, 0.0, 0.0),
    )
    at, manoeuvres = state.p_n, list[Manoeuvre]()
    for name, airspeed, ahead, right, up, turned in legs:
        at = moved(at, course, ahead, right, up)
        length = abs(ahead) + 0.5 * math.pi * abs(right)
        goal = Goal(at, course + turned, 0.0, MET, MET_ANGLE, attempts=1)
        bulge = 0.5 * (abs(right) + abs(ahead)) if right else 0.0
        longest = PATIENCE * length / airspeed + SPARE
        manoeuvres.append(Manoeuvre(name, goal, airspeed, longest, bulge))
    return tuple(manoeuvres)


def least_room(start: Vec3, legs: Sequence[Manoeuvre], hazards: Hazards | None, t: float) -> float:
    """Least distance of ends and middles of the legs from a hazard at the time `t` [s] [m]."""
    least, at = math.inf, start
    for leg in legs:
        p_n = leg.goal.p_n
        halfway = scale(0.5, add(at, p_n))
        if leg.bulge > 0.0:  # the far side of a turn
            halfway = moved(halfway, leg.goal.course, -leg.bulge, 0.0, 0.0)
        least = min(least, room(halfway, hazards, t), room(p_n, hazards, t))
        at = p_n
    return least


def room(p_n: Vec3, hazards: Hazards | None, t: float) -> float:
    """Distance of a place from the nearest hazard [m]."""
    if hazards is None:
        return math.inf
    return min(hazard_distance(hazards, i, p_n, t) for i in range(hazard_count(hazards)))


def moved(p_n: Vec3, course: float, ahead: float, right: float, up: float) -> Vec3:
    """A place from another one, in the directions of a course [m]."""
    c, s = math.cos(course), math.sin(course)
    return (p_n[0] + c * ahead - s * right, p_n[1] + s * ahead + c * right, p_n[2] - up)


def at_airspeed(law: Law, airspeed: float) -> Law:
    """The same law at another airspeed [m/s]."""
    other = law.copy()
    other[AIRSPEED_GAIN] = airspeed
    return other
