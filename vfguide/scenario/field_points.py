"""The field of a scenario at points of one's own: `vfguide field`, and the same from Python.

>>> loaded = load_scenario("paper/example-3")
>>> vehicle = vehicle_of(loaded.scenario, 4)
>>> fields = fields_at(loaded, vehicle, read_points(Path("points.csv")), "paper")
"""

import csv
import math
from collections.abc import Sequence
from pathlib import Path
from typing import Any, Literal

import numpy as np
from numpy.typing import NDArray

from vfguide.field.composite_arrays import composite_fields
from vfguide.field.robots import Spacing
from vfguide.files.errors import InputError
from vfguide.geometry.so3 import from_euler
from vfguide.geometry.units import DEG
from vfguide.geometry.vector import Mat3, Vec3, scale
from vfguide.kernels.rows import Table, columns
from vfguide.scenario.field_point import FieldPoint, Point, point_of
from vfguide.scenario.flight_points import NoPlanError, flight_field
from vfguide.scenario.load import LoadedScenario
from vfguide.scenario.obstacles import rows_of
from vfguide.scenario.plans import frame_of, plan_of
from vfguide.scenario.resolved import Scenario, Vehicle
from vfguide.scenario.wind import blowing

COLUMNS = ("x", "y", "z", "vx", "vy", "vz", "t")
"""Names of the columns of a file of points: position [m] and velocity [m/s] in the scenario frame,
time [s]."""
LARGEST_NUMBER = 1e9
"""Largest value of any number in a file of points; chosen."""

Points = Table
"""The rows of N points."""
LawName = Literal["paper", "flight"]


def read_points(path: Path) -> Points:
    """The points of a CSV file.

    Raises:
        InputError: it cannot be read, or is no table of points.
    """
    try:
        with path.open(newline="", encoding="utf-8-sig") as file:
            rows = [[cell.strip() for cell in row] for row in csv.reader(file)]
    except OSError as error:
        raise InputError(f"--points {path}: {error.strerror or error}") from error
    except (UnicodeDecodeError, csv.Error) as error:
        raise InputError(f"--points {path}: not a CSV file: {error}") from error
    header = ",".join(COLUMNS)
    if not rows or rows[0] != list(COLUMNS):
        first = ",".join(rows[0]) if rows else ""
        raise InputError(f'--points {path}: its first line is "{first}", allowed is "{header}"')
    points = [_point(path, line, row) for line, row in enumerate(rows[1:], start=2) if row]
    if not points:
        raise InputError(f"--points {path}: no points, at least one line must follow {header}")
    return np.array(points)


def _point(path: Path, line: int, row: Sequence[str]) -> list[float]:
    if len(row) != len(COLUMNS):
        rule = f"{len(row)} values, allowed {len(COLUMNS)}: {','.join(COLUMNS)}"
        raise InputError(f"--points {path}: line {line}: {rule}")
    return [_number(path, line, *cell) for cell in zip(COLUMNS, row, strict=True)]


def _number(path: Path, line: int, column: str, text: str) -> float:
    try:
        number = float(text)
    except ValueError:
        number = math.nan
    if not abs(number) <= LARGEST_NUMBER:
        rule = f"allowed is a number from -{LARGEST_NUMBER:g} to {LARGEST_NUMBER:g}"
        raise InputError(f'--points {path}: line {line}: {column} = "{text}": {rule}')
    return number


def fields_at(
    loaded: LoadedScenario, vehicle: Vehicle, points: Points, law: LawName
) -> list[FieldPoint]:
    """The field that leads `vehicle` to its first goal, at each of the points.

    Raises:
        InputError: law flight, and from one of the points there is no plan.
    """
    if law == "paper":
        return paper_fields(loaded.scenario, vehicle, points)
    return flight_fields(loaded, vehicle, points)


def paper_fields(scenario: Scenario, vehicle: Vehicle, points: Points) -> list[FieldPoint]:
    """The composite field of the paper among obstacles and the robots to give way to."""
    avoidance = scenario.avoidance
    at: Any = columns(Point, points)
    fields = composite_fields(
        frame_of(vehicle.goals[0]),
        at.p_n,
        at.v_n,
        at.time,
        rows_of(scenario.obstacles),
        others_at(scenario, vehicle, at.time),
        Spacing(avoidance.safety_radius_m, avoidance.detection_range_m),
    )
    lists = (array.tolist() for array in fields)
    return [
        FieldPoint(vec(F), vec(G), vec(H), mat(R), vec(Omega_a), tuple(chi))
        for F, G, H, R, Omega_a, chi in zip(*lists, strict=True)
    ]


def vec(values: Sequence[float]) -> Vec3:
    """Three numbers as a vector."""
    x, y, z = values
    return (x, y, z)


def mat(rows: Sequence[Sequence[float]]) -> Mat3:
    """Three rows as a matrix."""
    x, y, z = rows
    return (vec(x), vec(y), vec(z))


def others_at(scenario: Scenario, vehicle: Vehicle, t: NDArray[np.float64]) -> Points:
    """The robots that `vehicle` gives way to at times (N,): position and velocity, (N, K, 6).

    Each flies straight on from its start at the velocity that law paper has there.
    """
    above = [other for other in scenario.vehicles if other.id < vehicle.id]
    if not (above and scenario.avoidance.between_vehicles):
        return np.zeros((len(t), 0, 6))
    start = np.array([other.position_m for other in above])
    velocity = np.array([velocity_at_start(scenario, other) for other in above])
    now = start + t[:, None, None] * velocity
    return np.concatenate((now, np.broadcast_to(velocity, now.shape)), axis=-1)


def velocity_at_start(scenario: Scenario, vehicle: Vehicle) -> Vec3:
    """k_v |p - p_d| along body x, NED [m/s]."""
    R_nb = from_euler(*(angle * DEG for angle in vehicle.euler_deg))
    away = math.dist(vehicle.position_m, vehicle.goals[0].position_m)
    speed = scenario.guidance.k_v * away
    return scale(speed, (R_nb[0][0], R_nb[1][0], R_nb[2][0]))


def flight_fields(loaded: LoadedScenario, vehicle: Vehicle, points: Points) -> list[FieldPoint]:
    """The plan of law `flight` at each of the points, in the wind that the scenario begins with.

    Raises:
        InputError: from one of them there is no plan.
    """
    wind, plan, fields = loaded.scenario.wind, plan_of(loaded, vehicle), list[FieldPoint]()
    wind_n = blowing(wind.speed_mps, wind.from_deg)
    for number, row in enumerate(points, start=1):
        try:
            fields.append(flight_field(plan, point_of(row.tolist()), wind_n))
        except NoPlanError as error:
            raise InputError(f"--points: point {number}: {error}") from error
    return fields
