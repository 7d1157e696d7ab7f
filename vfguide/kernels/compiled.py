"""The one way this project compiles a function.

A function that compiled code calls becomes a part of its caller: it needs no machine code of its
own, nor the code that takes Python objects apart. A function that Python calls gets both, and its
machine code is cached on disk with all its parts in it. Only what is called so is compiled so,
which takes a third less time than numba's own way of making every function complete.

The cache folder is named after the text of every compiled module, so that a change in one makes
all the cached machine code stale at once, for a function holds those that it calls.
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
    """Where programs keep what they can make anew; without a home, a path that cannot be made."""
    if named := os.environ.get("XDG_CACHE_HOME"):
        return Path(named)
    try:
        return Path.home() / ".cache"
    except RuntimeError:
        return Path(os.devnull, ".cache")


class EntryPoint(CPUDispatcher):
    """A function compiled for calls from Python, and the same as a part of its callers."""

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
        """What compiled code calls; Python must not."""
        njit: Any = numba.njit
        part = njit(no_cpython_wrapper=True, no_cfunc_wrapper=True)(self.py_func)
        if self.source is not None:
            part._cache = MachineCode(self.py_func, self.source, cache_folder(), "part")
        return part


@typeof_impl.register(EntryPoint)
def typeof_entry_point(function: EntryPoint, context: object) -> types.Dispatcher:
    """What compiled code takes such a function for."""
    return types.Dispatcher(function.part)


def compiled(function: Callable[P, T]) -> Callable[P, T]:
    """Compile `function` with numba on its first call; the machine code is cached on disk.

    It must not call itself.
    """
    return cast("Callable[P, T]", EntryPoint(function, function))


def is_kept(function: object) -> bool:
    """Whether the machine code of what numba compiles is kept from one start to the next."""
    return isinstance(getattr(function, "_cache", None), MachineCode)


def compiled_source(
    function: Callable[P, T], source: Callable[..., Any] | None = None
) -> Callable[P, T]:
    """The same for a function without a file, whose machine code is not cached.

    With a `source`, the function that it is made from and that has a file, it is.
    """
    return cast("Callable[P, T]", EntryPoint(function, source))
