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
"""Least and greatest value of a flight; None where it is not finite."""


@dataclass(frozen=True)
class GoalResult:
    """How a goal was met; None where the flight had no pass of it."""

    reached: bool
    """Whether a pass was within all tolerances of the goal."""
    time_s: float | None
    """When it was passed, since the start of the run."""
    miss_m: float | None
    """Distance from it."""
    told_miss_m: float | None
    """Distance from it that the companion announced; None: it announced nothing of the pass."""
    course_error_deg: float | None
    """Angle between the course and the goal's, not negative."""
    climb_error_deg: float | None
    """Difference of the climb from the goal's, not negative."""


@dataclass(frozen=True)
class ObstacleResult:
    """How near a vehicle came to an obstacle."""

    name: str
    min_level: float | None
    """Least level U, dimensionless: below 1 inside."""
    min_clearance_m: float | None
    """Least distance of the vehicle's centre from its surface, negative inside."""


@dataclass(frozen=True)
class MeasuredResult:
    """A number of the aircraft file as the test flight has shown it; None where it has not."""

    key: str
    """Dotted key in the aircraft file, which tells the unit."""
    value: float | None
    sigma: float | None
    """Standard deviation of the value, in its unit."""
    used: bool
    """Whether the companion flew with it."""


@dataclass(frozen=True)
class VehicleResult:
    """How one vehicle flew."""

    id: int
    goals: tuple[GoalResult, ...]
    """Results of its goals, in order."""
    obstacles: tuple[ObstacleResult, ...]
    """Results of the obstacles, in the order of the scenario."""
    fence_clearance_m: float | None
    """Least distance from where the fence is violated, negative there; None: there is no fence."""
    assurance: AssuranceResult | None
    """What the run-time assurance did; None: there was nothing to keep clear of."""
    field: FieldResult | None
    """What law `field` followed; None: another law was flown."""
    max_bank_deg: float | None
    """Largest bank to either side."""
    load_factor: Range
    """Load factor, dimensionless."""
    airspeed_mps: Range
    """True airspeed."""
    altitude_m: Range
    """Altitude above mean sea level."""
    setpoints: int
    """Number of setpoints that were sent."""
    setpoint_rate_hz: float | None
    """Average rate of setpoints over the whole run."""
    traffic: tuple[TrafficResult, ...] = ()
    """Results of other aircraft, in the order of the scenario."""
    identified: tuple[MeasuredResult, ...] = ()
    """What a test flight has shown; empty: none went before the first goal."""


@dataclass(frozen=True)
class Result:
    """What `result.json` holds."""

    name: str
    """Name of the scenario."""
    version: str
    """Version of vfguide."""
    seed: int
    """Seed of everything random."""
    verdict: Literal["good", "bad"]
    reasons: tuple[str, ...]
    """Reasons for a bad verdict; empty if it is good."""
    sim_s: float
    """Simulated time."""
    wall_s: float
    """Real time that the flight loop took."""
    realtime_factor: float | None
    """Ratio of simulated to real time."""
    min_separation_m: float | None
    """Least distance between the centres of two vehicles; None: there is only one."""
    vehicles: tuple[VehicleResult, ...]

    def to_json(self) -> str:
        """As strict JSON."""
        return json.dumps(asdict(self), indent=2, allow_nan=False) + "\n"


def write_result(result: Result, path: Path) -> None:
    """Write `result.json`."""
    write_atomically(path, result.to_json())
