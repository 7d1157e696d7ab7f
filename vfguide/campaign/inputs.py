"""What all flights of a campaign have to be flown from: the same program and the same files."""

import hashlib
from collections.abc import Iterable
from pathlib import Path
from typing import NamedTuple

from vfguide import __version__
from vfguide.files.data import find_aircraft, find_scenario


class Inputs(NamedTuple):
    """What may not change during a campaign."""

    program: str
    """Version of the program."""
    scenario: str
    """SHA-256 of the scenario file."""
    aircraft: str
    """SHA-256 of all files of its aircraft."""


def inputs_of(scenario: str, aircraft: Iterable[str]) -> Inputs:
    """This program, and the files of a scenario as they are now.

    Args:
        scenario: path of a scenario file, or a shipped name.
        aircraft: names of its aircraft.

    Raises:
        InputError: one is not found.
        OSError: one cannot be read.
    """
    path = find_scenario(scenario)
    own = hashlib.sha256(path.read_bytes()).hexdigest()
    files = [each for name in sorted(aircraft) for each in aircraft_files(name, path)]
    digests = [hashlib.sha256(each.read_bytes()).digest() for each in files]
    return Inputs(__version__, own, hashlib.sha256(b"".join(digests)).hexdigest())


def aircraft_files(name: str, beside: Path) -> list[Path]:
    """The files of an aircraft in a fixed order: its aircraft file, then those of its model.

    Raises:
        InputError: there is no aircraft of that name.
    """
    files = find_aircraft(name, beside)
    model = files.model.parent.rglob("*") if files.model else ()
    return [files.performance, *sorted(each for each in model if each.is_file())]
