"""The hazards of a scenario."""

import math

from vfguide.airspace.fence import fence_distance, fences
from vfguide.airspace.hazards import Hazards, traffic_rows
from vfguide.airspace.keep_out import (
    KEEP_IN,
    KEEP_OUT,
    NO_FENCE,
    KeepOutZones,
    circle,
    joined,
    polygon,
)
from vfguide.field.obstacle import PlacedObstacle, placed
from vfguide.files.fence import Fence, check_zones, zone_of
from vfguide.files.source import Source
from vfguide.files.toml_types import in_words
from vfguide.kernels.rows import table_of
from vfguide.scenario.obstacles import obstacle_of
from vfguide.scenario.resolved import Obstacle, Scenario
from vfguide.scenario.traffic import avoids_traffic


def hazards_of(scenario: Scenario) -> Hazards | None:
    """The hazards of a scenario, traffic still unknown; None where nothing is to be avoided."""
    if not (scenario.obstacles or avoids_traffic(scenario)) and scenario.fence == Fence():
        return None
    fence = scenario.fence
    return Hazards(
        table_of(PlacedObstacle, map(seen_from_afar, scenario.obstacles)),
        traffic_rows(()),
        fences([zone_of(zone) for zone in fence.zone]),
        -math.inf if fence.floor_m is None else fence.floor_m,
        math.inf if fence.ceiling_m is None else fence.ceiling_m,
    )


def seen_from_afar(obstacle: Obstacle) -> PlacedObstacle:
    """The obstacle, detected from its `visible_from_m` on, even outside its reactive area."""
    return placed(obstacle_of(obstacle))._replace(visible_from=obstacle.visible_from_m)


def hazard_names(scenario: Scenario) -> tuple[str, ...]:
    """The names of the hazards in the order of their numbers; those of traffic come after them.

    Floor and ceiling are one hazard, with one name, the last.
    """
    fence = scenario.fence
    heights = [key for key in ("floor_m", "ceiling_m") if getattr(fence, key) is not None]
    return (
        *(obstacle.name for obstacle in scenario.obstacles),
        *(f"fence.zone[{index}]" for index in range(len(fence.zone))),
        " or ".join(f"fence.{key}" for key in heights),
    )


def keep_out_zones_of(fence: Fence) -> KeepOutZones:
    """The zones of the fence in the horizontal plane, whatever the heights at which they hold."""
    zones = NO_FENCE
    for zone in fence.zone:
        sign = KEEP_IN if zone.kind == "include" else KEEP_OUT
        if zone.polygon_m is not None:
            joining = polygon(zone.polygon_m, sign)
        else:
            joining = circle(*(zone.centre_m or (0.0, 0.0)), zone.radius_m or 0.0, sign)
        zones = joined(zones, joining)
    return zones


def check_fence(scenario: Scenario, source: Source) -> None:
    """Check that the fence is well formed, and that every start and goal is inside it.

    Raises:
        InputError: it is not, or the plant takes no fence, or a start or goal is outside.
    """
    check_zones(scenario.fence, source)
    if scenario.fence != Fence() and scenario.plant != "jsbsim":
        raise source.error(("fence",), 'plant = "kinematic" has none, allowed none')
    for index, vehicle in enumerate(scenario.vehicles):
        places = [(("vehicle", index, "position_m"), vehicle.position_m)]
        places += [
            (("vehicle", index, "goal", number), goal.position_m)
            for number, goal in enumerate(vehicle.goals)
        ]
        for at, p_n in places:
            if broken := broken_fence(scenario.fence, p_n):
                raise source.error(at, broken, p_n)


def broken_fence(fence: Fence, p_n: tuple[float, float, float]) -> str:
    """The rule of the fence that a place, NED [m], violates, in words; empty: none."""
    height = -p_n[2]
    if fence.floor_m is not None and height < fence.floor_m:
        return f"below the fence, allowed above fence.floor_m = {in_words(fence.floor_m)}"
    if fence.ceiling_m is not None and height > fence.ceiling_m:
        return f"above the fence, allowed below fence.ceiling_m = {in_words(fence.ceiling_m)}"
    zones = fences([zone_of(zone) for zone in fence.zone])
    for index in range(len(fence.zone)):
        if fence_distance(zones, index, p_n) < 0.0:
            kind = "outside" if fence.zone[index].kind == "include" else "inside"
            return f"{kind} fence.zone[{index}], allowed {_other(kind)} it"
    return ""


def _other(kind: str) -> str:
    return "inside" if kind == "outside" else "outside"
