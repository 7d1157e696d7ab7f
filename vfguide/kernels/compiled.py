"""The one way this project compiles a function.

A function has two forms. The one that compiled code calls is a part of its caller and cannot take
Python objects. The one that Python calls can, and its machine code holds that of all the functions
that it calls. Each form is compiled when it is first needed and kept on disk. numba would make
both forms of every function, which takes half as much time again.

The cache folder is named after the text of every compiled module: a function holds those that it
calls, so a change in one module has to make all the cached machine code stale.
"""

import hashlib
import os
from collections.abc import Callable
from functools import cache, cached_property
from pathlib import Path
from typing import Any, ParamSpec, TypeVar, cast

import numba
from numba.core import types
from numba.core.registry import CPUDispatcher
from numba.extending import typeof_impl

from vfguide.kernels.machine_code import MachineCode

P = ParamSpec("P")
T = TypeVar("T")


@cache
def cache_folder() -> Path:
    """Folder for the machine code of exactly this version of the compiled sources."""
    package = Path(__file__).parent.parent
    digest = hashlib.sha256()
    for source in sorted(package.rglob("*.py")):
        text = source.read_bytes()
        if b"kernels.compiled import" in text or b"NamedTuple" in text:
            digest.update(text)
    return cache_home() / "vfguide" / digest.hexdigest()[:16]


def cache_home() -> Path:
    """The user's cache folder (XDG Base Directory Specification).

    Without a home directory it is a path that cannot be created, so that nothing is kept.
    """
    if named := os.environ.get("XDG_CACHE_HOME"):
        return Path(named)
    try:
        return Path.home() / ".cache"
    except RuntimeError:
        return Path(os.devnull, ".cache")


class EntryPoint(CPUDispatcher):
    """A function compiled for calls from Python; its `part` is the form for compiled callers."""

    def __init__(self, function: Callable[..., Any], source: Callable[..., Any] | None) -> None:
        """Nothing is compiled before the first call.

        Args:
            function: to compile.
            source: the function whose file holds its text; None: its machine code is not kept.
        """
        super().__init__(function, targetoptions={"nopython": True, "no_cfunc_wrapper": True})
        self.source = source
        if source is not None:
            self._cache = MachineCode(function, source, cache_folder(), "whole")

    @cached_property
    def part(self) -> Any:
        """The form that compiled code calls; Python must not call it."""
        njit: Any = numba.njit
        part = njit(no_cpython_wrapper=True, no_cfunc_wrapper=True)(self.py_func)
        if self.source is not None:
            part._cache = MachineCode(self.py_func, self.source, cache_folder(), "part")
        return part


@typeof_impl.register(EntryPoint)
def typeof_entry_point(function: EntryPoint, context: object) -> types.Dispatcher:
    """The type in numba of an entry point that compiled code names: that of its `part`."""
    return types.Dispatcher(function.part)


def compiled(function: Callable[P, T]) -> Callable[P, T]:
    """Compile `function` with numba on its first call; the machine code is cached on disk.

    `function` must not be recursive.
    """
    return cast("Callable[P, T]", EntryPoint(function, function))


def is_kept(function: object) -> bool:
    """Whether the machine code of `function` is kept from one start to the next."""
    return isinstance(getattr(function, "_cache", None), MachineCode)


def compiled_source(
    function: Callable[P, T], source: Callable[..., Any] | None = None
) -> Callable[P, T]:
    """Compile, as `compiled` does, a function that was made from text and has no file.

    Its machine code is cached only with a `source`: the function it was made from, which has one.
    """
    return cast("Callable[P, T]", EntryPoint(function, source))
