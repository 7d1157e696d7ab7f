"""What is simulated, as it is written: the air, the software autopilots and the link to them.

The companion never sees these numbers.
"""

from typing import Annotated, Literal

from pydantic import Field

from vfguide.files.toml_types import Angle, Position, Table, above, between, word

WindSpeed = Annotated[float, between(0, 50)]
"""A speed of the wind [m/s]."""
Delay = Annotated[float, between(0, 2000)]
"""A delay of the link [ms]."""
Turbulence = Annotated[
    Literal["none", "light", "moderate", "severe"], word("none", "light", "moderate", "severe")
]
AirspeedFault = Annotated[
    Literal["missing", "frozen", "blocked"], word("missing", "frozen", "blocked")
]


class Weather(Table):
    """The pressure of the air."""

    qnh_hpa: Annotated[float, between(870, 1085)] = 1013.25
    """Pressure at mean sea level. Pressure altitudes follow it, the density of the air does not."""


class WindChange(Table):
    """A wind that the wind changes to, linearly since the change before."""

    time_s: Annotated[float, above(0, 86_400)]
    """When it is reached."""
    speed_mps: WindSpeed
    from_deg: Angle | None = None
    """Direction from which it comes; None: that of the beginning."""


class Wind(Table):
    """The motion of the air."""

    speed_mps: WindSpeed = 0.0
    """Speed at the beginning."""
    from_deg: Angle = 0.0
    """Direction from which it comes at the beginning."""
    turbulence: Turbulence = "none"
    """Intensity of the gusts, of MIL-F-8785C."""
    shear_mps_per_100m: Annotated[float, between(-20, 20)] = 0.0
    """Speed that the wind gains with each 100 m of height, in its direction at the beginning."""
    shear_height_m: Annotated[float, between(0, 10_000)] = 100.0
    """Height above the ground at which the shear adds nothing."""
    change: list[WindChange] = Field(default_factory=list[WindChange])
    """Changes of the wind, in the order of time."""

    @property
    def stages(self) -> tuple[tuple[float, float, float], ...]:
        """The winds between which it changes: when [s], speed [m/s], coming from where [deg]."""
        changes = (
            (each.time_s, each.speed_mps, self.from_deg if each.from_deg is None else each.from_deg)
            for each in self.change
        )
        return ((0.0, self.speed_mps, self.from_deg), *changes)


class Reset(Table):
    """A position reset of every autopilot."""

    time_s: Annotated[float, between(0, 86_400)]
    """When it happens."""
    position_m: Position = (0.0, 0.0, 0.0)
    """Jump of the estimated position: north, east, down."""
    origin_m: Position = (0.0, 0.0, 0.0)
    """Jump of the origin of the local frame: north, east, down."""


class Autopilot(Table):
    """The software autopilots: their sensors, motors and messages."""

    airspeed_fails_at_s: Annotated[float, between(0, 86_400)] | None = None
    """When the airspeed sensor fails; 0: there is none; None: it never does."""
    airspeed_fault: AirspeedFault = "missing"
    """How it fails."""
    thrust_scale: Annotated[float, above(0, 2)] = 1.0
    """Thrust at the start, as a share of that of the thrust map."""
    thrust_sag_per_min: Annotated[float, between(0, 1)] = 0.0
    """Decrease of this share in a minute, as a battery runs down."""
    thrust_floor: Annotated[float, between(0, 1)] = 0.5
    """Least value of this share."""
    wind_message: bool = True
    """Whether WIND_COV is sent."""
    pressure_message: bool = True
    """Whether SCALED_PRESSURE is sent to those who ask for it."""
    reset: list[Reset] = Field(default_factory=list[Reset])


class Link(Table):
    """The link between each autopilot and its companion, as `vfguide run` simulates it."""

    delay_ms: Delay = 0.0
    """Delay from the autopilot to the companion."""
    delay_back_ms: Delay = 0.0
    """Delay from the companion to the autopilot."""


class Sensors(Table):
    """Standard deviations of the autopilots' errors; the defaults are those of small ones."""

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
