"""Machine code that is kept on disk from one start to the next: a convenience, never a condition.

One file holds one compiled function for one signature and one kind of processor. It begins with
the digest of the rest, so that a damaged file is recognised before anything in it is loaded, and
it appears whole or not at all, so that programs that start together may share the folder.
Whatever is wrong with a file or the folder costs the time to compile, and one warning.
"""

import functools
import hashlib
import inspect
import pickle
import sys
import uuid
import warnings
from collections.abc import Callable
from contextlib import suppress
from pathlib import Path
from typing import Any, cast

import llvmlite
import numba
from numba.core.caching import FunctionCache
from numba.core.compiler import CompileResult
from numba.core.serialize import dumps

DIGEST_BYTES = 32
"""Length of a SHA-256 digest [bytes] (FIPS 180-4)."""


class MachineCodeWarning(UserWarning):
    """Machine code cannot be kept, or what was kept is damaged."""


class MachineCode(FunctionCache):
    """The machine code of one function, as numba asks for it and gives it."""

    def __init__(
        self,
        function: Callable[..., Any],
        source: Callable[..., Any],
        folder: Path,
        variant: str,
    ) -> None:
        """Nothing is read yet.

        Args:
            function: what is compiled.
            source: the function whose file holds its text.
            folder: where machine code is kept.
            variant: tells apart what is compiled of one function.
        """
        self._py_func = function
        self._folder = folder
        self._name = f"{function.__module__}.{function.__qualname__}"
        self._made_of = (variant, self._name, source_digest(source), VERSIONS)
        self.enable()

    @property
    def cache_path(self) -> str:
        """The folder."""
        return str(self._folder)

    def flush(self) -> None:
        """Do nothing: part of numba's interface, to forget all machine code; nothing calls it."""

    def load_overload(self, sig: Any, target_context: Any) -> Any:
        """The function as it was compiled for a signature; None if it has to be compiled."""
        target_context.refresh()
        key = self._key(sig, target_context.codegen())
        path = self._path(key)
        try:
            content = path.read_bytes()
        except FileNotFoundError:
            return None
        except OSError as error:
            warn_of_folder(self._folder, error.strerror or str(error))
            return None
        if not is_whole(content):
            warn_of_damage(self._folder)
            return None
        kept = unpacked(content, key)
        return None if kept is None else cast("Any", CompileResult)._rebuild(target_context, *kept)

    def save_overload(self, sig: Any, data: Any) -> None:
        """Keep a compiled function, if that is possible."""
        if data.library.has_dynamic_globals or data.lifted:
            return
        key = self._key(sig, data.codegen)
        try:
            write_whole(self._path(key), packed(key, data._reduce()))
        except OSError as error:
            warn_of_folder(self._folder, error.strerror or str(error))

    def _key(self, sig: Any, codegen: Any) -> Any:
        """All that the machine code depends on besides the folder: signature, processor, source."""
        return (*self._index_key(sig, codegen), self._made_of)

    def _path(self, key: Any) -> Path:
        digest = hashlib.sha256(str(key).encode()).hexdigest()
        return self._folder / f"{self._name}.{digest[:32]}".replace("<locals>.", "")


VERSIONS = (numba.__version__, llvmlite.__version__, sys.version)
"""Versions of numba, llvmlite and Python; others cannot use their machine code and pickles."""


def packed(key: Any, kept: Any) -> bytes:
    """The content of a file."""
    data = dumps((key, kept))
    return hashlib.sha256(data).digest() + data


def is_whole(content: bytes) -> bool:
    """Whether the content of a file is as it was written."""
    return hashlib.sha256(content[DIGEST_BYTES:]).digest() == content[:DIGEST_BYTES]


def unpacked(content: bytes, key: Any) -> Any:
    """What was packed with `key`; None if the file holds another key."""
    # The digest tells damage, not malice: the folder is the user's own, as numba's cache is.
    found, kept = pickle.loads(content[DIGEST_BYTES:])  # noqa: S301
    return kept if found == key else None


def write_whole(path: Path, content: bytes) -> None:
    """Write a file that appears whole or not at all; its folder is made if need be.

    Raises:
        OSError: it cannot be written; nothing is left of it.
    """
    path.parent.mkdir(parents=True, exist_ok=True)
    temporary = path.with_name(f"{uuid.uuid4().hex}.part")
    try:
        temporary.write_bytes(content)
        temporary.replace(path)
    except BaseException:
        with suppress(OSError):
            temporary.unlink()
        raise


def source_digest(function: Callable[..., Any]) -> str:
    """Digest of the file that holds a function, hexadecimal; empty for one without a file."""
    file = inspect.getsourcefile(function)
    return digest_of_file(file) if file is not None and Path(file).exists() else ""


@functools.cache
def digest_of_file(file: str) -> str:
    """SHA-256 digest of a file, hexadecimal, as it was when it was first asked for."""
    return hashlib.sha256(Path(file).read_bytes()).hexdigest()


@functools.cache
def warn_of_folder(folder: Path, reason: str) -> None:
    """Say once why the next start has to compile again."""
    text = f"{folder}: machine code cannot be kept there, so every start compiles anew: {reason}"
    warnings.warn(text, MachineCodeWarning, stacklevel=1)


@functools.cache
def warn_of_damage(folder: Path) -> None:
    """Say once why this start compiles what had been compiled before."""
    text = f"{folder}: machine code that was kept there is damaged, and compiled anew"
    warnings.warn(text, MachineCodeWarning, stacklevel=1)
