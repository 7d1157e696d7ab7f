"""Files that are written whole or not at all."""

import os
from pathlib import Path


def write_atomically(path: Path, content: str | bytes) -> None:
    """Write a file under another name beside `path`, then rename it to `path`.

    Text is encoded as UTF-8. Lone surrogates, as in the text of a path that is not valid UTF-8, are
    escaped.

    Raises:
        OSError: it cannot be written; then `path` is as it was before.
    """
    data = content.encode(errors="backslashreplace") if isinstance(content, str) else content
    temporary = path.with_name(f".{path.name}.{os.getpid()}")
    try:
        temporary.write_bytes(data)
        temporary.replace(path)
    except BaseException:
        temporary.unlink(missing_ok=True)
        raise
