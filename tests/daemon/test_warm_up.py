"""After the warm-up nothing is compiled in flight, where a small computer would stand still."""

import os
import subprocess
import sys

import pytest

pytestmark = pytest.mark.slow

PROGRAM = """
import sys

import vfguide.daemon.daemon
from vfguide.daemon.warm_up import warm_up
from vfguide.kernels.compiled import EntryPoint
from vfguide.preflight.load import load_scenario
from vfguide.scenario.plans import plan_of

loaded = load_scenario(sys.argv[1])
warm_up(plan_of(loaded, loaded.scenario.vehicles[0]))
rooms = tuple(f"vfguide.{room}" for room in sys.argv[2:])
for name, module in sorted(sys.modules.items()):
    if name.startswith(rooms):
        for what, thing in vars(module).items():
            if isinstance(thing, EntryPoint) and not thing.signatures:
                print(f"{name}.{what}")
"""
"""It prints the compiled functions that Python calls in flight and that were not called yet."""
ROOMS = ("annunciations", "companion", "surveillance", "telemetry")
"""The rooms whose Python calls compiled functions while a vehicle flies."""
FLIGHT = "vfguide.companion.guided_flight"
NOT_IN_FLIGHT = {f"{FLIGHT}.air_report", f"{FLIGHT}.noted_numbers"}
"""What only records of simulated flights ask for."""
IDENTIFICATION = {
    f"{FLIGHT}.in_sight",
    f"{FLIGHT}.no_attempts",
    "vfguide.companion.circuit",
    "vfguide.companion.identification_flight",
}
"""What only test flights call: modules, and functions of others."""


@pytest.mark.parametrize("scenario", ["first-flight", "traffic"])
def test_all_that_is_called_in_flight_has_been_called(scenario):
    done = subprocess.run(
        [sys.executable, "-c", PROGRAM, scenario, *ROOMS],
        env=os.environ,
        capture_output=True,
        text=True,
        check=True,
        timeout=300,
    )
    left = set(done.stdout.split()) - NOT_IN_FLIGHT - IDENTIFICATION
    assert {each for each in left if each.rpartition(".")[0] not in IDENTIFICATION} == set()
