"""A scenario as it is written: the TOML tables, their keys, types and ranges."""

from datetime import UTC, datetime
from typing import Annotated, Literal

from pydantic import AfterValidator, AwareDatetime, Field

from vfguide.files.fence import Fence
from vfguide.files.obstacle_entry import ObstacleEntry
from vfguide.files.simulation_entry import Autopilot, Link, Sensors, Weather, Wind
from vfguide.files.toml_types import (
    Angle,
    Attitude,
    Position,
    Table,
    Vector,
    above,
    between,
    rule_broken,
    word,
)
from vfguide.files.traffic_entry import Address, TrafficEntry, TrafficReceiver
from vfguide.files.vary import Distribution, Vary
from vfguide.surveillance.report import SMALL_AIRCRAFT

Latitude = Annotated[float, between(-89, 89)]
Longitude = Annotated[float, between(-180, 180)]
Altitude = Annotated[float, between(-500, 10_000)]
Undulation = Annotated[float, between(-120, 120)]
Speed = Annotated[float, above(0, 150)]

DEFAULT_AIRCRAFT = "aerosonde"
"""Name of the aircraft that a vehicle has if none is given."""
KINEMATIC_AIRSPEED = 25.0
"""Speed of a kinematic body that is given none [m/s]; chosen, the cruise airspeed of the default
aircraft."""
LEAST_BANK_DEG = 5.0
"""Least value of the largest bank [deg]; chosen, since turns with less are too wide to be of
use."""


def _name(text: str) -> str:
    """Names become folder names: no path in them, nothing that hides them."""
    bad = sorted({letter for letter in text if not (letter.isalnum() or letter in "-_. ")})
    if bad or not text[:1].isalnum() or len(text) > 100:
        raise rule_broken("allowed are letters, digits, - _ . and spaces, a letter or digit first")
    return text


def _after_1970(time: datetime) -> datetime:
    """Logs count microseconds since 1970."""
    if not 1970 <= time.astimezone(UTC).year < 2200:
        raise rule_broken("allowed 1970 to 2200")
    return time.astimezone(UTC)


Name = Annotated[str, AfterValidator(_name)]
Time = Annotated[AwareDatetime, AfterValidator(_after_1970)]
Plant = Annotated[Literal["jsbsim", "kinematic"], word("jsbsim", "kinematic")]
Law = Annotated[Literal["flight", "field", "paper"], word("flight", "field", "paper")]


class Origin(Table):
    """Where the scenario frame, NED, touches a level surface."""

    latitude_deg: Latitude = 47.397742
    longitude_deg: Longitude = 8.545594
    altitude_m: Altitude = 488.0
    """Above mean sea level; also the height of the flat ground."""
    undulation_m: Undulation = 0.0
    """Height of mean sea level above the WGS-84 ellipsoid."""


class FieldRemedies(Table):
    """What law `field` does beyond the paper's print, each on or off."""

    relative_velocity: bool = True
    """Hazards are passed by the velocity relative to them; else by their place alone."""
    reactive_range: bool = True
    """Hazards act from where a turn away still suffices; else within their `reactive_level`."""
    lead: bool = True
    """The turn rate of the field is fed forward."""
    unit_sum: bool = True
    """All terms of the sum over the hazards have the airspeed."""
    side: bool = True
    """What is dead ahead is passed on the side of the step before."""
    bounded_circles: bool = True
    """Ahead of the goal a point behind it is led to; else the circles of the print."""
    approach: bool = True
    """The last three turn radii are flown as by law `flight`; else the field leads to the goal."""
    search: bool = True
    """Where the field is blocked ahead or comes no nearer, a route around the hazards is flown."""


class Guidance(Table):
    """Gains and limits of the companion."""

    rate_hz: Annotated[float, between(5, 200)] = 50.0
    airspeed_mps: Speed | None = None
    """True airspeed to fly; None: each vehicle's own."""
    bank_max_deg: Annotated[float, between(LEAST_BANK_DEG, 75)] | None = None
    """Largest bank asked for; None: each aircraft's own."""
    k_w: Annotated[float, above(0, 20)] = 3.5
    """Attitude gain of Lemma 4 [1/s]."""
    k_v: Annotated[float, above(0, 20)] = 1.0
    """Speed gain of the paper [1/s]; only the kinematic plant flies it."""
    k_lateral: Annotated[float, above(0, 10)] = 1.2
    """Turn rate per azimuth error of the air velocity [1/s]."""
    k_elevation: Annotated[float, between(0, 5)] = 0.5
    """Extra elevation per error of the path angle."""
    loiter: Annotated[Literal["right", "left"], word("right", "left")] = "right"
    """Side of the circle after the last goal."""
    loiter_radius_m: Annotated[float, above(0, 10_000)] | None = None
    """Of that circle; None: each aircraft's own. It grows where wind and bank ask for more."""
    remedies: FieldRemedies | None = None
    """None: law `field` flies all of them."""


class Avoidance(Table):
    """Distances to keep."""

    safety_radius_m: Annotated[float, above(0, 1000)] = 10.0
    """Safety radius of one vehicle: centres have to stay two of them apart."""
    detection_range_m: Annotated[float, above(0, 100_000)] = 300.0
    between_vehicles: bool = True
    traffic: bool = False
    """Whether reported traffic is avoided also where the scenario has none of its own."""
    traffic_radius_m: Annotated[float, between(10, 10_000)] = SMALL_AIRCRAFT.radius
    traffic_half_height_m: Annotated[float, between(5, 10_000)] = SMALL_AIRCRAFT.half_height
    """Of the volume around other aircraft to keep out of."""
    traffic_growth_mps: Annotated[float, between(0, 100)] = SMALL_AIRCRAFT.uncertainty_rate
    traffic_growth_up_mps: Annotated[float, between(0, 100)] = SMALL_AIRCRAFT.uncertainty_rate_up
    """Of both with the age of the report."""


class GoalEntry(Table):
    """A goal as it is written."""

    position_m: Position | None = None
    latitude_deg: Latitude | None = None
    longitude_deg: Longitude | None = None
    altitude_m: Altitude | None = None
    heading_deg: Angle | None = None
    direction: Vector | None = None
    climb_deg: Annotated[float, between(-89, 89)] | None = None
    tolerance_m: Annotated[float, above(0, 1000)] = 5.0
    tolerance_deg: Annotated[float, above(0, 180)] = 10.0
    attempts: Annotated[int, between(0, 1000)] = 0
    """Number of missed passes after which the goal is given up; 0: never."""


class VehicleEntry(Table):
    """A vehicle as it is written."""

    id: Annotated[int, between(1, 250)]
    position_m: Position
    heading_deg: Angle = 0.0
    attitude_deg: Attitude | None = None
    """Roll, pitch and yaw at the start of a kinematic body, instead of `heading_deg`."""
    airspeed_mps: Speed | None = None
    """At the start; None: the aircraft's cruise, or that of a kinematic body."""
    aircraft: str = DEFAULT_AIRCRAFT
    """Not used by the kinematic plant."""
    icao: Address | None = None
    """Of its own transponder; None: it has none."""
    identify: bool = False
    """Whether a test flight before the first goal finds out what the aircraft is like."""
    goal: Annotated[list[GoalEntry], Field(min_length=1)]


class ScenarioHead(Table):
    """The part of a scenario that concerns all vehicles."""

    name: Name
    plant: Plant = "jsbsim"
    law: Law = "flight"
    duration_s: Annotated[float, above(0, 86_400)] = 300.0
    seed: Annotated[int, between(0, 2**32 - 1)] = 1
    start_time: Time = datetime(2026, 1, 1, tzinfo=UTC)
    origin: Origin = Origin()
    wind: Wind = Wind()
    weather: Weather = Weather()
    sensors: Sensors | None = None
    """None: every autopilot knows its state exactly."""
    autopilot: Autopilot = Autopilot()
    link: Link = Link()
    guidance: Guidance = Guidance()
    avoidance: Avoidance = Avoidance()
    fence: Fence = Fence()
    traffic_receiver: TrafficReceiver = TrafficReceiver()


class ScenarioFile(ScenarioHead):
    """The whole file as it is written."""

    vehicle: Annotated[list[VehicleEntry], Field(min_length=1)]
    obstacle: Annotated[list[ObstacleEntry], Field(default_factory=list)]
    traffic: list[TrafficEntry] = Field(default_factory=list[TrafficEntry])
    vary: Vary = Field(default_factory=dict[str, Distribution])
    """Of campaigns alone: a run flies the values that are written."""
