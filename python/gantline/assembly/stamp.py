"""Whether a file beside the lift file is still the one that was read: all cases of a lift read it once."""

from __future__ import annotations

from pathlib import Path

from gantline.opened import note_opened

__all__ = ["stamp"]


def stamp(path: Path) -> tuple[int, int]:
    """Changes when the file does: its time and size, or zeros where there is none, which reading it says."""
    note_opened(path)
    try:
        found = path.stat()
    except OSError:
        return 0, 0
    return found.st_mtime_ns, found.st_size
