"""The legs of a vehicle: its goals in SI units and radians, and the circle after the last one."""

from vfguide.aircraft.performance import turn_length
from vfguide.geometry.units import DEG
from vfguide.loop.legs import Goal
from vfguide.scenario.resolved import Goal as ScenarioGoal
from vfguide.scenario.resolved import Scenario, Vehicle

CIRCLE_SIDES = {"right": 1.0, "left": -1.0}
"""Sides of the circle after the last goal, +1 right and -1 left, by their names in scenario files;
dimensionless."""
LOITER_RADIUS = 1.57
"""Default radius of the circle after the last goal [turn lengths]; chosen, 100 m at 25 m/s. Wind
and bank may make it larger."""


def goal_of(goal: ScenarioGoal) -> Goal:
    """A goal in SI units and radians."""
    return Goal(
        goal.position_m,
        goal.heading_deg * DEG,
        goal.climb_deg * DEG,
        goal.tolerance_m,
        goal.tolerance_deg * DEG,
        goal.attempts,
    )


def circle_side(scenario: Scenario) -> float:
    """Side of the circle after the last goal: +1 right-hand, -1 left-hand."""
    return CIRCLE_SIDES[scenario.guidance.loiter]


def circle_radius(scenario: Scenario, vehicle: Vehicle) -> float:
    """Radius of the circle after the last goal [m], in still air."""
    usual = LOITER_RADIUS * turn_length(scenario.airspeed_of(vehicle))
    return scenario.guidance.loiter_radius_m or usual
