"""Predicted flights: the control loop with law `flight` flies a point mass through its plan.

The state is known exactly, the wind is that of the scenario without gusts and shear, and commands
act without latency. Each vehicle flies as if it were alone. A rigid body of plant `kinematic` is
no point mass, but flown as it is.
"""

import math
from typing import Any

import numpy as np

from vfguide.aircraft.point_mass import PointMass, advance, dynamics
from vfguide.aircraft.state import FlightState
from vfguide.aircraft.vehicle import Vehicle, read_vehicle, vehicle_numbers
from vfguide.airspace.detection import Airspace, AirspaceTuple, airspace_of, unnested_airspace
from vfguide.estimation.estimation import exact_inputs
from vfguide.geometry.so3 import from_euler
from vfguide.geometry.units import DEG
from vfguide.geometry.vector import Vectors
from vfguide.guidance.laws import FLIGHT, Law, crossing, law_of
from vfguide.kernels.compiled import compiled
from vfguide.kernels.rows import Row
from vfguide.loop.legs import Legs, leg_rows
from vfguide.loop.state import fresh_state, read_state, row_of_state, write_state
from vfguide.loop.step import step
from vfguide.preflight.body_prediction import predict_body
from vfguide.preflight.route_checks import GuidedAircraft
from vfguide.scenario.hazards import hazards_of, keep_out_zones_of
from vfguide.scenario.legs import circle_radius, circle_side, goal_of
from vfguide.scenario.resolved import Scenario
from vfguide.scenario.resolved import Vehicle as ScenarioVehicle

PREDICTION_STEP = 0.1
"""Time between two predicted positions [s]; chosen, 2.5 m of flight at 25 m/s."""


def predict(
    scenario: Scenario, vehicle: ScenarioVehicle, guided: GuidedAircraft
) -> tuple[Vectors, int]:
    """Positions (N, 3), NED [m], PREDICTION_STEP apart, for as long as a run may take.

    The second result is the index of the first position after the last goal, from which on the
    vehicle circles; N where there is none.
    """
    goals = [goal_of(goal) for goal in vehicle.goals]
    legs = leg_rows(goals, circle_side(scenario), circle_radius(scenario, vehicle))
    steps = math.ceil(scenario.duration_s / PREDICTION_STEP) + 1
    if scenario.plant == "kinematic":
        flown, number = predict_body(scenario, vehicle, guided, legs)
        period, times = 1.0 / scenario.guidance.rate_hz, PREDICTION_STEP * np.arange(steps)
        axes = [np.interp(times, period * np.arange(len(flown)), axis) for axis in flown.T]
        return np.column_stack(axes), min(steps, math.ceil(number * period / PREDICTION_STEP))
    heading, airspeed = vehicle.euler_deg[2] * DEG, guided.gains.airspeed
    hazards, airspace, known = hazards_of(scenario), None, 0
    if hazards is not None:
        zones, known = keep_out_zones_of(scenario.fence), len(hazards.obstacles)
        airspace = unnested_airspace(Airspace(hazards, zones, 0.0, 0.0))
    path = np.empty((steps, 3))
    circles_from = fly_plan(
        tuple(PointMass(vehicle.position_m, heading, 0.0, 0.0, airspeed)),
        row_of_state(fresh_state(known)),
        legs,
        airspace,
        crossing(FLIGHT),
        np.array(vehicle_numbers(Vehicle(guided.aircraft, guided.gains, False))),
        winds(scenario, steps),
        path,
    )
    return path, circles_from


def winds(scenario: Scenario, steps: int) -> Vectors:
    """The wind at each of `steps` times PREDICTION_STEP apart, (steps, 3), NED [m/s].

    It is linear in time between its changes.
    """
    at, speeds, come_from = (np.array(each) for each in zip(*scenario.wind.stages, strict=True))
    toward, time = come_from * DEG + math.pi, PREDICTION_STEP * np.arange(steps)
    north = np.interp(time, at, speeds * np.cos(toward))
    east = np.interp(time, at, speeds * np.sin(toward))
    return np.column_stack((north, east, np.zeros(steps)))


@compiled
def fly_plan(
    begin: tuple[Any, ...],
    row: Row,
    legs: Legs,
    airspace: AirspaceTuple | None,
    law: Law | None,
    vehicle: Row,
    wind_n: Vectors,
    path: Vectors,
) -> int:
    """Write the positions of a flight into `path`; the index of the first after the last goal.

    Args:
        begin: a `PointMass`, as a plain tuple.
        row: the row of a `LoopState`, which becomes that after the flight.
        legs: legs of the mission.
        airspace: the hazards, from `unnested_airspace`, or None.
        law: the law that guides, from `crossing`.
        vehicle: the row of a `Vehicle`.
        wind_n: wind at each step (N, 3), NED [m/s].
        path: positions (N, 3), NED [m].
    """
    motion, flown = PointMass(*begin), read_vehicle(vehicle)
    guides, known = law_of(law), airspace_of(airspace)
    limits, circles_from = dynamics(flown.aircraft, flown.gains), len(path)
    for k in range(len(path)):
        path[k, 0], path[k, 1], path[k, 2] = motion.p_n
        wind, time = (wind_n[k, 0], wind_n[k, 1], wind_n[k, 2]), k * PREDICTION_STEP
        state = state_of(motion, wind, time)
        _, left, outcome = step(
            exact_inputs(state), read_state(row), legs, at_time(known, time), guides, flown
        )
        write_state(left, row)
        if left.mission.goal == len(legs) - 1 and circles_from == len(path):
            circles_from = k
        command = outcome.command
        motion = advance(motion, command.bank, command.gamma, wind, limits, PREDICTION_STEP)
    return circles_from


@compiled
def state_of(motion: PointMass, wind_n: tuple[float, float, float], time: float) -> FlightState:
    """The state of a point mass in a wind, NED [m/s], at a time [s]."""
    level = motion.airspeed * math.cos(motion.gamma)
    v_n = (
        level * math.cos(motion.azimuth) + wind_n[0],
        level * math.sin(motion.azimuth) + wind_n[1],
        wind_n[2] - motion.airspeed * math.sin(motion.gamma),
    )
    R_nb = from_euler(motion.bank, motion.gamma, motion.azimuth)
    return FlightState(time, motion.p_n, v_n, R_nb, motion.airspeed, wind_n)


@compiled
def at_time(airspace: Airspace | None, time: float) -> Airspace | None:
    """The airspace at a time on the clock of the obstacles [s]; None compiles to None."""
    if airspace is None:
        return None
    return Airspace(airspace.hazards, airspace.zones, time, airspace.gust)
