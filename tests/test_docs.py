"""The documentation says what the program does: keys, defaults, ranges, names."""

import importlib
import re
import subprocess
import sys
import tomllib
from dataclasses import fields
from types import NoneType, UnionType
from typing import Annotated, get_args, get_origin

import pytest
from pages import DOCS, PAGES, ROOT, names_in, rows_of, tables
from pydantic import TypeAdapter, ValidationError
from pydantic.fields import FieldInfo

from vfguide.autopilots.engagement import Phase
from vfguide.files import (
    aircraft_file,
    fence,
    obstacle_entry,
    scenario_file,
    simulation_entry,
    traffic_entry,
)
from vfguide.files.toml_types import Table
from vfguide.link.messages import RECORDS
from vfguide.results import field_share, interventions, result
from vfguide.runs.bench import Bench
from vfguide.sim.autopilot.mavlink_channel import GROUND, ONBOARD
from vfguide.sim.autopilot.parameters import Parameters

SCENARIO, AIRCRAFT = DOCS / "scenario.md", DOCS / "aircraft.md"
PAPER, PRINT = DOCS / "paper.md", ROOT.parent / "shared" / "paper.tex"
EQUATIONS = (
    "The robot and what it keeps away from",
    "The field in free space",
    "The frame and the rate law",
    "Among obstacles",
    "Among robots",
)
LABELS = r"(?:eq|theo|lem|cor|def|alg|assum|fig|n|tau)\w*"
"""Labels of the paper but for those of its sections."""
NUMBER = r"-?\d+(?:\.\d+)?"
PLACES = [
    (SCENARIO, "Top level", scenario_file.ScenarioHead),
    (SCENARIO, "[origin]", scenario_file.Origin),
    (SCENARIO, "[wind]", simulation_entry.Wind),
    (SCENARIO, "[weather]", simulation_entry.Weather),
    (SCENARIO, "[[wind.change]]", simulation_entry.WindChange),
    (SCENARIO, "[sensors]", simulation_entry.Sensors),
    (SCENARIO, "[link]", simulation_entry.Link),
    (SCENARIO, "[autopilot]", simulation_entry.Autopilot),
    (SCENARIO, "[[autopilot.reset]]", simulation_entry.Reset),
    (SCENARIO, "[guidance]", scenario_file.Guidance),
    (SCENARIO, "[guidance.remedies]", scenario_file.FieldRemedies),
    (SCENARIO, "[avoidance]", scenario_file.Avoidance),
    (SCENARIO, "[fence]", fence.Fence),
    (SCENARIO, "[[fence.zone]]", fence.ZoneEntry),
    (SCENARIO, "[[vehicle]]", scenario_file.VehicleEntry),
    (SCENARIO, "[[vehicle.goal]]", scenario_file.GoalEntry),
    (SCENARIO, "[[obstacle]]", obstacle_entry.ObstacleEntry),
    (SCENARIO, "[[traffic]]", traffic_entry.TrafficEntry),
    (SCENARIO, "[[traffic.change]]", traffic_entry.TrafficChange),
    (SCENARIO, "[traffic_receiver]", traffic_entry.TrafficReceiver),
    (AIRCRAFT, "Top level", aircraft_file.Aircraft),
    (AIRCRAFT, "[airspeed]", aircraft_file.Airspeed),
    (AIRCRAFT, "[limits]", aircraft_file.Limits),
    (AIRCRAFT, "[lift]", aircraft_file.Lift),
    (AIRCRAFT, "[thrust]", aircraft_file.Thrust),
    (AIRCRAFT, "[response]", aircraft_file.Response),
    (AIRCRAFT, "[model]", aircraft_file.ModelTable),
]


def first_rows(page, heading):
    """The rows of the first table under a heading."""
    return next(rows for its, rows in tables(page) if its == heading)


DOCUMENTED = [
    pytest.param(model, *row[:3], id=f"{page.stem} {heading} {row[0]}")
    for page, heading, model in PLACES
    for row in first_rows(page, heading)
]


def is_table(field: FieldInfo) -> bool:
    """Whether a field is a table, or a list of them, with a heading of its own."""
    kinds = (field.annotation, *get_args(field.annotation))
    return any(isinstance(kind, type) and issubclass(kind, Table) for kind in kinds)


def is_number(annotation: object) -> bool:
    """Whether values are numbers, perhaps none at all."""
    if get_origin(annotation) is Annotated:
        return is_number(get_args(annotation)[0])
    if isinstance(annotation, UnionType):
        return all(is_number(part) for part in get_args(annotation) if part is not NoneType)
    return annotation in (int, float)


def takes(field: FieldInfo, value: object) -> bool:
    """Whether the program takes the value for the key."""
    kind = Annotated[field.annotation, *field.metadata] if field.metadata else field.annotation
    try:
        TypeAdapter(kind).validate_python(value)
    except ValidationError:
        return False
    return True


@pytest.mark.parametrize(("page", "heading", "model"), PLACES)
def test_every_key_is_documented_and_no_other(page, heading, model):
    keys = [key for row in first_rows(page, heading) for key in names_in(row[0])]
    assert keys == [key for key, field in model.model_fields.items() if not is_table(field)]


def test_every_table_of_the_files_is_documented():
    documented = {model for _, _, model in PLACES}
    modules = (scenario_file, simulation_entry, obstacle_entry, traffic_entry, fence, aircraft_file)
    tables = {
        kind
        for module in modules
        for kind in vars(module).values()
        if isinstance(kind, type) and issubclass(kind, Table) and kind.__module__ == module.__name__
    }
    assert tables - documented == {scenario_file.ScenarioFile}  # the whole


@pytest.mark.parametrize(("model", "key", "default", "_"), DOCUMENTED)
def test_default(model, key, default, _):
    field = model.model_fields[key.strip("`")]
    if default == "required":
        assert field.is_required()
    elif re.fullmatch("`[^`]+`", default):
        (written,) = tomllib.loads(f"value = {names_in(default)[0]}").values()
        assert TypeAdapter(field.annotation).validate_python(written) == field.default
    else:
        assert field.default is None


@pytest.mark.parametrize(("model", "key", "_", "allowed"), DOCUMENTED)
def test_allowed(model, key, _, allowed):
    field = model.model_fields[key.strip("`")]
    words = [tomllib.loads(f"v = {word}")["v"] for word in names_in(allowed) if word[0] in '"tf']
    between = re.fullmatch(rf"({NUMBER}) to ({NUMBER})", allowed)
    above = re.fullmatch(rf"above ({NUMBER}), up to ({NUMBER})", allowed)
    if between or above:
        low, high = map(float, (between or above).groups())
        step = 1 if field.annotation is int else 1e-6
        kind = int if field.annotation is int else float
        assert takes(field, kind(high))
        assert not takes(field, kind(high + step))
        assert takes(field, kind(low + (step if above else 0)))
        assert not takes(field, kind(low if above else low - step))
    elif words:
        assert all(takes(field, word) for word in words)
        if field.annotation is not bool:
            offered = [value for part in (field.annotation,) for value in get_args(part)]
            assert sorted(offered) == sorted(words)
    else:
        assert not is_number(field.annotation), f"{key}: the range is missing"


def test_positions_reach_as_far_as_documented():
    field = scenario_file.VehicleEntry.model_fields["position_m"]
    rows = {row[0]: row for row in rows_of(SCENARIO, "[[vehicle]]", "[[vehicle.goal]]")}
    assert rows["`position_m`"][2] == "three numbers, -100000 to 100000 each"
    assert takes(field, [1e5, -1e5, 0.0])
    assert not takes(field, [1e5 + 1.0, 0.0, 0.0])


def test_the_sizes_of_every_shape_are_documented():
    _, rows = (rows for its, rows in tables(SCENARIO) if its == "[[obstacle]]")
    told = {names_in(shape)[0].strip('"'): tuple(names_in(sizes)) for shape, sizes, _ in rows}
    assert told == obstacle_entry.SIZES


RESULT_TABLES = (
    result.Result,
    result.VehicleResult,
    result.GoalResult,
    result.ObstacleResult,
    field_share.FieldResult,
    interventions.AssuranceResult,
    interventions.Intervention,
)


@pytest.mark.parametrize(("nth", "record"), list(enumerate(RESULT_TABLES)))
def test_keys_of_a_result(nth, record):
    page = (DOCS / "outputs.md").read_text()
    section = page[page.index("## `result.json`") : page.index("## Logs")]
    table = section.split("| key | meaning |")[nth + 1].split("\n\n")[0]
    first_cells = [line.split("|")[1] for line in table.splitlines() if line.startswith("|")]
    assert [key for cell in first_cells for key in names_in(cell)] == names_of(record)


def test_keys_of_the_bench():
    rows = rows_of(DOCS / "commands.md", "vfguide bench")
    assert [names_in(row[0])[0] for row in rows] == names_of(Bench)


def names_of(record) -> list[str]:
    return [field.name for field in fields(record)]


def test_streams():
    rates = {record.NAME: (record.MSGID, record) for record in RECORDS}
    written = {row[0]: (row[1], row[2]) for row in rows_of(DOCS / "mavlink.md", "What it streams")}
    for side, table in enumerate((ONBOARD, GROUND)):
        told = {
            rates[name][0]: float(row[side]) for name, row in written.items() if row[side] != "-"
        }
        assert told == table


def test_parameters_of_the_software_autopilot():
    rows = rows_of(DOCS / "mavlink.md", "How it flies")
    parameters = Parameters()
    assert {names_in(row[0])[0] for row in rows} == set(parameters.names())
    for name, value, _ in rows:
        assert parameters[names_in(name)[0]] == float(value)


def test_phases():
    rows = rows_of(DOCS / "mavlink.md", "Who flies")
    told = {name for row in rows for name in row[0].split(", ")}
    assert told == {phase.name.lower() for phase in Phase}


@pytest.mark.parametrize("command", ["run", "sim", "fly", "replay"])
def test_options_of_a_command(command):
    done = subprocess.run(
        [sys.executable, "-c", "from vfguide.cli.main import main; main()", command, "--help"],
        capture_output=True,
        text=True,
        check=True,
    )
    told = [names_in(row[0])[0] for row in rows_of(DOCS / "commands.md", f"vfguide {command}")]
    offered = set(re.findall(r"^\s+(?:-\w, )?(--[a-z-]+)", done.stdout, re.MULTILINE)) - {"--help"}
    if command == "run":
        offered = offered - {"--report"} | {"--no-report"}
    assert {option.split()[0] for option in told} == offered


def mentions(pattern: str):
    found = {(page, name) for page in PAGES for name in re.findall(pattern, page.read_text())}
    return [pytest.param(name, id=f"{page.stem} {name}") for page, name in sorted(found)]


@pytest.mark.parametrize("name", mentions(r"`((?:vfguide|tests|tools|docs|\.ci)/[\w/.-]*)`"))
def test_files_that_are_named_are_there(name):
    assert (ROOT / name).exists()


@pytest.mark.parametrize("name", mentions(r"`(tests/[\w/.]+::\w+)`"))
def test_tests_that_are_named_are_there(name):
    file, test = name.split("::")
    assert f"\ndef {test}(" in (ROOT / file).read_text()


@pytest.mark.parametrize("name", mentions(r"`(vfguide\.[a-z_]+\.[a-z_.]+)`"))
def test_functions_that_are_named_are_there(name):
    try:
        importlib.import_module(name)
    except ModuleNotFoundError:
        module, function = name.rsplit(".", 1)
        assert hasattr(importlib.import_module(module), function)


@pytest.mark.parametrize("row", rows_of(PAPER, *EQUATIONS), ids=lambda row: row[0])
def test_every_equation_has_a_test(row):
    tests = names_in(row[2])
    assert tests
    assert all(name.startswith("tests/") for name in tests)


@pytest.mark.skipif(not PRINT.exists(), reason="the source of the paper is not here")
def test_labels_of_the_paper():
    printed = set(re.findall(rf"\\label{{({LABELS}[^}}]*)}}", PRINT.read_text()))
    named = {name for row in rows_of(PAPER) for cell in row for name in names_in(cell)}
    assert {name for name in named if re.match(LABELS + "( |$)", name)} == printed
