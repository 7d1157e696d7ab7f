"""The command line as a user types it: the status of a command, and what it printed."""

import os
import subprocess
import sys
import tempfile
from contextlib import ExitStack, chdir, redirect_stderr, redirect_stdout
from pathlib import Path
from typing import TextIO
from unittest import mock

from programs import VFGUIDE

from vfguide.cli.program import run_program

WIDE = {"COLUMNS": "300"}
"""A terminal on which no message is broken into lines."""


def vfguide(
    *arguments: object, cwd: Path, encoding: str = "utf-8"
) -> subprocess.CompletedProcess[str]:
    """The program with its streams and signals, in this process.

    A start costs more than most flights: a process of its own is for what is about processes.
    """
    words = ["vfguide", *map(str, arguments)]
    with ExitStack() as stack:
        out, err = (stack.enter_context(terminal(encoding)) for _ in range(2))
        stack.enter_context(chdir(cwd))
        stack.enter_context(redirect_stdout(out))
        stack.enter_context(redirect_stderr(err))
        stack.enter_context(mock.patch.object(sys, "argv", words))
        stack.enter_context(mock.patch.dict(os.environ, WIDE))
        try:
            run_program(sys.exit)
        except SystemExit as ended:
            return subprocess.CompletedProcess(words, ended.code, read_back(out), read_back(err))
    raise AssertionError("a command ends with a status")


def terminal(encoding: str) -> TextIO:
    """A file in the place of a terminal."""
    return tempfile.TemporaryFile("w+", encoding=encoding)


def read_back(stream: TextIO) -> str:
    """What was written."""
    stream.seek(0)
    return stream.read()


def vfguide_alone(
    *arguments: object, cwd: Path, **options: object
) -> subprocess.CompletedProcess[str]:
    """The program in a process of its own."""
    return subprocess.run(
        [*VFGUIDE, *map(str, arguments)],
        cwd=cwd,
        env={**os.environ, **WIDE},
        capture_output=True,
        text=True,
        check=False,
        **options,
    )
