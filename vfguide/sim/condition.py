"""Initial conditions of a simulated flight: model, place, motion and weather."""

import hashlib
import math
from dataclasses import dataclass, field
from pathlib import Path

from vfguide.geometry.vector import Vec3
from vfguide.sim.signals import Controls
from vfguide.sim.turbulence import Turbulence


@dataclass(frozen=True)
class Model:
    """A JSBSim model: the file `directory`/`name`/`name`.xml."""

    directory: Path
    name: str

    @property
    def folder(self) -> Path:
        """The model's own folder."""
        return self.directory / self.name

    @property
    def file(self) -> Path:
        """The file that JSBSim loads."""
        return self.folder / f"{self.name}.xml"

    def fingerprint(self) -> str:
        """A digest of every XML file of the model."""
        texts = (file.read_bytes() for file in sorted(self.folder.rglob("*.xml")))
        return hashlib.sha256(b"\0".join(texts)).hexdigest()


@dataclass(frozen=True)
class FlightCondition:
    """Motion through the air with the controls held; `trim` finds those without acceleration."""

    airspeed: float
    """True airspeed [m/s]."""
    alpha: float = 0.0
    """Angle of attack [rad]."""
    beta: float = 0.0
    """Sideslip [rad]."""
    bank: float = 0.0
    """Euler roll angle [rad]."""
    climb: float = 0.0
    """Angle of the path through the air above the horizon [rad]."""
    omega_b: Vec3 = (0.0, 0.0, 0.0)
    """Body rates [rad/s]."""
    controls: Controls = field(default_factory=Controls)

    @property
    def pitch(self) -> float:
        """Euler pitch angle [rad].

        Stevens and Lewis, Aircraft Control and Simulation, rate-of-climb constraint:
        tan(pitch) = (a b + sin(climb) sqrt(a^2 - sin^2(climb) + b^2)) / (a^2 - sin^2(climb)).
        """
        a = math.cos(self.alpha) * math.cos(self.beta)
        b = math.sin(self.bank) * math.sin(self.beta)
        b += math.cos(self.bank) * math.sin(self.alpha) * math.cos(self.beta)
        s = math.sin(self.climb)
        return math.atan2(a * b + s * math.sqrt(a * a - s * s + b * b), a * a - s * s)

    @property
    def v_air_b(self) -> Vec3:
        """Velocity through the air, body FRD [m/s]."""
        in_plane = self.airspeed * math.cos(self.beta)
        return (
            in_plane * math.cos(self.alpha),
            self.airspeed * math.sin(self.beta),
            in_plane * math.sin(self.alpha),
        )


@dataclass(frozen=True)
class Start:
    """Where and how a flight begins."""

    latitude: float
    """Geodetic latitude [rad]."""
    longitude: float
    """Longitude [rad]."""
    altitude: float
    """Altitude above mean sea level [m]."""
    yaw: float
    """Yaw [rad]."""
    condition: FlightCondition


@dataclass(frozen=True)
class Weather:
    """Wind and gusts. Winds are where they blow toward, NED."""

    wind_n: Vec3 = (0.0, 0.0, 0.0)
    """The wind [m/s], at the beginning and at the height of the shear if it changes."""
    turbulence: Turbulence = Turbulence.NONE
    seed: int = 0
    """Seed of the gusts."""
    changes: tuple[tuple[float, Vec3], ...] = ()
    """Times [s], ascending, and winds [m/s]: linear from one to the next, the last one stays."""
    shear_n: Vec3 = (0.0, 0.0, 0.0)
    """Change of the wind for each metre of height [1/s]."""
    shear_height: float = 0.0
    """Height above the ground at which the shear adds nothing [m]."""

    @property
    def varies(self) -> bool:
        """Whether the wind changes with time or height."""
        return bool(self.changes) or any(self.shear_n)

    def wind_at(self, time: float, height: float) -> Vec3:
        """The wind [m/s] at a time [s] and a height above the ground [m], without its gusts."""
        north, east, down = self._wind_of(time)
        above = height - self.shear_height
        return (
            north + above * self.shear_n[0],
            east + above * self.shear_n[1],
            down + above * self.shear_n[2],
        )

    def _wind_of(self, time: float) -> Vec3:
        before, wind = 0.0, self.wind_n
        for after, following in self.changes:
            if time < after:
                part = (time - before) / (after - before)
                return (
                    wind[0] + part * (following[0] - wind[0]),
                    wind[1] + part * (following[1] - wind[1]),
                    wind[2] + part * (following[2] - wind[2]),
                )
            before, wind = after, following
        return wind
