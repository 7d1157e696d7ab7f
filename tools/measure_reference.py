#!/usr/bin/env python3
"""The reference attitude of law field along flights in random worlds, judged step by step.

    python tools/measure_reference.py --runs 50
    python tools/measure_reference.py --kind movers --runs 10 --seed 2

At each step with a setpoint: how far the reference attitude is from SO(3); its body rates against
the derivative of the reference attitude, moved on by the model of the aircraft from the same state,
with what guidance keeps held; and the angle between the attitude and the reference. Steps at which
the derivatives forward and backward differ, as at an obstacle that begins to act, are switches, and
so are those of an escape and of a rate at its limit: they are counted and left out. Worlds are
those of measure_avoidance.
"""

import argparse
import math
from collections.abc import Sequence
from concurrent.futures import ProcessPoolExecutor
from functools import partial
from multiprocessing import get_context
from typing import Any, NamedTuple

import numpy as np
from flown_worlds import DRAWN, scenario_of
from measure_avoidance import fly_table

from vfguide.aircraft.air_density import vehicle_in_air
from vfguide.aircraft.command import GuidanceCommand
from vfguide.aircraft.performance import Gains
from vfguide.aircraft.vehicle import Vehicle, read_vehicle
from vfguide.airspace import detection
from vfguide.airspace.detection import Airspace, airspace_of
from vfguide.assurance.decision import Reason
from vfguide.control import control
from vfguide.control.control import MAX_REFERENCE_RATE, ControlState
from vfguide.earth.geodesy import tangent_plane
from vfguide.estimation import estimation
from vfguide.estimation.caution import cautious
from vfguide.estimation.estimation import Inputs, NavState
from vfguide.estimation.local_frame import Measurement, measured_in, place_in
from vfguide.geometry.so3 import log
from vfguide.geometry.units import DEG
from vfguide.geometry.vector import Mat3, Vec3, Vector, matmul, norm, transpose
from vfguide.guidance import laws
from vfguide.guidance.field_law import Given, airspace_later, commanded, moved
from vfguide.guidance.field_progress import leader_now
from vfguide.guidance.guidance_state import GuidanceState, Leader
from vfguide.guidance.laws import FIELD_LAW, FieldLaw
from vfguide.kernels.compiled import compiled
from vfguide.kernels.rows import Row, replacing
from vfguide.loop import mission
from vfguide.loop.rows import step_measured
from vfguide.loop.state import LoopState, read_state, state_of_row
from vfguide.planning import planning
from vfguide.planning.objective import Objective
from vfguide.planning.route import Route
from vfguide.runs.steps import Steps

STEP = 1e-4
"""Time over which the reference is differenced forward and backward [s]."""
SMOOTH = 0.01
"""Largest difference of the derivatives forward and backward that is no switch [rad/s]."""


class Seen(NamedTuple):
    """What is recorded of one step."""

    orthogonality: float
    """Largest entry of R_na^T R_na - I."""
    rate_error: float
    """Error of the body rates of the reference [rad/s]; not a number at a switch."""
    attitude_error: float
    """Angle from the attitude to the reference [rad]."""
    leader: int
    switches: bool


moved_nav = replacing(NavState, "state", "elapsed")
with_bias = replacing(ControlState, "alpha_bias")
without_learning = replacing(Gains, "k_alpha")


class Guided(NamedTuple):
    """Inputs and outputs of the law at one step."""

    nav: NavState
    objective: Objective
    route: Route
    known: Airspace | None
    vehicle: Vehicle
    command: GuidanceCommand
    after: GuidanceState
    leader: int
    """The value of a `Leader`: what the law followed."""


@compiled
def guided(
    measured: Any, origin: Vec3, before: Row, legs: Any, airspace: Any, law: FieldLaw, vehicle: Row
) -> Guided:
    """The stages of a step up to the law; arguments as of `step_measured`."""
    measurement = Measurement(*measured)
    plane = tangent_plane(origin[0], origin[1], origin[2])
    inputs = Inputs(
        place_in(measurement, plane),
        measured_in(measurement, plane),
        measurement.omega_b,
        False,
        measurement.lead,
        measurement.density,
    )
    s = read_state(before)
    flown = vehicle_in_air(read_vehicle(vehicle), inputs.density)
    nav, _ = estimation.update(inputs, s.thrust, s.estimation, flown)
    flown = cautious(nav, flown)
    objective, _, _ = mission.update(nav, s.mission, s.planning.leg.phase, legs, flown)
    known, _ = detection.update(nav, airspace_of(airspace), s.detection)
    wants = laws.wants_route(law, s.guidance)
    route = planning.update(nav, objective, known, wants, s.planning, s.guidance.slope, flown)
    command, after = laws.update(law, nav, objective, route, known, s.guidance, flown)
    leader = leader_now(objective, s.guidance.progress)
    return Guided(nav, objective, route, known, flown, command, after, leader)


@compiled
def references(
    bias: float,
    measured: Any,
    origin: Any,
    before: Any,
    legs: Any,
    airspace: Any,
    law: FieldLaw,
    vehicle: Any,
) -> tuple[Mat3, Mat3, Mat3, Mat3]:
    """The attitude of a step, and the reference attitude STEP before, at and after it.

    `bias` is the learned correction of the angle of attack [rad]; the others are as of the step.
    """
    nav, goal, route, known, flown, command, after, leader = guided(
        measured, origin, before, legs, airspace, law, vehicle
    )
    s = read_state(before)
    kept = GuidanceState(s.guidance.slope, s.guidance.turning, after.progress)
    same = command, leader, law, nav, goal, route, known, kept, with_bias(s.control, bias), flown
    return (
        nav.state.R_nb,
        reference(-STEP, *same),
        reference(0.0, *same),
        reference(STEP, *same),
    )


@compiled
def reference(
    dt: float,
    command: GuidanceCommand,
    leader: int,
    law: FieldLaw,
    nav: NavState,
    goal: Objective,
    route: Route,
    airspace: Airspace | None,
    s: GuidanceState,
    control_state: ControlState,
    vehicle: Vehicle,
) -> Mat3:
    """The reference attitude of the model that has followed a command for `dt` [s]."""
    state = moved(goal.state, command, vehicle, dt)
    then = moved_nav(nav, state, nav.elapsed + dt)
    objective = Objective(goal.target, state, False, goal.is_goal)
    around = airspace_later(airspace, dt)
    there, _ = commanded(Given(leader, law.remedies, then, objective, route, around, s, vehicle))
    aircraft, gains, is_rigid_body = vehicle
    held = Vehicle(aircraft, without_learning(gains, 0.0), is_rigid_body)
    _, left = control.update(then, there, control_state, held)
    return left.R_na


class Watch:
    """The step of the control loop with law field, which records its reference attitude."""

    def __init__(self) -> None:
        """Start with no step recorded."""
        self.seen: list[Seen] = []

    def step(
        self, measured: Any, origin: Any, before: Any, legs: Any, airspace: Any, *rest: Any
    ) -> Any:
        """The result of the step, which is recorded."""
        _, vehicle = rest
        known = origin, before, legs, airspace, FIELD_LAW, vehicle
        out = step_measured(measured, *known)
        _, _, _, row, _ = out
        after = state_of_row(row)
        R_nb, *three = references(after.control.alpha_bias, measured, *known)
        self.seen.append(seen(after, R_nb, *three))
        return out


def seen(after: LoopState, R_nb: Mat3, earlier: Mat3, now: Mat3, later: Mat3) -> Seen:
    """The record of a step."""
    R_na = np.array(after.control.R_na)
    backward, forward = rate(earlier, now), rate(now, later)
    acts = after.assurance.decision.reason != Reason.NOMINAL
    is_limited = norm(after.control.omega_a) > 0.999 * MAX_REFERENCE_RATE
    switches = acts or is_limited or float(np.linalg.norm(forward - backward)) > SMOOTH
    error = np.linalg.norm(0.5 * (backward + forward) - after.control.omega_a)
    off = matmul(transpose(after.control.R_na), R_nb)
    return Seen(
        float(np.abs(R_na.T @ R_na - np.eye(3)).max()),
        math.nan if switches else float(error),
        float(np.linalg.norm(log(off))),
        int(after.guidance.progress.leader),
        bool(switches),
    )


def rate(a: Mat3, b: Mat3) -> Vector:
    """Body rates from one attitude to another one STEP later [rad/s]."""
    return np.array(log(matmul(transpose(a), b))) / STEP


def fly(kind: str, args: argparse.Namespace, number: int) -> list[Seen]:
    """The records of all steps of one flight."""
    watch = Watch()
    table = scenario_of(kind, args.seed, number)
    fly_table(table, number, args, Steps(measured=watch.step))
    return watch.seen


def parse(arguments: Sequence[str] | None = None) -> argparse.Namespace:
    """The options of the command line."""
    parser = argparse.ArgumentParser(
        description=__doc__, formatter_class=argparse.RawDescriptionHelpFormatter
    )
    parser.add_argument("--kind", dest="kinds", choices=list(DRAWN), action="append")
    parser.add_argument("--runs", type=int, default=25, help="worlds of each kind")
    parser.add_argument("--seed", type=int, default=1)
    parser.add_argument("--jobs", type=int, default=2)
    args = parser.parse_args(arguments)
    args.kinds = args.kinds or list(DRAWN)
    args.out, args.set, args.tree, args.reference_s = None, [], "none", 0.0
    return args


def main() -> None:
    """Fly all worlds, and print their figures."""
    args = parse()
    fly("field", args, 0)
    with ProcessPoolExecutor(args.jobs, get_context("fork")) as pool:
        for kind in args.kinds:
            flights = list(pool.map(partial(fly, kind, args), range(args.runs)))
            report(kind, len(flights), [each for flight in flights for each in flight])


def report(kind: str, flights: int, steps: Sequence[Seen]) -> None:
    """Print the figures of all steps in worlds of one kind."""
    table = np.array(steps, dtype=float)
    off, rates, errors, leader, switches = table.T
    field = leader == Leader.FIELD
    known = rates[~np.isnan(rates)]
    print(
        f"{kind}, {flights} flights, {len(table)} steps: off SO(3) {off.max():.1e}; "
        f"switches {int(switches.sum())}; rates off by {np.quantile(known, 0.999):.1e} at 99.9 %, "
        f"{known.max():.1e} at most, {int((known > 1e-4).sum())} above 1e-4 rad/s; "
        f"attitude error {np.median(errors) / DEG:.2f} deg median, "
        f"{np.median(errors[field]) / DEG:.2f} where the field leads",
        flush=True,
    )


if __name__ == "__main__":
    main()
