"""Encounter checks: whether vehicles of a scenario, which do not avoid each other, will meet."""

import math
from collections.abc import Iterator, Sequence
from itertools import combinations
from typing import NamedTuple

from vfguide.files.source import Source
from vfguide.geometry.polyline import nearest_to_origin
from vfguide.geometry.vector import Vectors
from vfguide.preflight.prediction import PREDICTION_STEP, predict
from vfguide.preflight.route_checks import GuidedAircraft
from vfguide.scenario.resolved import Scenario, Vehicle

AFTER_LAST_GOAL = 5.0
"""Time after the last goal of the last vehicle up to which encounters are looked for [s]: that for
which a run goes on."""


class Encounter(NamedTuple):
    """The closest point of approach of two paths."""

    distance: float
    """Least distance [m]."""
    time: float
    """Time of the least distance, since the start of the run [s]."""


def closest_approach(one: Vectors, other: Vectors) -> Encounter:
    """The encounter of two paths through positions (N, 3) [m], PREDICTION_STEP apart in time.

    The paths are straight between their positions.
    """
    nearest = nearest_to_origin(one - other)
    return Encounter(nearest.distance, PREDICTION_STEP * nearest.along)


def check_encounters(
    scenario: Scenario, guided: Sequence[GuidedAircraft], source: Source
) -> tuple[str, ...]:
    """A warning for each two vehicles that come within two safety radii, flown as planned.

    `guided` has the aircraft of each vehicle, in order. Nothing is checked with other laws than
    `flight`, nor of vehicles that fly a test flight first.
    """
    pairs = zip(scenario.vehicles, guided, strict=True)
    flown = [(vehicle, each) for vehicle, each in pairs if not vehicle.identify]
    if scenario.law != "flight" or not scenario.avoidance.between_vehicles or len(flown) < 2:
        return ()
    least, warnings = 2.0 * scenario.avoidance.safety_radius_m, list[str]()
    for one, other, meeting in encounters(scenario, flown):
        if meeting.distance < least:
            rule = (
                f"vehicles {one} and {other} come within {meeting.distance:.0f} m of each other "
                f"after {meeting.time:.0f} s as they are planned, where {least:g} m are kept; "
                "they do not avoid each other: move a start or a goal"
            )
            warnings.append(f"{source.path}: {rule}")
    return tuple(warnings)


def encounters(
    scenario: Scenario, flown: Sequence[tuple[Vehicle, GuidedAircraft]]
) -> Iterator[tuple[int, int, Encounter]]:
    """The ids of each two vehicles, and their encounter."""
    predicted = [(vehicle.id, *predict(scenario, vehicle, guided)) for vehicle, guided in flown]
    last = max(circles_from for _, _, circles_from in predicted)
    end = last + math.ceil(AFTER_LAST_GOAL / PREDICTION_STEP) + 1
    for (one, path, _), (other, beside, _) in combinations(predicted, 2):
        yield one, other, closest_approach(path[:end], beside[:end])
