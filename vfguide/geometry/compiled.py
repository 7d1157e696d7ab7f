"""The one way this project compiles a function.

A function that compiled code calls becomes a part of its caller: it needs no machine code of its
own, nor the code that takes Python objects apart. A function that Python calls gets both, and its
machine code is cached on disk with all its parts in it. Only what is called so is compiled so,
which takes a third less time than numba's own way of making every function complete.

numba caches machine code by the time stamp of the file that holds the function, not of
the files it calls into. Here the cache folder is named after the text of every compiled
module, so that a change in one makes all the cached machine code stale at once.
"""

import fcntl
import hashlib
import os
from collections.abc import Callable, Generator
from contextlib import contextmanager
from functools import cache, cached_property
from pathlib import Path
from typing import Any, ParamSpec, TypeVar, cast

import numba
from numba.core import config, types
from numba.core.registry import CPUDispatcher
from numba.extending import typeof_impl

P = ParamSpec("P")
T = TypeVar("T")


@cache
def cache_folder() -> Path:
    """Folder for the machine code of exactly this version of the compiled sources."""
    package = Path(__file__).parent.parent
    digest = hashlib.sha256()
    for source in sorted(package.rglob("*.py")):
        text = source.read_bytes()
        if b"geometry.compiled import" in text or b"NamedTuple" in text:
            digest.update(text)
    home = os.environ.get("XDG_CACHE_HOME") or str(Path.home() / ".cache")
    return Path(home) / "vfguide" / digest.hexdigest()[:16]


class EntryPoint(CPUDispatcher):
    """A function compiled for calls from Python, and the same as a part of its callers."""

    def __init__(self, function: Callable[..., Any], *, cached: bool) -> None:
        """Nothing is compiled before the first call."""
        super().__init__(function, targetoptions={"nopython": True, "no_cfunc_wrapper": True})
        self.cached = cached
        if cached:
            with _caching_in(cache_folder()):
                self.enable_caching()

    @cached_property
    def part(self) -> Any:
        """What compiled code calls; Python must not."""
        njit: Any = numba.njit
        part = njit(no_cpython_wrapper=True, no_cfunc_wrapper=True)(self.py_func)
        if self.cached:
            with _caching_in(cache_folder() / "parts"):
                part.enable_caching()
        return part


@typeof_impl.register(EntryPoint)
def typeof_entry_point(function: EntryPoint, context: object) -> types.Dispatcher:
    """What compiled code takes such a function for."""
    return types.Dispatcher(function.part)


def compiled(function: Callable[P, T]) -> Callable[P, T]:
    """Compile `function` with numba on its first call; the machine code is cached on disk.

    It must not call itself.
    """
    return cast("Callable[P, T]", EntryPoint(function, cached=True))


def compiled_source(function: Callable[P, T]) -> Callable[P, T]:
    """The same for a function without a file, whose machine code cannot be cached."""
    return cast("Callable[P, T]", EntryPoint(function, cached=False))


def over_points(signature: str, layout: str) -> Callable[[Callable[..., None]], Callable[..., Any]]:
    """Compile a kernel into a NumPy ufunc that runs over the leading axes of arrays.

    `signature` and `layout` are numba's, as in ``"(float64[:], float64[:])", "(n)->(n)"``.
    """

    def decorate(kernel: Callable[..., None]) -> Callable[..., Any]:
        with _one_process_at_a_time(), _caching_in(cache_folder()):
            ufunc = numba.guvectorize([signature], layout, nopython=True, cache=True)(kernel)
        return cast("Callable[..., Any]", ufunc)

    return decorate


@contextmanager
def _one_process_at_a_time() -> Generator[None]:
    """Hold the lock of the cache folder.

    numba keeps a kernel and the loop around it in two files, and names the one in the other by
    a number that each process counts for itself. Files of two processes that compile at the
    same time do not fit together: the first call would end the program.
    """
    folder = cache_folder()
    folder.mkdir(parents=True, exist_ok=True)
    with (folder / "lock").open("w") as lock:
        fcntl.flock(lock, fcntl.LOCK_EX)
        yield


@contextmanager
def _caching_in(folder: Path) -> Generator[None]:
    """Have numba cache in a folder what is decorated meanwhile."""
    settings = cast("Any", config)
    before = settings.CACHE_DIR
    settings.CACHE_DIR = str(folder)
    try:
        yield
    finally:
        settings.CACHE_DIR = before
