"""What `result.json` holds, and how it is written."""

import json
from dataclasses import asdict, dataclass
from pathlib import Path
from typing import Literal

from vfguide.files.atomic import write_atomically
from vfguide.results.field_share import FieldResult
from vfguide.results.interventions import AssuranceResult
from vfguide.results.traffic_results import TrafficResult

Range = tuple[float | None, float | None]


@dataclass(frozen=True)
class GoalResult:
    """How a goal was met; None where the flight had no pass of it."""

    reached: bool
    time_s: float | None
    miss_m: float | None
    told_miss_m: float | None
    """What the companion announced of the pass; None: nothing."""
    course_error_deg: float | None
    climb_error_deg: float | None


@dataclass(frozen=True)
class ObstacleResult:
    """How near an obstacle came."""

    name: str
    min_level: float | None
    min_clearance_m: float | None


@dataclass(frozen=True)
class MeasuredResult:
    """A number of the aircraft file as the test flight has shown it; None: it has not."""

    key: str
    value: float | None
    sigma: float | None
    used: bool


@dataclass(frozen=True)
class VehicleResult:
    """How one vehicle flew; ranges are (least, most)."""

    id: int
    goals: tuple[GoalResult, ...]
    obstacles: tuple[ObstacleResult, ...]
    fence_clearance_m: float | None
    """None: there is no fence."""
    assurance: AssuranceResult | None
    """None: there is nothing to keep clear of."""
    field: FieldResult | None
    """None: another law than `field` was flown."""
    max_bank_deg: float | None
    load_factor: Range
    airspeed_mps: Range
    altitude_m: Range
    setpoints: int
    setpoint_rate_hz: float | None
    traffic: tuple[TrafficResult, ...] = ()
    identified: tuple[MeasuredResult, ...] = ()
    """Empty: no test flight went before the first goal."""


@dataclass(frozen=True)
class Result:
    """What `result.json` holds."""

    name: str
    version: str
    seed: int
    verdict: Literal["good", "bad"]
    reasons: tuple[str, ...]
    sim_s: float
    wall_s: float
    realtime_factor: float | None
    min_separation_m: float | None
    vehicles: tuple[VehicleResult, ...]

    def to_json(self) -> str:
        """As strict JSON."""
        return json.dumps(asdict(self), indent=2, allow_nan=False) + "\n"


def write_result(result: Result, path: Path) -> None:
    """Write `result.json`."""
    write_atomically(path, result.to_json())
