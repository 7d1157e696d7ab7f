"""What the companion knows of an aircraft: the file `aircraft/NAME.toml`."""

import math
import re
from typing import Annotated

from pydantic import AfterValidator

from vfguide.flight.performance import Performance
from vfguide.scenario.data import AircraftFiles
from vfguide.scenario.source import Source
from vfguide.scenario.tables import Table, above, between, rule_broken

Speed = Annotated[float, above(0, 150)]
PathAngle = Annotated[float, above(0, 45)]
BodyRate = Annotated[float, above(0, 720)]
Alpha = Annotated[float, between(-20, 20)]


class Airspeed(Table):
    """True airspeeds of level flight."""

    min_mps: Speed
    cruise_mps: Speed
    max_mps: Speed


class Limits(Table):
    """The most that the guidance may ask for."""

    bank_max_deg: Annotated[float, between(5, 75)]
    load_factor_max: Annotated[float, above(1, 10)]
    load_factor_min: Annotated[float, between(-1, 0.95)]
    climb_max_deg: PathAngle
    descent_max_deg: PathAngle
    roll_rate_max_dps: BodyRate
    pitch_rate_max_dps: BodyRate
    yaw_rate_max_dps: BodyRate


class Lift(Table):
    """alpha = alpha_zero + alpha_load n / V^2, with the load factor n and true airspeed V."""

    alpha_zero_deg: Alpha = 0.0
    alpha_load_deg_m2ps2: Annotated[float, between(0, 100_000)] = 0.0


class Thrust(Table):
    """Thrust setpoint, 0 to 1: trim and slopes at cruise, gains of the airspeed."""

    trim: Annotated[float, between(0, 1)]
    per_climb: Annotated[float, above(0, 20)] = 1.0
    per_load: Annotated[float, between(0, 1)] = 0.05
    per_airspeed: Annotated[float, between(0, 2)] = 0.03
    integral: Annotated[float, between(0, 1)] = 0.01


class Response(Table):
    """How fast the aircraft follows what it is asked for."""

    roll_s: Annotated[float, above(0, 5)]
    thrust_s: Annotated[float, between(0, 10)] = 0.5


def _folder_name(name: str) -> str:
    if not re.fullmatch(r"\w[\w-]*", name):
        raise rule_broken("allowed is the name of a folder: letters, digits, - and _")
    return name


class ModelTable(Table):
    """What the simulator flies."""

    stock: Annotated[str, AfterValidator(_folder_name)] | None = None
    """Name of an aircraft that the jsbsim package ships; None: NAME/NAME.xml."""


class Aircraft(Table):
    """One aircraft as the companion knows it."""

    name: str
    description: str = ""
    source: str = ""
    airspeed: Airspeed
    limits: Limits
    lift: Lift = Lift()
    thrust: Thrust
    response: Response
    model: ModelTable = ModelTable()

    def performance(self) -> Performance:
        """The same for the flight law, SI units and radians."""
        limits, lift, thrust = self.limits, self.lift, self.thrust
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
            alpha_load=math.radians(lift.alpha_load_deg_m2ps2),
            thrust_trim=thrust.trim,
            thrust_per_climb=thrust.per_climb,
            thrust_per_load=thrust.per_load,
            thrust_per_airspeed=thrust.per_airspeed,
            thrust_integral=thrust.integral,
        )


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
