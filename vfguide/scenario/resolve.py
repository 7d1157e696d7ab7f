"""From a scenario as it is written to the scenario as it is flown."""

import math
from collections.abc import Mapping

from vfguide.geometry.geodesy import TangentPlane, geodetic_to_ned, tangent_plane
from vfguide.geometry.units import DEG
from vfguide.geometry.vector import Vec3
from vfguide.scenario.aircraft_file import Aircraft
from vfguide.scenario.resolved import Goal, Scenario, Vehicle
from vfguide.scenario.scenario_file import GoalEntry, Origin, ScenarioFile
from vfguide.scenario.source import Location, Source

FARTHEST = 100_000.0
"""A goal may be this far from the origin on each axis [m]."""


def resolve(entry: ScenarioFile, aircraft: Mapping[str, Aircraft], source: Source) -> Scenario:
    """The scenario of a file; `aircraft` are those that it names.

    Raises:
        InputError: a goal is not given in exactly one way.
    """
    head = {name: getattr(entry, name) for name in type(entry).model_fields if name != "vehicle"}
    vehicles = [
        Vehicle(
            id=vehicle.id,
            position_m=vehicle.position_m,
            heading_deg=vehicle.heading_deg,
            airspeed_mps=vehicle.airspeed_mps or aircraft[vehicle.aircraft].airspeed.cruise_mps,
            aircraft=vehicle.aircraft,
            goals=tuple(
                _goal(goal, entry.origin, source, ("vehicle", index, "goal", number))
                for number, goal in enumerate(vehicle.goal)
            ),
        )
        for index, vehicle in enumerate(entry.vehicle)
    ]
    return Scenario(**head, vehicles=tuple(vehicles))


def plane_of(origin: Origin) -> TangentPlane:
    """The scenario frame: the tangent plane at the origin."""
    return tangent_plane(*place_of(origin))


def place_of(origin: Origin) -> Vec3:
    """Latitude, longitude [rad] and altitude [m] of the origin."""
    return (origin.latitude_deg * DEG, origin.longitude_deg * DEG, origin.altitude_m)


def _goal(entry: GoalEntry, origin: Origin, source: Source, at: Location) -> Goal:
    heading_deg, climb_deg = _course(entry, source, at)
    return Goal(
        position_m=_position(entry, origin, source, at),
        heading_deg=heading_deg,
        climb_deg=climb_deg,
        tolerance_m=entry.tolerance_m,
        tolerance_deg=entry.tolerance_deg,
    )


def _position(entry: GoalEntry, origin: Origin, source: Source, at: Location) -> Vec3:
    latitude, longitude, altitude = entry.latitude_deg, entry.longitude_deg, entry.altitude_m
    if entry.position_m is not None and latitude is longitude is altitude is None:
        return entry.position_m
    if entry.position_m is not None or latitude is None or longitude is None or altitude is None:
        rule = (
            "its place must be given in exactly one way: "
            "position_m, or latitude_deg, longitude_deg and altitude_m"
        )
        raise source.error(at, rule)
    p_n = geodetic_to_ned(plane_of(origin), latitude * DEG, longitude * DEG, altitude)
    if max(map(abs, p_n)) > FARTHEST:
        rule = f"{math.hypot(*p_n) / 1e3:.0f} km from the origin, allowed up to 100 km on each axis"
        raise source.error((*at, "latitude_deg"), rule, latitude)
    return p_n


def _course(entry: GoalEntry, source: Source, at: Location) -> tuple[float, float]:
    """Heading and climb [deg]."""
    if entry.heading_deg is not None and entry.direction is None:
        return entry.heading_deg, entry.climb_deg or 0.0
    if entry.heading_deg is not None or entry.direction is None:
        rule = "its course must be given in exactly one way: heading_deg, or direction"
        raise source.error(at, rule)
    if entry.climb_deg is not None:
        rule = "not allowed beside direction, which has a climb of its own"
        raise source.error((*at, "climb_deg"), rule, entry.climb_deg)
    north, east, down = entry.direction
    if not any(entry.direction):
        rule = "has no direction, allowed is any vector but zero"
        raise source.error((*at, "direction"), rule, entry.direction)
    return math.atan2(east, north) / DEG, math.atan2(-down, math.hypot(north, east)) / DEG
