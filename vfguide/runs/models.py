"""Which JSBSim model the simulator flies for an aircraft."""

from pathlib import Path

from vfguide.files.data import close_match
from vfguide.files.errors import InputError
from vfguide.scenario.loaded import LoadedScenario
from vfguide.sim.condition import Model
from vfguide.sim.fdm import stock_root


def require_models(loaded: LoadedScenario) -> None:
    """Make sure that every aircraft can be simulated.

    Raises:
        InputError: one has no JSBSim model.
    """
    if loaded.scenario.plant == "jsbsim":
        for name in loaded.files:
            model_of(loaded, name)


def model_of(loaded: LoadedScenario, name: str) -> Model:
    """The model of the aircraft `name`: its own, or one that the jsbsim package ships.

    Raises:
        InputError: there is none, or there are two.
    """
    files, stock = loaded.files[name], loaded.aircraft[name].model.stock
    own = Model(files.root, name)
    if stock is None:
        if files.model is None:
            raise InputError(f"{own.file}: no such file, the simulation of {name} needs it")
        return own
    at = f'{files.performance}: model.stock = "{stock}"'
    if files.model is not None:
        raise InputError(f"{at}: not allowed beside a model of its own, {own.file}")
    return _stock(stock, at)


def _stock(name: str, at: str) -> Model:
    """The model `name` of the jsbsim package; `at` says who asks for it."""
    model = Model(stock_root(), name)
    if not model.file.is_file():
        hint = close_match(name, _names(model.directory))
        where = f"allowed are the folders of {model.directory}"
        raise InputError(f"{at}: the jsbsim package ships no such aircraft{hint}; {where}")
    return model


def _names(root: Path) -> list[str]:
    return sorted(
        folder.name for folder in root.glob("*") if Model(root, folder.name).file.is_file()
    )
