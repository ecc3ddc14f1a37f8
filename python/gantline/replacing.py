"""Writing files at once: under another name first, then renamed, so that nobody meets half a file."""

from __future__ import annotations

import errno
import os
import tempfile
from collections.abc import Iterator
from contextlib import contextmanager
from pathlib import Path

from gantline.interrupt import tidied

__all__ = ["ROOM_OF_TABLES", "hold_room", "remove_file", "replace_bytes", "replace_text", "replaced"]

#: What a NetCDF file has beside its values [bytes]: some 100 kB of a recording of a hundred variables.
ROOM_OF_TABLES = 1 << 20
_NO_ROOM = frozenset({errno.ENOSPC, errno.EDQUOT, errno.EFBIG})


@contextmanager
def replaced(path: Path) -> Iterator[Path]:
    """A file to write, which takes the place of `path` once it is complete, and else is gone.

    A link stays a link: what it leads to is replaced. A device or a pipe is no file to replace: it is
    written itself.

    Raises:
        OSError: If there is no writing there.
    """
    target = Path(os.path.realpath(path))
    if target.is_dir():
        raise IsADirectoryError(errno.EISDIR, os.strerror(errno.EISDIR), str(target))
    if target.exists() and not target.is_file():
        yield target
        return
    if not target.parent.is_dir():
        # Of a file in place of the folder "no such file" would not be true.
        kind = errno.ENOTDIR if target.parent.exists() else errno.ENOENT
        raise OSError(kind, os.strerror(kind), str(target.parent))
    trials: list[Path] = []

    def remove() -> None:
        for one in trials:
            one.unlink(missing_ok=True)

    # Half a recording would stay there under its other name.
    with tidied(remove):
        handle, name = tempfile.mkstemp(prefix=f".{target.name}.", suffix=".part", dir=target.parent)
        trial = Path(name)
        trials.append(trial)
        os.close(handle)
        try:
            yield trial
            # `mkstemp` keeps others out, which the file itself would not.
            trial.chmod(0o666 & ~_umask())
            trial.replace(target)
        except BaseException:
            trial.unlink(missing_ok=True)
            raise


def hold_room(handle: int, size: int, path: Path) -> None:
    """Take room on the disk for the first bytes of a file that HDF5 writes.

    It writes what it holds before it closes a file, and where it cannot, it brings the whole program down as
    that ends. So room is asked for beforehand, and it meets no full disk.

    Args:
        handle: Of the file.
        size: How many bytes.
        path: What the file is called in the error.

    Raises:
        OSError: If there is none; the error is that of the path.
    """
    try:
        os.posix_fallocate(handle, 0, size)
    except OSError as problem:
        # Any other is of a file system, or of a device, that knows no such promise.
        if problem.errno in _NO_ROOM:
            raise OSError(problem.errno, problem.strerror, str(path)) from None


def replace_text(path: Path, text: str) -> None:
    """Write a text file; an existing one is replaced, and only once the new one is complete.

    Raises:
        OSError: If it cannot be written there.
    """
    replace_bytes(path, text.encode("utf-8"))


def replace_bytes(path: Path, content: bytes) -> None:
    """Write a file; an existing one is replaced, and only once the new one is complete.

    Raises:
        OSError: If it cannot be written there.
    """
    with replaced(path) as trial:
        trial.write_bytes(content)


def remove_file(path: Path) -> None:
    """Remove a file if it is there; a link stays a link, and what it leads to goes.

    Raises:
        OSError: If it cannot be removed.
    """
    target = Path(os.path.realpath(path))
    if target.is_file():
        target.unlink()


def _umask() -> int:
    mask = os.umask(0)
    os.umask(mask)
    return mask
