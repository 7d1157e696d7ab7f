"""The plan of a companion: the goals, and the aircraft that flies to them."""

from dataclasses import dataclass, field

import numpy as np

from vfguide.aircraft.gain_scheduling import FAST_ROLL, suited
from vfguide.aircraft.performance import Gains, Performance
from vfguide.aircraft.vehicle import Vehicle, vehicle_numbers
from vfguide.airspace.hazards import Hazards
from vfguide.airspace.keep_out import NO_FENCE, KeepOutZones
from vfguide.annunciations.step_notes import Briefing
from vfguide.field.obstacle import PlacedObstacle
from vfguide.geometry.vector import Vec3
from vfguide.guidance.laws import FLIGHT, Law
from vfguide.kernels.rows import Row, getter
from vfguide.loop.legs import Goal, Legs, leg_rows
from vfguide.surveillance.report import SMALL_AIRCRAFT, Volume

velocity_of_row = getter(PlacedObstacle, "v_n")
"""The velocity of an obstacle, from its row."""


@dataclass(frozen=True)
class Plan:
    """The goals of one vehicle, and how to fly to them."""

    origin: Vec3
    """Latitude, longitude [rad] and altitude above mean sea level [m] where the tangent plane of
    the goals' coordinates, north-east-down, touches."""
    goals: tuple[Goal, ...]
    """The goals in the order in which they are flown to."""
    loiter_side: float
    """Side of the circle after the last goal: +1 right-hand, -1 left-hand."""
    loiter_radius: float
    """Radius of that circle [m]; it grows where wind and bank ask for more."""
    rate: float
    """Rate of guidance steps [Hz]."""
    aircraft: Performance
    """What is known of the aircraft."""
    gains: Gains
    """Gains for a roll response within FAST_ROLL."""
    roll_time: float = FAST_ROLL
    """Roll response time: 63 % of a step of the roll rate [s]."""
    identify: bool = False
    """Whether a test flight before the first goal has to show what the aircraft is like."""
    hazards: Hazards | None = None
    """The hazards; None: there are none."""
    hazard_names: tuple[str, ...] = ()
    """Names of the hazards for the operator, by their numbers."""
    fence: KeepOutZones = NO_FENCE
    """The fence as keep-out zones of the route search."""
    epoch: int = 0
    """Date of time zero on the clock of the obstacles [us since 1970]."""
    has_start_time: bool = False
    """Whether that date was chosen, so that moving obstacles are there by the date alone."""
    longest: float = 300.0
    """Longest time that the flight may take [s]."""
    volume: Volume = SMALL_AIRCRAFT
    """Volume to keep out of around other aircraft."""
    own_icao: int = 0
    """Address of the own transponder; 0: there is none."""
    law: Law = FLIGHT
    """The law of guidance."""
    is_rigid_body: bool = False
    """Whether the vehicle is the paper's rigid body."""
    legs: Legs = field(init=False, compare=False)
    """Goals and circle as rows, from `leg_rows`."""
    tuned: Gains = field(init=False, compare=False)
    """The gains that suit the roll response."""
    vehicle: Vehicle = field(init=False, compare=False)
    """The aircraft with those gains."""
    vehicle_row: Row = field(init=False, compare=False)
    """The row of that vehicle."""

    @property
    def moves(self) -> bool:
        """Whether any obstacle moves, so that the time of the obstacles matters."""
        rows = () if self.hazards is None else self.hazards.obstacles
        return any(any(velocity_of_row(row)) for row in rows)

    @property
    def is_assured(self) -> bool:
        """Whether the run-time assurance guards the law."""
        return self.hazards is not None and self.law.is_assured

    @property
    def briefing(self) -> Briefing:
        """What the notes of its steps mention of it."""
        names = None if self.hazards is None else self.hazard_names
        return Briefing(len(self.goals), self.gains.airspeed, names)

    def __post_init__(self) -> None:
        legs = leg_rows(self.goals, self.loiter_side, self.loiter_radius)
        object.__setattr__(self, "legs", legs)
        tuned = suited(self.gains, self.roll_time, self.aircraft.rate_max[0])
        object.__setattr__(self, "tuned", tuned)
        vehicle = Vehicle(self.aircraft, tuned, self.is_rigid_body)
        object.__setattr__(self, "vehicle", vehicle)
        object.__setattr__(self, "vehicle_row", np.array(vehicle_numbers(vehicle)))
