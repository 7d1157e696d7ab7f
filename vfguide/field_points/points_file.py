"""Files of points at which a field is wanted."""

import csv
import math
from collections.abc import Sequence
from pathlib import Path

import numpy as np

from vfguide.files.errors import InputError
from vfguide.kernels.rows import Table

COLUMNS = ("x", "y", "z", "vx", "vy", "vz", "t")
"""Names of the columns of a file of points: position [m] and velocity [m/s] in the scenario frame,
time [s]."""
LARGEST_NUMBER = 1e9
"""Largest value of any number in a file of points; chosen."""

Points = Table
"""The rows of N points."""


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
