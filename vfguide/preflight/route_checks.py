"""Route checks before a flight among hazards: escapes from its starts, routes to its goals.

A conflict with a hazard is an error where nothing could be flown, and a warning where the run-time
assurance is going to overrule guidance.
"""

import math
from collections.abc import Sequence
from typing import NamedTuple

import numpy as np

from vfguide.aircraft.envelope import radius_in, usable_bank
from vfguide.aircraft.performance import Gains, Performance
from vfguide.aircraft.point_mass import PointMass
from vfguide.aircraft.state import FlightState
from vfguide.airspace.footprint import Band
from vfguide.airspace.hazards import Hazards, hazard_count, hazard_distance
from vfguide.assurance.decision import Reason, assurance, assure, no_backup
from vfguide.estimation.estimation import FIRST_STEP
from vfguide.field.obstacle import Rows
from vfguide.files.fence import Fence
from vfguide.files.source import Location, Source, dotted
from vfguide.files.toml_types import in_words
from vfguide.geometry.se2 import Pose, straight_on
from vfguide.geometry.so3 import IDENTITY
from vfguide.geometry.units import DEG
from vfguide.geometry.vector import Vec3, Vector
from vfguide.geometry.velocity import horizontal_norm
from vfguide.paths.dubins import length_of
from vfguide.paths.edge import next_path
from vfguide.planning.collision_check import Air, Task
from vfguide.planning.objective import GuidanceTarget
from vfguide.planning.overflight import altitude_plan_by, band_of, left_in_path, levels_for
from vfguide.planning.replanning import CHECK_INTERVAL
from vfguide.planning.route_search import CLEARANCES, find_route
from vfguide.preflight.enclosure_checks import is_enclosed
from vfguide.scenario.hazards import hazard_names, hazards_of, keep_out_zones_of
from vfguide.scenario.obstacles import rows_of
from vfguide.scenario.resolved import Goal, Scenario, Vehicle
from vfguide.scenario.traffic import avoids_traffic
from vfguide.scenario.wind import blowing

SPACING = 2.0
"""Distance between two checked positions on a final approach [m]; chosen."""


class GuidedAircraft(NamedTuple):
    """An aircraft and the gains with which it is guided."""

    aircraft: Performance
    """The aircraft in the thinnest air of its plan."""
    gains: Gains


class Start(NamedTuple):
    """The start of a leg."""

    p_n: Vec3
    """Position, NED [m]."""
    course: float
    """Course [rad]."""


def check_routes(
    scenario: Scenario, guided: Sequence[GuidedAircraft], source: Source
) -> tuple[str, ...]:
    """Warnings about starts and goals near hazards, for law `flight` on aeroplanes.

    `guided` has the aircraft of each vehicle, in order.

    Raises:
        InputError: a start has no escape, or no route leads to a goal.
    """
    hazards = hazards_of(scenario)
    if scenario.law != "flight" or scenario.plant != "jsbsim" or hazards is None:
        return ()
    warnings: list[str] = []
    for index, (vehicle, each) in enumerate(zip(scenario.vehicles, guided, strict=True)):
        at: Location = ("vehicle", index)
        warnings += _check_start(scenario, vehicle, each, hazards, source, at)
        begin = Start(vehicle.position_m, vehicle.euler_deg[2] * DEG)
        for number, goal in enumerate(vehicle.goals):
            place = (*at, "goal", number)
            warnings += _tight_goal(scenario, goal, each, source, place)
            warnings += _check_route(scenario, begin, goal, each, source, place)
            begin = Start(goal.position_m, goal.heading_deg * DEG)
    return tuple(warnings)


def _check_start(
    scenario: Scenario,
    vehicle: Vehicle,
    guided: GuidedAircraft,
    hazards: Hazards,
    source: Source,
    at: Location,
) -> list[str]:
    """A warning where guidance is overruled from the start on.

    Raises:
        InputError: no escape from there is clear.
    """
    of = assurance(*guided)
    motion = PointMass(
        vehicle.position_m, vehicle.euler_deg[2] * DEG, 0.0, 0.0, vehicle.airspeed_mps
    )
    wind_n = _wind(scenario)
    decision, _ = assure(motion, (0.0, 0.0), wind_n, 0.0, hazards, 0.0, FIRST_STEP, of, no_backup())
    if decision.reason == Reason.NOMINAL:
        return []
    names, place = hazard_names(scenario), (*at, "position_m")
    what = f'"{names[decision.hazard]}"' if decision.hazard >= 0 else "what is near"
    if decision.margin <= 0.0:
        rule = f"no escape from here, straight on leads into {what}; allowed farther from it"
        raise source.error(place, f"{rule}, or with another heading_deg", vehicle.position_m)
    rule = f"begins with an escape from {what}, which leaves {decision.margin:.0f} m"
    return [_warning(source, place, f"{rule}; start farther away, or turn heading_deg")]


def _tight_goal(
    scenario: Scenario, goal: Goal, guided: GuidedAircraft, source: Source, at: Location
) -> list[str]:
    """A warning where the final approach is nearer to a hazard than the assurance allows."""
    aircraft, gains = guided
    margin = assurance(aircraft, gains).margin
    still = _still(scenario)
    hazards, names = hazards_of(still), hazard_names(still)
    if hazards is None:
        return []
    final_approach = gains.final_approach * _radius(scenario, guided)
    back = np.arange(0.0, final_approach + SPACING, SPACING)
    ahead: Vector = np.array(
        (math.cos(goal.heading_deg * DEG), math.sin(goal.heading_deg * DEG), 0.0)
    )
    ahead[2] = -math.tan(goal.climb_deg * DEG)
    places: list[Vec3] = [
        (x, y, z) for x, y, z in (np.array(goal.position_m) - back[:, None] * ahead).tolist()
    ]
    for number in range(hazard_count(hazards) - (len(names) < hazard_count(hazards))):
        distances = [hazard_distance(hazards, number, place, 0.0) for place in places]
        if (least := min(distances)) < margin:
            where = back[int(np.argmin(distances))]
            what = f'{least:.1f} m from "{names[number]}" on its straight approach, {where:.0f} m'
            rule = f"{what} before it, where {margin:.0f} m are kept"
            return [_warning(source, at, f"{rule}; move it away, or turn its course")]
    return []


def _check_route(
    scenario: Scenario,
    begin: Start,
    goal: Goal,
    guided: GuidedAircraft,
    source: Source,
    at: Location,
) -> list[str]:
    """A warning where the search finds no route to a goal around obstacles that do not move.

    Raises:
        InputError: there is none, since hazards enclose the start or the goal.
    """
    gains, (north, east, _) = guided.gains, _wind(scenario)
    radius = _radius(scenario, guided)
    course, (x, y, z) = goal.heading_deg * DEG, goal.position_m
    final_approach = gains.final_approach * radius
    entry = straight_on(Pose(x, y, course), -final_approach)
    from_x, from_y, from_z = begin.p_n
    start = Pose(from_x, from_y, begin.course)
    band = Band(min(z, from_z), max(z, from_z))
    task = Task(start, entry, radius, Air(gains.airspeed, north, east), 0.0)
    fence = keep_out_zones_of(_in_band(scenario.fence, band))
    rows = rows_of(_still(scenario).obstacles)
    if len(find_route(rows, fence, band, task).route_edges) > 0:
        return []
    if _passes_over(scenario, rows, begin.p_n, goal, guided, task):
        if not avoids_traffic(scenario):
            return []
        rule = (
            "the route there leads over obstacles, and no climb over one begins while "
            "other aircraft are known; open a gap, or start higher"
        )
        return [_warning(source, at, rule)]
    if is_enclosed(rows, fence, band, (from_x, from_y), (x, y)):
        rule = "enclosed, no route leads there at these heights; move it, or open a gap"
        raise source.error(at, rule, goal.position_m)
    rule = (
        f"with turns of {radius:.0f} m no route there was found from the start that keeps "
        f"{in_words(CLEARANCES[-1])} m clear; if it is not reached, move it, turn its course or "
        "widen the gaps"
    )
    return [_warning(source, at, rule)]


def _passes_over(
    scenario: Scenario, rows: Rows, begin: Vec3, goal: Goal, guided: GuidedAircraft, task: Task
) -> bool:
    """Whether the shortest path can be flown over the obstacles on it, detected early enough."""
    (aircraft, gains), margin, fence = guided, CLEARANCES[0], scenario.fence
    course, (x, y, z), wind_n = goal.heading_deg * DEG, goal.position_m, _wind(scenario)
    state = FlightState(0.0, begin, wind_n, IDENTITY, gains.airspeed, wind_n)
    target = GuidanceTarget((x, y, z), course, math.tan(goal.climb_deg * DEG), 0.0, 0.0)
    highest = -math.inf if fence.ceiling_m is None else margin - fence.ceiling_m
    seen_from = np.array([each.visible_from_m for each in _still(scenario).obstacles])
    unseen = 2.0 * CHECK_INTERVAL * (gains.airspeed + horizontal_norm(wind_n))
    shortest = length_of(next_path(task.start, task.goal, task.radius, -1.0)) * task.radius
    for level in levels_for(rows, begin[2], z, highest, margin).tolist():
        heights = altitude_plan_by(level, state, target, aircraft, gains)
        early = seen_from >= heights.rise + margin + unseen
        left = np.vstack((left_in_path(rows[early], heights, margin), rows[~early]))
        route = find_route(left, keep_out_zones_of(fence), band_of(heights), task)
        if route.clearance == margin and route.length <= (1.0 + 1e-6) * shortest:
            return True
    return False


def _still(scenario: Scenario) -> Scenario:
    """The scenario without moving obstacles."""
    still = tuple(each for each in scenario.obstacles if not any(each.velocity_mps))
    return scenario.model_copy(update={"obstacles": still})


def _in_band(fence: Fence, band: Band) -> Fence:
    """The fence without the zones that hold only above or only below the band."""
    zones = [
        zone
        for zone in fence.zone
        if (zone.lowest_m is None or zone.lowest_m < -band.top)
        and (zone.highest_m is None or zone.highest_m > -band.bottom)
    ]
    return fence.model_copy(update={"zone": zones})


def _radius(scenario: Scenario, guided: GuidedAircraft) -> float:
    """Radius of turns in the scenario's wind, at the largest bank that the wing carries [m]."""
    bank = usable_bank(*guided, guided.gains.airspeed)
    return radius_in(scenario.wind.speed_mps, bank, guided.gains)


def _wind(scenario: Scenario) -> Vec3:
    """The wind with which the scenario begins, NED [m/s]."""
    return blowing(scenario.wind.speed_mps, scenario.wind.from_deg)


def _warning(source: Source, at: Location, rule: str) -> str:
    return f"{source.path}: {dotted(at)}: {rule}"
