"""A scenario as it is flown: every default filled in, every goal in the scenario frame."""

import re

import tomli_w
from pydantic import Field

from vfguide import __version__
from vfguide.files.obstacle_entry import ShapeName
from vfguide.files.scenario_file import ScenarioHead
from vfguide.files.toml_types import Table, Vector
from vfguide.files.traffic_entry import AltitudeType, TrafficChange
from vfguide.geometry.units import US
from vfguide.geometry.vector import Vec3

_LIST = re.compile(r"\[\n((?: +[-+.\w]+,\n)+)\]")
"""Pattern of a list of numbers as tomli_w writes it, one number a line."""


class Goal(Table):
    """A pose to fly through."""

    position_m: Vector
    """Position north, east and down of the origin [m]."""
    heading_deg: float
    """Course over ground to have there."""
    climb_deg: float
    """Angle of the velocity over ground above the horizon to have there."""
    tolerance_m: float
    """Largest distance at which it counts as reached."""
    tolerance_deg: float
    """Largest error of course and of climb at which it counts as reached."""
    attempts: int = 0
    """Number of missed passes after which the goal is given up; 0: never."""


class Vehicle(Table):
    """A vehicle, its start and its goals in the order of flight."""

    id: int
    position_m: Vector
    """Position at the start, north, east and down of the origin [m]."""
    heading_deg: float | None = None
    """Yaw at the start; None: `attitude_deg` is given."""
    attitude_deg: Vector | None = None
    """Roll, pitch and yaw at the start; None: `heading_deg` is given."""
    airspeed_mps: float
    """True airspeed at the start."""
    aircraft: str
    """Name of the aircraft whose numbers guidance takes, on the kinematic plant too."""
    icao: str | None = None
    """ICAO address of its own transponder, six hexadecimal digits; None: it has none."""
    identify: bool = False
    """Whether a test flight goes before the first goal."""
    goals: tuple[Goal, ...] = Field(serialization_alias="goal")

    @property
    def euler_deg(self) -> Vec3:
        """Roll, pitch and yaw at the start [deg]."""
        return self.attitude_deg or (0.0, 0.0, self.heading_deg or 0.0)


class Obstacle(Table):
    """A body to keep out of; of the sizes, those of its shape are given."""

    name: str
    shape: ShapeName
    position_m: Vector
    """Position of its centre at time zero, north, east and down of the origin [m]."""
    radius_m: float | None = None
    height_m: float | None = None
    semi_axes_m: Vector | None = None
    exponents: Vector | None = None
    size_m: Vector | None = None
    """Whole lengths of a box along its axes."""
    heading_deg: float
    """Angle by which it is turned about the vertical, from north toward east."""
    velocity_mps: Vector
    """Its velocity, NED."""
    reactive_level: float
    """Level U below which it acts on the field, dimensionless."""
    visible_from_m: float
    """Largest distance from its surface at which it is detected."""


class Traffic(Table):
    """Another aircraft, with a transponder; the keys are explained in `TrafficEntry`."""

    name: str
    icao: str
    position_m: Vector
    velocity_mps: Vector
    interval_s: float
    delay_s: float
    position_error_m: float
    altitude_type: AltitudeType
    change: tuple[TrafficChange, ...] = ()


class Scenario(ScenarioHead):
    """A scenario as it is flown."""

    vehicles: tuple[Vehicle, ...] = Field(serialization_alias="vehicle")
    obstacles: tuple[Obstacle, ...] = Field(default=(), serialization_alias="obstacle")
    traffic: tuple[Traffic, ...] = ()

    def airspeed_of(self, vehicle: Vehicle) -> float:
        """True airspeed that the guidance of `vehicle` flies [m/s]."""
        return self.guidance.airspeed_mps or vehicle.airspeed_mps

    def to_toml(self) -> str:
        """A scenario file that resolves to this scenario again."""
        table = self.model_dump(by_alias=True, exclude_none=True)
        if not self.obstacles:
            del table["obstacle"]
        if not self.traffic:
            del table["traffic"]
        head = f"# Resolved by vfguide {__version__}: every default filled in.\n\n"
        return head + _LIST.sub(_on_one_line, tomli_w.dumps(table))


def start_us(scenario: Scenario) -> int:
    """The date and time of time zero, UTC [us since 1970]."""
    return round(scenario.start_time.timestamp() / US)


def _on_one_line(numbers: re.Match[str]) -> str:
    return f"[{', '.join(numbers[1].replace(',', ' ').split())}]"
