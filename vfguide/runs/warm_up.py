"""Warm-up flights, so that a timed flight finds all its code compiled."""

from functools import cache

from vfguide.runs.jsbsim_vehicle import JsbsimVehicle
from vfguide.runs.rigid_bodies import RigidBodies
from vfguide.scenario.hazards import hazards_of
from vfguide.scenario.load import LoadedScenario, load_scenario

UPDATES = 100
"""Number of updates of a warm-up flight; chosen, so that the companion takes over within it."""


def warm_up(loaded: LoadedScenario) -> None:
    """Compile or load all the compiled code that flies the scenario."""
    if loaded.scenario.plant == "jsbsim":
        law = loaded.scenario.law
        _fly_an_aeroplane("first-flight" if hazards_of(loaded.scenario) is None else "towers", law)
        if loaded.scenario.traffic:
            _fly_an_aeroplane("traffic", law)
    else:
        RigidBodies(loaded, _ignore).advance()


@cache
def _fly_an_aeroplane(name: str, law: str) -> None:
    """Once in a process, in the shipped scenario of that name."""
    loaded = load_scenario(name, [f"law={law}"])
    member = JsbsimVehicle(loaded, loaded.scenario.vehicles[0], _ignore, _ignore)
    for _ in range(UPDATES):
        member.fly(1)


def _ignore(_: int, __: bytes) -> None:
    pass
