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
"""A geodetic latitude, WGS-84 [deg]."""
Longitude = Annotated[float, between(-180, 180)]
"""A longitude, WGS-84 [deg]."""
Altitude = Annotated[float, between(-500, 10_000)]
"""An altitude above mean sea level [m]."""
Undulation = Annotated[float, between(-120, 120)]
"""A height of mean sea level above the WGS-84 ellipsoid [m]."""
Speed = Annotated[float, above(0, 150)]
"""A true airspeed [m/s]."""

DEFAULT_AIRCRAFT = "aerosonde"
"""Name of the aircraft that a vehicle has if none is given."""
KINEMATIC_AIRSPEED = 25.0
"""Speed of a rigid body of plant `kinematic` that is given none [m/s]; chosen as the cruise of the
default aircraft."""
LEAST_BANK_DEG = 5.0
"""Least value of the largest bank that may be written [deg]; chosen, since turns with less are too
wide to be of use."""


def _name(text: str) -> str:
    """The name, if it can be that of a folder: without a path, and not hidden."""
    bad = sorted({letter for letter in text if not (letter.isalnum() or letter in "-_. ")})
    if bad or not text[:1].isalnum() or len(text) > 100:
        raise rule_broken("allowed are letters, digits, - _ . and spaces, a letter or digit first")
    return text


def _after_1970(time: datetime) -> datetime:
    """The time in UTC, if logs can hold it: they count microseconds since 1970."""
    if not 1970 <= time.astimezone(UTC).year < 2200:
        raise rule_broken("allowed 1970 to 2200")
    return time.astimezone(UTC)


Name = Annotated[str, AfterValidator(_name)]
"""The name of a scenario, which can be that of a folder."""
Time = Annotated[AwareDatetime, AfterValidator(_after_1970)]
"""A date and time with its zone, in UTC when it is read."""
Plant = Annotated[Literal["jsbsim", "kinematic"], word("jsbsim", "kinematic")]
Law = Annotated[Literal["flight", "field", "paper"], word("flight", "field", "paper")]


class Origin(Table):
    """The origin of the scenario frame, NED, which is tangent to the Earth there."""

    latitude_deg: Latitude = 47.397742
    longitude_deg: Longitude = 8.545594
    altitude_m: Altitude = 488.0
    """Altitude above mean sea level, of the flat ground too."""
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
    """A hazard dead ahead is passed on the side of the step before."""
    bounded_circles: bool = True
    """Ahead of the goal a point behind it is led to; else the circles of the print."""
    approach: bool = True
    """The last three turn radii are flown as by law `flight`; else the field leads to the goal."""
    search: bool = True
    """Where the field is blocked ahead or comes no nearer, a route around the hazards is flown."""


class Guidance(Table):
    """Gains and limits of guidance."""

    rate_hz: Annotated[float, between(5, 200)] = 50.0
    """Rate at which setpoints are sent."""
    airspeed_mps: Speed | None = None
    """True airspeed to fly; None: each vehicle's own."""
    bank_max_deg: Annotated[float, between(LEAST_BANK_DEG, 75)] | None = None
    """Largest bank asked for; None: each aircraft's own."""
    k_w: Annotated[float, above(0, 20)] = 3.5
    """Attitude gain of Lemma 4 [1/s]."""
    k_v: Annotated[float, above(0, 20)] = 1.0
    """Speed gain of the paper [1/s]; only the kinematic plant flies it."""
    k_lateral: Annotated[float, above(0, 10)] = 1.2
    """Turn rate for each unit of azimuth error of the air velocity [1/s]."""
    k_elevation: Annotated[float, between(0, 5)] = 0.5
    """Elevation that is added for each unit of error of the path angle, dimensionless."""
    loiter: Annotated[Literal["right", "left"], word("right", "left")] = "right"
    """Side of the circle after the last goal."""
    loiter_radius_m: Annotated[float, above(0, 10_000)] | None = None
    """Radius of the circle after the last goal, larger where wind and bank require it; None: 1.57
    V^2 / g at the airspeed V of the vehicle."""
    remedies: FieldRemedies | None = None
    """Remedies of law `field`; None: all of them."""


class Avoidance(Table):
    """Distances to keep from obstacles, other vehicles and other aircraft."""

    safety_radius_m: Annotated[float, above(0, 1000)] = 10.0
    """Safety radius of one vehicle: the centres of two have to stay two of them apart."""
    detection_range_m: Annotated[float, above(0, 100_000)] = 300.0
    """Distance from which obstacles and other vehicles are detected."""
    between_vehicles: bool = True
    """Whether vehicles of the scenario have to keep apart."""
    traffic: bool = False
    """Whether reported traffic is avoided even where the scenario has none of its own."""
    traffic_radius_m: Annotated[float, between(10, 10_000)] = SMALL_AIRCRAFT.radius
    """Radius of the volume around other aircraft to keep out of."""
    traffic_half_height_m: Annotated[float, between(5, 10_000)] = SMALL_AIRCRAFT.half_height
    """Half the height of that volume."""
    traffic_growth_mps: Annotated[float, between(0, 100)] = SMALL_AIRCRAFT.uncertainty_rate
    """Growth of the radius with the age of the report and with the time of prediction."""
    traffic_growth_up_mps: Annotated[float, between(0, 100)] = SMALL_AIRCRAFT.uncertainty_rate_up
    """Growth of the half height with the same."""


class GoalEntry(Table):
    """A goal as it is written: its position and its course in one of two ways each."""

    position_m: Position | None = None
    """Position north, east and down of the origin; None: it is given by latitude, longitude and
    altitude."""
    latitude_deg: Latitude | None = None
    longitude_deg: Longitude | None = None
    altitude_m: Altitude | None = None
    """Altitude above mean sea level."""
    heading_deg: Angle | None = None
    """Course over ground to have there; None: `direction` is given."""
    direction: Vector | None = None
    """Vector north, east, down to fly along there; None: `heading_deg` is given."""
    climb_deg: Annotated[float, between(-89, 89)] | None = None
    """Angle of the velocity over ground above the horizon; None: 0, or that of `direction`."""
    tolerance_m: Annotated[float, above(0, 1000)] = 5.0
    """Largest distance at which it counts as reached."""
    tolerance_deg: Annotated[float, above(0, 180)] = 10.0
    """Largest error of course and of climb at which it counts as reached."""
    attempts: Annotated[int, between(0, 1000)] = 0
    """Number of missed passes after which the goal is given up; 0: never."""


class VehicleEntry(Table):
    """A vehicle as it is written."""

    id: Annotated[int, between(1, 250)]
    """Its MAVLink system id."""
    position_m: Position
    """Position at the start, north, east and down of the origin."""
    heading_deg: Angle = 0.0
    """Yaw at the start."""
    attitude_deg: Attitude | None = None
    """Roll, pitch and yaw at the start of a rigid body, instead of `heading_deg`."""
    airspeed_mps: Speed | None = None
    """True airspeed at the start; None: the aircraft's cruise, or KINEMATIC_AIRSPEED of a rigid
    body."""
    aircraft: str = DEFAULT_AIRCRAFT
    """Name of its aircraft; the kinematic plant takes DEFAULT_AIRCRAFT instead."""
    icao: Address | None = None
    """ICAO address of its own transponder; None: it has none."""
    identify: bool = False
    """Whether a test flight before the first goal identifies the aircraft."""
    goal: Annotated[list[GoalEntry], Field(min_length=1)]


class ScenarioHead(Table):
    """The part of a scenario that concerns all vehicles."""

    name: Name
    plant: Plant = "jsbsim"
    """What is simulated: aeroplanes, or rigid bodies."""
    law: Law = "flight"
    """The guidance law."""
    duration_s: Annotated[float, above(0, 86_400)] = 300.0
    """Longest simulated time of a run."""
    seed: Annotated[int, between(0, 2**32 - 1)] = 1
    """Seed of everything random."""
    start_time: Time = datetime(2026, 1, 1, tzinfo=UTC)
    """Date and time of time zero."""
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
    """A scenario file as it is written."""

    vehicle: Annotated[list[VehicleEntry], Field(min_length=1)]
    obstacle: Annotated[list[ObstacleEntry], Field(default_factory=list)]
    traffic: list[TrafficEntry] = Field(default_factory=list[TrafficEntry])
    vary: Vary = Field(default_factory=dict[str, Distribution])
    """Of campaigns alone: a run flies the values that are written."""
