"""The table of a campaign in its folder: each flight kept as it ends, a Parquet file at any moment.

`journal.jsonl` has a line for each flight, in the order in which they end. `results.parquet` has
the flights from the first on without a gap. It is written anew from the journal every now and then,
under another name, and renamed: it is whole at any moment. Then what it holds leaves the journal.
Whatever ends the program, no flight that ended is lost, and none is there twice.
"""

import json
import os
from collections import deque
from collections.abc import Iterable, Iterator, Mapping
from itertools import chain
from pathlib import Path
from types import TracebackType
from typing import Any, Self

import pyarrow as pa
import pyarrow.parquet as pq

from vfguide.campaign.schema import COLUMN_WORDS
from vfguide.files.atomic import write_atomically

JOURNAL = "journal.jsonl"
"""Name of the file with the flights that the Parquet file does not hold."""
TABLE = "results.parquet"
"""Name of the Parquet file."""
LEAST_GROUP = 20
"""Least number of new flights with which the Parquet file is written anew; chosen, few enough that
who looks finds new ones."""
LARGEST_GROUP = 2000
"""Largest number of flights that wait in memory for that; chosen, some ten megabytes."""
GROWTH = 0.25
"""Number of new flights with which it is written anew, as a share of those in it; chosen, so that
up to some ten thousand flights each is written about five times."""
BATCH = 5000
"""Number of flights in a row group of the Parquet file; chosen, some ten megabytes in memory."""

Columns = Mapping[str, Any]
"""The values of a flight by the names of their columns."""


class CampaignTable:
    """The flights of a campaign so far; a context manager."""

    def __init__(self, folder: Path, schema: pa.Schema) -> None:
        """The table in a folder, with what an earlier program left there.

        Raises:
            OSError: it cannot be read or written.
            pyarrow.ArrowException: the Parquet file cannot be read, or has other columns.
        """
        self._path, self._journal_path = folder / TABLE, folder / JOURNAL
        self._schema = schema
        for left in folder.glob(f".{TABLE}.*"):
            left.unlink()
        self._written = self._number_written()
        self.whole = self._written
        """Number of flights from the first on of which none is missing."""
        self._ready = deque[Columns]()
        self._early: dict[int, Columns] = {}
        for columns in journal(self._journal_path):
            if is_row(columns, schema) and not self.has(columns["index"]):
                self._take(columns)
        self._journal = self._journal_path.open("a", encoding="utf-8")
        self._write_anew()

    @property
    def number(self) -> int:
        """Number of flights that have ended."""
        return self.whole + len(self._early)

    def has(self, index: int) -> bool:
        """Whether a flight has ended."""
        return index < self.whole or index in self._early

    def add(self, columns: Columns) -> list[Columns]:
        """Keep a flight that has ended.

        Returns:
            The flights that now follow the others without a gap, in the order of their numbers.

        Raises:
            OSError: it cannot be written.
        """
        self._journal.write(line_of(columns))
        self._journal.flush()
        new = self._take(columns)
        if len(self._ready) >= max(LEAST_GROUP, min(GROWTH * self._written, LARGEST_GROUP)):
            self._write_anew()
        return new

    def rows(self) -> Iterator[Columns]:
        """The flights from the first on of which none is missing, in their order."""
        for batch in self.batches():
            yield from batch.to_pylist()
        yield from self._ready

    def cut(self, number: int) -> None:
        """Leave the first flights alone, `number` of them, of which none is missing.

        Raises:
            OSError: it cannot be written.
        """
        self._early.clear()
        self._write_anew()
        whole = pa.Table.from_batches(self.batches(), self._schema)
        self._write(whole.slice(0, number).to_batches(BATCH))
        self._written = self.whole = number

    def close(self) -> None:
        """Write all flights that follow without a gap into the Parquet file.

        Raises:
            OSError: it cannot be written.
        """
        if self._journal.closed:
            return
        try:
            self._write_anew()
        finally:
            self._journal.close()

    def batches(self) -> Iterator[pa.RecordBatch]:
        """The flights of the Parquet file in their order, a part at a time."""
        with pq.ParquetFile(self._path) as file:
            yield from file.iter_batches(BATCH)

    def _take(self, columns: Columns) -> list[Columns]:
        """Put a flight in its place; those that now follow without a gap."""
        self._early[columns["index"]] = columns
        new: list[Columns] = []
        while (first := self._early.pop(self.whole, None)) is not None:
            self.whole += 1
            new.append(first)
        self._ready.extend(new)
        return new

    def _number_written(self) -> int:
        """Number of flights in the Parquet file; there is one from now on."""
        if not self._path.exists():
            self._write(())
        with pq.ParquetFile(self._path) as file:
            if not file.schema_arrow.equals(self._schema):
                raise pa.ArrowInvalid("other columns than those of the campaign")
            return file.metadata.num_rows

    def _write_anew(self) -> None:
        """Move what follows without a gap from the journal to the Parquet file."""
        if self._ready:
            new = pa.Table.from_pylist(list(self._ready), schema=self._schema)
            self._write(chain(self.batches(), new.to_batches()))
            self._written += len(self._ready)
            self._ready.clear()
        self._journal.close()
        left = map(line_of, self._early.values())
        write_atomically(self._journal_path, "".join(left))
        self._journal = self._journal_path.open("a", encoding="utf-8")

    def _write(self, batches: Iterable[pa.RecordBatch]) -> None:
        """Write the Parquet file under another name, then rename it."""
        temporary = self._path.with_name(f".{TABLE}.{os.getpid()}")
        try:
            with pq.ParquetWriter(temporary, self._schema, compression="zstd") as writer:
                for batch in batches:
                    writer.write_batch(batch)
            temporary.replace(self._path)
        except BaseException:
            temporary.unlink(missing_ok=True)
            raise

    def __enter__(self) -> Self:
        return self

    def __exit__(
        self,
        kind: type[BaseException] | None,
        error: BaseException | None,
        trace: TracebackType | None,
    ) -> None:
        self.close()


def line_of(columns: Columns) -> str:
    """The line of a flight in the journal."""
    return json.dumps(columns, allow_nan=False) + "\n"


def journal(path: Path) -> Iterator[Columns]:
    """The flights of a journal; a line that was cut as it was written is none."""
    if not path.exists():
        return
    with path.open("rb") as lines:
        for line in lines:
            columns = flight_of(line)
            if columns is not None:
                yield columns


def is_row(columns: Columns, schema: pa.Schema) -> bool:
    """Whether a flight of the journal can be a row of the table."""
    if set(columns) != set(schema.names) or columns["verdict"] not in COLUMN_WORDS["verdict"]:
        return False
    try:
        pa.RecordBatch.from_pylist([dict(columns)], schema=schema)
    except (pa.ArrowException, OverflowError):
        return False
    return True


def flight_of(line: bytes) -> Columns | None:
    """The flight of a line of the journal; None: it is none."""
    try:
        columns = json.loads(line)
    except (ValueError, RecursionError):
        return None
    if not isinstance(columns, dict):
        return None
    index: object = columns.get("index")
    if not isinstance(index, int) or isinstance(index, bool) or index < 0:
        return None
    return columns
