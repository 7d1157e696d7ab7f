"""What is simulated, as it is written: the air, the software autopilots and the link to them.

The companion never sees these numbers.
"""

from typing import Annotated, Literal

from pydantic import Field

from vfguide.files.toml_types import Angle, Position, Table, above, between, word

WindSpeed = Annotated[float, between(0, 50)]
Delay = Annotated[float, between(0, 2000)]
Turbulence = Annotated[
    Literal["none", "light", "moderate", "severe"], word("none", "light", "moderate", "severe")
]
AirspeedFault = Annotated[
    Literal["missing", "frozen", "blocked"], word("missing", "frozen", "blocked")
]


class Weather(Table):
    """The pressure of the air; the companion never sees it."""

    qnh_hpa: Annotated[float, between(870, 1085)] = 1013.25
    """At mean sea level. Pressure altitudes follow it, the density of the air does not."""


class WindChange(Table):
    """A change of the wind."""

    time_s: Annotated[float, above(0, 86_400)]
    speed_mps: WindSpeed
    from_deg: Angle | None = None
    """None: where it came from at the beginning."""


class Wind(Table):
    """The air's motion; the companion never sees these numbers."""

    speed_mps: WindSpeed = 0.0
    from_deg: Angle = 0.0
    """Where it comes from."""
    turbulence: Turbulence = "none"
    shear_mps_per_100m: Annotated[float, between(-20, 20)] = 0.0
    """What the wind gains on each 100 m of height, along its direction at the beginning."""
    shear_height_m: Annotated[float, between(0, 10_000)] = 100.0
    """Above the ground: where the wind has the written speed."""
    change: list[WindChange] = Field(default_factory=list[WindChange])
    """Linear from one to the next."""

    @property
    def stages(self) -> tuple[tuple[float, float, float], ...]:
        """The winds between which it changes: from when [s], speed [m/s], where from [deg]."""
        changes = (
            (each.time_s, each.speed_mps, self.from_deg if each.from_deg is None else each.from_deg)
            for each in self.change
        )
        return ((0.0, self.speed_mps, self.from_deg), *changes)


class Reset(Table):
    """A position reset of every autopilot."""

    time_s: Annotated[float, between(0, 86_400)]
    position_m: Position = (0.0, 0.0, 0.0)
    """By which the estimate of the position jumps: north, east, down."""
    origin_m: Position = (0.0, 0.0, 0.0)
    """By which the origin of the local frame moves: north, east, down."""


class Autopilot(Table):
    """The software autopilots: their sensors, motors and messages."""

    airspeed_fails_at_s: Annotated[float, between(0, 86_400)] | None = None
    """When the airspeed sensor fails; 0: there is none; None: it never does."""
    airspeed_fault: AirspeedFault = "missing"
    thrust_scale: Annotated[float, above(0, 2)] = 1.0
    """Thrust at the start, as a share of what the map of the motor says."""
    thrust_sag_per_min: Annotated[float, between(0, 1)] = 0.0
    """What the share loses in a minute."""
    thrust_floor: Annotated[float, between(0, 1)] = 0.5
    """The share falls no lower than this."""
    wind_message: bool = True
    """Whether WIND_COV is sent."""
    pressure_message: bool = True
    """Whether SCALED_PRESSURE is sent to who asks for it."""
    reset: list[Reset] = Field(default_factory=list[Reset])


class Link(Table):
    """The link between each autopilot and its companion, as `vfguide run` simulates it."""

    delay_ms: Delay = 0.0
    """From the autopilot to the companion."""
    delay_back_ms: Delay = 0.0
    """From the companion to the autopilot."""


class Sensors(Table):
    """Standard deviations of the autopilots' errors: typical of small ones."""

    position_m: Annotated[float, between(0, 100)] = 1.5
    height_m: Annotated[float, between(0, 100)] = 1.0
    drift_s: Annotated[float, above(0, 86_400)] = 100.0
    """Time constant of the drift of position and height."""
    velocity_mps: Annotated[float, between(0, 10)] = 0.1
    attitude_deg: Annotated[float, between(0, 20)] = 0.5
    attitude_bias_deg: Annotated[float, between(0, 20)] = 0.5
    yaw_deg: Annotated[float, between(0, 45)] = 1.0
    yaw_bias_deg: Annotated[float, between(0, 45)] = 1.5
    rate_dps: Annotated[float, between(0, 50)] = 0.3
    rate_bias_dps: Annotated[float, between(0, 50)] = 0.1
    airspeed_mps: Annotated[float, between(0, 20)] = 0.3
    airspeed_bias_mps: Annotated[float, between(0, 20)] = 0.7
    wind_mps: Annotated[float, between(0, 20)] = 0.5
