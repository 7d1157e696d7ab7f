"""Warm-up flights, so that a timed flight finds all its code compiled."""

from collections.abc import Callable
from functools import cache, partial

from vfguide.preflight.load import load_scenario
from vfguide.runs.jsbsim_vehicle import JsbsimVehicle
from vfguide.runs.rigid_bodies import RigidBodies
from vfguide.scenario.hazards import hazards_of
from vfguide.scenario.loaded import LoadedScenario

UPDATES = 100
"""Number of updates of a warm-up flight; chosen, so that the companion takes over within it."""


Tell = Callable[[str, int, int], None]
"""Told what is compiled from now on, if it is not in the cache, and which of how many stages."""


def tell_nobody(_: str, __: int, ___: int) -> None:
    """A silent one."""


def warm_up(loaded: LoadedScenario, tell: Tell = tell_nobody) -> None:
    """Compile or load all the compiled code that flies the scenario."""
    stages = _stages(loaded)
    for number, (name, fly) in enumerate(stages.items(), start=1):
        tell(name, number, len(stages))
        fly()


def _stages(loaded: LoadedScenario) -> dict[str, Callable[[], None]]:
    """The flights by what they compile."""
    law = loaded.scenario.law
    if loaded.scenario.plant != "jsbsim":
        return {"the rigid bodies": RigidBodies(loaded, _ignore).advance}
    if hazards_of(loaded.scenario) is None:
        stages = {"the control loop": partial(_fly_an_aeroplane, "first-flight", law)}
    else:
        stages = {"the control loop among hazards": partial(_fly_an_aeroplane, "towers", law)}
    if loaded.scenario.traffic:
        stages["the control loop in traffic"] = partial(_fly_an_aeroplane, "traffic", law)
    return stages


@cache
def _fly_an_aeroplane(name: str, law: str) -> None:
    """Once in a process, in the shipped scenario of that name."""
    loaded = load_scenario(name, [f"law={law}"])
    member = JsbsimVehicle(loaded, loaded.scenario.vehicles[0], _ignore, _ignore)
    for _ in range(UPDATES):
        member.fly(1)


def _ignore(_: int, __: bytes) -> None:
    pass
