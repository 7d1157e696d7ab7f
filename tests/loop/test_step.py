"""The step: what it remembers, the same over rows, and that it is the spine of the program."""

import ast
import inspect
import math
import textwrap
from collections import Counter
from pathlib import Path

import pytest
from flight_states import VEHICLE
from loop_legs import LEGS

import vfguide
from vfguide.aircraft.state import FlightState
from vfguide.airspace.detection import Airspace, unnested_airspace
from vfguide.airspace.fence import fences
from vfguide.airspace.hazards import Hazards, traffic_rows
from vfguide.airspace.keep_out import NO_FENCE
from vfguide.earth.projection import Projection
from vfguide.estimation.estimation import Inputs
from vfguide.estimation.local_frame import (
    Measurement,
    place_measured,
    place_state,
)
from vfguide.field.obstacle import Obstacle, obstacle_rows
from vfguide.geometry.shapes import shape
from vfguide.geometry.so3 import from_euler
from vfguide.geometry.vector import ZERO
from vfguide.guidance.laws import FLIGHT, PAPER, crossing
from vfguide.kernels.rows import row_of
from vfguide.loop.rows import step_measured
from vfguide.loop.state import fresh_state, row_of_state
from vfguide.loop.step import step

ORIGIN = (0.8, 0.1, 400.0)
MEASURED = Measurement(
    time=1.0,
    origin=(0.8001, 0.1, 380.0),
    p_l=(-900.0, 20.0, -130.0),
    v_l=(24.0, 3.0, -1.0),
    ahead=0.02,
    q_lb=(0.9, 0.1, 0.05, 0.1),
    calibrated=23.0,
    altitude=510.0,
    density=1.166,
    wind_l=(2.0, -1.0, 0.0),
    omega_b=(0.1, 0.2, -0.1),
    lead=0.05,
    projection=int(Projection.AZIMUTHAL_EQUIDISTANT),
)


def towers() -> Airspace:
    """One in sight, and one that is not yet."""
    places = ((-250.0, 20.0, -100.0), (400.0, 0.0, -100.0))
    rows = obstacle_rows([Obstacle(shape.cylinder(20.0, 300.0), p_n) for p_n in places])
    hazards = Hazards(rows, traffic_rows([]), fences([]), 30.0, math.inf)
    return Airspace(hazards, NO_FENCE, 7.0, 1.0)


def test_a_step_remembers_its_state():
    here = FlightState(
        1.0, (-400.0, 30.0, -140.0), (25.0, 0.0, 0.0), from_euler(0.0, 0.05, 0.0), 25.0, (0.0,) * 3
    )
    setpoint, after, outcome = step(
        Inputs(here, here, ZERO, False, 0.0), fresh_state(), LEGS, None, FLIGHT, VEHICLE
    )
    s = after.estimation
    assert (s.time, s.p_n, s.v_n, s.is_continuous) == (1.0, here.p_n, here.v_n, True)
    assert s.air.time == 1.0
    assert after.thrust == setpoint.thrust
    assert after.mission.goal == 0
    assert outcome.command.remaining > 390.0
    assert outcome.passage.miss == math.inf


def test_a_state_that_is_known_exactly_is_not_estimated():
    here = FlightState(
        1.0, (-400.0, 30.0, -140.0), (25.0, 0.0, 0.0), from_euler(0.0, 0.05, 0.0), 25.0, (0.0,) * 3
    )
    _, after, _ = step(
        Inputs(here, here, ZERO, True, 0.0), fresh_state(), LEGS, None, FLIGHT, VEHICLE
    )
    assert after.estimation.p_n == here.p_n
    assert (row_of(after.estimation.air) == row_of(fresh_state().estimation.air)).all()


@pytest.mark.parametrize("law", [FLIGHT, PAPER])
@pytest.mark.parametrize("airspace", [None, towers()])
def test_the_step_for_a_link_is_the_step(law, airspace):
    s = fresh_state(0 if airspace is None else 2)
    now, then = place_measured(MEASURED, ORIGIN), place_state(MEASURED, ORIGIN)
    inputs = Inputs(then, now, MEASURED.omega_b, False, MEASURED.lead, MEASURED.density)
    setpoint, after, outcome = step(inputs, s, LEGS, airspace, law, VEHICLE)
    measured = tuple(MEASURED)
    values = None if airspace is None else unnested_airspace(airspace)
    omega_b, thrust, q_nb, row_after, miss = step_measured(
        measured, ORIGIN, row_of_state(s), LEGS, values, crossing(law), row_of(VEHICLE)
    )
    assert (omega_b, thrust, q_nb) == setpoint
    assert (row_after == row_of_state(after)).all()
    assert miss == outcome.passage.miss


STAGES = {
    "vfguide.estimation.estimation.update",
    "vfguide.loop.mission.update",
    "vfguide.airspace.detection.update",
    "vfguide.planning.planning.update",
    "vfguide.guidance.laws.update",
    "vfguide.assurance.assurance.update",
    "vfguide.control.control.update",
    "vfguide.control.limits.apply",
    "vfguide.loop.progress.update",
}
LAWS = {f"vfguide.guidance.{name}_law.update" for name in ("flight", "field", "paper")}
LONGEST = 30
"""Lines that the spine may have."""
PACKAGE = Path(vfguide.__file__).parent
USED_BY = {
    "loop/step.py": STAGES,
    "guidance/laws.py": LAWS,
    # At a point there is no step.
    "field_points/field_law_points.py": {"vfguide.guidance.field_law.update"},
    # The approach and the routes are those of law flight.
    "guidance/field_law.py": {"vfguide.guidance.flight_law.update"},
    # The paper says nothing of the circle after the last goal.
    "guidance/paper_law.py": {"vfguide.guidance.flight_law.update"},
}
"""Modules that may name the function of a stage."""


def full_names(tree: ast.AST) -> dict[str, str]:
    """What the names that a module imports stand for."""
    names = dict[str, str]()
    for node in ast.walk(tree):
        if isinstance(node, ast.Import):
            for each in node.names:
                first = each.name.split(".")[0]
                names[each.asname or first] = each.name if each.asname else first
        elif isinstance(node, ast.ImportFrom):
            for each in node.names:
                names[each.asname or each.name] = f"{node.module}.{each.name}"
    return names


def used(tree: ast.AST, names: dict[str, str]) -> Counter[str]:
    """How often each dotted name is used, by its full name; one that is imported counts, too."""
    count = Counter[str]()
    for node in ast.walk(tree):
        if isinstance(node, ast.ImportFrom):
            count.update(f"{node.module}.{each.name}" for each in node.names)
        elif isinstance(node, ast.Attribute):
            first, *rest = ast.unparse(node).split(".")
            count[".".join((names.get(first, first), *rest))] += 1
    return count


def spine() -> ast.FunctionDef:
    source = textwrap.dedent(inspect.getsource(step.py_func))
    (function,) = ast.parse(source).body
    assert isinstance(function, ast.FunctionDef)
    return function


def test_the_spine_is_short():
    _, first, *_ = spine().body  # after its docstring
    last = spine().body[-1]
    assert last.end_lineno - first.lineno + 1 <= LONGEST


def test_the_spine_calls_each_stage_once():
    names = full_names(ast.parse((PACKAGE / "loop" / "step.py").read_text()))
    calls = [node.func for node in ast.walk(spine()) if isinstance(node, ast.Call)]
    called = Counter[str]()
    for function in calls:
        first, *rest = ast.unparse(function).split(".")
        called[".".join((names.get(first, first), *rest))] += 1
    assert {name for name in called if name.endswith(".update")} == STAGES - {
        "vfguide.control.limits.apply"
    }
    assert {name: called[name] for name in STAGES} == dict.fromkeys(STAGES, 1)
    assert not any(isinstance(node, ast.For | ast.While | ast.If) for node in ast.walk(spine()))


def test_nothing_else_calls_a_stage():
    found = dict[str, set[str]]()
    for path in sorted(PACKAGE.rglob("*.py")):
        tree = ast.parse(path.read_text())
        if stages := set(used(tree, full_names(tree))) & (STAGES | LAWS):
            found[path.relative_to(PACKAGE).as_posix()] = stages
    assert found == USED_BY


@pytest.mark.parametrize(
    "source",
    [
        "from vfguide.planning import planning\nplanning.update(1)",
        "from vfguide.planning import planning as p\nplan = p.update",
        "import vfguide.planning.planning\nvfguide.planning.planning.update(1)",
        "import vfguide.planning.planning as p\np.update(1)",
        "from vfguide.planning.planning import update",
        "from vfguide.planning.planning import update as plan",
        "def f():\n    from vfguide.planning import planning\n    return planning.update(1)",
    ],
)
def test_a_stage_is_seen_by_whatever_name(source):
    tree = ast.parse(source)
    assert "vfguide.planning.planning.update" in used(tree, full_names(tree))
