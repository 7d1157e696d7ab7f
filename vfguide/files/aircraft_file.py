"""The aircraft file `NAME.toml`: what the companion knows of an aircraft."""

import math
import re
from typing import Annotated

import tomli_w
from pydantic import AfterValidator

from vfguide.aircraft.gain_scheduling import airspeed_gains
from vfguide.aircraft.identification import Identified
from vfguide.aircraft.performance import Performance
from vfguide.files.data import AircraftFiles
from vfguide.files.source import Source
from vfguide.files.toml_types import Table, above, between, rule_broken

Speed = Annotated[float, above(0, 150)]
"""An airspeed [m/s]."""
PathAngle = Annotated[float, above(0, 45)]
"""The amount of a path angle [deg]."""
BodyRate = Annotated[float, above(0, 720)]
"""The amount of a body rate [deg/s]."""
Alpha = Annotated[float, between(-20, 20)]
"""An angle of attack [deg]."""

TYPICAL_GLIDE = 10.0
"""Ratio of lift to drag at cruise that is assumed where the thrust was not measured; the shipped
aircraft have 8.5 to 10 (`tools/measure_aircraft.py`)."""
TYPICAL_INDUCED = 0.15
"""Share of the induced drag that is assumed where the thrust was not measured; the shipped aircraft
have 0.13 to 0.30 (`tools/measure_aircraft.py`)."""
TYPICAL_ZERO_DEG = -3.0
"""Angle of attack of zero lift that is assumed where the lift was not measured [deg]; the shipped
aircraft have -2.5 to -3.5 (`tools/measure_aircraft.py`)."""
TYPICAL_STALL_DEG = 11.0
"""Angle of attack above that of zero lift, in the slowest level flight, that is assumed where the
lift was not measured [deg]; the shipped aircraft have 11 to 16 (`tools/measure_aircraft.py`)."""


class Airspeed(Table):
    """Equivalent airspeeds of level flight."""

    min_mps: Speed
    """The slowest that is flown, which guidance takes as the stall at load factor 1."""
    cruise_mps: Speed
    """The one at which trim and slopes of the thrust hold."""
    max_mps: Speed
    """The fastest that is flown."""


class Limits(Table):
    """The limits of what guidance may ask for; path angles are those through the air."""

    bank_max_deg: Annotated[float, between(5, 75)]
    load_factor_max: Annotated[float, above(1, 10)]
    load_factor_min: Annotated[float, between(-1, 0.95)]
    climb_max_deg: PathAngle
    """Steepest climb."""
    descent_max_deg: PathAngle
    """Steepest descent, positive."""
    roll_rate_max_dps: BodyRate
    pitch_rate_max_dps: BodyRate
    yaw_rate_max_dps: BodyRate


class Lift(Table):
    """Angle of attack alpha_zero + alpha_load n / V^2: load factor n, equivalent airspeed V."""

    alpha_zero_deg: Alpha = TYPICAL_ZERO_DEG
    """Angle of attack of zero lift."""
    alpha_load_deg_m2ps2: Annotated[float, above(0, 100_000)] | None = None
    """Slope of the angle of attack over n / V^2 [deg m^2/s^2]; None: that which gives
    TYPICAL_STALL_DEG at the slowest airspeed."""


class Thrust(Table):
    """Thrust setpoint, 0 to 1, as a share of full thrust at cruise at sea level."""

    trim: Annotated[float, between(0, 1)]
    """Setpoint of level flight at cruise."""
    per_climb: Annotated[float, above(0, 20)] | None = None
    """Weight over full thrust: setpoint for each unit of the sine of the path angle; None:
    TYPICAL_GLIDE times the trim, at least 1."""
    per_load: Annotated[float, between(0, 1)] | None = None
    """Setpoint for each unit of n^2 - 1, with load factor n; None: TYPICAL_INDUCED of the trim."""
    full_at_max: Annotated[float, between(0, 1)] | None = None
    """Full thrust at the fastest airspeed over that at cruise; None: what level flight takes there,
    at most 1."""
    per_airspeed: Annotated[float, between(0, 2)] | None = None
    """Setpoint for each m/s of airspeed missing [s/m]; None: what suits `per_climb` and the
    response of the thrust."""
    integral: Annotated[float, between(0, 1)] | None = None
    """Setpoint for each m/s of airspeed missing during 1 s [1/m]; None: likewise."""


class Response(Table):
    """How fast the aircraft follows setpoints."""

    roll_s: Annotated[float, above(0, 5)]
    """Time from a step of the roll rate setpoint to 63 % of it."""
    thrust_s: Annotated[float, between(0, 10)] = 0.5
    """Time from a step of the thrust setpoint to 63 % of it."""


def _folder_name(name: str) -> str:
    if not re.fullmatch(r"\w[\w-]*", name):
        raise rule_broken("allowed is the name of a folder: letters, digits, - and _")
    return name


class ModelTable(Table):
    """The JSBSim model that the simulator flies."""

    stock: Annotated[str, AfterValidator(_folder_name)] | None = None
    """Name of a model that the package jsbsim ships; None: the model is NAME/NAME.xml."""


class Aircraft(Table):
    """One aircraft as the companion knows it."""

    name: str
    """Name of the aircraft and of its file."""
    description: str = ""
    """What it is, in words."""
    source: str = ""
    """Where its numbers come from, in words."""
    airspeed: Airspeed
    limits: Limits
    lift: Lift = Lift()
    thrust: Thrust
    response: Response
    model: ModelTable = ModelTable()

    @property
    def alpha_load_deg(self) -> float:
        """`alpha_load_deg_m2ps2`, or the typical one where it was not measured [deg m^2/s^2]."""
        return self.lift.alpha_load_deg_m2ps2 or TYPICAL_STALL_DEG * self.airspeed.min_mps**2

    @property
    def _thrust_fade(self) -> float:
        """Share of full thrust that is lost with each m/s of true airspeed above cruise [s/m]."""
        speeds, thrust = self.airspeed, self.thrust
        if speeds.max_mps <= speeds.cruise_mps:
            return 0.0
        per_load = _known(thrust.per_load, TYPICAL_INDUCED * thrust.trim)
        q_ratio = (speeds.max_mps / speeds.cruise_mps) ** 2
        drag = (thrust.trim - per_load) * q_ratio + per_load / q_ratio
        left = _known(thrust.full_at_max, min(drag, 1.0))
        return (1.0 - left) / (speeds.max_mps - speeds.cruise_mps)

    def performance(self) -> Performance:
        """The performance at sea-level density, in SI units and radians."""
        limits, lift, thrust = self.limits, self.lift, self.thrust
        per_climb = thrust.per_climb or max(TYPICAL_GLIDE * thrust.trim, 1.0)
        per_airspeed, integral = airspeed_gains(per_climb, self.response.thrust_s)
        return Performance(
            airspeed_min=self.airspeed.min_mps,
            airspeed_cruise=self.airspeed.cruise_mps,
            airspeed_max=self.airspeed.max_mps,
            bank_max=math.radians(limits.bank_max_deg),
            load_max=limits.load_factor_max,
            load_min=limits.load_factor_min,
            climb_max=math.radians(limits.climb_max_deg),
            descent_max=math.radians(limits.descent_max_deg),
            rate_max=(
                math.radians(limits.roll_rate_max_dps),
                math.radians(limits.pitch_rate_max_dps),
                math.radians(limits.yaw_rate_max_dps),
            ),
            alpha_zero=math.radians(lift.alpha_zero_deg),
            alpha_load=math.radians(self.alpha_load_deg),
            thrust_trim=thrust.trim,
            thrust_per_climb=per_climb,
            thrust_per_load=_known(thrust.per_load, TYPICAL_INDUCED * thrust.trim),
            thrust_per_airspeed=_known(thrust.per_airspeed, per_airspeed),
            thrust_integral=_known(thrust.integral, integral),
            thrust_fade=self._thrust_fade,
        )

    def as_identified(self, found: Identified, how: str) -> "Aircraft":
        """The aircraft with the estimates of a test flight; `how` tells their source in words."""
        each, used = found.aircraft, [estimate for estimate in found.estimates if estimate.used]
        table = self.model_dump(exclude_none=True)
        table["thrust"] |= {
            "per_climb": each.thrust_per_climb,
            "per_load": each.thrust_per_load,
            "per_airspeed": each.thrust_per_airspeed,
            "integral": each.thrust_integral,
        }
        for estimate in used:
            table[estimate.table][estimate.key] = estimate.value
        shown = ", ".join(map(str, used))
        table["source"] = f"{how}: {shown or 'nothing was seen'}; the rest: {self.source}"
        return Aircraft.model_validate(table)

    def to_toml(self) -> str:
        """The text of an aircraft file with these values."""
        return tomli_w.dumps(self.model_dump(exclude_none=True))


def _known(value: float | None, else_: float) -> float:
    return else_ if value is None else value


def load_aircraft(files: AircraftFiles) -> Aircraft:
    """The aircraft in `files`.

    Raises:
        InputError: its file says something that is not allowed.
    """
    source = Source(files.performance)
    aircraft = source.parse(Aircraft)
    if aircraft.name != files.name:
        raise source.error(
            ("name",), f'not the name of the file, allowed "{files.name}"', aircraft.name
        )
    speeds = aircraft.airspeed
    if not speeds.min_mps <= speeds.cruise_mps <= speeds.max_mps:
        rule = f"not between min_mps {speeds.min_mps} and max_mps {speeds.max_mps}"
        raise source.error(("airspeed", "cruise_mps"), rule, speeds.cruise_mps)
    return aircraft
