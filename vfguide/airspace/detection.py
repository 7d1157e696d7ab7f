"""The stage of detection: which of the obstacles are known."""

from typing import Annotated, Any, NamedTuple

import numpy as np
from numba import types
from numba.extending import overload
from numpy.typing import NDArray

from vfguide.airspace.distance_bound import distance_bound
from vfguide.airspace.hazards import Hazards
from vfguide.airspace.keep_out import KeepOutZones
from vfguide.estimation.estimation import NavState
from vfguide.field.obstacle import Rows, obstacle_distance, put_out_of_sight, read_obstacle
from vfguide.geometry.vector import Vec3
from vfguide.kernels.compiled import compiled
from vfguide.kernels.rows import OPEN, nester, unnester

Known = NDArray[np.float64]
"""(M,), one number for each obstacle: 1 once it is known, else 0."""


class Airspace(NamedTuple):
    """What to keep clear of at one step."""

    hazards: Hazards
    """All hazards of the plan before detection, the known ones after it."""
    zones: KeepOutZones
    """The fence as keep-out zones of the route search."""
    time: float
    """Time on the clock of the obstacles [s]."""
    gust: float
    """Speed of the gusts, one standard deviation [m/s]."""


AirspaceTuple = tuple[Any, ...]
"""The values of an `Airspace` without names, as they cross into compiled code."""
unnested_airspace = unnester(Airspace)
_nested_airspace = nester(Airspace)


def airspace_of(values: AirspaceTuple | None) -> Airspace | None:
    """The airspace from the tuple of its values; None where there is none."""
    if values is None:
        return None
    return _nested_airspace(values)


@overload(airspace_of)
def _compiled_airspace_of(values: Any) -> Any:
    """`airspace_of` in compiled code, where None stays a None that the compiler sees."""

    def nothing(values: Any) -> Any:
        return None

    def nested(values: Any) -> Any:
        return _nested_airspace(values)

    return nothing if isinstance(values, types.NoneType) else nested


class DetectionState(NamedTuple):
    """What the stage keeps from one step to the next."""

    known: Annotated[Known, OPEN]
    """Which obstacles are known, (M,)."""


@compiled
def update(
    nav: NavState, airspace: Airspace | None, s: DetectionState
) -> tuple[Airspace | None, DetectionState]:
    """The airspace without undetected obstacles, and what is known now; None stays None."""
    if airspace is None:
        return None, s
    known = s.known.copy()
    seen = in_sight(airspace.hazards, known, nav.state.p_n, airspace.time)
    return Airspace(seen, airspace.zones, airspace.time, airspace.gust), DetectionState(known)


@compiled
def in_sight(hazards: Hazards, known: Known, p_n: Vec3, t: float) -> Hazards:
    """The hazards with undetected obstacles moved out of sight.

    Args:
        hazards: all hazards.
        known: which obstacles are known; what is detected becomes 1 in place, and stays 1.
        p_n: position of the vehicle, NED [m].
        t: time on the clock of the obstacles [s].
    """
    obstacles = hazards.obstacles
    if len(obstacles) == 0:
        return hazards
    seen = obstacles.copy()
    for i in range(len(obstacles)):
        if known[i] == 0.0 and comes_into_sight(obstacles, i, p_n, t):
            known[i] = 1.0
        if known[i] == 0.0:
            put_out_of_sight(seen[i])
    return Hazards(seen, hazards.traffic, hazards.fences, hazards.floor, hazards.ceiling)


@compiled
def comes_into_sight(obstacles: Rows, i: int, p_n: Vec3, t: float) -> bool:
    """Whether obstacle `i` is near enough to be detected from `p_n` (NED) [m] at time `t` [s]."""
    visible_from = read_obstacle(obstacles[i]).visible_from
    if distance_bound(obstacles, i, p_n, t) > visible_from:
        return False
    return obstacle_distance(obstacles, i, p_n, t) <= visible_from
