"""Says what is compiled, so that nobody waits without knowing for what."""

from typing import Any

from vfguide.terminal.console import err


class Compiling:
    """Tells once a stage that it has to be compiled, when something of it is not in the cache."""

    def __init__(self) -> None:
        self._stage = ""
        self._listens = False

    def stage(self, name: str, number: int = 1, of: int = 1) -> None:
        """What is compiled from now on, if anything is, and which of how many stages that is."""
        count = f" ({number} of {of})" if of > 1 else ""
        self._stage = f"{name}{count}"
        if not self._listens:
            self._listens = True
            self._listen()

    def tell(self) -> None:
        """Say that machine code is missing; once a stage."""
        if self._stage:
            what, self._stage = self._stage, ""
            err.print(f"vfguide: compiling {what}; this may take a minute or two")

    def _listen(self) -> None:
        """Hear from numba what it compiles; functions that are never kept take no time."""
        from numba.core import event

        from vfguide.kernels.compiled import is_kept

        teller = self

        class Listener(event.Listener):
            """Of numba."""

            def on_start(self, event: Any) -> None:
                """A function is not in the cache."""
                if is_kept(event.data["dispatcher"]):
                    teller.tell()

            def on_end(self, event: Any) -> None:
                """It is compiled."""

        event.register("numba:compile", Listener())


COMPILING = Compiling()
"""What this process tells: there is one numba in it."""
