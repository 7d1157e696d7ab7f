"""The field of a scenario at points of one's own: `vfguide field`, and the same from Python.

>>> loaded = load_scenario("paper/example-3")
>>> vehicle = vehicle_of(loaded.scenario, 4)
>>> fields = fields_at(loaded, vehicle, read_points(Path("points.csv")), "paper")
"""

import csv
import math
from collections.abc import Sequence
from pathlib import Path
from typing import Any, Literal, NamedTuple

import numpy as np
from numpy.typing import NDArray

from vfguide.aircraft.state import FlightState
from vfguide.companion.plan import Plan
from vfguide.estimation.estimation import Inputs
from vfguide.field.composite_arrays import composite_fields
from vfguide.field.robots import Spacing
from vfguide.files.errors import InputError
from vfguide.geometry.atmosphere import isa_density
from vfguide.geometry.rows import Row, Table, columns, python_reader
from vfguide.geometry.so3 import from_euler, from_quaternion, log
from vfguide.geometry.units import DEG
from vfguide.geometry.vector import ZERO, Mat3, Vec3, add, matmul, scale, sub, transpose
from vfguide.loop.state import fresh_state
from vfguide.loop.step import step
from vfguide.scenario.load import LoadedScenario
from vfguide.scenario.obstacles import rows_of
from vfguide.scenario.plans import frame_of, plan_of
from vfguide.scenario.resolved import Scenario, Vehicle

COLUMNS = ("x", "y", "z", "vx", "vy", "vz", "t")
"""Names of the columns of a file of points: position [m] and velocity [m/s] in the scenario frame,
time [s]."""
LARGEST_NUMBER = 1e9
"""Largest value of any number in a file of points; chosen."""
DIFFERENCE_TIME = 1e-3
"""Time before and after a point between which the reference attitude is differentiated [s];
chosen."""

Points = Table
"""The rows of N points."""
LawName = Literal["paper", "flight"]


class Point(NamedTuple):
    """A point at which the field is wanted, in the scenario frame, in the order of COLUMNS."""

    p_n: Vec3
    """Position [m]."""
    v_n: Vec3
    """Velocity [m/s]."""
    time: float
    """Time [s]."""


point_of = python_reader(Point)


class FieldPoint(NamedTuple):
    """The field at one point, in the scenario frame; what a law does not have is None."""

    F: Vec3
    """Law paper: F of the composite, not normalised. Law flight: the wanted direction through the
    air, a unit vector."""
    G: Vec3 | None
    """G' of the same composite, orthogonal to F."""
    H: Vec3 | None
    """H' of the same composite, orthogonal to F and G."""
    R_a: Mat3
    """The auxiliary attitude; law flight: the reference attitude that is flown. Body to NED."""
    Omega_a: Vec3
    """Body rates of R_a for the motion through the point [rad/s]."""
    chi: tuple[float, ...]
    """One of each obstacle."""


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
        InputError: law flight among obstacles, whose routes are not shown.
    """
    if law == "paper":
        return paper_fields(loaded.scenario, vehicle, points)
    if loaded.scenario.obstacles:
        rule = "not supported yet among obstacles, allowed is paper"
        raise InputError(f"--law flight: {rule}")
    plan = plan_of(loaded, vehicle)
    return [flight_field(plan, point) for point in points]


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


def flight_field(plan: Plan, point: Row) -> FieldPoint:
    """The reference of the flight law at a point on a new leg to the first goal.

    The air is still, the airspeed the one to fly; the law looks at the velocity's direction only.
    """
    p_n, v_n, time = point_of(point.tolist())
    azimuth, gamma, R_a = flight_reference(plan, p_n, v_n, time)
    step = scale(DIFFERENCE_TIME, v_n)
    *_, before = flight_reference(plan, sub(p_n, step), v_n, time - DIFFERENCE_TIME)
    *_, after = flight_reference(plan, add(p_n, step), v_n, time + DIFFERENCE_TIME)
    level = math.cos(gamma)
    F = (level * math.cos(azimuth), level * math.sin(azimuth), -math.sin(gamma))
    Omega_a = scale(0.5 / DIFFERENCE_TIME, log(matmul(transpose(before), after)))
    return FieldPoint(F, None, None, R_a, Omega_a, ())


def flight_reference(plan: Plan, p_n: Vec3, v_n: Vec3, time: float) -> tuple[float, float, Mat3]:
    """Azimuth and path angle wanted through the air [rad], and the reference attitude."""
    level = from_euler(0.0, 0.0, math.atan2(v_n[1], v_n[0]))
    state = FlightState(time, p_n, v_n, level, plan.gains.airspeed, (0.0, 0.0, 0.0))
    density = isa_density(plan.origin[2] - p_n[2])
    inputs = Inputs(state, state, ZERO, True, density)
    setpoint, _, told = step(inputs, fresh_state(), plan.legs, None, plan.law, plan.vehicle)
    return told.command.azimuth, told.command.gamma, from_quaternion(setpoint.q_nb)
