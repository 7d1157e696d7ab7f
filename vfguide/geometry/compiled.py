"""The one way this project compiles a function.

numba caches machine code by the time stamp of the file that holds the function, not of
the files it calls into. Here the cache folder is named after the text of every compiled
module, so that a change in one makes all the cached machine code stale at once.
"""

import fcntl
import hashlib
import os
from collections.abc import Callable, Generator
from contextlib import contextmanager
from functools import cache
from pathlib import Path
from typing import Any, ParamSpec, TypeVar, cast

import numba
from numba.core import config

P = ParamSpec("P")
T = TypeVar("T")


@cache
def cache_folder() -> str:
    """Folder for the machine code of exactly this version of the compiled sources."""
    package = Path(__file__).parent.parent
    digest = hashlib.sha256()
    for source in sorted(package.rglob("*.py")):
        text = source.read_bytes()
        if b"geometry.compiled import" in text or b"NamedTuple" in text:
            digest.update(text)
    home = os.environ.get("XDG_CACHE_HOME") or str(Path.home() / ".cache")
    return str(Path(home) / "vfguide" / digest.hexdigest()[:16])


def compiled(function: Callable[P, T]) -> Callable[P, T]:
    """Compile `function` with numba on its first call; the machine code is cached on disk."""
    return cast("Callable[P, T]", _cached(numba.njit, function, {}))


def over_points(signature: str, layout: str) -> Callable[[Callable[..., None]], Callable[..., Any]]:
    """Compile a kernel into a NumPy ufunc that runs over the leading axes of arrays.

    `signature` and `layout` are numba's, as in ``"(float64[:], float64[:])", "(n)->(n)"``.
    """

    def decorate(kernel: Callable[..., None]) -> Callable[..., Any]:
        def guvectorize(**options: Any) -> Callable[[Callable[..., None]], Any]:
            return numba.guvectorize([signature], layout, nopython=True, **options)

        with _one_process_at_a_time():
            return cast("Callable[..., Any]", _cached(guvectorize, kernel, {}))

    return decorate


@contextmanager
def _one_process_at_a_time() -> Generator[None]:
    """Hold the lock of the cache folder.

    numba keeps a kernel and the loop around it in two files, and names the one in the other by
    a number that each process counts for itself. Files of two processes that compile at the
    same time do not fit together: the first call would end the program.
    """
    folder = Path(cache_folder())
    folder.mkdir(parents=True, exist_ok=True)
    with (folder / "lock").open("w") as lock:
        fcntl.flock(lock, fcntl.LOCK_EX)
        yield


def _cached(decorator: Any, function: Any, options: dict[str, Any]) -> Any:
    settings = cast("Any", config)
    before = settings.CACHE_DIR
    settings.CACHE_DIR = cache_folder()
    try:
        return decorator(cache=True, **options)(function)
    finally:
        settings.CACHE_DIR = before
