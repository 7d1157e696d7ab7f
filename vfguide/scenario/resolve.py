"""From a scenario as it is written to the scenario as it is flown."""

import math
from collections.abc import Mapping

from vfguide.earth.atmosphere import true_airspeed
from vfguide.earth.geodesy import TangentPlane, geodetic_to_ned, tangent_plane
from vfguide.files.aircraft_file import Aircraft
from vfguide.files.obstacle_entry import check_sizes
from vfguide.files.scenario_file import (
    DEFAULT_AIRCRAFT,
    KINEMATIC_AIRSPEED,
    GoalEntry,
    Origin,
    ScenarioFile,
    ScenarioHead,
    VehicleEntry,
)
from vfguide.files.source import Location, Source
from vfguide.files.traffic_entry import TrafficEntry
from vfguide.geometry.units import DEG, KM
from vfguide.geometry.vector import Vec3
from vfguide.scenario.air import NO_AIR, Air, air_between
from vfguide.scenario.resolved import Goal, Obstacle, Scenario, Traffic, Vehicle

MAX_GOAL_DISTANCE = 100_000.0
"""Largest distance of a goal from the origin along each axis [m]; chosen."""


def resolve(entry: ScenarioFile, aircraft: Mapping[str, Aircraft], source: Source) -> Scenario:
    """The scenario of a file with every default filled in; `aircraft` has those that it names.

    Raises:
        InputError: an attitude or a goal is not given in exactly one way, a goal is too far away,
            or an obstacle has not the sizes of its shape.
    """
    head = {name: getattr(entry, name) for name in ScenarioHead.model_fields}
    vehicles = tuple(
        _vehicle(entry, index, aircraft, source) for index in range(len(entry.vehicle))
    )
    obstacles = tuple(_obstacle(entry, index, source) for index in range(len(entry.obstacle)))
    traffic = tuple(_traffic(each, index) for index, each in enumerate(entry.traffic, start=1))
    return Scenario(**head, vehicles=vehicles, obstacles=obstacles, traffic=traffic)


def plane_of(origin: Origin) -> TangentPlane:
    """The tangent plane at the origin, in which the scenario frame, NED, is."""
    return tangent_plane(*place_of(origin))


def place_of(origin: Origin) -> Vec3:
    """Latitude, longitude [rad] and altitude [m] of the origin."""
    return (origin.latitude_deg * DEG, origin.longitude_deg * DEG, origin.altitude_m)


def air_of(scenario: Scenario, vehicle: Vehicle) -> Air:
    """The air from the start of a vehicle to its goals; plant `kinematic` has none."""
    if scenario.plant == "kinematic":
        return NO_AIR
    goals = (goal.position_m for goal in vehicle.goals)
    return air_between(plane_of(scenario.origin), (vehicle.position_m, *goals))


def aircraft_of(entry: ScenarioFile, vehicle: VehicleEntry) -> str:
    """Name of the aircraft of a vehicle; of a rigid body, that whose numbers guidance takes."""
    return vehicle.aircraft if entry.plant == "jsbsim" else DEFAULT_AIRCRAFT


def _vehicle(
    entry: ScenarioFile, index: int, aircraft: Mapping[str, Aircraft], source: Source
) -> Vehicle:
    vehicle, at = entry.vehicle[index], ("vehicle", index)
    name = aircraft_of(entry, vehicle)
    heading_deg, attitude_deg = _attitude(entry, vehicle, source, at)
    goals = tuple(
        _goal(goal, entry.origin, source, (*at, "goal", number))
        for number, goal in enumerate(vehicle.goal)
    )
    cruise = KINEMATIC_AIRSPEED
    if entry.plant == "jsbsim":
        places = (vehicle.position_m, *(goal.position_m for goal in goals))
        air = air_between(plane_of(entry.origin), places)
        cruise = true_airspeed(aircraft[name].airspeed.cruise_mps, air.thinnest)
    return Vehicle(
        id=vehicle.id,
        position_m=vehicle.position_m,
        heading_deg=heading_deg,
        attitude_deg=attitude_deg,
        airspeed_mps=vehicle.airspeed_mps or cruise,
        aircraft=name,
        icao=vehicle.icao,
        identify=vehicle.identify,
        goals=goals,
    )


def _attitude(
    entry: ScenarioFile, vehicle: VehicleEntry, source: Source, at: Location
) -> tuple[float | None, Vec3 | None]:
    """Heading and attitude at the start [deg], of which the one that is not given is None.

    Raises:
        InputError: both are given, or an attitude is where the plant takes none.
    """
    if vehicle.attitude_deg is None:
        return vehicle.heading_deg, None
    place = (*at, "attitude_deg")
    if entry.plant != "kinematic":
        rule = 'only plant = "kinematic" starts in any attitude, allowed is heading_deg'
        raise source.error(place, rule, vehicle.attitude_deg)
    if "heading_deg" in vehicle.model_fields_set:
        rule = "not allowed beside heading_deg, its third number is the heading"
        raise source.error(place, rule, vehicle.attitude_deg)
    return None, vehicle.attitude_deg


def _obstacle(entry: ScenarioFile, index: int, source: Source) -> Obstacle:
    written = entry.obstacle[index]
    check_sizes(written, source, ("obstacle", index))
    values = written.model_dump()
    values["name"] = str(index) if written.name is None else written.name
    if written.visible_from_m is None:
        values["visible_from_m"] = entry.avoidance.detection_range_m
    return Obstacle(**values)


def _traffic(entry: TrafficEntry, number: int) -> Traffic:
    values = entry.model_dump(exclude={"change"})
    values["icao"] = entry.icao or f"{number:06X}"
    return Traffic(**values, change=tuple(entry.change))


def _goal(entry: GoalEntry, origin: Origin, source: Source, at: Location) -> Goal:
    heading_deg, climb_deg = _course(entry, source, at)
    return Goal(
        position_m=_position(entry, origin, source, at),
        heading_deg=heading_deg,
        climb_deg=climb_deg,
        tolerance_m=entry.tolerance_m,
        tolerance_deg=entry.tolerance_deg,
        attempts=entry.attempts,
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
    if max(map(abs, p_n)) > MAX_GOAL_DISTANCE:
        rule = f"{math.hypot(*p_n) / KM:.0f} km from the origin, allowed up to 100 km on each axis"
        raise source.error((*at, "latitude_deg"), rule, latitude)
    return p_n


def _course(entry: GoalEntry, source: Source, at: Location) -> tuple[float, float]:
    """Course and climb to have at a goal [deg].

    Raises:
        InputError: they are not given in exactly one way.
    """
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
