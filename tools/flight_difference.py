"""Where two flights of one scenario differ first: logs frame by frame, results key by key.

Logs are the same if their bytes are. They are decoded only to name what differs, so that a fault in
the decoder hides nothing.
"""

import json
from collections.abc import Iterator
from itertools import zip_longest
from pathlib import Path
from typing import Any

from vfguide.geometry.units import US
from vfguide.link.codec import decode
from vfguide.link.tlog import TlogReader
from vfguide.replay.compare import Timed

OF_THE_CLOCK = frozenset({"wall_s", "realtime_factor"})
"""Keys of a result that depend on the clock of the machine, and differ from run to run."""


class Absent:
    """The value of a key that one of two results does not have."""

    def __repr__(self) -> str:
        return "absent"


ABSENT = Absent()


def flight_difference(old: Path, new: Path) -> str | None:
    """What differs first between two folders that a run has left; None: nothing.

    Compared are every `*.tlog` and `result.json`.
    """
    for name in sorted({path.name for folder in (old, new) for path in folder.glob("*.tlog")}):
        if found := log_difference(old / name, new / name):
            return f"{name}: {found}"
    return value_difference("result.json", result_of(old), result_of(new))


def frames_in(folder: Path) -> int:
    """Number of frames in all logs of a flight."""
    readers = [TlogReader.open(path) for path in folder.glob("*.tlog")]
    return sum(1 for reader in readers for _ in reader)


def log_difference(old: Path, new: Path) -> str | None:
    """The first frame of two logs that differs, in its time or in any byte; None: no byte does."""
    for path, other in ((old, "the tree"), (new, "the reference")):
        if not path.exists():
            return f"only {other} has it"
    was, now = old.read_bytes(), new.read_bytes()
    if was == now:
        return None
    for number, pair in enumerate(zip_longest(TlogReader(was), TlogReader(now))):
        if pair[0] != pair[1]:
            return frame_difference(number, start_of(was), *pair)
    return "every frame is the same, the bytes between them are not"


def start_of(log: bytes) -> int:
    """Time of the first frame [us since 1970], 0 if there is none."""
    return next((time for time, _ in TlogReader(log)), 0)


def frame_difference(number: int, start: int, old: Timed | None, new: Timed | None) -> str:
    """What differs in frames number `number`, from 0, of two logs that begin at `start` [us]."""
    if old is None or new is None:
        more, only = ("tree", new) if old is None else ("reference", old)
        assert only is not None
        return f"the {more} has more frames, the first is {named(number, start, only)}"
    pairs = zip(fields_of(old), fields_of(new), strict=False)
    what, was, now = next((key, a, b) for (key, a), (_, b) in pairs if a != b)
    return f"{named(number, start, old)}: {what} {was}, now {now}"


def named(number: int, start: int, timed: Timed) -> str:
    """A frame by its number, its time and what it says."""
    time, frame = timed
    sender = f"{frame.sysid}/{frame.compid}"
    return f"frame {number:,} at {(time - start) * US:.6f} s, {message_of(timed)} of {sender}"


def message_of(timed: Timed) -> str:
    """The name of the message in a frame."""
    _, frame = timed
    message = decode(frame)
    return f"message {frame.msgid}" if message is None else message.NAME


def fields_of(timed: Timed) -> Iterator[tuple[str, str]]:
    """Names and values of all that can differ between two frames, the most telling first."""
    time, frame = timed
    yield "time [us]", str(time)
    yield "message", message_of(timed)
    message = decode(frame)
    if message is not None:
        yield from ((key, repr(each)) for key, each in zip(message._fields, message, strict=True))
    for key in ("sysid", "compid", "seq", "version"):
        yield key, repr(getattr(frame, key))
    yield "payload", frame.payload.hex()
    yield "frame", frame.raw.hex()


def result_of(folder: Path) -> dict[str, Any]:
    """The result of a flight, without the keys in OF_THE_CLOCK."""
    result = json.loads((folder / "result.json").read_text())
    return {key: value for key, value in result.items() if key not in OF_THE_CLOCK}


def value_difference(path: str, old: Any, new: Any) -> str | None:
    """The path of the first value in which two nested values differ, with both; None: none does."""
    was, now = entries(old), entries(new)
    if was is None or now is None or type(old) is not type(new):
        return None if repr(old) == repr(new) else f"{path}: {old!r}, now {new!r}"
    for key in was | now:
        found = value_difference(path + key, was.get(key, ABSENT), now.get(key, ABSENT))
        if found:
            return found
    return None


def entries(value: Any) -> dict[str, Any] | None:
    """The entries of a table or a list, by the ends of their paths; None for any other value."""
    match value:
        case dict():
            return {f".{key}": each for key, each in value.items()}
        case list():
            return {f"[{index}]": each for index, each in enumerate(value)}
    return None
