"""JSBSim, loaded with a model and kept quiet. No other module knows jsbsim."""

import ctypes
import os
from pathlib import Path
from typing import Any

os.environ.setdefault("JSBSIM_DEBUG", "0")

import jsbsim

from vfguide.sim.condition import Model

Fdm = jsbsim.FGFDMExec
PropertyNode = jsbsim.FGPropertyNode
JsbsimError = jsbsim.BaseError


class ModelError(Exception):
    """A JSBSim model cannot be flown; the message names its file and what is wrong with it."""


def stock_root() -> Path:
    """The folder of the aircraft that the jsbsim package ships."""
    return Path(jsbsim.get_default_root_dir()) / "aircraft"


def load(model: Model, dt: float) -> Fdm:
    """A fresh JSBSim instance that has loaded `model`, and run it once with its clock standing.

    `dt` is the time step [s]; JSBSim takes it into its filters while it loads, never later.

    Raises:
        ModelError: the model is missing, unreadable or broken.
    """
    _require_file(model)
    journal = _Journal()
    jsbsim.set_logger(journal)
    directory = model.directory.resolve()
    fdm = Fdm(str(directory.parent))
    fdm.set_debug_level(0)
    fdm.set_dt(dt)
    engines, systems = str(directory.parent / "engine"), str(directory.parent / "systems")
    try:
        loaded = fdm.load_model_with_paths(model.name, str(directory), engines, systems)
        if loaded and fdm.run_ic() and not journal.fatal:
            return fdm
    except JsbsimError as error:
        never_free(fdm)
        raise model_error(model, journal.text or str(error)) from error
    never_free(fdm)
    raise model_error(model, journal.text or "JSBSim cannot load it")


def model_error(model: Model, complaint: str) -> ModelError:
    """The error that names the file of `model` and, on the same line, what JSBSim says of it."""
    what = " ".join(complaint.split()).removeprefix(f"In file {model.file.resolve()}: ")
    return ModelError(f"{model.file}: {what}")


class _Journal(jsbsim.FGLogger):
    """Keeps what JSBSim says off the terminal, and its errors for a message of ours."""

    def __init__(self) -> None:
        super().__init__()
        self._is_error = False
        self.fatal = False
        self.text = ""

    def set_level(self, level: jsbsim.LogLevel) -> None:
        self._is_error = level in (jsbsim.LogLevel.ERROR, jsbsim.LogLevel.FATAL)
        self.fatal = self.fatal or level == jsbsim.LogLevel.FATAL

    def file_location(self, filename: str, line: int) -> None:
        self.message(f"In file {filename}: line {line} ")

    def message(self, message: str) -> None:
        if self._is_error:
            self.text = (self.text + message)[-_LONGEST:]

    def format(self, format: Any) -> None:  # noqa: A002, the name is JSBSim's
        pass

    def flush(self) -> None:
        self.message(" ")


_LONGEST = 500
"""Characters of JSBSim's errors that are kept."""


def _require_file(model: Model) -> None:
    if not model.folder.is_dir():
        raise ModelError(f"{model.folder}: no such directory of a JSBSim model")
    if not model.file.is_file():
        raise ModelError(f"{model.file}: no such file; a JSBSim model is NAME/NAME.xml")


def never_free(fdm: Fdm) -> None:
    """Keep `fdm` to the end of the process and beyond.

    The destructor of JSBSim 1.3.3 evaluates the model's functions once more; the error that
    a broken one then raises ends the process.
    """
    ctypes.pythonapi.Py_IncRef(ctypes.py_object(fdm))
