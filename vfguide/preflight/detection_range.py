"""The detection range that a plan needs: what the best escape from its obstacles takes.

An obstacle straight ahead becomes known at the range D. For the time t_0 of latency and of a roll
from the largest bank to the other side the aircraft flies on. Then it turns at its largest bank, of
radius r = V^2 / (g tan bank) in the air (Beard and McLain, Small Unmanned Aircraft, 2012, chapter
9), to the side until it is past half the width of the obstacle, or all the way back; whichever
needs less. All the while the obstacle closes with c, its own speed and the wind. So

    D = m + (V + c) t_0 + min(side step, turn back),

where m is the margin that the assurance keeps and its greatest uncertainty. A level turn is open at
every height; a climb, which may be shorter, is not counted.
"""

import math
from collections.abc import Iterator, Sequence
from typing import NamedTuple

from vfguide.aircraft.performance import turn_length
from vfguide.assurance.decision import HOLD, assurance
from vfguide.assurance.trajectory_clearance import MAX_UNCERTAINTY
from vfguide.files.scenario_file import ScenarioFile
from vfguide.files.source import Location, Source, dotted
from vfguide.geometry.shapes.base import Shape
from vfguide.geometry.shapes.shape import section_at, widest_at
from vfguide.geometry.units import MS
from vfguide.geometry.vector import norm
from vfguide.preflight.route_checks import GuidedAircraft
from vfguide.scenario.obstacles import shape_of
from vfguide.scenario.resolved import Obstacle, Scenario

LATENCY_PERIODS = 3.0
"""Number of guidance periods from when an obstacle is in range to its first effect; chosen: one to
the next detection, one of a held setpoint, and one since the state is half a period old at both
ends of the link."""


class Escape(NamedTuple):
    """How an aircraft escapes in level flight."""

    airspeed: float
    """True airspeed [m/s]."""
    radius: float
    """Radius of its turns in the air at the largest bank [m]."""
    delay: float
    """Time before it turns [s]: latency, the HOLD of the assurance, and a roll from the largest
    bank to the other side."""
    margin: float
    """Clearance that it keeps: the margin of the assurance, and MAX_UNCERTAINTY [m]."""


class Body(NamedTuple):
    """What is escaped from: an obstacle or another vehicle."""

    name: str
    """Name in messages."""
    half_width: float
    """Largest horizontal distance of its surface from its centre [m]."""
    closing: float
    """Upper bound of its speed relative to the air [m/s]."""


class Need(NamedTuple):
    """The range that a vehicle needs to escape from a body."""

    range: float
    """Detection range that is needed, rounded up to a whole number of metres [m]."""
    vehicle: int
    """Id of the vehicle."""
    body: str
    """Name of the body."""


def side_step(escape: Escape, half_width: float, closing: float) -> float:
    """By how much an obstacle comes nearer until the aircraft is beside it, turned aside [m].

    Args:
        escape: the escape of the aircraft.
        half_width: half the width of the obstacle [m].
        closing: speed of the obstacle relative to the air [m/s].
    """
    aside, r = half_width + escape.margin, escape.radius
    if aside >= r:
        return r + closing * (0.5 * math.pi * r + aside - r) / escape.airspeed
    turned = math.acos(1.0 - aside / r)
    return r * math.sin(turned) + closing * r * turned / escape.airspeed


def turn_back(escape: Escape, closing: float) -> float:
    """By how much an obstacle comes nearer until the aircraft flies away from it as fast [m].

    The distance falls while V cos(a) + c > 0, so until the turn a = acos(-c / V). It is infinite
    where the obstacle is no slower than the aircraft.
    """
    ratio = closing / escape.airspeed
    if ratio >= 1.0:
        return math.inf
    turned = math.acos(-ratio)
    return escape.radius * (math.sin(turned) + ratio * turned)


def escape_range(escape: Escape, half_width: float, closing: float) -> float:
    """Distance from the surface at which an obstacle has to be known [m].

    Args:
        escape: the escape of the aircraft.
        half_width: half the width of the obstacle [m].
        closing: speed of the obstacle relative to the air [m/s].
    """
    turn = min(side_step(escape, half_width, closing), turn_back(escape, closing))
    return escape.margin + (escape.airspeed + closing) * escape.delay + turn


def escape_of(guided: GuidedAircraft, latency: float) -> Escape:
    """The escape of an aircraft whose setpoints act after a `latency` [s]."""
    of, airspeed = assurance(*guided), guided.gains.airspeed
    roll = 2.0 * of.limits.bank_max / of.limits.roll_rate + of.limits.bank_lag
    return Escape(
        airspeed,
        turn_length(airspeed) / math.tan(of.limits.bank_max),
        latency + roll + HOLD * of.scale,
        of.margin + MAX_UNCERTAINTY,
    )


def half_width_of(shape: Shape) -> float:
    """Upper bound of the horizontal distance of a surface from its centre [m].

    It is exact for ellipses; other sections have it from their bounding rectangle.
    """
    section = section_at(shape, widest_at(shape))
    is_ellipse = section.p == 1.0 and section.q == 1.0
    return max(section.a, section.b) if is_ellipse else math.hypot(section.a, section.b)


def body_of(scenario: Scenario, obstacle: Obstacle) -> Body:
    """An obstacle as a body to escape from, in the strongest wind of the scenario."""
    wind = max(speed for _, speed, _ in scenario.wind.stages)
    speed = norm(obstacle.velocity_mps)
    return Body(f'"{obstacle.name}"', half_width_of(shape_of(obstacle)), speed + wind)


def others_of(scenario: Scenario, vehicle: int) -> Iterator[Body]:
    """The other vehicles, where they are avoided, as bodies of two safety radii.

    The same air carries them, so that the wind adds nothing to their speed. `vehicle` is an id.
    """
    for each in scenario.vehicles if scenario.avoidance.between_vehicles else ():
        if each.id != vehicle:
            apart = 2.0 * scenario.avoidance.safety_radius_m
            yield Body(f"vehicle {each.id}", apart, scenario.airspeed_of(each))


def needs(
    scenario: Scenario, obstacles: Sequence[Obstacle], guided: Sequence[GuidedAircraft]
) -> Iterator[Need]:
    """The ranges that each vehicle needs for each obstacle and each other vehicle.

    `guided` has the aircraft of each vehicle of the scenario, in order.
    """
    link = scenario.link
    latency = (
        link.delay_ms + link.delay_back_ms
    ) * MS + LATENCY_PERIODS / scenario.guidance.rate_hz
    bodies = [body_of(scenario, each) for each in obstacles]
    for vehicle, each in zip(scenario.vehicles, guided, strict=True):
        escape = escape_of(each, latency)
        for name, half_width, closing in (*bodies, *others_of(scenario, vehicle.id)):
            needed = escape_range(escape, half_width, closing)
            yield Need(float(math.ceil(needed)), vehicle.id, name)


def with_detection_range(
    scenario: Scenario, entry: ScenarioFile, guided: Sequence[GuidedAircraft]
) -> Scenario:
    """The scenario with the detection range that it needs, where none is written.

    It is never shorter than the default.
    """
    avoidance = scenario.avoidance
    if not _is_assured(scenario) or "detection_range_m" in entry.avoidance.model_fields_set:
        return scenario
    needed = needs(scenario, _seen_by_default(scenario), guided)
    wanted = max((each.range for each in needed), default=0.0)
    if wanted <= avoidance.detection_range_m:
        return scenario
    obstacles = tuple(
        each.model_copy(update={"visible_from_m": wanted})
        if written.visible_from_m is None
        else each
        for each, written in zip(scenario.obstacles, entry.obstacle, strict=True)
    )
    avoidance = avoidance.model_copy(update={"detection_range_m": wanted})
    return scenario.model_copy(update={"avoidance": avoidance, "obstacles": obstacles})


def check_detection(
    scenario: Scenario, guided: Sequence[GuidedAircraft], source: Source
) -> tuple[str, ...]:
    """Warnings of detection ranges that are too short for an escape in time."""
    if not _is_assured(scenario):
        return ()
    default = scenario.avoidance.detection_range_m
    usual, warnings = _seen_by_default(scenario), list[str]()
    places: list[tuple[Location, float, Sequence[Obstacle]]] = [
        (("avoidance", "detection_range_m"), default, usual)
    ]
    places += [
        (("obstacle", index, "visible_from_m"), each.visible_from_m, [each])
        for index, each in enumerate(scenario.obstacles)
        if each not in usual
    ]
    for at, seen_from, obstacles in places:
        most = max(needs(scenario, obstacles, guided), default=None)
        if most is not None and most.range > seen_from:
            warnings.append(f"{source.path}: {dotted(at)} = {_told(most, seen_from)}")
    return tuple(warnings)


def _told(need: Need, seen_from: float) -> str:
    return (
        f"{seen_from:g} m is less than the {need.range:g} m that vehicle {need.vehicle} needs "
        f"to escape from {need.body}"
    )


def _seen_by_default(scenario: Scenario) -> list[Obstacle]:
    """The obstacles that are detected from the detection range, and not from one of their own."""
    default = scenario.avoidance.detection_range_m
    return [each for each in scenario.obstacles if each.visible_from_m == default]


def _is_assured(scenario: Scenario) -> bool:
    """Whether the run-time assurance guards the vehicles of a scenario."""
    return scenario.law != "paper" and scenario.plant == "jsbsim"
