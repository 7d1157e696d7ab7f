"""Two campaigns flown in pairs: the same seeds and drawn values, flight by flight."""

import json
from collections.abc import Iterator, Mapping
from dataclasses import dataclass
from pathlib import Path

import numpy as np

from vfguide.campaign.campaign import IDENTITY_FILE
from vfguide.campaign.results.flown import FlownCampaign, read_flown
from vfguide.files.errors import InputError

PAIRABLE = "allowed are campaigns with the same --seed and the same [vary]"
"""Which campaigns can be paired, in words."""

Identity = Mapping[str, object]
"""What `campaign.json` says of a campaign."""


@dataclass(frozen=True)
class PairedCampaigns:
    """Two campaigns, cut to the flights that both have."""

    a: FlownCampaign
    b: FlownCampaign
    identity_a: Identity
    identity_b: Identity
    flights_a: int
    """Number of all flights of the first."""
    flights_b: int
    """Number of all flights of the second."""

    @property
    def number(self) -> int:
        """Number of pairs."""
        return self.a.number


def read_pairs(folder_a: Path, folder_b: Path) -> PairedCampaigns:
    """Two campaigns of their folders.

    Raises:
        InputError: one is none, or has no flight, or they were not flown in pairs.
    """
    identity_a, identity_b = read_identity(folder_a), read_identity(folder_b)
    a, b = read_flown(folder_a), read_flown(folder_b)
    for each in (a, b):
        if not each.number:
            raise InputError(f"{each.folder}: the campaign has no flight yet")
    number = min(a.number, b.number)
    pairs = PairedCampaigns(
        a.first(number), b.first(number), identity_a, identity_b, a.number, b.number
    )
    difference = next(differences(pairs.a, pairs.b), None)
    if difference is not None:
        raise InputError(f"--compare {folder_a} {folder_b}: {difference}; {PAIRABLE}")
    return pairs


def differences(a: FlownCampaign, b: FlownCampaign) -> Iterator[str]:
    """In what was drawn for two campaigns differs, in words."""
    for one, other in ((a, b), (b, a)):
        for key in one.varied:
            if key not in other.varied:
                yield f"{key} varies in {one.folder} alone"
                return
    for name in ("index", "seed", *a.varied):
        columns = a.columns.column(name).to_numpy(), b.columns.column(name).to_numpy()
        unlike = np.flatnonzero(columns[0] != columns[1])
        if unlike.size:
            place = int(unlike[0])
            there, here = (column[place] for column in columns)
            yield f"flight {place}: {name} = {there} in {a.folder}, {here} in {b.folder}"


def read_identity(folder: Path) -> Identity:
    """What a folder says of its campaign.

    Raises:
        InputError: it is no folder of a campaign, or it cannot be read.
    """
    path = folder / IDENTITY_FILE
    if not path.is_file():
        raise InputError(f"{folder}: no {IDENTITY_FILE}; allowed is the folder of a campaign")
    try:
        identity = json.loads(path.read_text())
    except (OSError, ValueError) as error:
        raise InputError(f"{path}: cannot be read: {error}") from error
    if not isinstance(identity, dict):
        raise InputError(f"{path}: none of this program's")
    return identity
