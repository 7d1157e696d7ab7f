"""The field of a scenario at points that the user gives: `vfguide field`, and the same from Python.

>>> loaded = load_scenario("paper/example-3")
>>> vehicle = vehicle_of(loaded.scenario, 4)
>>> fields = fields_at(loaded, vehicle, read_points(Path("points.csv")), "paper")
"""

from collections.abc import Callable
from typing import Literal

from vfguide.companion.plan import Plan
from vfguide.field_points.field_law_points import led_field
from vfguide.field_points.field_point import FieldPoint, Point, point_of
from vfguide.field_points.flight_points import NoPlanError, flight_field
from vfguide.field_points.paper_points import paper_fields
from vfguide.field_points.points_file import Points
from vfguide.files.errors import InputError
from vfguide.geometry.vector import Vec3
from vfguide.scenario.loaded import LoadedScenario
from vfguide.scenario.plans import plan_of
from vfguide.scenario.resolved import Vehicle
from vfguide.scenario.wind import blowing

LawName = Literal["paper", "field", "flight"]
LAW_NAMES: tuple[LawName, ...] = ("paper", "field", "flight")
"""Names of the laws whose field is evaluated."""


def fields_at(
    loaded: LoadedScenario, vehicle: Vehicle, points: Points, law: LawName
) -> list[FieldPoint]:
    """The field that leads `vehicle` to its first goal, at each of the points.

    Raises:
        InputError: law flight, and from one of the points there is no plan.
    """
    if law == "paper":
        return paper_fields(loaded.scenario, vehicle, points)
    return flown_fields(loaded, vehicle, points, led_field if law == "field" else flight_field)


def flown_fields(
    loaded: LoadedScenario,
    vehicle: Vehicle,
    points: Points,
    field_at: Callable[[Plan, Point, Vec3], FieldPoint],
) -> list[FieldPoint]:
    """What an aeroplane flies at each of the points, in the wind that the scenario begins with.

    Raises:
        InputError: from one of them there is no plan.
    """
    wind, plan, fields = loaded.scenario.wind, plan_of(loaded, vehicle), list[FieldPoint]()
    wind_n = blowing(wind.speed_mps, wind.from_deg)
    for number, row in enumerate(points, start=1):
        try:
            fields.append(field_at(plan, point_of(row.tolist()), wind_n))
        except NoPlanError as error:
            raise InputError(f"--points: point {number}: {error}") from error
    return fields
