"""Files that a lift is read from: whoever follows a lift asks here which ones were opened, and as what."""

from __future__ import annotations

from collections.abc import Iterator
from contextlib import contextmanager
from contextvars import ContextVar
from pathlib import Path

__all__ = ["GONE", "note_opened", "noted_opened", "state_of"]

#: What a file is while it is not there.
GONE = "gone"

_OPENED: ContextVar[dict[Path, str] | None] = ContextVar("opened", default=None)


def state_of(file: Path) -> str:
    """Changes whenever a file is written anew; `GONE` while it is not there."""
    try:
        about = file.stat()
    except (OSError, ValueError):
        return GONE
    return f"{about.st_mtime_ns}-{about.st_size}"


def note_opened(file: Path) -> None:
    """Note that a file is about to be opened; one that is not there is noted, too: it may come."""
    opened = _OPENED.get()
    if opened is not None:
        opened.setdefault(file, state_of(file))


@contextmanager
def noted_opened() -> Iterator[dict[Path, str]]:
    """Note in this thread which files a lift is read from.

    Yields:
        The state of each before it was first opened, by its path; it grows until the end.
    """
    opened: dict[Path, str] = {}
    before = _OPENED.set(opened)
    try:
        yield opened
    finally:
        _OPENED.reset(before)
