"""Enclosure checks: whether hazards enclose a place, so that not even a point could reach it."""

import math
from typing import Any

import numpy as np
from scipy import ndimage

from vfguide.airspace.footprint import Band
from vfguide.airspace.keep_out import KeepOutZone, KeepOutZones, joined, obstacle_zones
from vfguide.airspace.planar_clearance import clearance_at
from vfguide.field.obstacle import Rows
from vfguide.kernels.rows import columns

CELL = 4.0
"""Side of a cell of the grid [m]; chosen, since no aeroplane flies through a gap that it misses."""
MAX_CELLS = 500
"""Largest number of cells along a side of the grid; chosen, larger areas are not checked."""
BORDER_CELLS = 3.0
"""Number of cells by which the grid extends beyond all hazards and places on each side; chosen, so
that it contains a path round them all."""
Place = tuple[float, float]
"""Coordinates north and east [m]."""


def is_enclosed(
    obstacles: Rows, fence: KeepOutZones, band: Band, start: Place, goal: Place
) -> bool:
    """Whether no path in a band of heights leads from `start` to `goal`, hazards as at time zero.

    False where that is not known: the area is larger than MAX_CELLS, or one of the two is too near
    to a hazard.
    """
    hazards = joined(obstacle_zones(obstacles, band, 0.0), fence)
    zones = columns(KeepOutZone, hazards.table)
    places = np.vstack((np.column_stack((zones.x, zones.y)), start, goal))
    reach = np.append(zones.bounding_radius, (CELL, CELL))[:, None]
    low = (places - reach).min(axis=0) - BORDER_CELLS * CELL
    cells = np.ceil(((places + reach).max(axis=0) + BORDER_CELLS * CELL - low) / CELL).astype(int)
    if cells.max() > MAX_CELLS:
        return False
    north, east = (low[axis] + CELL * np.arange(cells[axis]) for axis in (0, 1))
    free = [[clearance_at(hazards, x, y, 0.0).distance > 0.0 for y in east] for x in north]
    labelled: Any = ndimage.label(np.array(free), structure=np.ones((3, 3)))
    regions, _ = labelled
    one, other = (region_at(regions, low, place) for place in (start, goal))
    return one > 0 and other > 0 and one != other


def region_at(regions: np.ndarray, low: np.ndarray, place: Place) -> int:
    """Number of the region of free cells that a place is in; 0 where its cell is not free.

    `regions` are the numbers of the cells (n, m), north and east; `low` is the place of the first
    of them [m].
    """
    i, j = (math.floor((place[axis] - low[axis]) / CELL + 0.5) for axis in (0, 1))
    return int(regions[i, j])
