"""The flights of a campaign as they lie in its folder: what has one value a flight, as columns."""

from collections.abc import Generator, Mapping, Sequence
from contextlib import contextmanager
from dataclasses import dataclass
from functools import cached_property
from pathlib import Path
from typing import NamedTuple

import numpy as np
import pyarrow as pa
import pyarrow.parquet as pq

from vfguide.campaign.schema import schema_of
from vfguide.campaign.summary import UNREPEATABLE
from vfguide.campaign.table import BATCH, TABLE
from vfguide.files.errors import InputError
from vfguide.geometry.vector import Mask, Series

COMMON = schema_of(())
"""The columns that every campaign has."""
JUDGED = ("index", "seed", "verdict", "reached")
"""Names of the columns that say which flight it was, and how it went."""
TEXTS = ("reasons", "command")
"""Names of the columns that are read for a few flights alone, for they are long."""


class FlightTexts(NamedTuple):
    """What a row says in words."""

    reasons: tuple[str, ...]
    command: str
    """The command line that flies it alone."""


@dataclass(frozen=True)
class FlownCampaign:
    """The flights of one folder, from the first on; their place in a column is their number."""

    folder: Path
    columns: pa.Table
    """What was judged, the drawn values, and the figures of the flights."""

    @property
    def number(self) -> int:
        """Number of flights."""
        return self.columns.num_rows

    @property
    def varied(self) -> list[str]:
        """The dotted keys that were drawn."""
        return [name for name in self.columns.column_names if name not in COMMON.names]

    @property
    def figures(self) -> list[str]:
        """Names of the figures that at least one flight has."""
        names = [name for name in self.columns.column_names if name in COMMON.names]
        return [name for name in names if name not in JUDGED and self.known(name).any()]

    @cached_property
    def verdicts(self) -> np.ndarray:
        """Verdict of each flight, as a word."""
        return np.array(self.columns.column("verdict").to_pylist(), dtype="U6")

    @cached_property
    def reached(self) -> Mask:
        """Whether each flight reached all goals."""
        return self.columns.column("reached").to_numpy().astype(bool)

    def values(self, name: str) -> Series:
        """Values of a column; NaN where a flight has none."""
        return self.columns.column(name).to_numpy().astype(float)

    def first(self, number: int) -> "FlownCampaign":
        """The campaign as if it had only so many flights."""
        return FlownCampaign(self.folder, self.columns.slice(0, number))

    def known(self, name: str) -> Mask:
        """Which flights have a value of a column that is a finite number."""
        return np.isfinite(self.values(name))

    def texts(self, places: Sequence[int]) -> Mapping[int, FlightTexts]:
        """What the rows of some flights say in words.

        Raises:
            InputError: they cannot be read.
        """
        found: dict[int, FlightTexts] = {}
        ordered, first = sorted(places), 0
        path = self.folder / TABLE
        with reading(path), pq.ParquetFile(path) as file:
            for batch in file.iter_batches(BATCH, columns=[*TEXTS]):
                here = [each for each in ordered if first <= each < first + batch.num_rows]
                rows = batch.take(pa.array([each - first for each in here], pa.int64()))
                for place, row in zip(here, rows.to_pylist(), strict=True):
                    found[place] = FlightTexts(tuple(row["reasons"]), row["command"])
                first += batch.num_rows
        return found


def read_flown(folder: Path) -> FlownCampaign:
    """The flights of a folder, without what is long.

    Raises:
        InputError: it has no table of a campaign, or one that cannot be read.
    """
    path = folder / TABLE
    if not path.is_file():
        raise InputError(f"{folder}: no {TABLE}; allowed is the folder of a campaign")
    with reading(path), pq.ParquetFile(path) as file:
        check_columns(path, file.schema_arrow)
        names = [field.name for field in file.schema_arrow if is_short(field)]
        return FlownCampaign(folder, file.read(names))


@contextmanager
def reading(path: Path) -> Generator[None]:
    """Where a table is read.

    Raises:
        InputError: it cannot be read.
    """
    try:
        yield
    except (OSError, pa.ArrowException) as error:
        raise InputError(f"{path}: cannot be read: {error}") from error


def check_columns(path: Path, schema: pa.Schema) -> None:
    """Refuse a table without the columns that every campaign has had.

    Raises:
        InputError: one is missing, or of another type.
    """
    for name in (*JUDGED, *TEXTS):
        if name not in schema.names or schema.field(name).type != COMMON.field(name).type:
            raise InputError(
                f"{path}: no column {name} of type {COMMON.field(name).type}; "
                "allowed is the table of a campaign"
            )


def is_short(field: "pa.Field[pa.DataType]") -> bool:
    """Whether a column is read for all flights: numbers that can be repeated, and the verdict."""
    if field.name in JUDGED:
        return True
    is_number = pa.types.is_floating(field.type) or pa.types.is_integer(field.type)
    return is_number and field.name not in UNREPEATABLE
