"""Tells the operator what is compiled, so that nobody waits without knowing for what."""

from typing import Any

from vfguide.terminal.console import err


class Compiling:
    """Tells, once a stage, that machine code of the stage is not in the cache and is compiled."""

    def __init__(self) -> None:
        self._stage = ""
        self._listens = False

    def stage(self, name: str, number: int = 1, of: int = 1) -> None:
        """Name what is compiled from now on, if anything is: stage `number` of so many, from 1."""
        count = f" ({number} of {of})" if of > 1 else ""
        self._stage = f"{name}{count}"
        if not self._listens:
            self._listens = True
            self._listen()

    def tell(self) -> None:
        """Print that the stage has to be compiled, unless that was printed before."""
        if self._stage:
            what, self._stage = self._stage, ""
            err.print(f"vfguide: compiling {what}; this may take a minute or two")

    def _listen(self) -> None:
        """Listen to numba compile; functions that are not kept in the cache take no time."""
        from numba.core import event

        from vfguide.kernels.compiled import is_kept

        teller = self

        class Listener(event.Listener):
            """Listener to numba's events of compilation."""

            def on_start(self, event: Any) -> None:
                """Tell that a function is not in the cache, and is compiled."""
                if is_kept(event.data["dispatcher"]):
                    teller.tell()

            def on_end(self, event: Any) -> None:
                """Do nothing: the function is compiled."""

        event.register("numba:compile", Listener())


COMPILING = Compiling()
"""The one instance of this process, as there is one numba in it."""
