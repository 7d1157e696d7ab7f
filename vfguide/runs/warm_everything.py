"""Everything compiled ahead: all that the commands do is done once, with the shipped scenarios."""

from collections.abc import Callable, Sequence
from dataclasses import dataclass
from functools import partial
from pathlib import Path
from tempfile import TemporaryDirectory

from vfguide.daemon.warm_up import warm_up as warm_up_companion
from vfguide.field_points.field_point import Point
from vfguide.field_points.field_points import LAW_NAMES, fields_at
from vfguide.files.data import shipped_scenarios
from vfguide.geometry.vector import ZERO
from vfguide.kernels.rows import table_of
from vfguide.preflight.load import load_scenario
from vfguide.preflight.prediction import predict
from vfguide.preflight.route_checks import GuidedAircraft
from vfguide.runs.lockstep import NoRequests, ignore_progress
from vfguide.runs.run import run_scenario
from vfguide.runs.vehicle_setup import simulate
from vfguide.scenario.plans import plan_of
from vfguide.sim.realtime import warm_up as warm_up_simulator

FIELD_SCENARIOS = ("first-flight", "towers")
"""The shipped scenarios whose field is evaluated in all laws: one without obstacles, one with."""
DRAWN = (
    "avoidance/fence-corner",
    "field/example-1",
    "field/slalom",
    "paper/example-2",
    "towers",
    "traffic",
)
"""The shipped scenarios that are drawn: each kind of thing that a figure shows is in one of them,
and law field without hazards and with. A drawing takes longer than the flight, and the next of the
same kind compiles nothing."""


@dataclass(frozen=True)
class Stage:
    """A part of what the commands do."""

    name: str
    do: Callable[[], None]


def everything() -> Sequence[Stage]:
    """All that the commands do, in stages."""
    flights = [Stage(name, partial(_fly, name)) for name in shipped_scenarios()]
    others = (("sim and fly", _fly_live), ("field", _evaluate), ("vehicles that meet", _predict))
    return (*flights, *(Stage(*each) for each in others))


def _fly(name: str) -> None:
    """Fly a shipped scenario, judge and perhaps draw it, and leave nothing."""
    with TemporaryDirectory(prefix="vfguide-warm-") as folder:
        loaded, wanted, draw = load_scenario(name), Path(folder, "run"), name in DRAWN
        run_scenario(loaded, wanted, ignore_progress, NoRequests(), "", report=draw)


def _fly_live() -> None:
    """What `vfguide sim` and `vfguide fly` do before their clocks run."""
    for name in ("first-flight", "towers", "traffic"):
        loaded = load_scenario(name)
        warm_up_simulator(simulate(loaded, loaded.scenario.vehicles[0]))
        warm_up_companion(plan_of(loaded, loaded.scenario.vehicles[0]))


def _predict() -> None:
    """What `vfguide check` does with several vehicles, with hazards and without."""
    for name in ("first-flight", "towers"):
        loaded = load_scenario(name)
        vehicle = loaded.scenario.vehicles[0]
        predict(
            loaded.scenario,
            vehicle,
            GuidedAircraft(loaded.performance(vehicle), loaded.gains(vehicle)),
        )


def _evaluate() -> None:
    """The field of vehicles at their starts, in all laws."""
    for name in FIELD_SCENARIOS:
        loaded = load_scenario(name)
        vehicle = loaded.scenario.vehicles[0]
        points = table_of(Point, [Point(vehicle.position_m, ZERO, 0.0)])
        for law in LAW_NAMES:
            fields_at(loaded, vehicle, points, law)
