"""A file that one program has for itself while it writes to it again and again."""

from __future__ import annotations

import errno
import fcntl
import os
from collections.abc import Iterator
from contextlib import contextmanager, suppress
from pathlib import Path
from typing import BinaryIO

from gantline.interrupt import tidied
from gantline.replacing import remove_file

__all__ = ["InUseError", "locked"]

#: What a system says of a lock that another has.
_TAKEN = frozenset({errno.EAGAIN, errno.EACCES})


class InUseError(Exception):
    """Another has the file."""


@contextmanager
def locked(path: Path) -> Iterator[BinaryIO]:
    """A file to read and write, made if there is none; gone again where nothing has come into it.

    The lock is one of the system: it ends with the program, however that ends. On file systems that know no
    locks there is none.

    Raises:
        InUseError: If another has it, in this program or in another one.
        OSError: If it cannot be opened for reading and writing.
    """
    with _own(path) as file:

        def remove() -> None:
            # Still locked, so that nobody has begun to write to it.
            if os.fstat(file.fileno()).st_size == 0:
                remove_file(path)

        with tidied(remove):
            try:
                yield file
            finally:
                with suppress(OSError):
                    file.flush()
                    remove()


def _own(path: Path) -> BinaryIO:
    """The file, opened and locked."""
    while True:
        file = os.fdopen(os.open(path, os.O_RDWR | os.O_CREAT | os.O_CLOEXEC, 0o666), "r+b")
        try:
            _lock(file)
            if _is_at(path, file):
                return file
        except BaseException:
            file.close()
            raise
        # Whoever had it has found nothing to write, and has removed it meanwhile.
        file.close()


def _lock(file: BinaryIO) -> None:
    try:
        fcntl.flock(file, fcntl.LOCK_EX | fcntl.LOCK_NB)
    except OSError as problem:
        # Any other is of a file system that knows no locks.
        if problem.errno in _TAKEN:
            raise InUseError from None


def _is_at(path: Path, file: BinaryIO) -> bool:
    """Whether the path still leads to this file."""
    try:
        return os.path.samestat(os.stat(path), os.fstat(file.fileno()))
    except FileNotFoundError:
        return False
